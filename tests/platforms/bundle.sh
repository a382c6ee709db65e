#!/usr/bin/env bash
# bundle.sh BUILD [SUITE...]: unpacks the bundle of a build in bare roots of Debian (12 and 13 where none is named), where nothing
# is installed, and draws samples there: the bytes are those of the build's own command. The root's own tar unpacks the
# .tar.gz; the .tar.zst, for which a bare root has no program, has the same files. Prints a line for each root. Needs root,
# mmdebstrap and a mirror.
set -euo pipefail
build=$1
shift
[[ $# -gt 0 ]] || set -- bookworm trixie
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
fail() { printf 'bundle: %s\n' "$*" >&2; exit 1; }
. "$source/tests/install/bare_root.sh"
root=
undo() { [[ -z $root ]] || ! mountpoint -q "$root/proc" || umount "$root/proc"; }
skip_unless_root "bundle" mmdebstrap zstd
packed=$(echo "$build"/burin-*-linux-*.tar.zst)
[[ -s $packed ]] || fail "no bundle in $build; run ./dev bundle"
name=$(basename "$packed" .tar.zst)
plain=$build/$name.tar.gz
for file in "$packed" "$plain"; do
  (cd "$build" && sha256sum --quiet -c "$(basename "$file").sha256") || fail "the SHA-256 of $file is another"
done
cmp -s <(zstd -dcq --long=27 "$packed") <(gzip -dc "$plain") || fail "$packed and $plain hold other files"

for suite in "$@"; do
  root=$scratch/$suite
  bare_root apt "$root" "$suite"
  mount -t proc proc "$root/proc"  # the loader looks there for the place of a program
  inside() { chroot "$root" env -i HOME=/root LC_ALL=C.UTF-8 "/opt/$name/bin/burin" "$@"; }
  cp "$plain" "$root/opt/"
  chroot "$root" tar -C /opt -xf "/opt/$name.tar.gz"
  inside --version >/dev/null || fail "$suite: the command does not start"
  # As the README of the bundle says.
  chroot "$root" env -i sh -c "cd /opt/$name && bin/burin draw samples/coupling.step -o /tmp/own.svg --quiet" ||
    fail "$suite: the sample of the bundle is not drawn"
  for model in coupling.step spindle.stl horn.itd lantern.glb blend.implicit; do
    for style in outline engraving; do
      cp "$source/samples/$model" "$root/tmp/"
      inside draw "/tmp/$model" --style "$style" --callouts -o /tmp/a.svg -o /tmp/a.pdf -o /tmp/a.png --quiet ||
        fail "$suite: $model is not drawn"
      "$build/bin/burin" draw "$source/samples/$model" --style "$style" --callouts -o "$scratch/a.svg" --quiet
      cmp -s "$scratch/a.svg" "$root/tmp/a.svg" || fail "$suite: the drawing of $model ($style) has other bytes"
      [[ -s $root/tmp/a.pdf && -s $root/tmp/a.png ]] || fail "$suite: no PDF or PNG of $model"
    done
  done
  printf 'cube(size = [3, 3, 3], center = false);\n' >"$root/tmp/a.csg"
  inside draw /tmp/a.csg -o /tmp/a.svg --quiet || fail "$suite: a tree of OpenSCAD is not drawn"
  glibc=$(chroot "$root" ldd --version | sed -n '1s/.* //p')
  start=$(for _ in 1 2 3 4 5; do
    a=$(date +%s%N); inside --version >/dev/null; b=$(date +%s%N); echo $(((b - a) / 1000000))
  done | sort -n | sed -n 3p)
  debian=$(cat "$root/etc/debian_version") result="10 drawings of 5 samples with the same bytes; starts in $start ms"
  echo "$suite, Debian $debian, glibc $glibc: $result"
  "$source/tests/platforms/table.py" add "Debian ${debian#*/}" "the bundle, nothing else installed" "glibc $glibc" "$result"
  umount "$root/proc"
  root=
done
