"""Drawing files, read for the 3-D view beside the GUI: a large one takes a tenth of a second and more."""

import threading
import time

from PySide import QtCore

from . import ink

# Seconds that the GUI's thread may take at a time to put lines into the 3-D view.
SLICE = 0.01

_under_way = []
_clock = None  # one for all: who lets go of a timer in another thread may end FreeCAD


class _Reading:
    def __init__(self, obj, path, done):
        self.obj, self.path, self._done = obj, path, done
        self._given = []  # by the thread: what `ink.read` gives, or what went wrong
        self._pens, self._nodes = None, []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        try:
            self._given.append((ink.read(self.path), None))
        except Exception as error:  # of the kernel, of files, of JSON
            self._given.append((None, error))

    def go_on(self):
        """For a while; whether there is more to do."""
        if not self._given:
            return True
        found, error = self._given[0]
        if error is None:
            stand, pens, texts, painted = found
            end = time.monotonic() + SLICE
            while len(self._nodes) < len(pens):
                if time.monotonic() > end:
                    return True
                self._nodes.append(ink.lines_node(pens[len(self._nodes)]))
            if texts:
                self._nodes.append(ink.texts_node(stand, texts))
        else:
            stand = painted = None
        self._done(self, stand, self._nodes, painted, error)
        return False


def start(obj, path, done):
    """Reads a drawing file, and calls `done(reading, stand, nodes, painted, error)` later in the GUI's thread."""
    global _clock
    reading = _Reading(obj, path, done)
    _under_way.append(reading)
    if _clock is None:
        _clock = QtCore.QTimer()
        _clock.setInterval(15)
        _clock.timeout.connect(lambda: _look())
    _clock.start()
    return reading


def drop(reading):
    """Nobody wants it any more."""
    if reading in _under_way:
        _under_way.remove(reading)


def busy(obj=None):
    """Whether drawings are still to be shown, of an illustration or of any."""
    return any(obj is None or reading.obj is obj for reading in _under_way)


def _look():
    for reading in list(_under_way):
        if not reading.go_on():
            drop(reading)
    if not _under_way:
        _clock.stop()
