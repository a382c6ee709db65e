"""Dimensions and notes of an illustration: objects of the document that name the faces, edges and vertices that are measured or pointed at,
so that these links follow the model as all of FreeCAD's do."""

import re

from .. import hooks
from ..errors import Refused
from ..proxy import Stateless
from ..text import tr
from . import note
from .found import drawn, features_of, for_kernel, found_of, now, point_for_kernel, text_of
from .measured import ends_of, kind_of, may_have, measured
from .note import NOTE
from .properties import DIMENSION, NOT_OF_NOTES, OF_NOTES, ensure, is_newer, show_alone
from .sources import from_the_top, survey

OVERALL = "Overall"
PAIRS = ("Distance", "Angle")
MOST_DECIMALS = 6

_NUMBER = r"[-+]?\d+(?:[.,]\d+)?"
_DEVIATIONS = re.compile(rf"\s*({_NUMBER})\s*[/;]\s*({_NUMBER})\s*$")


class Dimension(Stateless):
    """The Proxy of a dimension or a note. Documents name it as freecad.burin_wb.features.Dimension."""

    def __init__(self, obj):
        obj.Proxy = self
        self.onDocumentRestored(obj)

    def onDocumentRestored(self, obj):
        ensure(obj, DIMENSION)
        self._show(obj)
        hooks.dress(obj)

    @staticmethod
    def _show(obj):
        """The properties of its kind alone."""
        show_alone(obj, *((OF_NOTES, NOT_OF_NOTES) if is_note(obj) else (NOT_OF_NOTES, OF_NOTES)))

    def onChanged(self, obj, name):
        """Features that are chosen again for lost ones are others, even where they have the same names."""
        if name == "Kind" and "Restore" not in obj.State:
            self._show(obj)
        if name == "Features" and getattr(obj, "Message", "") and getattr(obj, "Kept", ()) and not obj.Document.Transacting \
                and "Restore" not in obj.State:
            obj.Kept = []

    def execute(self, obj):
        """Follows what it names, and says what is wrong with it; never fails, for FreeCAD would not draw the illustration then."""
        if is_newer(obj):
            return
        text, found = _problem(obj)
        if not text:
            _follow(obj, found)
        tell_why(obj, text or obj.LeftOut)


def is_dimension(obj):
    return isinstance(getattr(obj, "Proxy", None), Dimension)


def is_note(dimension):
    return getattr(dimension, "Kind", "") == NOTE


def dimensions_of(illustration):
    """Notes are among them."""
    return [one for one in getattr(illustration, "Dimensions", ()) if is_dimension(one)]


def illustrations_of(dimension):
    return [obj for obj in dimension.InList if dimension in dimensions_of(obj)]


def tell_why(dimension, text):
    """Sets why it is not drawn."""
    if dimension.Message != text:
        dimension.Message = text


def own_dimensions(illustration):
    """A copy of an illustration comes with the dimensions of its original: gives it its own."""
    others = [one for other in illustration.Document.Objects if other is not illustration for one in dimensions_of(other)]
    if any(one in others for one in illustration.Dimensions):
        illustration.Dimensions = [_copy(one) if one in others else one for one in illustration.Dimensions]


def _copy(one):
    obj = _new(one.Document, one.Kind)
    for name in ("Label", *(row.name for row in DIMENSION)):
        setattr(obj, name, getattr(one, name))
    return obj


def _new(document, kind):
    obj = document.addObject("App::FeaturePython", "Note" if kind == NOTE else "Dimension")
    Dimension(obj)
    obj.Kind = kind
    return obj


def make_note(illustration, features=(), **properties):
    """A new note of an illustration, with a leader to each of `features`, (object, sub-name) each, "" for the object as a whole. Text,
    Frame, Symbol ... are `properties`. No transaction, no recompute. Throws Refused."""
    found = [now(*from_the_top(obj, sub), wholes=True) for obj, sub in features]
    parts = [piece.part for piece in survey(illustration.Sources)[0]]
    for one in found:
        note.target(one, parts)  # which is drawn
    return _made(illustration, NOTE, found, properties)


def make_dimension(illustration, features=(), kind="", **properties):
    """A new dimension of an illustration: of `features`, (object, sub-name) each; of none: the overall ones. `kind`: a word of the
    property Kind; empty: what the features have. No transaction, no recompute. Throws Refused."""
    found = [now(*from_the_top(obj, sub)) for obj, sub in features]
    sources = [piece.part.source for piece in survey(illustration.Sources)[0]]
    elements = _elements(found, sources)
    has, why = kind_of([one.shape for one in found])
    if not kind and why:
        raise Refused(why)
    if not features and any(one.Kind == OVERALL for one in dimensions_of(illustration)):
        raise Refused(tr("{0} has its overall dimensions already; select faces or edges for others").format(illustration.Label))
    for one in dimensions_of(illustration):
        if features and _is_like(one, kind or has, elements, properties, sources):
            raise Refused(tr("{0} measures this already; select other faces or edges").format(one.Label))
    return _made(illustration, kind or has, found, properties)


