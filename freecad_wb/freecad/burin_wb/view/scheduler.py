"""Runs of the kernel beside the GUI: the newest job of an object wins, results come back in the GUI's thread."""

import threading
import time

import FreeCAD
from PySide import QtCore

from .. import worker
from ..features import illustration

# Seconds that a worker gets to end a cancelled job before it is ended itself.
PATIENCE = 1.0


class _Run:
    def __init__(self, key, job, finish):
        self.key, self.job, self.finish = key, job, finish
        self.stage, self.share = "waiting", 0.0
        self.cancelled = False
        self.started = None


class Scheduler(QtCore.QObject):
    """Called with (object, job, finish) as features.illustration.scheduler; returns at once."""

    progressed = QtCore.Signal(object, str, float)  # (document, object) names, stage, share
    ended = QtCore.Signal(object, object)  # names, error or None
    _came_back = QtCore.Signal(object, object, object)

    def __init__(self):
        super().__init__()
        self._worker = worker.Worker()
        self._waiting = []
        self._current = None
        self._lock = threading.Condition()
        self._came_back.connect(self._finish)
        self._thread = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(100)
        self._timer.timeout.connect(lambda: self._tell())

    def __call__(self, obj, job, finish):
        key = (obj.Document.Name, obj.Name)
        with self._lock:
            self._drop(key)
            self._waiting.append(_Run(key, job, finish))
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name="burin", daemon=True)
                self._thread.start()
            self._lock.notify()
        self._timer.start()

    def running(self, obj=None):
        """Whether a run is under way or waiting, of an object or of any."""
        with self._lock:
            runs = [r for r in [self._current, *self._waiting] if r and not r.cancelled]
        return any(obj is None or r.key == (obj.Document.Name, obj.Name) for r in runs)

    def cancel(self, obj):
        """Ends the runs of an object; what it shows stays as it is."""
        with self._lock:
            self._drop((obj.Document.Name, obj.Name))

    def _drop(self, key):
        """With the lock held."""
        self._waiting = [r for r in self._waiting if r.key != key]
        run = self._current
        if run is not None and run.key == key and not run.cancelled:
            run.cancelled = True
            self._worker.cancel()
            threading.Timer(PATIENCE, self._lose_patience, (run,)).start()

    def _lose_patience(self, run):
        with self._lock:
            still = self._current is run
        if still:
            self._worker.stop()

    def _work(self):
        while True:
            with self._lock:
                while not self._waiting:
                    self._current = None
                    self._lock.wait()
                self._current = run = self._waiting.pop(0)
                run.started = time.monotonic()
            result = error = None
            try:
                result = self._worker.draw(run.job, lambda stage, share: self._note(run, stage, share))
            except worker.Stopped:
                error = worker.Stopped("cancelled; the drawing shown is the one before")
            except Exception as failure:
                error = failure
            self._came_back.emit(run, result, error)

    @staticmethod
    def _note(run, stage, share):
        run.stage, run.share = stage, share

    def _tell(self):
        run = self._current
        if run is None:
            if not self._waiting:
                self._timer.stop()
            return
        if not run.cancelled:
            self.progressed.emit(run.key, run.stage, run.share)

    def _finish(self, run, result, error):
        """In the GUI's thread."""
        obj = _object(run.key)
        if obj is None or run.cancelled and not isinstance(error, worker.Stopped):
            return
        if not run.cancelled or isinstance(error, worker.Stopped) and not self.running(obj):
            run.finish(result, error)
            if error is None:
                _follow(obj)
        self.ended.emit(run.key, error)


def _object(key):
    try:
        return FreeCAD.getDocument(key[0]).getObject(key[1])
    except NameError:  # the document was closed meanwhile
        return None


def _follow(obj):
    """What shows the drawing elsewhere in the document shows the new one."""
    obj.purgeTouched()
    for other in obj.InList:
        if getattr(other, "Illustration", None) is obj:
            other.touch()
            other.recompute()


scheduler = None


def install():
    """From now on runs do not stop the GUI."""
    global scheduler
    if scheduler is None:
        scheduler = Scheduler()
        illustration.scheduler = scheduler
    return scheduler
