"""Dimensions of an illustration: objects of the document that name the faces, edges and vertices that are measured, so that these links
follow the model as all of FreeCAD's do."""

import re

from .. import hooks
from ..errors import Refused
from ..text import tr
from .details import shape_at
from .looks import path_of
from .measured import ends_of, kind_of, may_have, measured
from .properties import DIMENSION, ensure, is_newer
from .sources import from_the_top, survey

OVERALL = "Overall"
PAIRS = ("Distance", "Angle")
MOST_DECIMALS = 6

_NUMBER = r"[-+]?\d+(?:[.,]\d+)?"
_DEVIATIONS = re.compile(rf"\s*({_NUMBER})\s*[/;]\s*({_NUMBER})\s*$")


class Dimension:
    """The Proxy of a dimension. Documents name it as freecad.burin_wb.features.Dimension."""

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, DIMENSION)
        hooks.dress(obj)

    def onDocumentRestored(self, obj):
        ensure(obj, DIMENSION)
        hooks.dress(obj)

    def execute(self, obj):
        """Says what is wrong with it; never fails, for FreeCAD would not draw the illustration then."""
        if is_newer(obj):
            return
        text = _problem(obj)
        if obj.Message != text:
            obj.Message = text

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def is_dimension(obj):
    return isinstance(getattr(obj, "Proxy", None), Dimension)


def dimensions_of(illustration):
    return [one for one in getattr(illustration, "Dimensions", ()) if is_dimension(one)]


def illustrations_of(dimension):
    return [obj for obj in dimension.InList if dimension in dimensions_of(obj)]


def features_of(dimension):
    """(object, sub-name) of each face, edge or vertex, through the outermost assembly."""
    return [from_the_top(obj, sub) for obj, subs in dimension.Features for sub in subs]


def make_dimension(illustration, features=(), kind="", **properties):
    """A new dimension of an illustration: of `features`, (object, sub-name) each; of none: the overall ones. `kind`: a word of the
    property Kind; empty: what the features have. No transaction, no recompute. Throws Refused."""
    features = [from_the_top(obj, sub) for obj, sub in features]
    sources = [piece.part.source for piece in survey(illustration.Sources)[0]]
    for top, sub in features:
        _part_of(top, sub, sources)
    found, why = kind_of([_shape(top, sub) for top, sub in features])
    if not kind and why:
        raise Refused(why)
    if not features and any(one.Kind == OVERALL for one in dimensions_of(illustration)):
        raise Refused(tr("{0} has its overall dimensions already; select faces or edges for others").format(illustration.Label))
    obj = illustration.Document.addObject("App::FeaturePython", "Dimension")
    Dimension(obj)
    obj.Kind, obj.Label = kind or found, kinds()[kind or found]
    obj.Features = [(top, (sub,)) for top, sub in features]
    for name, value in properties.items():
        setattr(obj, name, value)
    illustration.Dimensions = [*illustration.Dimensions, obj]
    return obj


def kinds():
    """The words of Kind in the user's language."""
    return {OVERALL: tr("Overall dimensions"), "Distance": tr("Distance"), "Diameter": tr("Diameter"), "Radius": tr("Radius"),
            "Angle": tr("Angle"), "Depth": tr("Depth"), "Thread": tr("Thread")}


def rows_of(obj, parts, notes):
    """The labels of the dimensions of an illustration, and these as the kernel takes them. What cannot be measured any more is told and
    left out. `parts`: PartJobs."""
    sources = [part.source if part.drawn else "" for part in parts]
    rows = []
    for one in dimensions_of(obj):
        try:
            rows.append((one.Label, _said(one, sources)))
        except Refused as why:
            notes.append(f"{one.Label}: {why}")
    return rows


