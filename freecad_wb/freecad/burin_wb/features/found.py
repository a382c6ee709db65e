"""Where faces, edges and vertices that are measured or noted are now: in the objects that Features name, and in the shapes that are
drawn, which for the steps of a body are others."""

import json
import re
from collections import namedtuple

import Part

from ..errors import Refused
from ..text import tr
from . import kept
from .looks import path_of
from .sources import from_the_top

_ELEMENT = re.compile(r"(Face|Edge|Vertex)\d+")

# An element: `sub` names it in its object, `base` is the shape of that in its own coordinates, `shape` itself in those of the model. Of a
# whole object both are nothing.
Found = namedtuple("Found", "top sub base shape")


def called(top, sub):
    return f"{path_of(top, sub)}.{sub.rpartition('.')[2].lstrip('?')}".rstrip(".")


def now(top, sub, text="", wholes=False):
    """An element as it is now, with `wholes` an object too. `text`: what was kept of it. Throws Refused where there is no such element any
    more; FreeCAD 1.0 marks lost ones with a question mark."""
    inside, dot, name = sub.rpartition(".")
    if wholes and not name:
        return _object(top, sub)
    whole = _whole(top, inside + dot)
    known = _known(text, called(top, sub))
    if not _ELEMENT.fullmatch(name.lstrip("?") if known else name):
        raise _gone(top, sub)
    base = kept.own(whole)
    name = kept.find(base, known, _place(top, inside)) if known else name
    shape = kept.element(whole, name) if name else None
    if shape is None:
        raise _gone(top, sub)
    return Found(top, inside + dot + name, base, shape)


def _object(top, sub):
    """Throws Refused."""
    try:
        obj = top.getSubObject(sub, retType=1) if sub else top
    except Exception:  # FreeCAD throws many kinds for names that it does not know
        obj = None
    if obj is None:
        raise _gone(top, sub)
    return Found(top, sub, None, None)


def text_of(found):
    """What is kept of an element; of an object nothing."""
    if found.shape is None:
        return ""
    inside, _, name = found.sub.rpartition(".")
    return json.dumps({"of": called(found.top, found.sub), **kept.keep(found.base, name, _place(found.top, inside))})


def drawn(found, sources):
    """The number of the part that an element is of, its object's or that of a body in which that is a step; its name there, and itself.
    Throws Refused."""
    path = path_of(found.top, found.sub)
    for k, source in enumerate(sources):
        if source and f"{path}.".startswith(f"{source}."):
            return (k, *_in_source(found, path, source))
    raise left_out(path)


def left_out(path):
    return Refused(tr("{0} is not drawn here; add it to Sources, or choose other Features").format(path))


def for_kernel(part, name, shape):
    """An element that is `drawn`, as the kernel takes it."""
    kind, number = kept.split(name)
    return point_for_kernel(shape.Point) if kind == "Vertex" else {"part": f"@index={part}", kind.lower(): number - 1}


def point_for_kernel(at):
    return {"point": [round(a, 9) + 0.0 for a in at]}


def features_of(dimension):
    """(object, sub-name) of each face, edge, vertex or object, through the outermost assembly."""
    return [from_the_top(obj, sub) for obj, subs in dimension.Features for sub in subs]


def found_of(dimension, wholes=False):
    """The elements of a dimension as they are now, with `wholes` objects too. Throws Refused."""
    texts = list(dimension.Kept)
    return [now(top, sub, texts[k] if k < len(texts) else "", wholes) for k, (top, sub) in enumerate(features_of(dimension))]


def _in_source(found, path, source):
    name = found.sub.rpartition(".")[2]
    if path == source:
        return name, found.shape
    inside = source.partition(".")[2]
    whole = _whole(found.top, inside + "." if inside else "")
    name = kept.in_other(whole, name, kept.print_of(found.shape))
    if not name:
        raise _gone(found.top, found.sub)
    return name, kept.element(whole, name)


def _whole(top, sub):
    """The shape of an object, in the coordinates of the model. Throws Refused."""
    try:
        shape = Part.getShape(top, sub, needSubElement=False, transform=True)
        if not shape.isNull():
            return shape
        obj = top.getSubObject(sub, retType=1) if sub else top
        is_mesh = obj is not None and obj.getLinkedObject(True).isDerivedFrom("Mesh::Feature")
    except Exception:  # FreeCAD throws many kinds for names that it does not know
        is_mesh = False
    if is_mesh:
        raise Refused(tr("{0} is a mesh, which has no faces and edges that can be measured").format(obj.Label))
    raise _gone(top, sub)


def _gone(top, sub):
    return Refused(tr("{0} is gone; choose its Features again, or delete it").format(called(top, sub)))


def _known(text, name):
    """What was kept of an element of this name; nothing where another one was chosen since."""
    known = json.loads(text) if text else {}
    return known if known.get("of") == name else None


def _place(top, inside):
    return top.Document.Name, f"{top.Name}.{inside}"
