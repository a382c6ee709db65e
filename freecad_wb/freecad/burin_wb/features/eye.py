"""From where an illustration is seen."""

import collections

import FreeCAD
import Part

from .. import offers
from .sources import from_the_top

# direction: from the model to the viewer; angle: vertical field of view in degrees, 0 = parallel.
Eye = collections.namedtuple("Eye", "direction up angle")


def standards():
    """Names of the standard views."""
    return list(offers.kept()["views"])


def standard(name):
    direction, up = offers.kept()["views"][name]
    return Eye(FreeCAD.Vector(*direction), FreeCAD.Vector(*up), 0.0)


def of_face(face, solid=None):
    """Square onto a flat or curved face, at its middle; up stays up where that can be. `solid`: the shape that it is of."""
    u0, u1, v0, v1 = face.ParameterRange
    normal = face.normalAt((u0 + u1) / 2, (v0 + v1) / 2)
    if solid is not None and solid.Solids and _is_inward(face, solid):
        normal = -normal
    up = FreeCAD.Vector(0, 0, 1)
    if abs(normal.dot(up)) > 0.999:  # seen from above or below: as in the standard views
        up = FreeCAD.Vector(0, 1, 0)
    return Eye(normal, up, 0.0)


# Places on a face that are tried, as shares of its parameters: the middle may lie in a hole of it.
_SHARES = (0.5, 0.3, 0.7, 0.1, 0.9)


def _is_inward(face, solid):
    """Whether the normals of a face point into its solid: those of mirrored links do."""
    u0, u1, v0, v1 = face.ParameterRange
    step = 1e-4 * face.BoundBox.DiagonalLength
    for a in _SHARES:
        for b in _SHARES:
            u, v = u0 + a * (u1 - u0), v0 + b * (v1 - v0)
            if face.isPartOfDomain(u, v):
                place, off = face.valueAt(u, v), face.normalAt(u, v) * step
                return solid.isInside(place + off, step / 10, False) and not solid.isInside(place - off, step / 10, False)
    return False


def face_of(obj, sub):
    """A face by its way ('Inner.Box.Face3') from `obj`, and the shape that it is of, in global coordinates."""
    top, sub = from_the_top(obj, sub)
    return (Part.getShape(top, sub, needSubElement=True, transform=True),
            Part.getShape(top, sub[: sub.rfind(".") + 1], needSubElement=False, transform=True))


def set_view(obj, eye):
    """One view from there; several are one no more."""
    obj.Views = []
    obj.ViewDirection, obj.ViewUp = eye.direction, eye.up
    obj.Projection = "Perspective" if eye.angle else "Orthographic"
    if eye.angle:
        obj.FieldOfView = eye.angle
