#!/usr/bin/env bash
# debian.sh SOURCE PACKAGES [--all]: a bare Debian 12 in a folder of its own; the packages of the folder PACKAGES are
# installed there by apt, and draw. Needs root, mmdebstrap and a mirror. --all: the workbench too, and FreeCAD draws
# with it (a gigabyte of packages); else only its dependencies are tried.
set -euo pipefail
source=$1 packages=$2 all=${3:-}
fail() { printf 'debian test: %s\n' "$*" >&2; exit 1; }
. "$(dirname "${BASH_SOURCE[0]}")/bare_root.sh"
root=
undo() { ! mountpoint -q "$root/proc" || umount "$root/proc"; }
skip_unless_root "debian test" mmdebstrap

root=$scratch/root
bare_root apt "$root"
mount -t proc proc "$root/proc"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
mkdir "$root/try"
cp "$packages"/*.deb "$root/try/"
cp "$source"/samples/{coupling.step,spindle.stl,horn.itd} "$root/try/"
version=$(sed -n 's/^project(burin VERSION \([^ ]*\).*/\1/p' "$source/CMakeLists.txt")
for name in burin burin-dev python3-burin burin-freecad; do
  compgen -G "$root/try/${name}_${version}_*.deb" >/dev/null || fail "no package $name"
done

inside apt-get -qq update
before=$(du -sm --one-file-system "$root" | cut -f1)
inside sh -c 'apt-get -qq install --no-install-recommends /try/burin_*.deb >/try/log 2>&1' ||
  { tail -20 "$root/try/log" >&2; fail "apt cannot install burin"; }
echo "burin: $(du -sm --one-file-system "$root" | cut -f1) MB in all, $before before"
inside burin --version | grep -qF "burin $version" || fail "the command does not start"
for model in coupling.step spindle.stl horn.itd; do
  inside burin draw "/try/$model" -o /try/a.svg -o /try/a.pdf -o /try/a.png --quiet || fail "burin does not draw $model"
  [[ $(grep -c '<path' "$root/try/a.svg") -gt 2 && -s $root/try/a.pdf && -s $root/try/a.png ]] || fail "the drawing of $model is empty"
done
printf 'difference() {\n\tcube(size = [4, 4, 4], center = true);\n\tsphere($fn = 32, $fa = 12, $fs = 2, r = 2.4);\n}\n' >"$root/try/a.csg"
inside burin draw /try/a.csg -o /try/a.svg --quiet || fail "burin does not evaluate a tree"
[[ -s $root/usr/share/man/man1/burin-draw.1.gz && -s $root/usr/share/bash-completion/completions/burin ]] ||
  fail "manual pages or completions are missing"
inside burin draw /try/coupling.step -o /try/inside.svg --quiet --style engraving
# What a user asks first of a package without Python.
inside burin batch plan /try/none.toml -o /try/jobs 2>"$root/try/said" && fail "burin batch runs without Python"
grep -q python3-burin "$root/try/said" || fail "burin batch does not name the package that it needs: $(cat "$root/try/said")"

inside sh -c 'apt-get -qq install --no-install-recommends /try/python3-burin_*.deb >/try/log 2>&1' ||
  { tail -20 "$root/try/log" >&2; fail "apt cannot install python3-burin"; }
inside python3 -c "import burin; burin.draw('/try/coupling.step', style='engraving').save('/try/python.svg')" ||
  fail "the Python module does not draw"
cmp "$root/try/inside.svg" "$root/try/python.svg" || fail "the Python module draws other than the command"

if [[ $all == --all ]]; then
  inside sh -c 'apt-get -qq install --no-install-recommends /try/burin-freecad_*.deb >/try/log 2>&1' ||
    { tail -20 "$root/try/log" >&2; fail "apt cannot install burin-freecad"; }
  inside freecadcmd -c "from freecad.burin_wb import kernel; print(kernel.module().__file__)" </dev/null | grep -q dist-packages/burin ||
    fail "FreeCAD does not find the workbench with its kernel"
else
  inside sh -c 'apt-get -qq install --simulate --no-install-recommends /try/burin-freecad_*.deb >/try/log 2>&1' ||
    { tail -20 "$root/try/log" >&2; fail "apt cannot install burin-freecad"; }
fi
inside sh -c 'apt-get -qq remove burin >/try/log 2>&1' || fail "apt cannot remove burin"
[[ ! -e $root/usr/bin/burin ]] || fail "the command stays after it was removed"
echo "installed, drawn and removed"
