"""The lines of an illustration as edges in a plane, for TechDraw: dimensions, hatches and DXF work on them."""

import FreeCAD
import Part

from ..proxy import Stateless
from ..tell import NOTE, tell
from .curves import edges_of
from .properties import FLAT_EDGES, ensure, is_newer
from .sheet import Sheet
from .sheet_view import add_template, add_view, blank_template, sheet_center, sheet_size

# Edges stay this near to the drawn lines, in mm of paper: half the finest pen's width is 0.06.
TOLERANCE = 0.02

# Kinds of paths that are no lines of the model: numbers with their leaders, lists, the ways of an exploded view, threads; and hatching.
NOTES, STROKES = ("leader", "frame", "trail", "centre", "thread", "thread-end"), ("stroke", "pattern")


class FlatEdges(Stateless):
    """The Proxy of a Part::FeaturePython: an illustration's lines in the XY plane, in mm of the model as projected,
    the middle of the sheet at the origin. Documents name it as freecad.burin_wb.features.FlatEdges."""

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, FLAT_EDGES)

    def onDocumentRestored(self, obj):
        ensure(obj, FLAT_EDGES)
        _show_plainly(obj)

    def execute(self, obj):
        source = obj.Illustration
        if is_newer(obj) or source is None or not source.Drawing:
            return
        sheet = Sheet(source.Drawing)
        edges = []
        for _, path in sheet.paths():
            if path["kind"] in NOTES or path["kind"] in STROKES and not obj.Strokes or not path["visible"] and not obj.Hidden:
                continue
            edges.extend(edges_of([sheet.flat(p) for p in path["points"]], path["closed"], TOLERANCE / sheet.scale))
        obj.Shape = Part.makeCompound(edges)
        for view in obj.InList:
            if view.isDerivedFrom("TechDraw::DrawViewPart"):
                fit(view, obj, sheet)


def _show_plainly(flat):
    """Without a view provider of its own FreeCAD shows a shape only where that is said."""
    if flat.ViewObject is not None and flat.ViewObject.Proxy is None:
        flat.ViewObject.Proxy = 0


def fit(view, flat, sheet):
    """Puts a TechDraw view over the illustration's own view on the same page, else leaves its place alone."""
    if view.Scale != sheet.scale:
        view.Scale = sheet.scale
    page = next((o for o in view.InList if o.isDerivedFrom("TechDraw::DrawPage")), None)
    beside = [v for v in page.Views if getattr(v, "Illustration", None) is flat.Illustration] if page else []
    if not beside or not flat.Shape.Edges:
        return
    x, y = sheet_center(beside[0])
    # TechDraw puts the middle of what it shows at X, Y.
    middle = flat.Shape.optimalBoundingBox(False).Center
    view.X, view.Y = x + middle.x * sheet.scale, y + middle.y * sheet.scale


def make_flat_edges(page, illustration, name="IllustrationLines"):
    """A TechDraw view of `illustration`'s lines on `page`: an ordinary DrawViewPart, whose dimensions tell the projected
    lengths in the model. It lies over the illustration's own view where that is on the page. Returns the view. No
    transaction, no recompute."""
    if page.Template is None:
        add_template(page, blank_template([sheet_size(illustration)]))
    document = page.Document
    flat = document.addObject("Part::FeaturePython", name)
    FlatEdges(flat)
    flat.Illustration = illustration
    _show_plainly(flat)
    if flat.ViewObject is not None:
        flat.ViewObject.Visibility = False  # on the page, not in the model
    view = document.addObject("TechDraw::DrawViewPart", name + "View")
    view.Source = [flat]
    view.Direction, view.XDirection = FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(1, 0, 0)
    view.ScaleType = "Custom"
    add_view(page, view)
    flat.Proxy.execute(flat)
    if illustration.Drawing and Sheet(illustration.Drawing).box is not None:
        tell(f"{illustration.Label}: the lines of the first view are there to be measured; those of other views and of details, which have other "
             "scales and places, are left out", NOTE)
    return view
