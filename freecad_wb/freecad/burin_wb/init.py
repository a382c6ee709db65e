"""Run by FreeCAD at every start, with or without a GUI: kept light."""

import FreeCAD

for _text, _suffix in (("Burin SVG", "svg"), ("Burin PDF", "pdf"), ("Burin PNG", "png"), ("Burin EPS", "eps"),
                       ("Burin DXF", "dxf"), ("Burin drawing", "json")):
    FreeCAD.addExportType(f"{_text} (*.{_suffix})", "freecad.burin_wb.export")
