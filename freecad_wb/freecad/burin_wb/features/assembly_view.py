"""Exploded views of FreeCAD's own workbench Assembly (FreeCAD 1.0 and later), as steps. Known by what they hold, so that documents
can be read where that workbench is absent."""

import FreeCAD

from .explosion import Step
from .looks import path_of


def exploded_views(document):
    """The exploded views of a document, in its order."""
    return [obj for obj in document.Objects if _moves(obj)]


def _moves(view):
    """Its moves: in its group, in FreeCAD 1.0 in a property."""
    if not hasattr(view, "Proxy"):
        return []
    return [move for move in getattr(view, "Moves", None) or getattr(view, "Group", None) or () if _is_move(move)]


def _is_move(obj):
    return all(hasattr(obj, name) for name in ("MoveType", "MovementTransform", "References"))


def steps_of(view):
    """The steps of an exploded view, and what could not be taken over."""
    steps, notes = [], []
    for move in _moves(view):
        try:
            steps.append(_step(move))
        except ValueError as why:
            notes.append(f"{move.Label}: {why}")
    return steps, notes


def _step(move):
    """Throws ValueError that says why it is none."""
    if move.MoveType != "Normal":
        raise ValueError("moves parts away from a middle, not along a way; it is left out")
    if abs(move.MovementTransform.Rotation.Angle) > 1e-9:
        raise ValueError("turns parts, which steps do not; it is left out")
    root, subs = move.References if move.References else (None, ())
    if root is None or not subs:
        raise ValueError("moves nothing; it is left out")
    way = FreeCAD.Placement(root.getSubObject("", retType=4)).Rotation.multVec(move.MovementTransform.Base)
    if way.Length <= 0:
        raise ValueError("does not move its parts; it is left out")
    paths = [path_of(root, sub if "." in sub else sub + ".") for sub in ([subs] if isinstance(subs, str) else subs)]
    along = tuple(round(a, 9) + 0.0 for a in way / way.Length)
    return Step(list(dict.fromkeys(paths)), along, float(f"{way.Length:.6g}"))
