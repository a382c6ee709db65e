#!/usr/bin/env bash
# tests/kernel_only/compare.sh KERNEL_ONLY [WHOLE]: draws meshes by the build of the preset kernel_only, and compares them
# byte for byte with the same program of a whole build, where there is one. What is not built has to say so.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
draw=$1/bin/burin_mesh_to_svg
whole=${2:-}/bin/burin_mesh_to_svg
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() { printf 'kernel_only: error: %s\n' "$*" >&2; exit 1; }

# refused STATUS TEXT ARGUMENT...: the program ends so, and says so.
refused() {
  local status=0 expected=$1 text=$2
  shift 2
  "$draw" "$@" 2>"$scratch/error" || status=$?
  ((status == expected)) || fail "status $status in place of $expected: $*"
  grep -qF "$text" "$scratch/error" || fail "'$(<"$scratch/error")' in place of '$text'"
  (($(wc -l <"$scratch/error") == 1)) || fail "more than one line: $(<"$scratch/error")"
}

for model in spindle.stl bolt.3mf; do
  for style in outline engraving; do
    "$draw" "samples/$model" "$style" "$scratch/a.svg" "$scratch/a.json"
    (($(grep -o '<path\|<poly' "$scratch/a.svg" | wc -l) >= 3)) || fail "the drawing of $model is empty"
    [[ -x $whole ]] || continue
    "$whole" "samples/$model" "$style" "$scratch/b.svg" "$scratch/b.json"
    cmp "$scratch/a.svg" "$scratch/b.svg" || fail "$model in $style is another drawing than that of the whole build"
    cmp "$scratch/a.json" "$scratch/b.json" || fail "$model in $style is other data than that of the whole build"
  done
done
refused 3 "STEP, IGES and BREP files need Burin with OCCT (BURIN_CAD)" samples/coupling.step outline "$scratch/c.svg"
refused 1 "PDF files need Burin with cairo and libpng (BURIN_PICTURES)" samples/spindle.stl outline "$scratch/c.pdf"
refused 1 "DXF files need Burin with the writer dxf (BURIN_WRITERS)" samples/spindle.stl outline "$scratch/c.dxf"
needed=$(objdump -p "$1"/lib/libburin.so "$1"/lib/libburin_io.so | sed -n 's/ *NEEDED *//p')
for library in TK tbb cairo python harfbuzz fontconfig; do
  ! grep -q "^lib$library" <<<"$needed" || fail "the libraries need $library"
done
if [[ -x $whole ]]; then
  echo "kernel_only: drawings are those of the whole build"
else
  echo "kernel_only: drawn; there is no whole build to compare with"
fi
