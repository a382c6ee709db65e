"""Threads of the holes of bodies, which have no shape."""

import FreeCAD
import Part

from .patterns import copies_of, is_pattern

_Z = FreeCAD.Vector(0, 0, 1)
# Model mm: deeper than any part, of holes that go through all.
_THROUGH = 1e6


def threads_of(leaf, matrix):
    """What `burin.Part.threads` takes of the holes of a body and their copies in patterns, up to its tip. `matrix`: where the body is."""
    if not leaf.isDerivedFrom("PartDesign::Body"):
        return ()
    found = []
    for feature in leaf.Group:
        if feature.isDerivedFrom("PartDesign::Hole"):
            found += [(feature, thread) for thread in _of_hole(feature)]
        elif is_pattern(feature):
            found += _of_pattern(feature, found)
        if feature == leaf.Tip:
            break
    return tuple(_placed(thread, matrix) for _, thread in found)


def _of_pattern(pattern, found):
    """Copies of the threads that its originals have, or, of patterns of the whole shape, of all."""
    whole = str(getattr(pattern, "TransformMode", "")).lower().endswith("shape")
    repeated = [thread for feature, thread in found if whole or feature in pattern.Originals]
    copies = copies_of(pattern) if repeated else None
    return [(pattern, _placed(thread, copy)) for copy in (copies or ())[1:] for thread in repeated]


def _placed(thread, matrix):
    at = FreeCAD.Vector(*thread["at"])
    start, end = matrix.multVec(at), matrix.multVec(at + FreeCAD.Vector(*thread["along"]))
    return {**thread, "at": tuple(start), "along": tuple(end - start)}


def _of_hole(hole):
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
        found.append({"size": size, "at": tuple(start), "along": tuple(across), "length": depth})
    return found


def _size(hole):
    """As the kernel takes it: FreeCAD has sizes of unified threads without their series."""
    size = str(hole.ThreadSize)
    return size if size.startswith("M") else f"{size} {hole.ThreadType}"
