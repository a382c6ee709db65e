"""Objects that FreeCAD saved without the add-on: all their properties, and no behaviour."""

from .dimension import Dimension
from .flat_edges import FlatEdges
from .illustration import Illustration
from .sheet_view import SheetView

# What tells an object that has lost its Proxy: its type, and properties that all versions of it have.
_KINDS = (
    (Illustration, "App::FeaturePython", {"Sources", "Drawing", "Inputs", "Schema"}),
    (Dimension, "App::FeaturePython", {"Kind", "Features", "Tolerance", "Schema"}),
    (SheetView, "TechDraw::DrawViewSymbolPython", {"Illustration", "Schema"}),
    (FlatEdges, "Part::FeaturePython", {"Illustration", "Strokes", "Hidden", "Schema"}),
)


def _kind(obj):
    if getattr(obj, "Proxy", 0) is None:
        for kind, type_name, names in _KINDS:
            if obj.TypeId == type_name and names <= set(obj.PropertiesList):
                return kind
    return None


def repair(document):
    """Gives illustrations, their dimensions and notes, their views on pages and their flat lines the behaviour back that they lost where they were
    saved without the add-on. Returns the objects, illustrations first."""
    lost = [(kind, o) for kind, _, _ in _KINDS for o in document.Objects if _kind(o) is kind]
    for kind, obj in lost:
        obj.Proxy = kind.__new__(kind)
        obj.Proxy.onDocumentRestored(obj)
    return [obj for _, obj in lost]
