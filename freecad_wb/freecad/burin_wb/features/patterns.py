"""Where patterns of PartDesign repeat their features."""

import math

import FreeCAD
import Part

_X, _Y, _Z = (FreeCAD.Vector(*axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
_ORIGIN = {"X_Axis": _X, "Y_Axis": _Y, "Z_Axis": _Z, "YZ_Plane": _X, "XZ_Plane": _Y, "XY_Plane": _Z}
_SKETCH_LINES = {"H_Axis": _X, "V_Axis": _Y, "N_Axis": _Z, "": _Z}
# A plane goes through the axis and stands on the sketch.
_SKETCH_PLANES = {"H_Axis": _Y, "V_Axis": _X, "N_Axis": _Z, "": _Z}
MOST = 10000


def is_pattern(feature):
    return feature.isDerivedFrom("PartDesign::Transformed")


def copies_of(pattern):
    """Matrices in the frame of the body, the original first; None where it refers to what is no line or plane."""
    if pattern.isDerivedFrom("PartDesign::MultiTransform"):
        found = [FreeCAD.Matrix()]
        for one in pattern.Transformations:
            copies = copies_of(one)
            if copies is None:
                return None
            found = [copy * before for copy in copies for before in found][:MOST]
        return found
    if pattern.isDerivedFrom("PartDesign::Mirrored"):
        plane = _reference(pattern.MirrorPlane, _SKETCH_PLANES)
        return plane and [FreeCAD.Matrix(), _mirrored(*plane)]
    polar = pattern.isDerivedFrom("PartDesign::PolarPattern")
    if not polar and not pattern.isDerivedFrom("PartDesign::LinearPattern"):
        return None
    line = _reference(pattern.Axis if polar else pattern.Direction, _SKETCH_LINES)
    if not line:
        return None
    count = min(pattern.Occurrences, MOST)
    step = (-1 if pattern.Reversed else 1) * _step(pattern, count, float(pattern.Angle if polar else pattern.Length), polar)
    return [_turned(*line, k * step) if polar else _moved(k * step * line[1]) for k in range(count)]


def _step(pattern, count, extent, polar):
    if str(getattr(pattern, "Mode", "")).lower() in ("spacing", "offset"):
        return float(pattern.Offset)
    return extent / max(count if polar and abs(extent) >= 360 else count - 1, 1)


def _reference(link, of_sketch):
    """A point and a direction of what a property names, in the frame of the body."""
    if not link or not link[0]:
        return None
    obj, sub = link[0], (list(link[1]) or [""])[0]
    if obj.isDerivedFrom("App::Line") or obj.isDerivedFrom("App::Plane"):
        return next(((FreeCAD.Vector(), way) for name, way in _ORIGIN.items() if obj.Name.startswith(name)), None)
    if obj.isDerivedFrom("PartDesign::Line") or obj.isDerivedFrom("PartDesign::Plane"):
        return obj.Placement.Base, obj.Placement.Rotation.multVec(_Z)
    if obj.isDerivedFrom("Sketcher::SketchObject") and sub in of_sketch:
        return obj.Placement.Base, obj.Placement.Rotation.multVec(of_sketch[sub])
    return _of_shape(obj, sub)


def _of_shape(obj, sub):
    """Of a straight or round edge, a flat or turned face."""
    try:
        shape = obj.Shape.getElement(sub)
    except Exception:  # whatever FreeCAD has for a name that is gone
        return None
    curve = shape.Curve if isinstance(shape, Part.Edge) else getattr(shape, "Surface", None)
    if isinstance(curve, Part.Line):
        return shape.Vertexes[0].Point, curve.Direction
    if isinstance(curve, Part.Circle):
        return curve.Center, curve.Axis
    if isinstance(curve, (Part.Plane, Part.Cylinder, Part.Cone)):
        return getattr(curve, "Center", None) or curve.Position, curve.Axis
    return None


def _moved(by):
    return FreeCAD.Placement(by, FreeCAD.Rotation()).toMatrix()


def _turned(point, axis, degrees):
    return FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(axis, degrees), point).toMatrix()


def _mirrored(point, normal):
    """Mirrored at a plane."""
    n = normal / math.sqrt(normal.dot(normal))
    rows = [[(i == k) - 2 * n[i] * n[k] for k in range(3)] + [2 * point.dot(n) * n[i]] for i in range(3)]
    return FreeCAD.Matrix(*rows[0], *rows[1], *rows[2], 0, 0, 0, 1)
