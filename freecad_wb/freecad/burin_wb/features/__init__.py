"""Objects of documents. Works without a GUI. The names here are a file-format contract: documents refer to
`freecad.burin_wb.features.Illustration`, `.Dimension`, `.SheetView` and `.FlatEdges`."""

from .dimension import Dimension, is_dimension, make_dimension, make_note
from .flat_edges import FlatEdges, make_flat_edges
from .illustration import Illustration, is_illustration, make_illustration
from .repair import repair
from .sources import visible
from .sheet_view import SheetView, place_on_page

# The stored module name stays this package's, whatever file a class lives in.
for _class in (Illustration, Dimension, SheetView, FlatEdges):
    _class.__module__ = __name__

__all__ = ["Dimension", "FlatEdges", "Illustration", "SheetView", "is_dimension", "is_illustration", "make_dimension", "make_flat_edges",
           "make_illustration", "make_note", "place_on_page", "repair", "visible"]
