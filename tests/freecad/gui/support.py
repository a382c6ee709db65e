"""What GUI tests share. A test script ends with `support.run(__name__)`."""

import contextlib
import faulthandler
import os
import pathlib
import signal
import sys
import time
import traceback
import unittest
import unittest.mock

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

OUT = pathlib.Path(os.environ["BURIN_TEST_OUT"])
DATA = pathlib.Path(os.environ.get("BURIN_TEST_DATA", "/nowhere"))
REFERENCES = pathlib.Path(__file__).resolve().parent / "references"


def run(name):
    """Runs the tests of a module once FreeCAD's window stands, and ends FreeCAD."""

    def main():
        status = 1
        # A test that hangs says where before run.py ends it.
        faulthandler.dump_traceback_later(0.9 * float(os.environ.get("BURIN_TEST_TIMEOUT", "120")), file=sys.__stderr__)
        try:
            settle(300)
            suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules[name])
            only = os.environ.get("BURIN_TEST_ONLY")
            if only:
                suite = unittest.defaultTestLoader.loadTestsFromName(only, sys.modules[name])
            result = unittest.TextTestRunner(stream=sys.stderr, verbosity=2, durations=None) \
                if sys.version_info >= (3, 12) else unittest.TextTestRunner(stream=sys.stderr, verbosity=2)
            result = result.run(suite)
            status = 0 if result.wasSuccessful() and result.testsRun else 1
            pathlib.Path(os.environ["BURIN_TEST_VERDICT"]).write_text(str(status))
        except BaseException:
            traceback.print_exc()
        finally:
            stop_worker()
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(status)

    QtCore.QTimer.singleShot(0, main)


def stop_worker():
    from freecad.burin_wb.view import scheduler

    if scheduler.scheduler is not None:
        scheduler.scheduler.stop()


class Heartbeat:
    """Beats every 5 ms in the GUI's thread. `longest`: seconds of the GUI's own work between two beats; `wall`: seconds of the
    clock. Both depend on the machine and on what else it does: tests/bench measures them, a test asserts neither."""

    def __init__(self):
        self.longest = self.wall = 0.0
        self.beats = 0
        self._last = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(lambda: self._beat())

    def _beat(self):
        now = time.thread_time(), time.monotonic()
        if self._last is not None:
            self.longest = max(self.longest, now[0] - self._last[0])
            self.wall = max(self.wall, now[1] - self._last[1])
        self._last = now
        self.beats += 1

    def __enter__(self):
        self._beat()
        self._timer.start(5)
        return self

    def __exit__(self, *_):
        self._timer.stop()
        self._beat()


# Of Qt 5 a number, of Qt 6 an enumerator.
DELETED = int(getattr(QtCore.QEvent.DeferredDelete, "value", QtCore.QEvent.DeferredDelete))


def settle(milliseconds=60):
    """Lets the GUI work for a while, and then until what comes one after the other has come: on a busy machine the time may
    be over before the first event."""
    loop = QtCore.QEventLoop()
    for wait in (milliseconds, 0, 0, 0, 0):
        QtCore.QTimer.singleShot(wait, loop.quit)
        loop.exec_()


def until(condition, seconds=120.0):
    """Lets the GUI work until a condition holds; whether it does. The time is for machines of any speed: it only passes where
    the test fails."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        settle(10)
    return True


def resting(value, seconds=60.0):
    """Lets the GUI work until a value is the same three times in a row; returns it."""
    seen = [object(), object(), value()]

    def same():
        seen[:] = [*seen[1:], value()]
        return seen[0] == seen[1] == seen[2]

    assert until(lambda: settle(40) or same(), seconds), "it does not come to rest"
    return seen[-1]


def quiet(obj=None):
    """Whether nothing is under way: no run of an illustration (or of any), no change of the open panel that is still to be
    drawn or shown, no picture that is painted."""
    from freecad.burin_wb.view import reading, scheduler

    runs, shown = scheduler.scheduler, panel()
    if runs is not None and (runs.busy(obj) or reading.busy(obj)):
        return False
    return shown is None or shown.over or not (shown.waits() or shown.preview.busy())


def drawn(obj=None, seconds=200.0):
    """Waits until all that is asked for is drawn and shown: what one event asks for may come in the next."""
    turns = []

    def rests():
        turns.append(quiet(obj))
        return turns[-4:] == [True] * 4

    assert until(rests, seconds), "the run did not end in time"


def at_work():
    """Waits until the worker has a run; whether it comes to that."""
    from freecad.burin_wb.view import scheduler

    return until(lambda: scheduler.scheduler._current is not None)


@contextlib.contextmanager
def held():
    """The worker process stands still meanwhile: what it is asked for is under way for as long, on a fast machine too, and who
    waits for it in the GUI's thread waits for ever. Runs that are cancelled end after it; no process is ended for that."""
    from freecad.burin_wb import worker as module
    from freecad.burin_wb.view import scheduler

    worker = scheduler.install()._worker
    assert worker.start(), "there is no worker process"
    process = worker._process
    with unittest.mock.patch.multiple(module, PATIENCE=1e6, PATIENCE_AT_START=1e6):
        process.send_signal(signal.SIGSTOP)
        try:
            yield process
        finally:
            process.send_signal(signal.SIGCONT)