def _said(one, sources):
    """Throws Refused."""
    text = _problem(one)
    if text:
        raise Refused(text)
    if one.Kind == OVERALL:
        return one.Kind.lower()
    of = [_feature(top, sub, sources) for top, sub in features_of(one)]
    if one.Kind == "Distance" and len(of) == 1:
        of = [_point(end) for end in ends_of(_shape(*features_of(one)[0]))]
    row = {one.Kind.lower(): of if one.Kind in PAIRS else of[0]}
    if one.Kind == "Distance" and one.Along.Length > 0:
        row["along"] = list(one.Along)
    if one.Kind == "Angle" and one.Supplement:
        row["supplement"] = True
    if one.Decimals >= 0:
        row["decimals"] = min(one.Decimals, MOST_DECIMALS)
    row.update({key: value for key, value in (("text", one.Text.strip()), ("tolerance", tolerance_of(one.Tolerance)), ("view", one.View.strip()))
                if value})
    return row


def tolerance_of(text):
    """As the kernel takes it: "H7" and "±0.1" as they are, "+0.1/-0.2" as two deviations, a number alone with its sign."""
    both = _DEVIATIONS.match(text)
    if both:
        return list(both.groups())
    text = text.strip()
    return f"±{text}" if re.fullmatch(r"\d+(?:[.,]\d+)?", text) else text


def tolerance_text(tolerance):
    """The other way round."""
    if isinstance(tolerance, list):
        return "/".join(one if isinstance(one, str) else f"{one:+g}" for one in tolerance)
    return tolerance if isinstance(tolerance, str) else f"{tolerance:g}"


def _feature(top, sub, sources):
    shape = _shape(top, sub)
    if shape.ShapeType == "Vertex":
        _part_of(top, sub, sources)
        return _point(shape.Point)
    element = sub.rpartition(".")[2]
    kind = "face" if element.startswith("Face") else "edge"
    return {"part": f"@index={_part_of(top, sub, sources)}", kind: int(element[len(kind):]) - 1}


def _point(at):
    return {"point": [round(a, 9) + 0.0 for a in at]}


def _part_of(top, sub, sources):
    """The number of the part that an element is of: its object's, or that of a body in which the object is a step. Throws Refused."""
    path = path_of(top, sub)
    for k, source in enumerate(sources):
        if source and f"{path}.".startswith(f"{source}."):
            return k
    raise Refused(tr("{0} is not drawn here; add it to Sources, or delete the dimension").format(path))


def _shape(top, sub):
    """Throws Refused where there is no such element any more; FreeCAD 1.0 marks lost ones with a question mark."""
    try:
        if "?" not in sub:
            shape = shape_at(top, sub)
            if not shape.isNull() and shape.ShapeType in ("Face", "Edge", "Vertex"):
                return shape
    except Exception:  # FreeCAD throws many kinds for names that it does not know
        pass
    raise Refused(tr("{0} is gone; choose its Features again, or delete it").format(f"{path_of(top, sub)}.{sub.rpartition('.')[2].lstrip('?')}"))


def _problem(one):
    """Why nothing can be measured; empty where it can be."""
    if one.Kind == OVERALL:
        return ""
    features = features_of(one)
    try:
        shapes = [_shape(top, sub) for top, sub in features]
    except Refused as why:
        return str(why)
    if not shapes:
        return tr("its features are gone; choose its Features again, or delete it")
    if one.Kind in PAIRS:
        return _problem_of_pair(one, shapes)
    if len(shapes) != 1 or not may_have(one.Kind, shapes[0]):
        return tr("Kind {0} needs one round face or edge that has it, in Features").format(one.Kind)
    if one.Kind == "Thread" and not one.Text.strip():
        return tr("a thread needs Text, such as M8: its shape alone does not tell")
    return ""


def _problem_of_pair(one, shapes):
    alone = one.Kind == "Distance" and len(shapes) == 1 and measured(shapes[0]).kind == "line"
    if alone:
        return ""
    if len(shapes) != 2:
        return tr("Kind {0} needs two faces, edges or vertices in Features").format(one.Kind)
    found, why = kind_of(shapes)
    if one.Kind == found or one.Kind == "Distance" and one.Along.Length > 0:
        return ""
    return why or tr("its features have Kind {0}, not {1}; change Kind, or choose its Features again").format(found, one.Kind)
