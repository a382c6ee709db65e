"""From document objects to parts: assemblies are taken apart, placements and names kept."""

import os
import re
import tempfile
from collections import namedtuple

import Part

from ..job import PartJob
from .colors import colors_of, split
from .looks import FLAGS, words_of
from .shapes import shapes
from .shown import is_shown
from .threads import threads_of


class Left(Exception):
    """An object that cannot be drawn; the text says why."""


# A part to be: `part` without its geometry, which is `shape` (nothing for meshes, those are of `leaf`) at (top, sub).
Piece = namedtuple("Piece", "part shape leaf top sub")


def collect(sources, looks=None):
    """Parts and notes of a list of (object, sub-names) as LinkSubList properties give it."""
    pieces, notes = survey(sources, looks)
    return [filled(piece) for piece in pieces], notes


def survey(sources, looks=None):
    """As `collect`, without writing geometry: quick."""
    pieces, notes, seen = [], [], set()
    for obj, subs in sources:
        for sub in _objects_of(subs):
            _walk(*from_the_top(obj, sub), True, pieces, notes, seen, looks or {})
    return pieces, notes


def filled(piece):
    """The part with its geometry. Cost: that of writing a shape or reading a mesh, where it is new."""
    part = piece.part
    if piece.shape is None:
        part.vertices, part.triangles = _mesh(piece)
    else:
        part.brep, part.placement = shapes.text(piece.shape, _place(piece))
    return part


def _place(piece):
    return piece.top.Document.Name, piece.part.source


def is_ready(piece):
    """Whether `filled` has nothing to write."""
    return piece.shape is not None and shapes.has(piece.shape, _place(piece))


def from_the_top(obj, sub=""):
    """An object inside assemblies as the outermost assembly has it: (assembly, 'Inner.Body.'). Only so placements
    are those of the whole."""
    inside, part = obj, _above(obj)
    while part is not None:
        obj, sub, part = part, inside.Name + "." + sub, _above(part)
        inside = obj
    return obj, sub


def _above(obj):
    """The assembly that an object is in: an App::Part, or a group of links, as those of STEP files are; nothing where it is in none."""
    part = obj.getParentGeoFeatureGroup()
    if part is not None:
        return part
    return next((other for other in obj.InList if other.isDerivedFrom("App::LinkGroup") and obj in other.ElementList), None)


def _objects_of(subs):
    """The object parts of sub-names: 'Body.Face3' is 'Body.'; an element of the object itself is ''."""
    names = {s[: s.rfind(".") + 1] for s in subs if s} if subs else {""}
    return sorted(names) or [""]


def _walk(top, sub, asked, pieces, notes, seen, looks):
    try:
        resolved = top.getSubObject(sub, retType=1) if sub else top
    except Exception:  # FreeCAD throws many kinds for names that it does not know
        resolved = None
    path = top.Name + ("." + sub.rstrip(".") if sub else "")
    if resolved is None:
        notes.append(f"{path}: the object is gone; choose the sources again")
        return
    if path in seen:
        return
    seen.add(path)
    leaf = resolved.getLinkedObject(True)
    if not asked and leaf is not None and is_aid(leaf):
        return
    if _is_broken_link(leaf):
        notes.append(f"{resolved.Label}: links to something that is not there; open the file that it links to, or "
                     "repair the link")
        return
    children = _children(resolved, leaf)
    if children is not None:
        before = len(pieces) + len(notes)
        for child in children:
            if _visible(resolved, top, sub + child):
                _walk(top, sub + child, False, pieces, notes, seen, looks)
        if asked and len(pieces) + len(notes) == before:
            notes.append(f"{resolved.Label}: has no visible shape in it; show what is to be drawn")
        return
    try:
        piece = _piece(top, sub, resolved, leaf, path)
    except Left as why:
        if asked or "Invalid" in resolved.State:
            notes.append(f"{resolved.Label}: {why}")
        return
    if "Invalid" in resolved.State:
        notes.append(f"{resolved.Label}: its last recompute failed; drawn as it was before that")
    _apply_looks(piece.part, looks.get(path) or looks.get(resolved.Name) or "", notes)
    pieces.append(piece)


# Aids of modelling, no parts of the model: sketches, datum planes, lines, points and coordinate systems (those of FreeCAD
# 1.1 lie in assemblies too), binders.
_AIDS = ("Sketcher::SketchObject", "Part::Datum", "App::OriginFeature", "App::DatumElement", "App::LocalCoordinateSystem",
         "App::Origin", "PartDesign::ShapeBinder", "PartDesign::SubShapeBinder")


def is_aid(obj):
    """Whether an object is drawn only where it is asked for by name."""
    return any(obj.isDerivedFrom(kind) for kind in _AIDS)


def _visible(parent, top, sub):
    """Whether a child is shown: links have a say of their own, else the object's property holds."""
    said = parent.isElementVisible(sub.rstrip(".").rpartition(".")[2])
    if said >= 0:
        return said == 1
    child = top.getSubObject(sub, retType=1)
    return child is None or is_shown(child)


def _is_broken_link(leaf):
    return leaf is None or leaf.isDerivedFrom("App::Link") and not leaf.getSubObjects()


def _children(obj, leaf):
    """Sub-names of the objects in an assembly, a group, a link array; None for what has a shape of its own."""
    if leaf.isDerivedFrom("PartDesign::Body"):
        return None
    if (leaf.hasExtension("App::GroupExtension") or leaf.isDerivedFrom("App::LinkGroup")
            or leaf.isDerivedFrom("App::Link") or _is_link_array(leaf)):
        return obj.getSubObjects()
    return None


