"""Runs of the kernel beside the GUI: the newest job of an object wins, results come back in the GUI's thread."""

import collections
import threading

import FreeCAD
from PySide import QtCore

from .. import kernel
from ..errors import Failed, Stopped
from ..features import illustration
from ..text import tr
from ..worker import Worker
from . import reading, stale, status
from .documents import Documents
from .runs import Run, Writing, asked_of, key_of

# Results that are kept, so that undo and redo show at once what was drawn before.
KEPT = 8


class Scheduler(QtCore.QObject):
    """Called with (object, job, finish) as features.illustration.scheduler; returns at once."""

    beside = True  # long looks belong into runs

    progressed = QtCore.Signal(object, str, float)  # (document, object) names, stage, share
    ended = QtCore.Signal(object, object)  # names, error or None
    began = QtCore.Signal(object)  # names
    left = QtCore.Signal(str, str)  # names; an illustration leaves its document, or (without its name) the document is closed
    undone = QtCore.Signal(str)  # name of a document whose changes were undone or done again
    _came_back = QtCore.Signal()

    def __init__(self):
        super().__init__()
        self._worker = Worker()
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
        self._writing = {}  # by key
        self._ready = set()  # keys of what has just been written
        self._slices = QtCore.QTimer(self)
        self._slices.setInterval(0)
        self._slices.timeout.connect(lambda: self._write())

    # --- shapes, before a run ---

    def ready(self, obj):
        """As features.illustration.ready: what is to be written comes between other events, SLICE seconds at a time; none in the
        click itself, which shows a panel too."""
        key = key_of(obj)
        self._writing.pop(key, None)
        if key in self._ready:
            return True
        writing = Writing(obj)
        if not writing.pieces:
            return True
        with self._lock:
            self._replace(key)  # what is under way is of before
        self._writing[key] = writing
        self._slices.start()
        self._timer.start()
        self.began.emit(key)
        return False

    def _write(self):
        key, writing = next(iter(self._writing.items()), (None, None))
        if writing is None:
            self._slices.stop()
            return
        if not _lives(writing.obj):
            del self._writing[key]
            self.ended.emit(key, Stopped(tr("cancelled")))
            return
        try:
            if not writing.go_on():
                return
        except Exception:  # it changed meanwhile: the run will say what is wrong with it
            pass
        del self._writing[key]
        obj = writing.obj
        self._ready.add(key)
        try:
            obj.Proxy.execute(obj)
        finally:
            self._ready.discard(key)
        if not self.running(obj):  # refused, or drawn already
            obj.purgeTouched()
            self.ended.emit(key, None)

    # --- runs ---

    def __call__(self, obj, job, finish):
        key = key_of(obj)
        inputs = job.exact_fingerprint()
        result = self._kept.get(inputs)
        with self._lock:
            for run in self._begun(key):
                if run.inputs == inputs and not run.cancelled and not run.replaced and run.obj is obj:
                    self._waiting = [r for r in self._waiting if r.key != key or r.what != "draw"]
                    run.finish, run.asked = finish, asked_of(obj)
                    return
            self._replace(key)
            if result is None:
                self._waiting.append(Run(obj, job, inputs, finish))
        if result is not None:
            finish(result, None)
            self._after(obj, key, None)
            return
        self._start(key)

    def ask(self, what, obj, job, done):
        """What the worker answers to a job ("steps", "items"; see job.answer), beside the drawings of the object:
        `done(answer, error)` is called later in the GUI's thread, but not where the document is closed. Ended as drawings are."""
        run = Run(obj, job, "", done, what)
        with self._lock:
            self._waiting.append(run)
        self._start(run.key)

    def _start(self, key):
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
            import numpy  # noqa: F401  loaded here it does not stop the GUI

            kernel.offered()  # so does the kernel, which panels ask
            try:
                self._worker.start()
            except (Failed, Stopped):
                pass  # the first run will tell

        threading.Thread(target=start, daemon=True).start()

    def running(self, obj=None):
        """Whether a run is under way or waiting, of an object or of any."""
        with self._lock:
            runs = [r for r in self._begun() + self._waiting if not r.cancelled]
        runs += self._writing.values()
        return any(obj is None or r.key == key_of(obj) for r in runs)

    def busy(self, obj=None):
        """As running, and also while a run that was cancelled comes to its end or has still to be told."""
        with self._lock:
            runs = self._begun() + self._waiting
        runs += self._writing.values()
        return any(obj is None or r.obj is obj for r in runs)

    def waiting(self):
        """How many drawings wait for the one that runs."""
        with self._lock:
            return len(self._waiting) + max(len(self._writing) - (self._current is None), 0)

    def cancel(self, obj, tell=True):
        """Ends the runs of an object; what it shows stays as it is."""
        key = key_of(obj)
        writing = self._writing.pop(key, None)
        with self._lock:
            waiting = [r for r in self._waiting if r.key == key]
            self._drop(key)
            begun = [r for r in self._begun(key) if r.what == "draw"]
        unborn = [r for r in waiting if r.what == "draw"]
        for asked in (r for r in waiting if r.what != "draw"):
            asked.finish(None, Stopped(tr("cancelled")))
            self.ended.emit(key, Stopped(tr("cancelled")))
        if (unborn or writing) and not begun:  # else the end of what has begun is told
            error = Stopped(tr("cancelled"))
            if tell and unborn:
                unborn[-1].finish(None, error)
            elif tell:
                illustration.not_drawn(obj, error)
            self.ended.emit(key, error)

    def drop_document(self, name):
        """Ends all runs of a document that is closed."""
        self._writing = {key: w for key, w in self._writing.items() if key[0] != name}
        with self._lock:
            runs = [r for r in self._begun() + self._waiting if r.key[0] == name]
            for run in runs:
                run.replaced = True  # there is nobody to tell
                self._drop(run.key)
        for key in {run.key for run in runs}:
            self.ended.emit(key, Stopped(tr("cancelled")))

    def _begun(self, key=None):
        """With the lock held: the runs, of an illustration or of all, that have begun and whose end is not told yet."""
        runs = [run for run, _, _ in self._ended_runs] + ([self._current] if self._current else [])
        return [run for run in runs if key is None or run.key == key]

    def _drop(self, key, what=None):
        """With the lock held: all runs of a key, or those of a kind."""
        self._waiting = [r for r in self._waiting if r.key != key or what not in (None, r.what)]
        for run in self._begun(key):
            if what not in (None, run.what):
                continue
            if not run.cancelled and run is self._current:
                self._worker.cancel()
            run.cancelled = True

    def _replace(self, key):
        """With the lock held: the drawing under way will have nothing to tell."""
        self._drop(key, "draw")
        for run in self._begun(key):
            run.replaced |= run.what == "draw"

    def cancel_all(self):
        with self._lock:
            runs = self._begun() + self._waiting
        runs += self._writing.values()
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
                    self._lock.wait()
                self._current = run = self._waiting.pop(0)
            result = error = None
            try:
                result = self._worker.do(run.what, run.job, lambda stage, share: self._note(run, stage, share),
                                         lambda: not run.cancelled)
            except Stopped:
                error = Stopped(tr("cancelled"))
            except Exception as failure:
                error = failure
            with self._lock:  # at once: who is told of the end is not to find it under way
                self._current = None
                self._ended_runs.append((run, result, error))
            self._came_back.emit()

    @staticmethod
    def _note(run, stage, share):
        run.stage, run.share = stage, share

    def _tell(self):
        run = self._current
        for key, writing in self._writing.items():
            self.progressed.emit(key, "read", writing.share())
        if run is None:
            if not self._waiting and not self._writing:
                self._timer.stop()
            return
        if not run.cancelled:
            self.progressed.emit(run.key, run.stage, run.share)

    def _collect(self):
        """In the GUI's thread."""
        while self._ended_runs:
            with self._lock:
                over = self._ended_runs.popleft()
            self._finish(*over)

    def _finish(self, run, result, error):
        if run.what != "draw":
            self._answer(run, result, error)
            return
        unchanged = result is not None and result.drawing is None
        self.count += not unchanged
        if result is not None and not unchanged:
            self._kept[run.inputs] = result
            while len(self._kept) > KEPT:
                self._kept.popitem(last=False)
        if run.replaced:
            return
        obj = run.obj if _lives(run.obj) else None
        if obj is not None:
            if run.cancelled:
                error = Stopped(tr("cancelled"))
            changed = run.asked != asked_of(obj)  # before the result is there: numbers of items are a part of it
            run.finish(None if error else result, error)
            if error is None and changed:
                # Changed meanwhile and not yet recomputed: it is not up to date.
                self.ended.emit(run.key, None)
                return
        self._after(obj, run.key, error)

    def _answer(self, run, result, error):
        if run.replaced:
            return
        if run.cancelled:
            error = Stopped(tr("cancelled"))
        run.finish(None if error else result, error)
        self.ended.emit(run.key, error)

    def _after(self, obj, key, error):
        if obj is not None and error is None:
            _follow(obj)
        self.ended.emit(key, error)