def screenshot(name):
    """The whole screen as OUT/name.png, when it holds still: a busy machine lays windows out late."""
    before = now = None
    for _ in range(10):
        settle(150)
        before, now = now, QtGui.QGuiApplication.primaryScreen().grabWindow(0).toImage()
        if now == before:
            break
    path = OUT / f"{name}.png"
    assert now.save(str(path)), path
    return path


def picture(name, width=640, height=480):
    """The 3-D view as OUT/name.png."""
    settle(50)
    path = OUT / f"{name}.png"
    Gui.ActiveDocument.ActiveView.saveImage(str(path), width, height, "White")
    return path


def glass():
    """What the 3-D view in front is painted on, once it and its camera are at rest: windows are laid out late, and FreeCAD 1.0
    turns the camera slowly."""
    view = Gui.ActiveDocument.ActiveView
    shown = next(v for v in Gui.getMainWindow().centralWidget().findChildren(QtGui.QGraphicsView) if v.isVisible()).viewport()
    resting(lambda: (view.getSize(), shown.width(), shown.height(), view.getCamera()))
    return shown


def leaves(obj, path=""):
    """Paths of what an assembly is made of, and its labels, in order: releases of FreeCAD name what they import differently."""
    below = obj.getSubObjects() if obj.hasExtension("App::GroupExtension") or obj.TypeId.startswith("App::Link") else ()
    if not below:
        yield path or obj.Name, obj.Label
    for sub in below:
        yield from leaves(obj.getSubObject(sub, retType=1), f"{path or obj.Name}.{sub.rstrip('.')}")


def panel():
    """The panel that is shown, as the add-on made it."""
    from freecad.burin_wb import tasks

    return tasks.shown


def close_pages():
    """Closes the windows of TechDraw pages before their document: FreeCAD 0.20 may crash while it asks one whose page is gone what it
    can do (MDIViewPage::onHasMsg), 1.1 where it deletes one after its document. Qt keeps what is to be deleted until the loop of
    events ends in which it was closed, which is after the test; it is deleted here."""
    closed = []
    for window in Gui.getMainWindow().centralWidget().subWindowList():
        if window.widget() is not None and "MDIViewPage" in window.widget().metaObject().className():
            closed += [window.widget(), window]
            window.close()
    settle(50)
    for widget in closed:
        try:
            QtCore.QCoreApplication.sendPostedEvents(widget, DELETED)
        except RuntimeError:  # it is gone already
            pass


# Mistakes in slots and callbacks, which end nothing by themselves.
uncaught = []


def _note(kind, error, trace):
    uncaught.append("".join(traceback.format_exception(kind, error, trace)))
    sys.stderr.write(uncaught[-1])


sys.excepthook = _note


class Case(unittest.TestCase):
    """A test with a document of its own."""

    def setUp(self):
        uncaught.clear()
        self.document = FreeCAD.newDocument("Test")
        self.document.UndoMode = 1

    def tearDown(self):
        if Gui.Control.activeDialog():
            Gui.Control.closeDialog()
        close_pages()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        settle(10)
        self.assertEqual(uncaught, [])

    def box_and_ball(self):
        """A box with a ball beside it; both are parts."""
        box = self.document.addObject("Part::Box", "Box")
        box.Length, box.Width, box.Height = 40, 30, 20
        ball = self.document.addObject("Part::Sphere", "Ball")
        ball.Radius = 14
        ball.Placement.Base = FreeCAD.Vector(55, 15, 14)
        self.document.recompute()
        Gui.ActiveDocument.ActiveView.viewIsometric()
        Gui.ActiveDocument.ActiveView.fitAll()
        return box, ball

    def select(self, *objects):
        Gui.Selection.clearSelection()
        for obj in objects:
            if isinstance(obj, tuple):
                Gui.Selection.addSelection(self.document.Name, obj[0].Name, obj[1])
            else:
                Gui.Selection.addSelection(self.document.Name, obj.Name)

    def illustrate(self, *objects):
        """A new illustration by the command, its panel closed with OK."""
        self.select(*objects)
        Gui.runCommand("Burin_NewIllustration")
        self.assertTrue(Gui.Control.activeDialog())
        obj = panel().obj
        drawn(obj)
        panel().accept()
        settle()
        return obj


def off_segment(point, ends):
    """Distance of a paper point from the segment between two others, in mm."""
    (ax, ay), (bx, by) = ends
    dx, dy = bx - ax, by - ay
    t = max(0.0, min(1.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / (dx * dx + dy * dy)))
    return ((ax + t * dx - point[0]) ** 2 + (ay + t * dy - point[1]) ** 2) ** 0.5
