#!/usr/bin/env bash
# responsiveness.sh BUILD: responsiveness.py in FreeCAD's GUI on a screen of its own; the table it makes goes to standard
# output.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export BURIN_TABLE=$scratch/table BURIN_TEST_TIMEOUT=${BURIN_TEST_TIMEOUT:-1800} BURIN_TEST_DATA=${BURIN_TEST_DATA:-$root/../shared/data}
# As a user has it: tests paint in the thread of the window, on a smaller screen.
BURIN_TEST_SCREEN=1280x900 BURIN_TEST_CUBE=1 LP_NUM_THREADS=$(nproc) \
  /usr/bin/python3 "$root/tests/freecad/gui/run.py" "$(cd "$1" && pwd)/python" "$scratch" "$here/responsiveness.py" >"$scratch/log" 2>&1 ||
  { tail -30 "$scratch/log" >&2; exit 1; }
cat "$BURIN_TABLE"
