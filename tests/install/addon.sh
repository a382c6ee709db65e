#!/usr/bin/env bash
# addon.sh ADDON SCRATCH PREFIX [HOME]: FreeCAD loads an installed add-on, which draws with the kernel below PREFIX.
# HOME: a user's folder, in whose Mod the add-on lies; without it FreeCAD is told where it is.
set -euo pipefail
addon=$1 scratch=$2 prefix=$3 home=${4:-}
freecadcmd=$(command -v freecadcmd || command -v FreeCADCmd || true)
if [[ -z $freecadcmd ]]; then
  echo "FreeCAD is not there: the installed add-on is not tried"
  exit 0
fi
cat >"$scratch/addon.py" <<'PY'
import os
import sys
import traceback

try:
    import FreeCAD as App
    from freecad.burin_wb import export, features, kernel

    prefix = os.environ["BURIN_PREFIX"]
    assert os.path.normpath(features.__file__).startswith(os.environ["BURIN_ADDON"]), features.__file__
    assert "freecad.burin_wb.export" in App.getExportType("eps")
    document = App.newDocument()
    box = document.addObject("Part::Box", "Box")
    obj = features.make_illustration(document, [box])
    document.recompute()
    assert not obj.Message, obj.Message
    assert kernel.module().__file__.startswith(prefix), kernel.module().__file__
    export.export([obj], os.path.join(os.environ["BURIN_SCRATCH"], "addon.pdf"))
except BaseException:
    traceback.print_exc()
    sys.exit(1)
sys.exit(0)
PY
told=()
if [[ -z $home ]]; then
  home=$scratch/home
  told=(-M "$addon")  # in front FreeCAD 0.20 would end with a segmentation fault
fi
mkdir -p "$home"
rm -f "$scratch/addon.pdf"
env -u PYTHONPATH BURIN_PYTHON_PATH="${BURIN_KERNEL_FOLDER:-}" FREECAD_USER_HOME="$home" BURIN_PREFIX="$prefix" BURIN_ADDON="$addon" \
  BURIN_SCRATCH="$scratch" timeout 60 "$freecadcmd" "$scratch/addon.py" "${told[@]}" </dev/null >"$scratch/addon.log" 2>&1 || {
  cat "$scratch/addon.log" >&2
  exit 1
}
[[ $(head -c 5 "$scratch/addon.pdf") == %PDF- ]]
