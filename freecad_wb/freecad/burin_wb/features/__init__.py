"""Objects of documents. Works without a GUI. The names here are a file-format contract: documents refer to
`freecad.burin_wb.features.Illustration`, `.SheetView` and `.FlatEdges`."""

from .flat_edges import FlatEdges, make_flat_edges
from .illustration import Illustration, is_illustration, make_illustration
from .repair import repair
from .sources import visible
from .sheet_view import SheetView, place_on_page

# The stored module name stays this package's, whatever file a class lives in.
for _class in (Illustration, SheetView, FlatEdges):
    _class.__module__ = __name__

__all__ = ["FlatEdges", "Illustration", "SheetView", "is_illustration", "make_flat_edges", "make_illustration", "place_on_page", "repair", "visible"]
