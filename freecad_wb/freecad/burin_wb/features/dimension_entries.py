"""Dimensions as illustration files have them, as objects of the document."""

import FreeCAD
import Part

from ..errors import Refused
from .dimension import OVERALL, kinds, make_dimension, tolerance_text
from .sources import survey

# Model mm: how far a vertex may be from the point of a file, which has rounded numbers.
NEAR = 1e-3

# Keys that properties have: the key, the property, and how its value becomes that of the property.
_VALUES = (("along", "Along", lambda way: FreeCAD.Vector(*way)), ("supplement", "Supplement", bool), ("text", "Text", str),
           ("tolerance", "Tolerance", tolerance_text), ("decimals", "Decimals", int), ("view", "View", str))
_KINDS = {"face": "Faces", "edge": "Edges"}


def add_entries(obj, entries, paths, notes):
    """Makes the dimensions of an illustration file. `paths(selector)`: paths of the objects that it means. What has no object here is
    told."""
    for number, entry in enumerate(entries, 1):
        if entry == "none":
            continue
        try:
            _add(obj, entry, paths, notes, number)
        except Refused as why:
            notes.append(f"dimension {number}: {why}, so it is left out")


def _add(obj, entry, paths, notes, number):
    if entry == OVERALL.lower():
        make_dimension(obj)
        return
    kind = next(kind for kind in kinds() if kind.lower() in entry)
    said = entry[kind.lower()]
    pair = isinstance(said, list) and not _is_point(said)
    properties = {name: made(entry[key]) for key, name, made in _VALUES if key in entry}
    left = [key for key in ("unit", "sign") if key in entry]
    if left:
        notes.append(f"dimension {number}: {' and '.join(left)}: the style has it here (dimension.unit, dimension.sign)")
    make_dimension(obj, [_found(obj, one, paths) for one in (said if pair else [said])], kind, **properties)


def _is_point(said):
    return isinstance(said, list) and isinstance(said[0], (int, float))


def _found(obj, said, paths):
    """(object, sub-name) of a feature. Throws Refused."""
    if _is_point(said):
        said = {"face": said}
    if "point" in said:
        return _nearest(obj, said["point"], "Vertexes", None, NEAR)
    key = next(key for key in _KINDS if key in said)
    chosen = paths(said["part"]) if "part" in said else None
    if _is_point(said[key]):
        return _nearest(obj, said[key], _KINDS[key], chosen, float("inf"))
    if chosen is None or len(chosen) != 1:
        raise Refused(f"the document has no object that alone is '{said.get('part', '')}'")
    top, _, sub = chosen[0].partition(".")
    return obj.Document.getObject(top), (sub + "." if sub else "") + f"{key.capitalize()}{said[key] + 1}"


def _nearest(obj, at, kind, chosen, most):
    """The face, edge or vertex at a point. Throws Refused."""
    point, best = Part.Vertex(FreeCAD.Vector(*at)), (most, None)
    for piece in survey(obj.Sources)[0]:
        if piece.shape is None or chosen is not None and piece.part.source not in chosen:
            continue
        for number, element in enumerate(getattr(piece.shape, kind), 1):
            distance = element.distToShape(point)[0]
            if distance < best[0]:
                best = distance, (piece.top, piece.sub + f"{'Vertex' if kind == 'Vertexes' else kind[:-1]}{number}")
    if best[1] is None:
        raise Refused(f"the document has no {'vertex' if kind == 'Vertexes' else kind[:-1].lower()} at {', '.join(f'{a:g}' for a in at)}")
    return best[1]
