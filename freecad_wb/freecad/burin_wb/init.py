"""Run by FreeCAD at every start, with or without a GUI: kept light."""

import FreeCAD

from freecad.burin_wb import offers

for _suffix in offers.kept()["formats"]:
    FreeCAD.addExportType(f"Burin {_suffix.upper()} (*.{_suffix})", "freecad.burin_wb.export")
