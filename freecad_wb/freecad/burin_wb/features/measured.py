"""What faces, edges and vertices are, as far as something of them can be measured; the kernel does the measuring."""

import math
from collections import namedtuple

import FreeCAD
import Part

from ..text import tr

# kind: "plane", "line" (a straight edge), "round" (it has an axis), "tube" (a torus), "point", "other"; along: a normal, a way or an
# axis; turn: degrees that there are around the axis.
Measured = namedtuple("Measured", "kind at along turn")

# Sine of the angle below which the kernel takes two directions for parallel or square.
PARALLEL = 1e-6

# Share of the size of two features below which straight lines meet.
MEET = 1e-6

# More degrees of an arc or a cylinder than this have a diameter, fewer a radius, as drawings have it.
HALF_TURN = 180.5


def measured(shape):
    """Of a face, an edge or a vertex, in the coordinates that it has."""
    if shape.ShapeType == "Vertex":
        return Measured("point", shape.Point, None, 0.0)
    try:
        return _face(shape) if shape.ShapeType == "Face" else _edge(shape)
    except (TypeError, AttributeError, Part.OCCError, RuntimeError):  # a surface or a curve that FreeCAD has no class for
        return Measured("other", shape.BoundBox.Center, None, 0.0)


def _face(face):
    surface, u = face.Surface, face.ParameterRange
    turn = math.degrees(abs(u[1] - u[0]))
    if isinstance(surface, (Part.Cylinder, Part.Cone)):
        return Measured("round", surface.Center, surface.Axis, turn)
    if isinstance(surface, Part.Toroid):
        return Measured("tube", surface.Center, surface.Axis, turn)
    if isinstance(surface, Part.Sphere):
        return Measured("point", surface.Center, None, turn)
    plane = face.findPlane()
    if plane is None:
        return Measured("other", face.BoundBox.Center, None, 0.0)
    return Measured("plane", plane.Position, plane.Axis, 0.0)


def _edge(edge):
    curve = edge.Curve
    if isinstance(curve, Part.Circle):
        return Measured("round", curve.Center, curve.Axis, math.degrees(abs(edge.LastParameter - edge.FirstParameter)))
    if isinstance(curve, Part.Line):
        return Measured("line", edge.valueAt(edge.FirstParameter), curve.Direction, 0.0)
    return Measured("other", edge.BoundBox.Center, None, 0.0)


def ends_of(edge):
    """The two ends of a straight edge."""
    return [edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)]


def kind_of(shapes):
    """What features have, a word of the property Kind, and else why they have nothing: (kind, "") or ("", why)."""
    found = [measured(shape) for shape in shapes]
    if not found:
        return "Overall", ""
    if len(found) == 1:
        return _of_one(shapes[0], found[0])
    if len(found) == 2:
        return _of_two(*found, max(shape.BoundBox.DiagonalLength for shape in shapes))
    return "", tr("a dimension has one or two faces, edges or vertices; {0} are selected").format(len(found))


def _of_one(shape, one):
    if one.kind == "line":
        return "Distance", ""
    if one.kind == "tube":
        return "Radius", ""
    if one.kind == "round" or one.kind == "point" and shape.ShapeType == "Face":
        return ("Diameter" if one.turn > HALF_TURN or is_cone(shape) else "Radius"), ""
    why = {"plane": tr("a flat face alone has no dimension; select another face, edge or vertex too"),
           "point": tr("a vertex alone has no dimension; select another vertex, face or edge too")}
    return "", why.get(one.kind, tr("it is neither flat nor straight nor round, so nothing of it can be measured"))


def may_have(kind, shape):
    """Whether a round face or edge may have a diameter, a radius, a depth or a thread; surfaces that FreeCAD does not know are left to
    the kernel."""
    one, is_face = measured(shape), shape.ShapeType == "Face"
    if one.kind == "other":
        return True
    if one.kind == "round":
        return {"Radius": not is_cone(shape), "Depth": is_face}.get(kind, True)
    return kind == "Radius" if one.kind == "tube" else kind in ("Diameter", "Radius") and one.kind == "point" and is_face


def is_cone(shape):
    return shape.ShapeType == "Face" and isinstance(shape.Surface, Part.Cone)


def _of_two(one, other, size):
    if "other" in (one.kind, other.kind):
        return "", tr("one of both is neither flat nor straight nor round, so nothing is measured between them")
    near, planes = MEET * max(size, 1.0), (one.kind == "plane") + (other.kind == "plane")
    if "point" not in (one.kind, other.kind):
        sine, cosine = one.along.cross(other.along).Length, abs(one.along.dot(other.along))
        if (cosine if planes == 1 else sine) >= PARALLEL:
            return ("Distance" if not planes and _gap(one, other) > near else "Angle"), ""
    if _apart(one, other) > near:
        return "Distance", ""
    return "", tr("both are at one place, so they have no distance")


def _apart(one, other):
    """Of points, and of others that are parallel."""
    way = other.at - one.at
    for kind, length in (("plane", way.dot), ("line", way.cross), ("round", way.cross), ("tube", way.cross)):
        for each in (one, other):
            if each.kind == kind:
                found = length(each.along)
                return abs(found) if isinstance(found, float) else found.Length
    return way.Length


def _gap(one, other):
    """Between two straight lines that are not parallel."""
    return abs((other.at - one.at).dot(FreeCAD.Vector(one.along.cross(other.along)).normalize()))
