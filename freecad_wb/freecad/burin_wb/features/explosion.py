"""Exploded views, as the property ExplodeSteps keeps them: a step of an illustration file each, as JSON, that names objects by
their paths. The placements of the document are never touched."""

import json
from dataclasses import dataclass, field
from typing import List, Tuple

import FreeCAD

from ..errors import Refused
from .chosen import numbers_of, paths_of, selectors


@dataclass
class Step:
    """Objects that move together."""

    move: List[str] = field(default_factory=list)  # paths or names of objects, or selectors
    along: Tuple[float, float, float] = (0.0, 0.0, 1.0)  # model axes
    by: float = 10.0  # mm
    trail: bool = True

    def text(self):
        return json.dumps({"move": self.move, "along": list(self.along), "by": self.by, "trail": self.trail}, ensure_ascii=False)

    def way(self):
        """As a vector, in mm."""
        way = FreeCAD.Vector(*self.along)
        return way.normalize() * self.by if way.Length > 0 else way

    @staticmethod
    def of(said):
        """Of a mapping as illustration files have it. Throws ValueError, TypeError, KeyError."""
        move, along = said["move"], said["along"]
        x, y, z = (float(a) for a in along)
        step = Step([move] if isinstance(move, str) else [str(word) for word in move], (x, y, z), float(said["by"]),
                    bool(said.get("trail", True)))
        if not step.move or FreeCAD.Vector(x, y, z).Length == 0 or not 0 < step.by <= 1e12:
            raise ValueError("it moves nothing")
        return step


def steps_of(obj):
    """The steps of an illustration, in order. Throws Refused."""
    steps = []
    for number, text in enumerate(obj.ExplodeSteps, 1):
        try:
            steps.append(Step.of(json.loads(text)))
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            raise Refused(f"step {number} of the property ExplodeSteps is none ({error}); it is like {Step(['Bolt']).text()}") from error
    return steps


def set_steps(obj, steps):
    obj.ExplodeSteps = [step.text() for step in steps]


def for_kernel(obj, sources, notes):
    """The key `explode` of an illustration; nothing where nothing comes apart. Steps that move nothing any more are told."""
    if not obj.Explode:
        return None
    steps = _said(obj, sources, notes)
    if steps:
        return {"steps": steps, "factor": obj.ExplodeFactor}
    if obj.ExplodeSteps:
        return None  # which was told
    return {**({"along": obj.ExplodeAlong} if obj.ExplodeAlong.strip() else {}), "factor": obj.ExplodeFactor}


def steps_for_kernel(obj, sources, notes):
    """The key `explode` of a step book: steps that are kept, whether they are drawn or not, else those that are found."""
    steps = _said(obj, sources, [] if obj.Explode else notes)  # where they are drawn, they have been told
    return {"steps": steps} if steps else {"along": obj.ExplodeAlong} if obj.ExplodeAlong.strip() else "auto"


def _said(obj, sources, notes):
    """Steps as the kernel takes them."""
    steps = []
    for number, step in enumerate(steps_of(obj), 1):
        chosen, lost = selectors(step.move, sources)
        if lost:
            notes.append(f"step {number} of the exploded view moves {', '.join(lost)}, which is not drawn here; delete the step or "
                         "find the steps anew")
        if chosen:
            steps.append({"move": chosen, "along": list(step.along), "by": step.by, "trail": step.trail})
    return steps


def taken(found, sources):
    """Steps that the kernel found ("parts": numbers), by the paths of objects."""
    return [Step(paths_of(step["parts"], sources), tuple(round(a, 6) + 0.0 for a in step["along"]), float(f"{step['by']:.6g}"),
                 step["trail"]) for step in found]


def moves_of(steps, sources, factor):
    """Where parts are after the steps: vectors in mm, one for each path in `sources`. Selectors mean nothing here."""
    moves = [FreeCAD.Vector() for _ in sources]
    for step in steps:
        for k in {k for word in step.move for k in numbers_of(word, sources)}:
            moves[k] += step.way() * factor
    return moves
