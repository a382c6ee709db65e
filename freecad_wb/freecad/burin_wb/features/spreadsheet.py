"""The parts list of an illustration as a spreadsheet of the document, and that on TechDraw pages."""

from ..text import tr
from .free_place import extent, free_place
from .sheet_view import add_view

WIDTHS = {"A": 50, "B": 200, "C": 70, "D": 80, "E": 260}  # pixels
_LINK = "Illustration"
# Paths of objects that a cell names.
SHOWN = 3


def sheet_of(obj):
    """The spreadsheet that holds the parts list of an illustration; nothing where there is none."""
    return next((o for o in obj.Document.Objects if o.isDerivedFrom("Spreadsheet::Sheet") and getattr(o, _LINK, None) is obj), None)


def write(obj, items):
    """Makes the spreadsheet of an illustration, or writes it anew: number, name, quantity, colour, source. Items as
    asking.items_of gives them. No transaction. Returns it."""
    sheet = sheet_of(obj)
    if sheet is None:
        sheet = obj.Document.addObject("Spreadsheet::Sheet", "PartsList")
        sheet.addProperty("App::PropertyLinkGlobal", _LINK, "Burin", "The illustration whose parts these are")
        sheet.Illustration = obj
        sheet.Label = tr("Parts list of {0}").format(obj.Label)
    _clear(sheet)
    for column, width in WIDTHS.items():
        sheet.setColumnWidth(column, width)
    rows = [(tr("No."), tr("Name"), tr("Quantity"), tr("Color"), tr("Source"))]
    rows += [(str(item["number"]), item["name"], str(item["quantity"]), item["color"], _source(item)) for item in items]
    for number, row in enumerate(rows, 1):
        for column, text in zip(WIDTHS, row):
            sheet.set(f"{column}{number}", text if column in "AC" and number > 1 else "'" + text)
    sheet.setStyle("A1:E1", "bold")
    sheet.recompute()
    for view in views_of(sheet):
        _show_all(view, len(rows))
        view.recompute()
    return sheet


def _clear(sheet):
    """Row by row: FreeCAD's clearAll takes the link to the illustration too."""
    row = 1
    while sheet.getContents(f"A{row}"):
        sheet.clear(f"A{row}:E{row}")
        row += 1


def _source(item):
    paths = item["sources"]
    return ", ".join(paths[:SHOWN]) + (f" + {len(paths) - SHOWN}" if len(paths) > SHOWN else "")


def views_of(sheet):
    """Where the spreadsheet lies on pages."""
    return [o for o in sheet.InList if o.isDerivedFrom("TechDraw::DrawViewSpreadsheet")]


def pages_of(obj):
    """The TechDraw pages that show an illustration."""
    views = [o for o in obj.InList if o.isDerivedFrom("TechDraw::DrawViewSymbol") and getattr(o, "Illustration", None) is obj]
    return [o for view in views for o in view.InList if o.isDerivedFrom("TechDraw::DrawPage")]


def place_on_page(page, sheet, rows):
    """The spreadsheet on a page, where there is room beside what lies there. Returns its view; that which is there already."""
    for view in page.Views:
        if getattr(view, "Source", None) is sheet:
            return view
    view = page.Document.addObject("TechDraw::DrawViewSpreadsheet", "PartsListView")
    view.Source = sheet
    view.TextSize = 9
    _show_all(view, rows)
    add_view(page, view)
    view.recompute()
    size = extent(view)
    if size is not None:
        place = free_place(page, *size, but=view)
        view.X, view.Y = place.x, place.y
    return view


def _show_all(view, rows):
    view.CellStart, view.CellEnd = "A1", f"E{rows}"
