#!/usr/bin/env bash
# image.sh SOURCE BURIN [PACKAGES]: builds the image of SOURCE's Containerfile, on a bare Debian 12 that is made here as its base,
# and draws in it: the same bytes as the command BURIN. Its first stage builds the packages, which takes as long as any build;
# where a folder of PACKAGES is named these are taken in its place. Needs root, podman, buildah, mmdebstrap and a mirror.
# Containers are entered by chroot, so that it works inside of other containers, too; `podman run` is not tried.
set -euo pipefail
source=$(cd "$1" && pwd) burin=$2 packages=${3:-}
fail() { printf 'image test: %s\n' "$*" >&2; exit 1; }
. "$(dirname "${BASH_SOURCE[0]}")/bare_root.sh"
container=
undo() { [[ -z $container ]] || buildah rm "$container" >/dev/null || true; }
skip_unless_root "image test" podman buildah mmdebstrap

base=$(sed -n 's/^FROM \([^ ]*\)$/\1/p' "$source/Containerfile")
[[ -n $base ]] || fail "the Containerfile names no base"
bare_root minbase "$scratch/base.tar"
podman import --quiet "$scratch/base.tar" "$base" >/dev/null
rm "$scratch/base.tar"

first=()
if [[ -n $packages ]]; then
  mkdir -p "$scratch/build/burin/build/release/packages"
  cp "$packages"/burin_*.deb "$packages"/python3-burin_*.deb "$scratch/build/burin/build/release/packages"
  first=(--build-context "build=$scratch/build")
fi
podman build --isolation=chroot --network=host --pull=never --quiet "${first[@]}" -t burin-image-test "$source" >"$scratch/log" 2>&1 ||
  { tail -30 "$scratch/log" >&2; fail "podman does not build the image"; }
container=$(buildah from --pull-never localhost/burin-image-test)
mkdir "$scratch/work"
cp "$source"/samples/{coupling.step,gear_pump.step} "$scratch/work"
inside() { buildah run --isolation=chroot --volume "$scratch/work:/work" "$container" -- "$@"; }
entry=$(podman image inspect --format '{{join .Config.Entrypoint " "}} in {{.Config.WorkingDir}}' localhost/burin-image-test)
[[ $entry == "burin in /work" ]] || fail "the image starts: $entry"
inside burin draw coupling.step -o inside.svg --quiet || fail "the image does not draw"
"$burin" draw "$source/samples/coupling.step" -o "$scratch/work/outside.svg" --quiet
cmp "$scratch/work/inside.svg" "$scratch/work/outside.svg" || fail "the image draws other than $burin"
printf 'out = "out"\nviews = ["front", "iso"]\n[[parts]]\nfiles = ["*.step"]\n' >"$scratch/work/catalogue.toml"
inside burin batch plan catalogue.toml -o jobs.jsonl && inside burin batch run jobs.jsonl || fail "the image draws no catalogue"
[[ $(find "$scratch/work/out" -name '*.svg' | wc -l) == 4 ]] || fail "the catalogue is not whole"
echo "the image is built, and draws: $(podman image inspect --format '{{.Size}}' localhost/burin-image-test) bytes"