def _is_link_array(obj):
    """Whether it is an array of links of another type, as Draft makes them."""
    return obj.hasExtension("App::LinkExtensionPython") and bool(obj.getSubObjects())


def _labels(top, sub):
    """Labels from the top of the assembly down to what contains the object. Link arrays are no assemblies: their elements, numbered,
    stand where the array does."""
    labels, at = [], ""
    if sub:
        for name in ("", *sub.rstrip(".").split(".")[:-1]):
            at += name + "." if name else ""
            inner = top.getSubObject(at, retType=1) if at else top
            if inner is not None and not getattr(inner, "ElementCount", 0) and not _is_link_array(inner):
                labels.append(f"{inner.Label} {int(name) + 1}" if name.isdigit() else inner.Label)
    return labels


def _definition(leaf):
    """What an object and all links to it are instances of: its label, or that of the containers that hold it alone where FreeCAD made
    the label from the type ("Body001")."""
    obj = leaf
    while obj is not None and re.sub(r"\d+$", "", obj.Label) == obj.TypeId.rpartition(":")[2]:
        inside, obj = obj, obj.getParentGeoFeatureGroup()
        if obj is not None and any(o is not inside and is_shown(o) and not is_aid(o) for o in obj.Group):
            break
    else:
        return leaf.Label if obj is None else obj.Label
    return leaf.Label


def _piece(top, sub, obj, leaf, path):
    looks_as, face_colors = colors_of(top, sub, leaf)
    color, opacity = split(looks_as)
    part = PartJob(name=obj.Label, source=path, assembly=_labels(top, sub), color=color, opacity=opacity,
                   definition=_definition(leaf))
    if leaf.isDerivedFrom("Mesh::Feature"):
        if not leaf.Mesh.CountFacets:
            raise Left("is an empty mesh; choose another one")
        return Piece(part, None, leaf, top, sub)
    try:
        shape = Part.getShape(top, sub, needSubElement=False, transform=True)
    except Exception as error:  # the kernel of FreeCAD throws many kinds
        raise Left(f"its shape cannot be read ({error})")
    if shape.isNull():
        raise Left("has no shape; recompute it, or choose an object with a solid, shell or face")
    if not shape.Faces:
        raise Left("has no faces (a sketch or wire); choose a solid, shell or face")
    if len(face_colors) == len(shape.Faces):
        part.face_colors = face_colors
    part.threads = threads_of(leaf, top.getSubObject(sub, retType=4))
    return Piece(part, shape, leaf, top, sub)


def _mesh(piece):
    import numpy

    vertices, triangles = _topology(piece.leaf.Mesh)
    matrix = piece.top.getSubObject(piece.sub, retType=4)
    a = numpy.array(matrix.A).reshape(4, 4)
    if not numpy.array_equal(a, numpy.eye(4)):
        vertices = vertices @ a[:3, :3].T + a[:3, 3]
    return vertices, triangles


# FreeCAD's own binary form of meshes: a word that tells the byte order, version, text, counts, points, and for each
# facet three corners and three neighbours.
_BMS_WORD, _BMS_COUNTS = 0xA0B0C0D0, 8 + 256


def _topology(mesh):
    """Points (n, 3) without the placement, and corners (m, 3). Through a file: FreeCAD's lists of them take six times as
    long."""
    import numpy

    handle, path = tempfile.mkstemp(suffix=".bms", prefix="burin-")
    os.close(handle)
    try:
        mesh.write(path, "BMS")
        with open(path, "rb") as file:
            data = file.read()
    finally:
        os.unlink(path)
    order = "<" if int.from_bytes(data[:4], "little") == _BMS_WORD else ">"
    points, facets = (int(n) for n in numpy.frombuffer(data, order + "u4", 2, _BMS_COUNTS))
    first = _BMS_COUNTS + 8
    vertices = numpy.frombuffer(data, order + "f4", 3 * points, first).reshape(-1, 3).astype(float)
    corners = numpy.frombuffer(data, order + "u4", 6 * facets, first + 12 * points).reshape(-1, 6)[:, :3]
    return vertices, corners.astype(numpy.int32)


def _apply_looks(part, words, notes):
    for word in words_of(words):
        if word == "not drawn":
            part.drawn = False
        elif word == "not hatched":
            part.hatched = False
        elif word == "transparent":
            part.transparent = True
        elif word.startswith("style="):
            part.style = word[len("style=") :]
        else:
            notes.append(f"{part.name}: the look '{word}' is not known; there are {', '.join(FLAGS)} and style=NAME")


def visible(document):
    """What a document shows, as sources: its visible objects with faces, each through the outermost assembly."""
    found = []
    for obj in document.Objects:
        if not is_shown(obj) or _above(obj) is not None:
            continue
        if is_aid(obj) or _is_folder(obj) or obj.isDerivedFrom("App::LinkElement"):
            continue  # what is in a folder is looked at by itself, elements of arrays through these
        pieces, _ = survey([(obj, ("",))])
        if pieces or _is_broken_link(obj.getLinkedObject(True)):  # what is lost is told
            found.append(obj)
    return found


def _is_folder(obj):
    """Whether it holds objects and moves none: groups, storeys of buildings."""
    return obj.hasExtension("App::GroupExtension") and not obj.hasExtension("App::GeoFeatureGroupExtension")
