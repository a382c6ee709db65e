"""Places that are drawn again, larger, and the views of a sheet that has several. The property Details keeps an entry of an
illustration file each, as JSON, or the text of the option --detail ("Bolt=5:1", "0,-40,30,12")."""

import json
import re

import FreeCAD
import Part

from ..errors import Refused
from . import eye
from .chosen import selectors

# ISO 128-3: letters but I, O and Q.
LETTERS = "ABCDEFGHJKLMNPRSTUVWXYZ"

PARALLEL = "several views are parallel: the perspective is left out"

METHODS = {"First angle": "first", "Third angle": "third"}

# Of the size of what is chosen: what a circle about it shows.
AROUND = 1.15

_SCALE = re.compile(r"\s*(\d+\.?\d*)\s*(?:[:/]\s*(\d+\.?\d*))?\s*$")
_PLACE = re.compile(r"\s*" + r"\s*,\s*".join([r"([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?)"] * 4) + r"\s*$")


def entry_of(text, number=1):
    """A mapping with "select", words for objects, or "at" and "radius"; maybe with "scale" and "letter". `text`: JSON, or as the
    option has it. Throws Refused."""
    text = text.strip()
    if not text.startswith("{"):
        return _of_option(text, number)
    try:
        entry = json.loads(text)
    except ValueError as error:
        raise Refused(f"detail {number} of the property Details is no JSON ({error}); choose its place again") from error
    return {**entry, "select": _words(entry["select"])} if "select" in entry else entry


def _words(said):
    return [said] if isinstance(said, str) else list(said)


def _of_option(text, number):
    what, equals, scale = text.rpartition("=")
    entry = {"scale": scale.strip()} if equals and scale_of(scale) else {}
    what = (what if entry else text).strip()
    place = _PLACE.match(what)
    if place:
        x, y, z, radius = (float(n) for n in place.groups())
        return {"at": [x, y, z], "radius": radius, **entry}
    if not what:
        raise Refused(f"detail {number} of the property Details shows nothing; it is like Bolt=5:1 or 0,-40,30,12")
    return {"select": [what], **entry}


def text_of(entry):
    return json.dumps(entry, ensure_ascii=False)


def entries_of(obj):
    """All details of an illustration. Throws Refused."""
    return [entry_of(text, number) for number, text in enumerate(obj.Details, 1) if text.strip()]


def set_details(obj, entries):
    obj.Details = [text_of(entry) for entry in entries]


def of_objects(words, scale="", letter=""):
    """A detail of objects, by paths or names. `scale`: "5:1"; empty: the largest of ISO 5455 that has room."""
    return {"select": list(words), **_said(scale, letter)}


def of_point(at, radius, scale="", letter=""):
    """A detail about a point of the model; mm."""
    return {"at": [float(a) for a in at], "radius": float(radius), **_said(scale, letter)}


def of_shape(shape, radius=0.0):
    """A detail about the middle of a face, an edge or a vertex, in global coordinates; as large as that is where it has a size,
    else of that radius."""
    box = shape.BoundBox
    size = 0.5 * AROUND * box.DiagonalLength
    return of_point([round(a, 6) + 0.0 for a in box.Center], float(f"{size if size > 1e-6 else radius:.4g}"))


def shape_at(top, sub):
    """A face, edge or vertex by its way ('Inner.Box.Face3'), in global coordinates."""
    return Part.getShape(top, sub, needSubElement=True, transform=True)


def _said(scale, letter):
    return {**({"scale": scale} if scale else {}), **({"letter": letter} if letter else {})}


def scale_of(text):
    """"5:1", "1:2", "2.5" as a number; 0 where it is none."""
    found = _SCALE.match(str(text))
    if found is None:
        return 0.0
    over = float(found.group(2)) if found.group(2) else 1.0
    return float(found.group(1)) / over if over > 0 else 0.0


def scale_text(entry):
    """As a table shows it; empty where it is found."""
    scale = entry.get("scale", "")
    return f"{scale:g}:1" if isinstance(scale, (int, float)) else str(scale)


def letters_of(entries):
    """The letters under which details stand in the drawing: those without one have the next that no other has."""
    taken, found = {entry["letter"] for entry in entries if entry.get("letter")}, []
    for entry in entries:
        letter = entry.get("letter") or next((c for c in LETTERS if c not in taken), "")
        taken.add(letter)
        found.append(letter)
    return found


def words_of(entry):
    """Words for the objects that a detail shows; none where it is about a point."""
    return entry.get("select", [])


def for_kernel(obj, sources, notes):
    """Entries as the kernel takes them: objects by the numbers of their parts. What shows nothing any more is told."""
    found = []
    for number, entry in enumerate(entries_of(obj), 1):
        words = words_of(entry)
        if words:
            chosen, lost = selectors(words, sources)
            if lost:
                notes.append(f"detail {number} shows {', '.join(lost)}, which is not drawn here; delete the detail or choose its place again")
            if not chosen:
                continue
            entry = {**entry, "select": chosen}
        found.append(entry)
    return found


def views_of(obj):
    """Names of the views that a sheet with several has; none where it has the one of the illustration."""
    return [name.strip() for name in obj.Views if name.strip()]


def sheet_of(obj, sources, notes):
    """Keys of an illustration about several views and details; only those that are asked for. Throws Refused."""
    said, views = {}, views_of(obj)
    if len(views) == 1 and "," in views[0]:
        raise Refused(f"Views has one direction alone, {views[0]}: make it ViewDirection and leave Views empty, or add a view by name")
    if views:
        said["views"] = "; ".join(views) if any("," in name for name in views) else views  # directions have commas
        said["projection"] = METHODS[obj.ProjectionMethod]
        if obj.Projection == "Perspective":
            notes.append(PARALLEL)
    found = for_kernel(obj, sources, notes)
    return {**said, "details": found} if found else said


def to_viewer(obj):
    """From the model to the viewer: of the view, or of the first of several."""
    names = views_of(obj)
    if not names:
        return obj.ViewDirection
    if names[0].lower() in eye.standards():
        return eye.standard(names[0].lower()).direction
    try:
        return FreeCAD.Vector(*(float(n) for n in names[0].split(",")))
    except (ValueError, TypeError):  # no view: the kernel will say so
        return obj.ViewDirection
