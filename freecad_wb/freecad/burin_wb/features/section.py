"""Planes that cut parts open, in all views or in one of their own, as the property Sections keeps them: an entry of an illustration file each, as JSON, or the text
of the option --section ("y", "-z=12")."""

import json
import math
import re

import FreeCAD

from ..errors import Refused
from . import eye
from .chosen import selectors


def entry_of(text, number=1):
    """What an illustration file would say: text, or a mapping. Throws Refused."""
    text = text.strip()
    if not text.startswith("{"):
        return text
    try:
        return json.loads(text)
    except ValueError as error:
        raise Refused(f"section {number} of the property Sections is no JSON ({error}); choose the plane again") from error


def text_of(entry):
    return entry if isinstance(entry, str) else json.dumps(entry, ensure_ascii=False)


def entries_of(obj):
    """All sections of an illustration. Throws Refused."""
    return [entry_of(text, number) for number, text in enumerate(obj.Sections, 1) if text.strip()]


def plane(normal, offset, exclude=None):
    """An entry of one plane: `normal` points to what is taken away, `offset` mm from the origin along it; `exclude`:
    paths or names of objects that stay whole; None: those that drawings leave whole by custom, such as bolts; an empty list: none."""
    entry = {"plane": {"normal": [float(n) for n in normal], "offset": float(offset)}}
    return entry if exclude is None else {**entry, "exclude": list(exclude)}


def excluded(entry):
    """Words for what stays whole."""
    words = entry.get("exclude", []) if isinstance(entry, dict) else []
    return [words] if isinstance(words, str) else list(words)


def view_of(entry):
    """The letter of the view of its own that an entry has, or true where the kernel chooses it; nothing where it cuts all views."""
    return entry.get("view") if isinstance(entry, dict) else None


def in_view(entry, view=True):
    """The entry in a view of its own, A-A: `view` is its letter, or true; false: it cuts all views again."""
    entry = {"plane": entry} if isinstance(entry, str) else {key: value for key, value in entry.items() if key != "view"}
    return {**entry, "view": view} if view else entry


def may_have_view(entry):
    """Whether it is one plane, or steps: a view shows one cut."""
    return isinstance(entry, str) and bool(_TEXT.match(entry)) or isinstance(entry, dict) and ("plane" in entry or "steps" in entry)


def own_views(entries):
    """Of the entries with views of their own the letters, as details have them: {"letter": "K"}, or nothing in it."""
    return [{"letter": view} if isinstance(view, str) else {} for view in map(view_of, entries) if view]


def for_kernel(obj, sources, notes):
    """Entries as the kernel takes them: objects by the numbers of their parts."""
    found = []
    for number, entry in enumerate(entries_of(obj), 1):
        words = excluded(entry)
        if words:
            chosen, lost = selectors(words, sources)
            if lost:
                notes.append(f"section {number} leaves {', '.join(lost)} whole, which is not drawn here; choose again what it leaves whole")
            entry = {**entry, "exclude": chosen}
        found.append(entry)
    return found


_TEXT = re.compile(r"\s*([+-]?)([xyz])\s*(?:=\s*([-+0-9.eE]+))?\s*$")
_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def plane_of(entry, to_viewer, extent):
    """The normal and offset of an entry that is one plane, as the kernel takes them; nothing where it is something else.
    `to_viewer`: a vector; `extent(normal)`: from where to where the model is along a normal, in mm."""
    said = entry.get("plane") if isinstance(entry, dict) else entry
    if isinstance(said, dict):
        try:
            normal = FreeCAD.Vector(*(float(n) for n in said["normal"])).normalize()
            return normal, float(said["offset"]) if "offset" in said else _middle(extent, normal)
        except (KeyError, TypeError, ValueError, FreeCAD.Base.FreeCADError):
            return None
    found = _TEXT.match(said) if isinstance(said, str) else None
    if found is None:
        return None
    axis = FreeCAD.Vector(*_AXES[found.group(2)])
    side = {"+": 1, "-": -1}.get(found.group(1)) or (1 if axis.dot(to_viewer) >= 0 else -1)
    offset = float(found.group(3)) if found.group(3) else _middle(extent, axis)
    return axis * side, side * offset


def _middle(extent, normal):
    return sum(extent(normal)) / 2


# mm: sections that are as near to each other are at one place.
NEAR = 1e-6


def offsets_along(entries, normal, to_viewer, extent):
    """Where entries that are one plane across a normal lie along that; nothing for each other entry."""
    planes = [plane_of(entry, to_viewer, extent) for entry in entries]
    return [math.copysign(1.0, found[0].dot(normal)) * found[1] if found and found[0].cross(normal).Length < NEAR else None for found in planes]


def free_offset(offset, taken, low, high):
    """The offset where no section lies, else the middle of the widest space between those that do, and the ends of the model."""
    if all(abs(one - offset) > NEAR for one in taken):
        return offset
    ends = [low, *sorted(one for one in taken if low < one < high), high]
    wide = max(zip(ends, ends[1:]), key=lambda gap: round(gap[1] - gap[0], 6))
    return sum(wide) / 2


def of_face(face, solid):
    """Normal and offset of a flat face of a shape; what lies before it goes. Throws Refused."""
    surface = face.findPlane()
    if surface is None:
        raise Refused("a section needs a flat face or a datum plane; this one is curved")
    normal = eye.of_face(face, solid).direction.normalize()
    return normal, normal.dot(surface.Position)


def of_placement(placement):
    """Of a plane that stands so: what lies on its positive side goes."""
    normal = placement.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
    return normal, normal.dot(placement.Base)
