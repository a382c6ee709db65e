"""What is kept of a measured face, edge or vertex, so that it is found again in a shape whose numbers have changed. FreeCAD 0.20 keeps
numbers alone; those of a step of a body are not those of the whole body in any release."""

import collections
import hashlib
import math

import FreeCAD
import Part

LISTS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}

# Share of the size of a shape, and sine of an angle: below it places and directions are the same, which FreeCAD computes anew to
# 1e-7 mm and keeps with 15 digits.
NEAR = 1e-6

# Shapes of which the Whole is known from the last time.
MOST = 64

# A shape as a whole: a word for which faces have which edges and vertices, by numbers; and where its vertices are.
Whole = collections.namedtuple("Whole", "structure spread")

_known = collections.OrderedDict()  # place -> (shape, its Whole)


def split(name):
    """"Face7" as ("Face", 7)."""
    kind = name.rstrip("0123456789")
    return kind, int(name[len(kind):])


def own(shape):
    """A shape in its own coordinates: moving it is no change."""
    base = Part.Shape(shape)
    base.Placement = FreeCAD.Placement()
    return base


def element(shape, name):
    """The element of a shape that has a name; nothing where there is none."""
    kind, number = split(name)
    found = getattr(shape, LISTS[kind])
    return found[number - 1] if 0 < number <= len(found) else None


def keep(shape, name, place):
    """What is kept of an element, as JSON has it. `shape`: in its own coordinates; `place`: words for where it is."""
    whole = whole_of(shape, place)
    return {"name": name, "in": whole.structure, "spread": whole.spread, "like": print_of(element(shape, name))}


def find(shape, kept, place):
    """The name that an element has now; empty where nothing is like it, or several are. While the structure of its shape is the same,
    its number counts, for sizes and places may change; but steps that change places number the same shape in another order."""
    kind, _ = split(kept["name"])
    whole = whole_of(shape, place)
    if whole.structure != kept["in"]:
        return like(shape, kind, kept["like"])
    near = _near(shape)
    is_same = _is_equal(print_of(element(shape, kept["name"])), kept["like"], near, near * _size(shape))
    if is_same or not _is_spread(whole.spread, kept["spread"], near):
        return kept["name"]
    return like(shape, kind, kept["like"]) or kept["name"]


def in_other(shape, name, wanted):
    """The name of an element in a shape of the same coordinates, most often the one that it has. Empty as `like`."""
    there = element(shape, name)
    if there is not None and _is_equal(print_of(there), wanted, _near(shape), _near(shape) * _size(shape)):
        return name
    return like(shape, split(name)[0], wanted)


def like(shape, kind, wanted):
    """The only element that lies there on the same surface, curve or point, else the only one there of the same size and middle: a
    chamfer beside a face leaves it where it is. Empty where there is none, or several."""
    near = _near(shape)
    there = []
    for number, one in enumerate(getattr(shape, LISTS[kind]), 1):
        name, on = _lies_on(one)
        if name == wanted["kind"] and _same(on, wanted["on"], near):
            found = print_of(one)
            if _meet(found["box"], wanted["box"], near):
                there.append((f"{kind}{number}", found))
    if len(there) == 1 and wanted["on"]:
        return there[0][0]
    equal = [name for name, found in there if _is_equal(found, wanted, near, near * _size(shape))]
    return equal[0] if len(equal) == 1 else ""


def _meet(one, other, near):
    """Whether two boxes have more in common than a border."""
    for low, high, other_low, other_high in zip(one[:3], one[3:], other[:3], other[3:]):
        is_thin = min(high - low, other_high - other_low) <= 10 * near
        if min(high, other_high) - max(low, other_low) <= (-near if is_thin else near):
            return False
    return True


def _size(shape):
    return max(1.0, shape.BoundBox.DiagonalLength)


def _near(shape):
    return NEAR * _size(shape)


def _is_equal(one, other, near, near_size):
    return one["kind"] == other["kind"] and _same(one["on"], other["on"], near) and _same(one["middle"], other["middle"], near) \
        and abs(one["size"] - other["size"]) <= near_size


def _same(one, other, near):
    return len(one) == len(other) and all(abs(a - b) <= near for a, b in zip(one, other))


def whole_of(shape, place):
    """Cost: 0.1 s for 1000 faces, where the shape is new."""
    known = _known.pop(place, None)
    if known is None or not (known[0].isPartner(shape) and known[0].Orientation == shape.Orientation):
        known = shape, Whole(_structure(shape), _spread(shape))
    _known[place] = known
    while len(_known) > MOST:
        _known.popitem(last=False)
    return known[1]


def forget(document):
    """Lets go of the shapes of a document that is closed, by its name."""
    for place in [place for place in _known if place[0] == document]:
        del _known[place]


