"""The parametric illustration: properties in, a drawing kept in the document out."""

import json
import os
import tempfile

from .. import hooks
from ..errors import Failed, Refused
from ..job import Job, shortened
from ..proxy import Stateless
from ..tell import ERROR, tell
from ..worker import Worker
from . import styles
from .apart import options_of
from .dimension import mark_left_out, own_dimensions, refused_of, rows_of
from .properties import CENTRE_LINES, ILLUSTRATION, ensure, is_newer
from .shapes import shapes
from .sources import collect, from_the_top


_worker = Worker()


def ask_to_end(what, job):
    """What a worker process answers to a job ("steps", "items"; see job.answer). Waits; with a window view.scheduler asks beside it.
    Throws Failed."""
    return _worker.do(what, job)


def run_to_end(obj, job, finish):
    """The scheduler of programs without a GUI: waits for the worker process."""
    try:
        result = _worker.draw(job)
    except Failed as error:
        finish(None, error)
        return
    finish(result, None)


# How runs are done: called with (object, job, finish). The GUI replaces it by one that returns at once and calls
# `finish(result, error)` later from the main thread.
scheduler = run_to_end


def ready(obj):
    """Whether the shapes of an illustration can be written now. The GUI replaces it by one that writes them a few at a
    time, and executes the illustration again when all are."""
    return True


def settle(obj):
    """Waits for the run of an illustration that is under way; whether it has ended. The GUI replaces it."""
    return True


class Illustration(Stateless):
    """The Proxy of an illustration. Documents name it as freecad.burin_wb.features.Illustration."""

    _restored = False

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, ILLUSTRATION)
        hooks.dress(obj)

    def onDocumentRestored(self, obj):
        self._restored = True
        ensure(obj, ILLUSTRATION)
        part_files(obj)
        hooks.dress(obj)
        if is_newer(obj):
            tell(f"{obj.Label}: {NEWER}")
        else:
            own_dimensions(obj)

    def execute(self, obj):
        if is_newer(obj):
            tell(f"{obj.Label}: {NEWER}")
            return
        if not ready(obj):
            return
        try:
            job = make_job(obj)
        except Refused as why:
            not_drawn(obj, why)
            return
        exact = job.exact_fingerprint()
        if self._is_drawn(obj, job, exact):
            self._take_as_drawn(obj, job, exact)
            return

        def finish(result, error):
            if error is None:
                try:
                    if result.drawing is None:
                        self._take_as_drawn(obj, job, exact)
                    else:
                        keep(obj, job, result, keep_numbers(obj, job, result) or exact)
                    return
                except OSError as failure:
                    error = (f"the drawing cannot be kept in the document ({reason(failure)}); free some disk space or save "
                             "the document elsewhere")
            not_drawn(obj, error)

        scheduler(obj, job, finish)

    def _is_drawn(self, obj, job, exact):
        """Whether the kept drawing is of these inputs."""
        if not obj.Drawing or not os.path.exists(obj.Drawing):
            return False
        kept_exact, _, kept = obj.Inputs.partition(":")
        if kept_exact == exact:
            return True
        if not self._restored:
            return False
        # Shapes come back from a file with other bytes; to see that they are the same takes a while.
        self._restored = False
        if getattr(scheduler, "beside", False):
            job.unless = kept
            return False
        return kept == job.fingerprint()

    @staticmethod
    def _take_as_drawn(obj, job, exact):
        """The kept drawing is the one of this job."""
        kept_exact, _, kept = obj.Inputs.partition(":")
        if kept_exact != exact:
            obj.Inputs = exact + ":" + kept
        refused = refused_of(obj, job)
        mark_left_out(obj, {**job.left, **refused})
        if job.notes or obj.Message:  # which may tell of what was left out of another job with the same drawing
            _say(obj, job, [*job.refusals(refused), *(job.without(refused).told(text) for text in messages_of(obj.Drawing))])


NEWER = "was made by a newer Burin; its kept drawing is shown and not drawn again. Install that version to change it"

KEPT = "; the drawing before is kept"


def messages_of(drawing):
    """What the kernel had to say of a kept drawing. Reads the end of the file alone, which may be long."""
    with open(drawing, encoding="utf-8") as file:
        text = file.read()
    _, said, rest = text.rpartition('"diagnostics": ')
    return [d["message"] for d in json.JSONDecoder().raw_decode(rest)[0]] if said else []


def not_drawn(obj, error):
    """A run did not end with a drawing: the one before stays, with a message."""
    text = str(error)
    if obj.Drawing:
        text += KEPT
    obj.Message = text
    tell(f"{obj.Label}: {text}", ERROR)