def _made(illustration, kind, found, properties):
    obj = _new(illustration.Document, kind)
    obj.Label = kinds()[kind]
    _follow(obj, found)
    for name, value in properties.items():
        setattr(obj, name, value)
    illustration.Dimensions = [*illustration.Dimensions, obj]
    return obj


def kinds():
    """The words of Kind in the user's language."""
    return {OVERALL: tr("Overall dimensions"), "Distance": tr("Distance"), "Diameter": tr("Diameter"), "Radius": tr("Radius"),
            "Angle": tr("Angle"), "Depth": tr("Depth"), "Thread": tr("Thread"), NOTE: tr("Note")}


def _elements(found, sources):
    """What features are in what is drawn, in any order. Throws Refused."""
    return sorted(drawn(one, sources)[:2] for one in found)


def _is_like(one, kind, elements, properties, sources):
    """Whether a dimension measures these elements, and has those of the properties that tell two of one kind apart."""
    if one.Kind != kind or any(getattr(one, name) != properties[name] for name in ("Along", "Supplement", "View") if name in properties):
        return False
    try:
        return _elements(found_of(one), sources) == elements
    except Refused:
        return False


def _follow(one, found):
    """Names its elements as they are called now, and keeps what they look like. What is as before is not set: that would be a change."""
    names = [(each.top, each.sub) for each in found]
    if names != features_of(one):
        one.Features = [(top, (sub,)) for top, sub in names]
    texts = [text_of(each) for each in found]
    if texts != list(one.Kept):
        one.Kept = texts


def rows_of(obj, parts, notes):
    """By their keys in illustrations: the dimensions and the notes of one, and these as the kernel takes them, by pairs; and why others are
    left out, by their names, which is told. `parts`: PartJobs."""
    rows, left = {"dimensions": [], "notes": []}, {}
    for one in dimensions_of(obj):
        try:
            rows["notes" if is_note(one) else "dimensions"].append((one, _said(one, parts)))
        except Refused as why:
            notes.append(f"{one.Label}: {why}")
            left[one.Name] = str(why)
    return rows, left


def refused_of(obj, job):
    """Of the dimensions that a job has those that the kernel refused the last time, by their names, and why."""
    return {one.Name: one.LeftOut for one in dimensions_of(obj) if one.LeftOut and one.Name in job.measured}


def mark_left_out(obj, left):
    """Has dimensions tell why a drawing is without them, which is the tree's mark; `left` by their names. It is no change of theirs."""
    for one in dimensions_of(obj):
        why = left.get(one.Name, "")
        if one.LeftOut == why or is_newer(one):
            continue
        touched = "Touched" in one.State
        tell_why(one, why if one.Message in ("", one.LeftOut) else one.Message)
        one.LeftOut = why
        if not touched:
            one.purgeTouched()


def _said(one, parts):
    """Throws Refused."""
    text, found = _problem(one)
    if text:
        raise Refused(text)
    if one.Kind == OVERALL:
        return one.Kind.lower()
    row = note.said(one, found, parts) if is_note(one) else _measured(one, found, [part.source if part.drawn else "" for part in parts])
    if one.Decimals >= 0:
        row["decimals"] = min(one.Decimals, MOST_DECIMALS)
    if one.View.strip():
        row["view"] = one.View.strip()
    return row


def _measured(one, found, sources):
    of = [drawn(each, sources) for each in found]
    if one.Kind == "Distance" and len(of) == 1:
        of = [point_for_kernel(end) for end in ends_of(of[0][2])]
    else:
        of = [for_kernel(*each) for each in of]
    row = {one.Kind.lower(): of if one.Kind in PAIRS else of[0]}
    if one.Kind == "Distance" and one.Along.Length > 0:
        row["along"] = list(one.Along)
    if one.Kind == "Angle" and one.Supplement:
        row["supplement"] = True
    row.update({key: value for key, value in (("text", one.Text.strip()), ("tolerance", tolerance_of(one.Tolerance))) if value})
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


def _problem(one):
    """Why it cannot be drawn, empty where it can be; and its elements."""
    if one.Kind == OVERALL:
        return "", []
    try:
        found = found_of(one, wholes=is_note(one))
    except Refused as why:
        return str(why), []
    if is_note(one):
        return note.problem(one, found), found
    return _problem_of_shapes(one, [each.shape for each in found]), found


def _problem_of_shapes(one, shapes):
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
