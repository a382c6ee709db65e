"""Which objects of a document the parts of an illustration file are: by names, and of equal ones by place."""

import os
import re
from dataclasses import dataclass, field
from typing import Any, List, Optional

from .features import is_illustration
from .features.shown import is_shown
from .features.sources import from_the_top, is_aid, survey
from .job import shortened
from .part_names import plain, unnumbered

# How far two placements may be from each other, in mm and as entries of a rotation, and still be the same.
SAME = 1e-6
_IDENTITY = [float(row == column) for row in range(4) for column in range(4)]


@dataclass
class Candidate:
    """An object that a part of a file may be: a leaf, or an assembly with all that it shows."""

    top: Any
    sub: str
    label: str
    name: str  # internal
    pieces: List[Any]
    used: bool = False

    @property
    def path(self):
        return self.top.Name + ("." + self.sub.rstrip(".") if self.sub else "")

    def matrix(self):
        return list(self.top.getSubObject(self.sub, retType=4).A)

    def is_shown(self):
        return is_shown(self.top.getSubObject(self.sub, retType=1) if self.sub else self.top)


@dataclass
class Match:
    """A part of a file and the object that it is; nothing where the document has none."""

    part: Any  # as burin.illustration tells it
    name: str
    found: Optional[Candidate] = None
    tied: List[Candidate] = field(default_factory=list)  # what might have been taken as well

    def take(self, free):
        """The one at the place that the file says before others, what is shown before what is hidden."""
        rank = {id(c): (not _is_at(c, self.part), not c.is_shown()) for c in free}
        self.found = min(free, key=lambda c: rank[id(c)])
        self.found.used = True
        self.tied = [c for c in free if rank[id(c)] == rank[id(self.found)] and c is not self.found]

    def selectable(self):
        """Pairs of what selectors know of a part and its path in the document; this is nothing where it is absent."""
        told = {"source": self.part["file"]}
        if self.found is None:
            return [({"name": self.name, **told}, None)]
        pieces = [p.part for p in self.found.pieces]
        if len(pieces) == 1:
            return [({"name": self.name, "color": pieces[0].color, **told}, pieces[0].source)]
        depth = len(self.found.sub.split(".")) if self.found.sub else 1
        return [({"name": p.name, "color": p.color, "assembly": [self.name, *p.assembly[depth:]], **told}, p.source)
                for p in pieces]


def match(burin, document, parts):
    """A Match for each part of a file, in order, and what there is to say of places."""
    by_name = {}
    for candidate in _candidates(document):
        for name in {plain(candidate.label), candidate.name, candidate.path}:
            by_name.setdefault(name, []).append(candidate)
    matches = [Match(part, _name_of(part)) for part in parts]
    # Names as they stand first, so that none of them goes to a part that `distinct` has numbered; then what FreeCAD names
    # that imports the file of the part.
    for known_as in (lambda one: one.name, lambda one: unnumbered(one.name), lambda one: _name_of_file(one.part),
                     lambda one: _internal(_name_of_file(one.part)),
                     lambda one: _internal(_name_of_file(one.part), keep_digit=True)):
        for one in matches:
            if one.found is None:
                free = [c for c in by_name.get(known_as(one), ()) if not c.used]
                if free:
                    one.take(free)
    for one in matches:
        if one.found is None and not one.part["name"]:
            one.name = _top_of_file(burin, one.part["file"]) or one.name
            free = [c for c in by_name.get(plain(one.name), ()) if not c.used]
            if free:
                one.take(free)
    return matches, _notes(matches, by_name)


def _top_of_file(burin, file):
    """What FreeCAD calls the assembly that it imports a file as; empty where there is no such file, or not one assembly."""
    if not os.path.isfile(file):
        return ""
    try:
        tops = {(part["assembly"] or [part["name"]])[0] for part in burin.info(file)[0]["parts"]}
    except burin.Error:  # only its name was wanted: that the part is absent is told
        return ""
    return tops.pop() if len(tops) == 1 else ""


def _notes(matches, by_name):
    found = [one for one in matches if one.found is not None]
    moved = [one.name for one in found if _is_moved(one)]
    tied = [f"{one.name} ({one.found.path})" for one in found if any(not c.used for c in one.tied)]
    read = sorted({option for one in found for option in one.part["read"]})
    notes = []
    if read:
        notes.append(f"options about reading have no effect on objects that are there: {', '.join(read)}")
    if moved:
        notes.append(f"are where the document has them, though the file has other places: {shortened(moved, ', ')}")
    numbered = [one.name for one in found if not one.part["name"] and any(
        not c.used for c in by_name.get(plain(one.found.label) + "001", ()))]
    if numbered:
        notes.append("objects of the same name with a number may be of the file too and were not taken (put them into a part of that "
                     f"name): {shortened(numbered, ', ')}")
    if tied:
        notes.append(f"names that several objects have, of which the first was taken: {shortened(tied, ', ')}")
    return notes


def _name_of(part):
    return plain(part["name"]) if part["name"] else _name_of_file(part)


def _name_of_file(part):
    """The label that FreeCAD gives to what it imports, of most formats."""
    return plain(os.path.basename(part["file"]).split(".")[0])


def _internal(label, keep_digit=False):
    """The internal name that FreeCAD makes of a label, byte by byte; BREP files have no other. Names begin with no digit:
    FreeCAD 0.20 and 1.0 have `_` for one, 1.1 has it before one."""
    name = re.sub(r"[^A-Za-z0-9_]", "_", label.encode().decode("latin-1"))
    return "_" + name[0 if keep_digit else 1 :] if name[0].isdigit() else name


def _candidates(document):
    """Every object that can be drawn, shown or hidden, and what links show of others."""
    found = {}
    for obj in document.Objects:
        if is_illustration(obj) or is_aid(obj):
            continue
        if not (obj.isDerivedFrom("App::GeoFeature") or obj.isDerivedFrom("App::Link") or obj.isDerivedFrom("App::LinkGroup")):
            continue
        top, sub = from_the_top(obj)
        pieces, _ = survey([(top, (sub,))])
        if pieces:
            found.setdefault((top.Name, sub), Candidate(top, sub, obj.Label, obj.Name, pieces))
        for piece in pieces:
            found.setdefault((piece.top.Name, piece.sub),
                             Candidate(piece.top, piece.sub, piece.part.name, piece.part.source, [piece]))
    return list(found.values())


def _numbers(part):
    return [number for row in part["place"] for number in row]


def _same(one, other):
    return all(abs(a - b) <= SAME * max(1.0, abs(a)) for a, b in zip(one, other))


def _is_at(candidate, part):
    return _same(candidate.matrix(), _numbers(part))


def _is_moved(one):
    """Whether the file places a part elsewhere. Models other than BREP may have the place in them, as meshes have, so only
    places that are said count there."""
    if _is_at(one.found, one.part):
        return False
    return one.part["file"].endswith(".brep") and _is_rigid_shape(one.found) or not _same(_numbers(one.part), _IDENTITY)


def _is_rigid_shape(candidate):
    if len(candidate.pieces) != 1 or candidate.pieces[0].shape is None:
        return False
    a = candidate.matrix()
    rows = a[0:3], a[4:7], a[8:11]
    return all(_same([sum(x * y for x, y in zip(rows[i], rows[k]))], [float(i == k)]) for i in range(3) for k in range(3))