def reason(error):
    """What an exception says: FreeCAD's own have it in a dictionary."""
    said = error.args[0] if error.args else ""
    return said["sErrMsg"] if isinstance(said, dict) and "sErrMsg" in said else str(error)


def is_illustration(obj):
    return isinstance(getattr(obj, "Proxy", None), Illustration)


def make_job(obj):
    """What the kernel is to do for this object, as plain data. Throws Refused."""
    if not obj.Sources:
        raise Refused("nothing to draw: Sources is empty; choose parts, bodies, meshes or assemblies there")
    parts, notes = collect(obj.Sources, obj.Looks)
    shapes.trim()
    if not parts:
        raise Refused("nothing to draw: " + shortened(notes))
    style = styles.resolve(obj.Style, obj.Document)
    for part in parts:
        if part.style:
            part.style = styles.resolve(part.style, obj.Document)
    rows, left = rows_of(obj, parts, notes)
    options = {
        "view": tuple(obj.ViewDirection),
        "up": tuple(obj.ViewUp),
        "perspective": obj.FieldOfView.Value if obj.Projection == "Perspective" else None,
        "paper": (obj.Width.Value, obj.Height.Value),
        "margin": obj.Margin.Value,
        "scale": None if obj.FitScale else obj.Scale,
        "style": style,
        "set": {**dict(obj.StyleKeys), **({CENTRE_LINES: "true"} if obj.CentreLines else {})},
        "light": tuple(obj.Light),
        "hidden": obj.HiddenLines.lower(),
        "seed": obj.Seed,
        "tolerance": obj.Tolerance.Value or None,
        **options_of(obj, [part.source for part in parts], rows, notes),
    }
    return Job(parts, options, notes, styles.contents({style, *(p.style for p in parts)}), 
               measured={one.Name: (key, one.Label) for key, of in rows.items() for one, said in of if not isinstance(said, str)}, left=left)


def keep_numbers(obj, job, result):
    """New items have numbers from now on; the fingerprint of what the object asks for then. Nothing where it is as before."""
    if not result.numbers or result.numbers == dict(obj.ItemNumbers):
        return None
    obj.ItemNumbers = result.numbers
    return job.with_numbers(result.numbers).exact_fingerprint()


def _say(obj, job, messages):
    """What was left out, and what the kernel said."""
    text = shortened(job.notes + messages)
    if obj.Message != text:
        obj.Message = text


def keep(obj, job, result, exact):
    """Puts the result of a run into the document. Throws OSError."""
    _include(obj, "Drawing", result.drawing, ".json")
    _include(obj, "Picture", result.picture, ".svg")
    obj.DrawnScale = result.scale
    obj.Inputs = exact + ":" + result.fingerprint
    mark_left_out(obj, {**job.left, **result.left})
    _say(obj, job, result.messages)


def _include(obj, name, data, suffix):
    handle, path = tempfile.mkstemp(suffix=suffix, prefix="burin-")
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        # By a name of its own each time: copies of documents have files of the same names, and where objects are
        # copied from one to the other these must be the same files.
        setattr(obj, name, (path, os.path.basename(path)))
    finally:
        if os.path.exists(path):
            os.unlink(path)


def part_files(obj):
    """A copy of an object comes with the very files of its original, and each would write over or delete those of the
    other: gives the copy its own."""
    for name, suffix in (("Drawing", ".json"), ("Picture", ".svg")):
        path = getattr(obj, name)
        if not path or not os.path.exists(path):
            continue
        if not any(getattr(other, name, "") == path for other in obj.Document.Objects if other is not obj):
            continue
        with open(path, "rb") as file:
            data = file.read()
        mode = os.stat(path).st_mode
        _include(obj, name, data, suffix)  # takes the file away with it
        with open(path, "wb") as file:
            file.write(data)
        os.chmod(path, mode)


def make_illustration(document, sources, name="Illustration"):
    """A new illustration of `sources`, a list of objects or (object, sub-names). No transaction, no recompute."""
    obj = document.addObject("App::FeaturePython", name)
    Illustration(obj)
    obj.Sources = [_whole(*s) if isinstance(s, tuple) else _whole(s, ("",)) for s in sources]
    return obj


def _whole(obj, subs):
    """A source through the outermost assembly, so that moving the assembly is noticed."""
    subs = (subs,) if isinstance(subs, str) else tuple(subs) or ("",)
    tops = [from_the_top(obj, sub) for sub in subs]
    return tops[0][0], tuple(sub for _, sub in tops)
