"""An illustration on a TechDraw page."""

import os

import FreeCAD

from .. import preferences
from ..tell import tell
from .free_place import extent, free_place
from .properties import SHEET_VIEW, ensure
from .symbol import Window, parted, pixels_of, symbol_size, to_symbol, window_of

# A symbol whose scale is off by more is made anew.
WRONG = 1e-4

# FreeCAD 1.1 keeps its templates in folders by standard.
TEMPLATES = (("ISO", "A3_Landscape_blank.svg"), ("A3_Landscape_blank.svg",))


def blank_template():
    """FreeCAD's own template of A3 without a frame."""
    folder = os.path.join(FreeCAD.getResourceDir(), "Mod", "TechDraw", "Templates")
    files = [os.path.join(folder, *names) for names in TEMPLATES]
    return next(filter(os.path.isfile, files), files[-1])


class SheetView:
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

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


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


def add_template(page, file=""):
    """A template for a page; A3 without a frame where no file is named."""
    template = page.Document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = file or blank_template()
    page.Template = template


def add_view(page, view):
    """Puts a view on a page. `addView` of FreeCAD 1.1 refuses views that are written in Python."""
    try:
        page.addView(view)
    except TypeError:
        page.Views = page.Views + [view]


def place_on_page(page, illustration, name="IllustrationView"):
    """A view of `illustration` on a TechDraw page: as near to the page's middle as there is room beside what lies there,
    inside the template's frame and off its title block. A page without a template gets A3 without a frame: TechDraw takes
    no views before. No transaction, no recompute."""
    if page.Template is None:
        add_template(page)
    view = page.Document.addObject("TechDraw::DrawViewSymbolPython", name)
    SheetView(view)
    view.Illustration = illustration
    view.ScaleType = "Custom"
    view.Scale = 1.0
    SheetView.execute(view.Proxy, view)  # an empty symbol is complained of when it comes on the page
    add_view(page, view)
    size = extent(view) or (illustration.Width.Value, illustration.Height.Value)
    place = free_place(page, *size, but=view)
    view.X, view.Y = place.x, place.y
    if not place.free:
        tell(
            f"{illustration.Label}: {page.Label} has no free space for its {size[0]:.0f} x {size[1]:.0f} mm beside what lies there; "
            "move it, make its Width and Height smaller, or choose a larger template")
    return view