def _structure(shape):
    numbers, said = {}, []

    def number(one):
        return numbers.setdefault((one.ShapeType, one.hashCode()), len(numbers))

    for face in shape.Faces:
        said.append((_surface(face), [number(edge) for edge in face.Edges], [number(vertex) for vertex in face.Vertexes]))
    said.append((len(shape.Edges), len(shape.Vertexes)))
    return hashlib.sha256(repr(said).encode()).hexdigest()[:16]


def _spread(shape):
    """The middle of all vertices, and how far they are spread about it: the same in whatever order they are."""
    points = [tuple(vertex.Point) for vertex in shape.Vertexes]
    middle = [sum(axis) / len(points) for axis in zip(*points)]
    off = [[at - center for at, center in zip(point, middle)] for point in points]
    return [[_number(n) for n in middle], [_number(sum(point[i] * point[k] for point in off)) for i in range(3) for k in range(i, 3)]]


def _is_spread(one, other, near):
    return _same(one[0], other[0], near) and _same(one[1], other[1], NEAR * max(map(abs, [1.0, *one[1]])))


def _surface(face):
    try:
        return type(face.Surface).__name__
    except (TypeError, AttributeError, Part.OCCError, RuntimeError):  # FreeCAD has no class for it
        return "other"


def _lies_on(one):
    kind, on = {"Face": _of_face, "Edge": _of_edge, "Vertex": _of_vertex}[one.ShapeType](one)
    return kind, _numbers(*on)


def print_of(one):
    """`on`: numbers that are the same for all that lies on one surface or curve; none where that is not told."""
    kind, on = _lies_on(one)
    size = {"Face": lambda: one.Area, "Edge": lambda: one.Length, "Vertex": lambda: 0.0}[one.ShapeType]()
    middle = one.Point if one.ShapeType == "Vertex" else one.CenterOfMass
    box = one.BoundBox
    return {"kind": kind, "on": on, "size": _number(size), "middle": _numbers(middle),
            "box": _numbers(box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)}


def _number(value):
    return float(f"{value:.12g}") + 0.0


def _numbers(*values):
    return [_number(n) for value in values for n in (value if isinstance(value, FreeCAD.Vector) else (value,))]


def _of_vertex(vertex):
    return "point", (vertex.Point,)


_ROUND = Part.Cylinder, Part.Cone, Part.Sphere, Part.Toroid


def _of_face(face):
    kind = _surface(face)
    if kind == "other":
        return kind, ()
    surface = face.Surface
    plane = surface if isinstance(surface, Part.Plane) else None if isinstance(surface, _ROUND) else face.findPlane()
    if plane is not None:
        normal = _normal(face)
        return "plane", (normal, normal.dot(plane.Position))
    if isinstance(surface, Part.Cylinder):
        return kind, (_foot(surface.Center, surface.Axis), _line(surface.Axis), surface.Radius, _side(face, surface.Center, surface.Axis))
    if isinstance(surface, Part.Cone):
        return kind, (surface.Apex, _line(surface.Axis), abs(surface.SemiAngle), _side(face, surface.Center, surface.Axis))
    if isinstance(surface, Part.Sphere):
        return kind, (surface.Center, surface.Radius, _side(face, surface.Center))
    if isinstance(surface, Part.Toroid):
        return kind, (surface.Center, _line(surface.Axis), surface.MajorRadius, surface.MinorRadius)
    return kind, ()


def _of_edge(edge):
    try:
        curve = edge.Curve
    except (TypeError, AttributeError, Part.OCCError, RuntimeError):
        return "other", ()
    if isinstance(curve, Part.Line):
        return "Line", (_foot(edge.valueAt(edge.FirstParameter), curve.Direction), _line(curve.Direction))
    if isinstance(curve, Part.Circle):
        return "Circle", (curve.Center, _line(curve.Axis), curve.Radius)
    return type(curve).__name__, ()


def _middle_of(face):
    u0, u1, v0, v1 = face.ParameterRange
    return (u0 + u1) / 2, (v0 + v1) / 2


def _normal(face):
    return face.normalAt(*_middle_of(face))


def _side(face, center, axis=None):
    """1 where a round face looks outwards, -1 in a hole."""
    way = face.valueAt(*_middle_of(face)) - center
    if axis is not None:
        way = way - axis * way.dot(axis)
    return math.copysign(1.0, _normal(face).dot(way))


def _foot(point, axis):
    """The point of a line that is nearest to the origin."""
    return point - axis * point.dot(axis)


def _line(axis):
    """One of both directions of a line."""
    first = next((a for a in axis if abs(a) > NEAR), 1.0)
    return axis * math.copysign(1.0, first)
