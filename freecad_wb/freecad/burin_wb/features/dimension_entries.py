"""Dimensions and notes as illustration files have them, as objects of the document."""

import FreeCAD
import Part

from ..errors import Refused
from .chosen import numbers_of_path
from .dimension import OVERALL, kinds, make_dimension, make_note, tolerance_text
from .note import option_of
from .sources import survey

# Model mm: how far a vertex may be from the point of a file, which has rounded numbers.
NEAR = 1e-3

# Keys that properties have: the key, the property, and how its value becomes that of the property.
_VALUES = (("along", "Along", lambda way: FreeCAD.Vector(*way)), ("supplement", "Supplement", bool), ("text", "Text", str),
           ("tolerance", "Tolerance", tolerance_text), ("decimals", "Decimals", int), ("view", "View", str), ("frame", "Frame", bool),
           ("symbol", "Symbol", str), ("mark", "Mark", str.capitalize), ("place", "Place", lambda at: FreeCAD.Vector(*at, 0)))
_KINDS = {"face": "Faces", "edge": "Edges"}


def add_entries(obj, told, paths, notes):
    """Makes the dimensions and notes of an illustration file. `paths(selector, what)`: paths of the objects that it means. What has no object
    here is told."""
    for key, what, add in (("dimensions", "dimension", _add), ("notes", "note", _add_note)):
        for number, entry in enumerate(told[key], 1):
            if entry == "none":
                continue
            said = []
            try:
                add(obj, entry, lambda selector, what=what: paths(selector, what), said)
            except Refused as why:
                said.append(f"{why}, so it is left out")
            notes.extend(f"{what} {number}: {text}" for text in said)


def _add(obj, entry, paths, notes):
    if entry == OVERALL.lower():
        make_dimension(obj)
        return
    kind = next(kind for kind in kinds() if kind.lower() in entry)
    said = entry[kind.lower()]
    pair = isinstance(said, list) and not _is_point(said)
    make_dimension(obj, [_found(obj, one, paths) for one in (said if pair else [said])], kind, **_properties(entry, notes))


def _properties(entry, notes):
    left = [key for key in ("unit", "sign") if key in entry]
    if left:
        notes.append(f"{' and '.join(left)}: the style has it here (dimension.unit, dimension.sign)")
    return {name: made(entry[key]) for key, name, made in _VALUES if key in entry}


def _add_note(obj, entry, paths, notes):
    entry = _spelled_out(entry) if isinstance(entry, str) else entry
    at = entry.get("at", [])
    targets = [at] if not isinstance(at, list) or _is_point(at) else at
    keys = {key: option_of(value) for key, value in entry.items() if key.startswith(entry.get("symbol", "") + "_")}
    make_note(obj, [_target(obj, one, paths, notes) for one in targets], SymbolKeys=keys, **_properties(entry, notes))


def _spelled_out(text):
    """"NAME=TEXT" or "X,Y,Z=TEXT"; a selector may have a sign of its own, @color=#ff0000."""
    at = text.index("=", text.index("=") + 1 if text.startswith("@") else 0)
    what, words = text[:at], text[at + 1:].replace("\\n", "\n")
    try:
        point = [float(number) for number in what.split(",")]
    except ValueError:
        point = []
    return {"at": point if len(point) == 3 else what, "text": words}


def _target(obj, said, paths, notes):
    """(object, sub-name) of what a note points at. Throws Refused."""
    selector = said if isinstance(said, str) else said.get("part") if isinstance(said, dict) and len(said) == 1 else None
    if selector is None:
        return _found(obj, said, paths)
    chosen, sources = paths(selector), [piece.part.source for piece in survey(obj.Sources)[0]]
    numbers = [k for k, source in enumerate(sources) if source in chosen]
    if not numbers:
        raise Refused(f"the document has no object '{selector}'")
    names = sources[numbers[0]].split(".")
    for depth in range(1, len(names) + 1):
        path = ".".join(names[:depth])
        if numbers_of_path(path, sources) == numbers:
            return _element(obj, path)
    notes.append(f"it points at {path}, the first of the {len(numbers)} objects that '{selector}' means")
    return _element(obj, path)


def _element(obj, path, name=""):
    top, _, sub = path.partition(".")
    return obj.Document.getObject(top), (sub + "." if sub else "") + name


def _is_point(said):
    return isinstance(said, list) and len(said) == 3 and isinstance(said[0], (int, float))


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
    return _element(obj, chosen[0], f"{key.capitalize()}{said[key] + 1}")


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
