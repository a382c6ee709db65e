#!/usr/bin/env bash
# run.sh SCRIPT BUILD: documents.py or performance.py inside freecadcmd; the table it makes goes to standard output.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export FREECAD_USER_HOME=$scratch BURIN_TABLE=$scratch/table
export BURIN_PYTHON_PATH=${BURIN_PYTHON_PATH:-$(cd "$2" && pwd)/python} BURIN_TEST_DATA=${BURIN_TEST_DATA:-$root/../shared/data}
# The add-on after the script: with -M in front FreeCAD 0.20 ends with a segmentation fault.
freecadcmd "$here/$1" -M "$root/freecad_wb" </dev/null >"$scratch/log" 2>&1 || { tail -30 "$scratch/log" >&2; exit 1; }
cat "$BURIN_TABLE"
