"""From document objects to parts: assemblies are taken apart, placements and names kept."""

from ..job import PartJob


class Left(Exception):
    """An object that cannot be drawn; the text says why."""


def collect(sources, looks=None):
    """Parts and notes of a list of (object, sub-names) as LinkSubList properties give it."""
    parts, notes, seen = [], [], set()
    for obj, subs in sources:
        for sub in _objects_of(subs):
            _walk(obj, sub, True, parts, notes, seen, looks or {})
    return parts, notes


def _objects_of(subs):
    """The object parts of sub-names: 'Body.Face3' is 'Body.'; an element of the object itself is ''."""
    names = {s[: s.rfind(".") + 1] for s in subs if s} if subs else {""}
    return sorted(names) or [""]


def _walk(top, sub, asked, parts, notes, seen, looks):
    resolved = top.getSubObject(sub, retType=1) if sub else top
    path = top.Name + ("." + sub.rstrip(".") if sub else "")
    if resolved is None:
        notes.append(f"{path}: the object is gone; choose the sources again")
        return
    if path in seen:
        return
    seen.add(path)
    leaf = resolved.getLinkedObject(True)
    if not asked and not _visible(top, sub, resolved):
        return
    if leaf is None:
        notes.append(f"{resolved.Label}: links to something that is not there; repair the link")
        return
    if _is_container(leaf):
        for child in resolved.getSubObjects():
            _walk(top, sub + child, False, parts, notes, seen, looks)
        return
    try:
        part = _part(top, sub, resolved, leaf, path)
    except Left as why:
        if asked:
            notes.append(f"{resolved.Label}: {why}")
        return
    _apply_looks(part, looks.get(path) or looks.get(resolved.Name) or "")
    parts.append(part)


def _visible(top, sub, obj):
    return bool(getattr(obj, "Visibility", True))


def _is_container(obj):
    if obj.isDerivedFrom("PartDesign::Body") or hasattr(obj, "Shape") and not obj.hasExtension(
        "App::GroupExtension"
    ):
        return False
    return obj.isDerivedFrom("App::Part") or obj.hasExtension("App::GroupExtension")


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
        raise Left("is an empty mesh")
    vertices = numpy.fromiter((c for p in points for c in p), float, 3 * len(points)).reshape(-1, 3)
    if sub:
        matrix = top.getSubObject(sub, retType=4)
        own = leaf.Placement.toMatrix().inverse()
        a = numpy.array((matrix * own).A).reshape(4, 4)
        vertices = vertices @ a[:3, :3].T + a[:3, 3]
    return dict(vertices=vertices, triangles=numpy.array(facets, dtype=numpy.int32))


def _color(obj, leaf):
    for candidate in (obj, leaf):
        view = getattr(candidate, "ViewObject", None)
        color = getattr(view, "ShapeColor", None)
        if color:
            return "#%02x%02x%02x" % tuple(round(255 * c) for c in color[:3])
    return ""


def _apply_looks(part, words):
    for word in (w.strip() for w in words.split(";")):
        if word == "not drawn":
            part.drawn = False
        elif word == "not hatched":
            part.hatched = False
        elif word == "transparent":
            part.transparent = True
        elif word.startswith("style="):
            part.style = word[len("style=") :]
