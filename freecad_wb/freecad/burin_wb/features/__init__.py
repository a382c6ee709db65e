"""Objects of documents. Works without a GUI. The names here are a file-format contract: documents refer to
`freecad.burin_wb.features.Illustration`, `.SheetView` and `.FlatEdges`."""

from .illustration import Illustration, is_illustration, make_illustration, repair
from .sheet_view import SheetView, place_on_page

# The stored module name stays this package's, whatever file a class lives in.
for _class in (Illustration, SheetView):
    _class.__module__ = __name__

__all__ = ["Illustration", "SheetView", "is_illustration", "make_illustration", "place_on_page", "repair"]
