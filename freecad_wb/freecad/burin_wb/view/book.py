"""Step books beside the GUI: the status bar tells of them and can end them."""

from PySide import QtCore

from .. import step_book
from ..errors import Refused
from ..tell import tell
from . import scheduler
from .runs import Writing

_under_way = []


class Making:
    """Shapes are written a few at a time, as before drawings; then the worker draws and writes."""

    def __init__(self, obj, file, new_items):
        self.obj, self._file, self._new_items = obj, file, new_items
        self._label = obj.Label
        step_book.check([file], new_items)
        self._writing = Writing(obj)
        self._slices = QtCore.QTimer()
        self._slices.setInterval(0)
        self._slices.timeout.connect(lambda: self._go_on())
        self._slices.start()
        self._runs = scheduler.install()
        self._runs.left.connect(self._left)
        self._key = obj.Document.Name, obj.Name
        _under_way.append(self)

    def _go_on(self):
        try:
            if not self._writing.go_on():
                return
            job = step_book.job_of(self.obj, [self._file], self._new_items)
        except (Refused, ReferenceError) as why:  # the document may be closed
            self._end()
            tell(f"{self._label}: {why}")
            return
        self._slices.stop()
        self._runs.ask("book", self.obj, job, self._done)

    def _done(self, answer, error):
        self._end()
        if error is None:
            step_book.written(self._label, [self._file], answer)
        else:
            tell(f"{self._label}: {error}")

    def _left(self, document, name):
        """The document is closed: the end is not reported."""
        if document == self._key[0] and not name:
            self._end()

    def _end(self):
        self._slices.stop()
        if self in _under_way:
            _under_way.remove(self)
            self._runs.left.disconnect(self._left)


def make(obj, file, new_items=step_book.NEW_ITEMS):
    """Writes a step book of an illustration; returns at once. Throws Refused."""
    return Making(obj, file, new_items)


def busy():
    """Whether one is still to be written, or its end to be told of."""
    return bool(_under_way)
