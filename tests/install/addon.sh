#!/usr/bin/env bash
# addon.sh ADDON SCRATCH PREFIX: FreeCAD loads an installed add-on, which draws with the kernel below PREFIX.
set -euo pipefail
addon=$1 scratch=$2 prefix=$3
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
    assert features.__file__.startswith(os.environ["BURIN_ADDON"]), features.__file__
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
mkdir -p "$scratch/home"
# With -M in front FreeCAD 0.20 ends with a segmentation fault.
env -u BURIN_PYTHON_PATH -u PYTHONPATH FREECAD_USER_HOME="$scratch/home" BURIN_PREFIX="$prefix" BURIN_ADDON="$addon" \
  BURIN_SCRATCH="$scratch" timeout 60 "$freecadcmd" "$scratch/addon.py" -M "$addon" </dev/null >"$scratch/addon.log" 2>&1 || {
  cat "$scratch/addon.log" >&2
  exit 1
}
[[ $(head -c 5 "$scratch/addon.pdf") == %PDF- ]]
