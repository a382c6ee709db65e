"""Runs of the kernel beside the GUI: the newest job of an object wins, results come back in the GUI's thread."""

import collections
import threading

import FreeCAD
from PySide import QtCore

from .. import worker
from ..features import illustration, is_illustration
from .text import tr

# Seconds that a worker gets to end a cancelled job before it is ended itself.
PATIENCE = 1.0

# Results that are kept, so that undo and redo show at once what was drawn before.
KEPT = 8


class _Run:
    def __init__(self, obj, job, inputs, finish):
        self.obj, self.key = obj, (obj.Document.Name, obj.Name)
        self.job, self.inputs, self.finish = job, inputs, finish
        self.stage, self.share = "", 0.0
        self.cancelled = False
        self.replaced = False  # by a newer one: nothing to tell


class Scheduler(QtCore.QObject):
    """Called with (object, job, finish) as features.illustration.scheduler; returns at once."""

    progressed = QtCore.Signal(object, str, float)  # (document, object) names, stage, share
    ended = QtCore.Signal(object, object)  # names, error or None
    began = QtCore.Signal(object)  # names
    _came_back = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._worker = worker.Worker()
        self._waiting = []
        self._current = None
        self._kept = collections.OrderedDict()
        self._ended_runs = collections.deque()
        self.count = 0  # runs of the kernel so far
        self._lock = threading.Condition()
        self._came_back.connect(self._collect, QtCore.Qt.QueuedConnection)
        self._thread = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(100)
        self._timer.timeout.connect(lambda: self._tell())

    def __call__(self, obj, job, finish):
        key = (obj.Document.Name, obj.Name)
        inputs = job.exact_fingerprint()
        result = self._kept.get(inputs)
        with self._lock:
            self._drop(key)
            if self._current is not None and self._current.key == key:
                self._current.replaced = True
            if result is None:
                self._waiting.append(_Run(obj, job, inputs, finish))
        if result is not None:
            finish(result, None)
            self._after(obj, key, None)
            return
        with self._lock:
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name="burin", daemon=True)
                self._thread.start()
            self._lock.notify()
        self._timer.start()
        self.began.emit(key)

    def warm(self):
        """Starts the worker ahead of the first run, which then is as quick as the others."""

        def start():
            try:
                self._worker.start()
            except worker.Failed:
                pass  # the first run will tell

        threading.Thread(target=start, daemon=True).start()

    def running(self, obj=None):
        """Whether a run is under way or waiting, of an object or of any."""
        with self._lock:
            runs = [r for r in [self._current, *self._waiting] if r and not r.cancelled]
        return any(obj is None or r.key == (obj.Document.Name, obj.Name) for r in runs)

    def busy(self, obj=None):
        """As running, and also while a run that was cancelled comes to its end or has still to be told."""
        with self._lock:
            runs = [r for r in [self._current, *self._waiting] if r] + [r for r, _, _ in list(self._ended_runs)]
        return any(obj is None or r.obj is obj for r in runs)

    def cancel(self, obj, tell=True):
        """Ends the runs of an object; what it shows stays as it is."""
        key = (obj.Document.Name, obj.Name)
        with self._lock:
            unborn = [r for r in self._waiting if r.key == key]
            self._drop(key)
            begun = self._current is not None and self._current.key == key
        if unborn and not begun:  # else the end of what has begun is told
            error = worker.Stopped(tr("cancelled"))
            if tell:
                unborn[-1].finish(None, error)
            self.ended.emit(key, error)

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

    def cancel_all(self):
        with self._lock:
            runs = [r for r in [self._current, *self._waiting] if r]
        for run in {r.key: r for r in runs}.values():
            if _lives(run.obj):
                self.cancel(run.obj)
            else:
                with self._lock:
                    self._drop(run.key)

    def stop(self):
        """Ends the worker; the next run starts another one."""
        self._worker.stop()

    def _work(self):
        while True:
            with self._lock:
                while not self._waiting:
                    self._current = None
                    self._lock.wait()
                self._current = run = self._waiting.pop(0)
                self.count += 1
            result = error = None
            try:
                result = self._worker.draw(run.job, lambda stage, share: self._note(run, stage, share))
            except worker.Stopped:
                error = worker.Stopped(tr("cancelled"))
            except Exception as failure:
                error = failure
            self._ended_runs.append((run, result, error))
            self._came_back.emit()

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

    def _collect(self):
        """In the GUI's thread."""
        while self._ended_runs:
            self._finish(*self._ended_runs.popleft())

    def _finish(self, run, result, error):
        if result is not None:
            self._kept[run.inputs] = result
            while len(self._kept) > KEPT:
                self._kept.popitem(last=False)
        if run.replaced:
            return
        obj = run.obj if _lives(run.obj) else None
        if obj is not None:
            if run.cancelled:
                error = worker.Stopped(tr("cancelled"))
            run.finish(None if error else result, error)
        self._after(obj, run.key, error)

    def _after(self, obj, key, error):
        if obj is not None and error is None:
            _follow(obj)
        self.ended.emit(key, error)


def _lives(obj):
    """Whether an object is still in its document; undo takes objects out, closing deletes them."""
    try:
        return obj.Document.getObject(obj.Name) is not None
    except (AttributeError, ReferenceError, RuntimeError):
        return False


def _follow(obj):
    """What shows the drawing elsewhere in the document shows the new one."""
    obj.purgeTouched()
    for other in obj.InList:
        if getattr(other, "Illustration", None) is obj:
            other.touch()
            other.recompute()


scheduler = None


class _Documents:
    """Undo and redo bring back properties, not drawings: those are looked up, or drawn again."""

    def slotUndoDocument(self, document):
        self._renew(document)

    slotRedoDocument = slotUndoDocument

    def slotDeletedObject(self, obj):
        if is_illustration(obj):
            scheduler.cancel(obj, tell=False)

    def slotDeletedDocument(self, document):
        from .. import tasks

        if tasks.shown is not None and not tasks.shown.over and tasks.shown.key[0] == document.Name:
            tasks.shown.abandon()

    def _renew(self, document):
        for obj in document.Objects:
            if is_illustration(obj) and "Touched" in obj.State:
                obj.recompute()


def install():
    """From now on runs do not stop the GUI."""
    global scheduler
    if scheduler is None:
        from . import status

        scheduler = Scheduler()
        illustration.scheduler = scheduler
        scheduler.documents = _Documents()
        FreeCAD.addDocumentObserver(scheduler.documents)
        status.install(scheduler)
    return scheduler


def wait(obj=None, seconds=60.0):
    """For scripts: lets the GUI live until the runs of an illustration (or all) have ended. Whether they have."""
    clock, loop = QtCore.QElapsedTimer(), QtCore.QEventLoop()
    clock.start()
    while scheduler is not None and scheduler.busy(obj):
        if clock.elapsed() > 1000 * seconds:
            return False
        QtCore.QTimer.singleShot(10, loop.quit)
        loop.exec_() if hasattr(loop, "exec_") else loop.exec()
    return True
