#!/usr/bin/env bash
# run.sh MODULE FOLDER: a test module inside freecadcmd, with settings of its own below FOLDER. 77 = skipped.
set -euo pipefail
module=$1 here=$(cd "$(dirname "$0")" && pwd)
addon=${BURIN_ADDON:-$here/../../../freecad_wb}
freecadcmd=$(command -v freecadcmd || command -v FreeCADCmd || true)
if [[ -z $freecadcmd ]]; then
  echo "skipped: FreeCAD is not there (Debian: apt-get install freecad)"
  exit 77
fi
if [[ -z ${BURIN_PYTHON_PATH:-} ]]; then
  echo "skipped: the Python module burin is not built"
  exit 77
fi
mkdir -p "$2"
FREECAD_USER_HOME=$(mktemp -d "$2/$module.XXXXXX")
export FREECAD_USER_HOME
trap 'rm -rf "$FREECAD_USER_HOME"' EXIT
# -P before anything else: with -M in front FreeCAD 0.20 ends with a segmentation fault.
"$freecadcmd" -t "$module" -P "$here" -P "$addon" </dev/null
