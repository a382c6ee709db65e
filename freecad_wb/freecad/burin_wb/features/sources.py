"""From document objects to parts: assemblies are taken apart, placements and names kept."""

from ..job import PartJob
from .looks import FLAGS, words_of
from .shown import is_shown


class Left(Exception):
    """An object that cannot be drawn; the text says why."""


def collect(sources, looks=None):
    """Parts and notes of a list of (object, sub-names) as LinkSubList properties give it."""
    parts, notes, seen = [], [], set()
    for obj, subs in sources:
        for sub in _objects_of(subs):
            _walk(*from_the_top(obj, sub), True, parts, notes, seen, looks or {})
    return parts, notes


def from_the_top(obj, sub=""):
    """An object inside assemblies as the outermost assembly has it: (assembly, 'Inner.Body.'). Only so placements
    are those of the whole."""
    inside, part = obj, obj.getParentGeoFeatureGroup()
    while part is not None:
        obj, sub, part = part, inside.Name + "." + sub, part.getParentGeoFeatureGroup()
        inside = obj
    return obj, sub


def _objects_of(subs):
    """The object parts of sub-names: 'Body.Face3' is 'Body.'; an element of the object itself is ''."""
    names = {s[: s.rfind(".") + 1] for s in subs if s} if subs else {""}
    return sorted(names) or [""]


def _walk(top, sub, asked, parts, notes, seen, looks):
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
    if leaf is None or _is_broken_link(leaf):
        notes.append(f"{resolved.Label}: links to something that is not there; open the file that it links to, or "
                     "repair the link")
        return
    children = _children(resolved, leaf)
    if children is not None:
        before = len(parts) + len(notes)
        for child in children:
            if _visible(resolved, top, sub + child):
                _walk(top, sub + child, False, parts, notes, seen, looks)
        if asked and len(parts) + len(notes) == before:
            notes.append(f"{resolved.Label}: has no visible shape in it; show what is to be drawn")
        return
    try:
        part = _part(top, sub, resolved, leaf, path)
    except Left as why:
        if asked or "Invalid" in resolved.State:
            notes.append(f"{resolved.Label}: {why}")
        return
    if "Invalid" in resolved.State:
        notes.append(f"{resolved.Label}: its last recompute failed; drawn as it was before that")
    _apply_looks(part, looks.get(path) or looks.get(resolved.Name) or "", notes)
    parts.append(part)


def _visible(parent, top, sub):
    """Whether a child is shown: links have a say of their own, else the object's property holds."""
    said = parent.isElementVisible(sub.rstrip(".").rpartition(".")[2])
    if said >= 0:
        return said == 1
    child = top.getSubObject(sub, retType=1)
    return child is None or is_shown(child)


def _is_broken_link(leaf):
    return leaf.isDerivedFrom("App::Link") and not leaf.getSubObjects()


def _children(obj, leaf):
    """Sub-names of the objects in an assembly, a group, a link array; None for what has a shape of its own."""
    if leaf.isDerivedFrom("PartDesign::Body"):
        return None
    if (leaf.hasExtension("App::GroupExtension") or leaf.isDerivedFrom("App::LinkGroup")
            or leaf.isDerivedFrom("App::Link")):
        return obj.getSubObjects()
    return None


def _labels(top, sub):
    """Labels from the top of the assembly down to what contains the object."""
    labels, at = [], ""
    if sub:
        labels.append(top.Label)
        names = sub.rstrip(".").split(".")
        for name in names[:-1]:
            at += name + "."
            inner = top.getSubObject(at, retType=1)
            if inner is not None:
                labels.append(inner.Label)
    return labels


def _part(top, sub, obj, leaf, path):
    common = dict(name=obj.Label, source=path, assembly=_labels(top, sub), color=_color(obj, leaf))
    if leaf.isDerivedFrom("Mesh::Feature"):
        return PartJob(**common, **_mesh(top, sub, leaf))
    import Part

    try:
        shape = Part.getShape(top, sub, needSubElement=False, transform=True)
    except Exception as error:  # the kernel of FreeCAD throws many kinds
        raise Left(f"its shape cannot be read ({error})")
    if shape.isNull():
        raise Left("has no shape; recompute it, or choose an object with a solid, shell or face")
    if not shape.Faces:
        raise Left("has no faces (a sketch or wire); choose a solid, shell or face")
    return PartJob(**common, brep=shape.exportBrepToString().encode())


def _mesh(top, sub, leaf):
    import numpy

    points, facets = leaf.Mesh.Topology
    if not facets:
        raise Left("is an empty mesh; choose another one")
    vertices = numpy.fromiter((c for p in points for c in p), float, 3 * len(points)).reshape(-1, 3)
    # The points are where the mesh itself is; assemblies and links put it elsewhere.
    matrix = top.getSubObject(sub, retType=4) * leaf.Placement.toMatrix().inverse()
    a = numpy.array(matrix.A).reshape(4, 4)
    if not numpy.array_equal(a, numpy.eye(4)):
        vertices = vertices @ a[:3, :3].T + a[:3, 3]
    return dict(vertices=vertices, triangles=numpy.array(facets, dtype=numpy.int32))


def invalid(sources):
    """Labels of the objects among the sources whose shapes FreeCAD itself finds faulty. Slow: for messages."""
    import Part

    found, (parts, _) = [], collect(sources)
    for part in parts:
        if part.brep is None:
            continue
        shape = Part.Shape()
        shape.importBrepFromString(part.brep.decode())
        if not shape.isValid():
            found.append(part.name)
    return found


def _color(obj, leaf):
    for candidate in (obj, leaf):
        view = getattr(candidate, "ViewObject", None)
        color = getattr(view, "ShapeColor", None)
        if color:
            return "#%02x%02x%02x" % tuple(round(255 * c) for c in color[:3])
    return ""


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
        if not is_shown(obj) or obj.getParentGeoFeatureGroup() is not None:
            continue
        if obj.isDerivedFrom("App::DocumentObjectGroup"):
            continue  # a folder: what is in it is looked at by itself
        parts, _ = collect([(obj, ("",))])
        if parts:
            found.append(obj)
    return found
