"""An illustration on a TechDraw page."""

from .properties import SHEET_VIEW, ensure
from .symbol import to_symbol


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


def place_on_page(page, illustration, name="IllustrationView"):
    """A view of `illustration` on a TechDraw page, in the page's middle. No transaction, no recompute."""
    view = page.Document.addObject("TechDraw::DrawViewSymbolPython", name)
    SheetView(view)
    view.Illustration = illustration
    view.ScaleType = "Custom"
    view.Scale = 1.0
    SheetView.execute(view.Proxy, view)  # an empty symbol is complained of when it comes on the page
    page.addView(view)
    return view
