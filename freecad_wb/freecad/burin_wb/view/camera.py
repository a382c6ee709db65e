"""The camera of a 3-D view."""

import math

import FreeCAD

from ..features.eye import Eye


def camera_of(view):
    """From where a 3-D view shows the model; nothing where the view has no camera."""
    if view is None or not hasattr(view, "getCameraNode"):
        return None
    rotation = view.getCameraOrientation()
    direction = rotation.multVec(FreeCAD.Vector(0, 0, 1))
    up = rotation.multVec(FreeCAD.Vector(0, 1, 0))
    angle = 0.0
    if view.getCameraType() == "Perspective":
        angle = math.degrees(view.getCameraNode().heightAngle.getValue())
    return Eye(direction, up, angle)
