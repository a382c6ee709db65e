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


def of_face(face):
    """Square onto a flat or curved face, at its middle; up stays up where that can be."""
    u0, u1, v0, v1 = face.ParameterRange
    normal = face.normalAt((u0 + u1) / 2, (v0 + v1) / 2)
    up = FreeCAD.Vector(0, 0, 1)
    if abs(normal.dot(up)) > 0.999:  # seen from above or below: as in the standard views
        up = FreeCAD.Vector(0, 1, 0)
    return Eye(normal, up, 0.0)


def face_of(obj, sub):
    """A face by its way ('Inner.Box.Face3') from `obj`, in global coordinates."""
    return Part.getShape(*from_the_top(obj, sub), needSubElement=True, transform=True)


def set_view(obj, eye):
    obj.ViewDirection, obj.ViewUp = eye.direction, eye.up
    obj.Projection = "Perspective" if eye.angle else "Orthographic"
    if eye.angle:
        obj.FieldOfView = eye.angle
