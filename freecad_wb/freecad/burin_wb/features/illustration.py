"""The parametric illustration: properties in, a drawing kept in the document out."""

import os
import tempfile

import FreeCAD

from .. import worker
from ..job import Job
from .properties import ILLUSTRATION, SCHEMA, ensure
from .sources import collect


_worker = worker.Worker()


def run_to_end(obj, job, finish):
    """The scheduler of programs without a GUI: waits for the worker process."""
    try:
        result = _worker.draw(job)
    except worker.Failed as error:
        finish(None, error)
        return
    finish(result, None)


# How runs are done: called with (object, job, finish). The GUI replaces it by one that returns at once and calls
# `finish(result, error)` later from the main thread.
scheduler = run_to_end


class Illustration:
    """The Proxy of an illustration. Documents name it as freecad.burin_wb.features.Illustration."""

    _restored = False

    def __init__(self, obj):
        obj.Proxy = self
        ensure(obj, ILLUSTRATION)
        _dress(obj)

    def onDocumentRestored(self, obj):
        self._restored = True
        ensure(obj, ILLUSTRATION)
        _dress(obj)
        if obj.Schema > SCHEMA:
            FreeCAD.Console.PrintWarning(
                f"{obj.Label}: was made by a newer Burin; its drawing is shown as it was kept\n"
            )

    def execute(self, obj):
        if obj.Schema > SCHEMA:
            return
        job = make_job(obj)
        exact = job.exact_fingerprint()
        if self._is_drawn(obj, job, exact):
            return

        def finish(result, error):
            if error is not None:
                obj.Message = str(error)
                FreeCAD.Console.PrintError(f"{obj.Label}: {error}\n")
                return
            keep(obj, result, exact)

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
        # Shapes come back from a file with other bytes.
        self._restored = False
        if kept != job.fingerprint():
            return False
        obj.Inputs = exact + ":" + kept
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def _dress(obj):
    """With a GUI: the view provider, which documents saved without a GUI have lost, and runs beside the GUI."""
    if FreeCAD.GuiUp:
        from .. import view

        view.dress(obj)


def is_illustration(obj):
    return isinstance(getattr(obj, "Proxy", None), Illustration)


def make_job(obj):
    """What the kernel is to do for this object, as plain data."""
    parts, notes = collect(obj.Sources, obj.Looks)
    options = {
        "view": tuple(obj.ViewDirection),
        "up": tuple(obj.ViewUp),
        "perspective": obj.FieldOfView.Value if obj.Projection == "Perspective" else None,
        "paper": (obj.Width.Value, obj.Height.Value),
        "margin": obj.Margin.Value,
        "scale": None if obj.FitScale else obj.Scale,
        "style": obj.Style,
        "set": dict(obj.StyleKeys),
        "light": tuple(obj.Light),
        "hidden": obj.HiddenLines.lower(),
        "seed": obj.Seed,
        "tolerance": obj.Tolerance.Value or None,
    }
    return Job(parts, options, notes)


def keep(obj, result, exact):
    """Puts the result of a run into the document."""
    _include(obj, "Drawing", result.drawing, ".json")
    _include(obj, "Picture", result.picture, ".svg")
    obj.DrawnScale = result.scale
    obj.Inputs = exact + ":" + result.fingerprint
    obj.Message = "; ".join(result.messages)


def _include(obj, name, data, suffix):
    handle, path = tempfile.mkstemp(suffix=suffix, prefix="burin-")
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        setattr(obj, name, path)
    finally:
        if os.path.exists(path):
            os.unlink(path)


def make_illustration(document, sources, name="Illustration"):
    """A new illustration of `sources`, a list of objects or (object, sub-names). No transaction, no recompute."""
    obj = document.addObject("App::FeaturePython", name)
    Illustration(obj)
    obj.Sources = [s if isinstance(s, tuple) else (s, ("",)) for s in sources]
    return obj
