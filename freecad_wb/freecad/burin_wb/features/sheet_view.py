"""An illustration on a TechDraw page."""

import os

import FreeCAD

from .properties import SHEET_VIEW, ensure
from .symbol import symbol_size, to_symbol

TEMPLATE = ("Mod", "TechDraw", "Templates", "A3_Landscape_blank.svg")


class SheetView:
    """The Proxy of a DrawViewSymbolPython that follows an illustration at the scale of its own sheet. Documents name
    it as freecad.burin_wb.features.SheetView."""

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, SHEET_VIEW)

    def onDocumentRestored(self, obj):
        ensure(obj, SHEET_VIEW)

    def execute(self, obj):
        source = obj.Illustration
        if source is None or not source.Picture:
            return
        with open(source.Picture, encoding="utf-8") as picture:
            symbol = to_symbol(picture.read(), source.Width.Value, source.Height.Value)
        if symbol != obj.Symbol:
            obj.Symbol = symbol

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def sheet_center(view):
    """Where on the page the middle of the illustration's sheet is, in mm: a symbol is a whole number of pixels wide, a
    little more than the sheet that begins at its top left."""
    width, height = view.Illustration.Width.Value, view.Illustration.Height.Value
    w, h = symbol_size(width, height)
    return view.X.Value - (w - width) / 2, view.Y.Value + (h - height) / 2


def add_template(page, file=""):
    """A template for a page; A3 without a frame where no file is named."""
    template = page.Document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = file or os.path.join(FreeCAD.getResourceDir(), *TEMPLATE)
    page.Template = template


def place_on_page(page, illustration, name="IllustrationView"):
    """A view of `illustration` on a TechDraw page, in the page's middle. A page without a template gets A3 without a
    frame: TechDraw takes no views before. No transaction, no recompute."""
    if page.Template is None:
        add_template(page)
    view = page.Document.addObject("TechDraw::DrawViewSymbolPython", name)
    SheetView(view)
    view.Illustration = illustration
    view.ScaleType = "Custom"
    view.Scale = 1.0
    SheetView.execute(view.Proxy, view)  # an empty symbol is complained of when it comes on the page
    page.addView(view)
    return view
