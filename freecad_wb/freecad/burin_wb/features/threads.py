"""Threads of the holes of bodies, which have no shape."""

import FreeCAD
import Part

_Z = FreeCAD.Vector(0, 0, 1)
# Model mm: deeper than any part, of holes that go through all.
_THROUGH = 1e6


def threads_of(leaf, matrix):
    """What `burin.Part.threads` takes of the holes of a body, up to its tip. `matrix`: where the body is."""
    if not leaf.isDerivedFrom("PartDesign::Body"):
        return ()
    found = []
    for feature in leaf.Group:
        if feature.isDerivedFrom("PartDesign::Hole"):
            found += _of_hole(feature, matrix)
        if feature == leaf.Tip:
            break
    return tuple(found)


def _of_hole(hole, matrix):
    if not hole.Threaded or getattr(hole, "ModelThread", False) or not hole.Profile:
        return []
    size, depth = _size(hole), float(getattr(hole, "ThreadDepth", _THROUGH))
    if hole.DepthType == "ThroughAll" and getattr(hole, "ThreadDepthType", "Hole Depth") == "Hole Depth":
        depth = _THROUGH
    sketch = hole.Profile[0]
    across = sketch.Placement.Rotation.multVec(_Z) * (1 if hole.Reversed else -1)
    found = []
    for i, geometry in enumerate(getattr(sketch, "Geometry", ())):
        if not isinstance(geometry, Part.Circle) or sketch.getConstruction(i):
            continue
        start = sketch.Placement.multVec(geometry.Center)
        at, end = matrix.multVec(start), matrix.multVec(start + across)
        found.append({"size": size, "at": tuple(at), "along": tuple(end - at), "length": depth})
    return found


def _size(hole):
    """As the kernel takes it: FreeCAD has sizes of unified threads without their series."""
    size = str(hole.ThreadSize)
    return size if size.startswith("M") else f"{size} {hole.ThreadType}"
