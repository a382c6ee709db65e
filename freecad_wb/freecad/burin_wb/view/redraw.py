"""All illustrations of a document anew; the status bar tells of the runs and ends them."""

from PySide import QtCore

from ..features.illustration import KEPT
from ..features.stale import redraw_all
from ..job import shortened
from ..tell import NOTE, WARNING, tell
from ..text import tr
from . import scheduler

OFTEN = 100  # milliseconds between two looks whether all runs have ended

_under_way = []


class Redraw:
    """Tells in the end what was drawn."""

    def __init__(self, document):
        before = {obj.Name: obj.Drawing for obj in document.Objects if hasattr(obj, "Drawing")}
        self._objects = redraw_all(document)
        self._before = [before.get(obj.Name, "") for obj in self._objects]
        self._timer = QtCore.QTimer()
        self._timer.setInterval(OFTEN)
        self._timer.timeout.connect(lambda: self._look())
        self._timer.start()
        _under_way.append(self)

    def _look(self):
        try:
            if any(scheduler.install().busy(obj) for obj in self._objects):
                return
            self._tell()
        except ReferenceError:  # the document was closed
            pass
        self._timer.stop()
        _under_way.remove(self)

    def _tell(self):
        failed = [obj.Label for obj in self._objects if obj.Message.endswith(KEPT)]
        drawn = sum(obj.Drawing != before for obj, before in zip(self._objects, self._before))
        text = tr("{0} illustrations drawn anew, {1} as they were").format(drawn, len(self._objects) - drawn)
        if failed:
            text += "; " + tr("not drawn: {0}").format(shortened(failed, ", "))
        tell(text, WARNING if failed else NOTE)


def redraw(document):
    return Redraw(document)


def busy():
    """Whether the end is still to be told of."""
    return bool(_under_way)