def _lives(obj):
    """Whether an object is still in its document; undo takes objects out, closing deletes them."""
    try:
        return obj.Document.getObject(obj.Name) is not None
    except (AttributeError, ReferenceError, RuntimeError, TypeError):  # FreeCAD 1.1: the name of a deleted one is None
        return False


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
        illustration.scheduler, illustration.ready, illustration.settle = scheduler, scheduler.ready, settle
        scheduler.documents = Documents(scheduler)
        FreeCAD.addDocumentObserver(scheduler.documents)
        status.install(scheduler)
        stale.install(scheduler)
    return scheduler


def settle(obj):
    """As features.illustration.settle: the status bar tells of the run meanwhile and can end it."""
    if scheduler is None or not scheduler.busy(obj):
        return True
    wait(obj, float("inf"))
    return _lives(obj) and not obj.Message.endswith(illustration.KEPT)


def wait(obj=None, seconds=60.0):
    """For scripts: lets the GUI live until the runs of an illustration (or all) have ended and the 3-D view shows what they
    drew. Whether they have."""
    clock, loop = QtCore.QElapsedTimer(), QtCore.QEventLoop()
    clock.start()
    while scheduler is not None and (scheduler.busy(obj) or reading.busy(obj)):
        if clock.elapsed() > 1000 * seconds:
            return False
        QtCore.QTimer.singleShot(10, loop.quit)
        loop.exec_() if hasattr(loop, "exec_") else loop.exec()
    return True
