#!/usr/bin/env bash
# wheel.sh BUILD WHEEL: installs a wheel of a build in an empty environment of a bare Debian whose Python it is for, where nothing
# else of Burin, no compiler and no library of it is. Draws there: the bytes are those of the build's own module. Prints a
# line. Needs root, mmdebstrap and a mirror.
set -euo pipefail
build=$1 wheel=$2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
fail() { printf 'wheel: %s\n' "$*" >&2; exit 1; }
. "$source/tests/install/bare_root.sh"
root=
undo() { [[ -z $root ]] || ! mountpoint -q "$root/proc" || umount "$root/proc"; }
skip_unless_root "wheel" mmdebstrap
[[ -s $wheel ]] || fail "there is no $wheel; run ./dev wheel"
case $wheel in
  *-cp311-*) suite=bookworm ;;
  *-cp313-*) suite=trixie ;;
  *-cp314-*) suite=sid ;;
  *) fail "no Debian is known whose Python $(basename "$wheel") is for" ;;
esac
models=(coupling.step spindle.stl horn.itd lantern.glb blend.implicit)
cat >"$scratch/draw.py" <<'PY'
import sys, burin
for model in sys.argv[2:]:
    for style in "outline", "engraving":
        drawing = burin.draw(model, style=style)
        drawing.save(f"{sys.argv[1]}/{model.split('/')[-1]}.{style}.svg")
drawing.save(f"{sys.argv[1]}/a.pdf")
drawing.save(f"{sys.argv[1]}/a.png")
PY

root=$scratch/$suite
bare_root apt "$root" "$suite"
cp /etc/resolv.conf "$root/etc/"
mount -t proc proc "$root/proc"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
inside apt-get -qq update && inside apt-get -qqy --no-install-recommends install python3-venv >"$scratch/log" 2>&1 || fail "$suite has no python3-venv"
before=$(inside dpkg-query -W)
mkdir -p "$root/models" "$root/out" "$scratch/out"
cp "$wheel" "$scratch/draw.py" "$root/"
cp "${models[@]/#/$source/samples/}" "$root/models/"

inside python3 -m venv /empty
inside /empty/bin/pip install --quiet --no-index --no-deps "/$(basename "$wheel")" || fail "pip does not install the wheel"
inside /empty/bin/python /draw.py /out "${models[@]/#//models/}" || fail "the module that pip installed does not draw"
[[ -s $root/out/a.pdf && -s $root/out/a.png ]] || fail "no PDF or PNG"
PYTHONPATH=$build/python /usr/bin/python3 "$scratch/draw.py" "$scratch/out" "${models[@]/#/$source/samples/}"
for svg in "$scratch"/out/*.svg; do
  cmp -s "$svg" "$root/out/$(basename "$svg")" || fail "$(basename "$svg") has other bytes"
done
# The command of the wheel.
inside /empty/bin/burin draw /models/coupling.step -o /out/command.svg --quiet --style outline || fail "the command of the wheel does not draw"
cmp -s "$root/out/command.svg" "$scratch/out/coupling.step.outline.svg" || fail "the command of the wheel draws other bytes than its module"
inside /empty/bin/python -m burin --version | grep -q '^burin ' || fail "python -m burin does not run the command"
[[ $(inside dpkg-query -W) == "$before" ]] || fail "a package was installed"
# With numpy, which pip asks for; here Debian's.
inside apt-get -qqy --no-install-recommends install python3-numpy >"$scratch/log" 2>&1 || fail "$suite has no python3-numpy"
inside python3 -m venv --system-site-packages /full
inside /full/bin/pip install --quiet --no-index "/$(basename "$wheel")" || fail "pip does not find numpy"
lines=$(inside /full/bin/python -c "import burin; print(len(burin.draw('/models/coupling.step', style='outline').arrays()['part']))")
((lines > 50)) || fail "no arrays: $lines"
# Taken away, nothing is left.
inside /empty/bin/pip uninstall --quiet --yes burin
left=$(find "$root/empty" -ipath '*burin*' | head -3)
[[ -z $left ]] || fail "pip uninstall leaves $left"
debian=$(cat "$root/etc/debian_version") python=$(inside python3 --version)
result="$(ls "$scratch"/out/*.svg | wc -l) drawings of ${#models[@]} samples with the same bytes"
echo "$suite, Debian $debian, $python: $result"
"$source/tests/platforms/table.py" add "Debian ${debian#*/}" "the wheel, installed by pip" "$python" "$result"
umount "$root/proc"
root=
