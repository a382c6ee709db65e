"""An illustration on a TechDraw page."""

import os

import FreeCAD

from .. import preferences
from ..proxy import Stateless
from ..tell import tell
from .free_place import EDGE, extent, free_place
from .properties import SHEET_VIEW, ensure
from .symbol import Window, parted, pixels_of, symbol_size, to_symbol, window_of

# A symbol whose scale is off by more is made anew.
WRONG = 1e-4

# FreeCAD's templates without a frame, from small to large: (name, width, height in mm).
BLANKS = (("A4_Landscape", 297, 210), ("A4_Portrait", 210, 297), ("A3_Landscape", 420, 297), ("A2_Landscape", 594, 420),
          ("A1_Landscape", 841, 594), ("A0_Landscape", 1189, 841))
# mm between sheets that share a page.
BETWEEN = 5.0


def blank_template(sheets=()):
    """The path of FreeCAD's own smallest template without a frame that holds all `sheets`, (width, height) in mm, in a row or in a
    column, off its edge; the largest where none does. A single sheet that is higher than wide gets A4 upright."""
    folder = os.path.join(FreeCAD.getResourceDir(), "Mod", "TechDraw", "Templates")
    widths, heights = zip(*sheets) if sheets else ((0,), (0,))
    gaps, edges = BETWEEN * (len(widths) - 1), 2 * EDGE
    needs = (sum(widths) + gaps + edges, max(heights) + edges), (max(widths) + edges, sum(heights) + gaps + edges)
    order = sorted(BLANKS, key=lambda blank: (blank[1] * blank[2], (blank[2] > blank[1]) != (heights[0] > widths[0])))
    fitting = [name for name, width, height in order if any(w <= width and h <= height for w, h in needs)] or [order[-1][0]]
    # FreeCAD 1.1 keeps its templates in folders by standard.
    files = [os.path.join(folder, *standard, name + "_blank.svg") for name in fitting for standard in (("ISO",), ())]
    return next(filter(os.path.isfile, files), files[-1])


def sheet_size(illustration):
    """(width, height) in mm."""
    return illustration.Width.Value, illustration.Height.Value


class SheetView(Stateless):
    """The Proxy of a DrawViewSymbolPython that follows an illustration at the scale of its own sheet. Documents name
    it as freecad.burin_wb.features.SheetView."""

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, SHEET_VIEW)

    def onDocumentRestored(self, obj):
        is_older = "Middle" not in obj.PropertiesList
        ensure(obj, SHEET_VIEW)
        if is_older and obj.Symbol and obj.Illustration is not None:
            obj.Middle = _middle(obj.Illustration, _whole(obj.Illustration))
        pixels = pixels_of(obj.Symbol)
        if pixels is not None and abs(pixels / preferences.pixels_per_mm() - 1) > WRONG:
            self.execute(obj)  # made for a FreeCAD that shows symbols at another scale
        elif parted(obj.Symbol) != obj.Symbol:
            obj.Symbol = parted(obj.Symbol)

    def execute(self, obj):
        source = obj.Illustration
        if source is None or not source.Picture:
            return
        with open(source.Picture, encoding="utf-8") as picture:
            svg = picture.read()
        window = window_of(svg, source.Width.Value, source.Height.Value, obj.Trim)
        symbol = to_symbol(svg, window)
        if symbol == obj.Symbol:
            return
        obj.Symbol = symbol
        self._stay(obj, _middle(source, window))

    @staticmethod
    def _stay(obj, middle):
        """TechDraw puts the middle of a symbol at X, Y. Where that is another place of the sheet than before, the view
        moves, so that what it shows does not."""
        moved = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), obj.Rotation.Value).multVec(middle - obj.Middle) * obj.Scale
        if moved.Length > 1e-9:
            obj.X, obj.Y = obj.X.Value + moved.x, obj.Y.Value + moved.y
            obj.Middle = middle


def _whole(illustration):
    return Window(0.0, 0.0, illustration.Width.Value, illustration.Height.Value)


def _middle(illustration, window):
    """From the middle of the sheet to the middle of a symbol of it, in mm, y up."""
    w, h = symbol_size(window)
    return FreeCAD.Vector(window.left + w / 2 - illustration.Width.Value / 2,
                          illustration.Height.Value / 2 - window.top - h / 2, 0)


def sheet_center(view):
    """Where on the page the middle of the illustration's sheet is, in mm."""
    return view.X.Value - view.Middle.x, view.Y.Value - view.Middle.y


def add_template(page, file):
    """A template, the path of a file, for a page without one."""
    template = page.Document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = file
    page.Template = template


def add_view(page, view):
    """Puts a view on a page. `addView` of FreeCAD 1.1 refuses views that are written in Python."""
    try:
        page.addView(view)
    except TypeError:
        page.Views = page.Views + [view]


def place_on_page(page, illustration, name="IllustrationView"):
    """A view of `illustration` on a TechDraw page: as near to the page's middle as there is room beside what lies there,
    inside the template's frame and off its title block. A page without a template gets a blank one that holds the
    sheet: TechDraw takes no views before. No transaction, no recompute."""
    if page.Template is None:
        add_template(page, blank_template([sheet_size(illustration)]))
    view = page.Document.addObject("TechDraw::DrawViewSymbolPython", name)
    SheetView(view)
    view.Illustration = illustration
    view.ScaleType = "Custom"
    view.Scale = 1.0
    SheetView.execute(view.Proxy, view)  # an empty symbol is complained of when it comes on the page
    add_view(page, view)
    size = extent(view) or sheet_size(illustration)
    place = free_place(page, *size, but=view)
    view.X, view.Y = place.x, place.y
    if not place.free:
        tell(
            f"{illustration.Label}: {page.Label} has no free space for its {size[0]:.0f} x {size[1]:.0f} mm beside what lies there; "
            "move it, make its Width and Height smaller, or choose a larger template")
    return view
