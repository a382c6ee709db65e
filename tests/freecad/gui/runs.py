"""Runs beside the work: saved, exported, closed, undone and copied while they go on."""

import json
import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402

V = FreeCAD.Vector

# Some seconds of work for a box and a ball.
LONG = {"Width": 900, "Height": 900, "Style": "engraving",
        "StyleKeys": {"hatch.spacing_min": "0.3", "hatch.spacing_max": "0.4"}}


def scheduler():
    from freecad.burin_wb.view import scheduler

    return scheduler.scheduler


def read(path):
    with open(path, "rb") as file:
        return file.read()


def paper(obj):
    return json.loads(read(obj.Drawing))["paper"]["width"]


class Case(support.Case):
    def setUp(self):
        super().setUp()
        self.box, self.ball = self.box_and_ball()
        self.obj = self.illustrate(self.box, self.ball)

    def begin_long(self):
        """Starts a run that takes a while, and waits until it tells of its progress."""
        for name, value in LONG.items():
            setattr(self.obj, name, value)
        self.document.recompute()
        self.assertTrue(support.until(lambda: scheduler()._current is not None and scheduler()._current.share > 0))


class Saving(Case):
    def test_a_document_saved_during_a_run_draws_when_it_is_opened(self):
        self.begin_long()
        path, name = str(support.OUT / "during.FCStd"), self.obj.Name
        with support.held():
            self.document.saveAs(path)
            self.assertNotIn("Touched", self.obj.State)
            self.assertTrue(scheduler().running(self.obj), "saving ends the run")
            scheduler().cancel(self.obj)
        support.drawn()
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        obj = self.document.getObject(name)
        self.assertEqual(paper(obj), 180)  # the drawing before
        self.assertIn("Touched", obj.State)
        obj.Width, obj.Height, obj.Style, obj.StyleKeys = 100, 90, "outline", {}
        self.document.recompute()
        support.drawn()
        self.assertEqual(paper(obj), 100)
        self.assertNotIn("Touched", obj.State)

    def test_an_up_to_date_document_is_saved_as_such(self):
        path, name, count = str(support.OUT / "after.FCStd"), self.obj.Name, scheduler().count
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.assertNotIn("Touched", self.document.getObject(name).State)
        self.document.getObject(name).touch()
        self.document.recompute()
        support.drawn()
        self.assertEqual(scheduler().count, count)

    def test_what_changed_during_the_run_stays_to_be_done(self):
        self.obj.Width = 400
        self.document.recompute()
        self.assertTrue(scheduler().running(self.obj))
        self.obj.Seed = 77  # and no recompute
        self.assertTrue(support.until(lambda: not scheduler().busy(self.obj)))
        support.settle()
        self.assertEqual(json.loads(read(self.obj.Drawing))["seed"], 1)
        self.assertIn("Touched", self.obj.State)

    def test_a_recompute_with_nothing_new_lets_the_run_go_on(self):
        self.begin_long()
        with support.held():
            run = scheduler()._current
            self.obj.touch()
            self.document.recompute()
            self.assertIs(scheduler()._current, run)
            self.assertFalse(run.cancelled or run.replaced)
            scheduler().cancel(self.obj)
        support.drawn()

    def test_who_is_told_of_the_end_finds_no_run(self):
        """However late the thread of the runs goes on after it: the panel would say "drawing" for good."""
        told = []
        scheduler().ended.connect(lambda key, error: told.append(scheduler().running(self.obj)))
        self.obj.Width = 137  # as no other test draws it: what was drawn once is kept
        with support.held():
            self.document.recompute()
            self.assertTrue(support.at_work())
        with scheduler()._lock:  # the thread stands still wherever it needs this
            support.until(lambda: told, 3)
        support.drawn()
        self.assertEqual(told, [False])


class Exporting(Case):
    def test_an_export_waits_for_the_run(self):
        from freecad.burin_wb import export

        self.obj.Width = 120
        self.document.recompute()
        self.assertTrue(scheduler().running(self.obj))
        path = str(support.OUT / "waited.svg")
        export.export([self.obj], path)
        self.assertIn(b'width="120mm"', read(path)[:2000])

    def test_one_can_give_up_waiting(self):
        from freecad.burin_wb import export

        self.begin_long()
        path = str(support.OUT / "given-up.svg")
        if os.path.exists(path):
            os.unlink(path)
        QtCore.QTimer.singleShot(0, Gui.getMainWindow().findChild(QtGui.QWidget, "BurinStatus").button.click)
        with self.assertRaisesRegex(ValueError, "cancelled.*nothing was written"):
            export.export([self.obj], path)
        self.assertFalse(os.path.exists(path))


class Closing(Case):
    def test_a_closed_document_ends_its_run(self):
        self.begin_long()
        run, ended = scheduler()._current, []
        scheduler().ended.connect(lambda key, error: ended.append((key, error)))
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(run.cancelled, "the run goes on")
        self.assertFalse(scheduler().running())
        self.assertTrue(support.until(lambda: not scheduler().busy()))
        self.assertEqual([key[0] for key, _ in ended], ["Test"])
        self.assertIsNotNone(ended[0][1])

    def test_closed_while_a_line_is_waited_for(self):
        from freecad.burin_wb.commands import select

        self.select(self.obj)
        Gui.runCommand("Burin_SelectSource")
        self.assertIsNotNone(select.picker)
        FreeCAD.closeDocument(self.document.Name)
        self.assertIsNone(select.picker)
        self.document = FreeCAD.newDocument("Test")
        obj = self.illustrate(*self.box_and_ball())
        self.select(obj)
        Gui.runCommand("Burin_SelectSource")
        self.assertIs(select.picker.obj, obj)
        self.document.removeObject(obj.Name)
        self.assertIsNone(select.picker)


class Undoing(Case):
    def test_undo_with_the_panel_open_takes_its_changes_back_and_closes_it(self):
        before, undos = read(self.obj.Drawing), self.document.UndoCount
        self.obj.ViewObject.Proxy.doubleClicked(self.obj.ViewObject)
        panel = support.panel()
        panel.style.setCurrentIndex(panel.style.findData("outline"))
        support.drawn()
        self.assertTrue(read(self.obj.Drawing) != before)
        Gui.runCommand("Std_Undo")
        self.assertTrue(support.until(lambda: Gui.Control.activeDialog() is False))
        support.drawn()
        self.assertEqual((self.obj.Style, self.document.UndoCount), ("technical", undos))
        self.assertTrue(read(self.obj.Drawing) == before)
        panel.change("Style", "engraving")  # a late signal of a widget
        self.assertEqual(self.obj.Style, "technical")
        self.obj.ViewObject.Proxy.doubleClicked(self.obj.ViewObject)  # and it opens again
        self.assertTrue(Gui.Control.activeDialog())
        support.panel().reject()

    def test_undo_with_the_panel_of_a_new_illustration(self):
        objects = [o.Name for o in self.document.Objects]
        self.select(self.ball)
        with support.held():  # the run ends when there is no illustration any more
            Gui.runCommand("Burin_NewIllustration")
            self.assertTrue(support.at_work())
            Gui.runCommand("Std_Undo")
            self.assertTrue(support.until(lambda: Gui.Control.activeDialog() is False))
        support.drawn()
        self.assertEqual([o.Name for o in self.document.Objects], objects)

    def test_escape_in_the_view_is_cancel(self):
        self.obj.ViewObject.Proxy.doubleClicked(self.obj.ViewObject)
        panel = support.panel()
        panel.style.setCurrentIndex(panel.style.findData("outline"))
        area = support.glass()
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            QtGui.QApplication.sendEvent(area, QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier))
        self.assertTrue(support.until(lambda: Gui.Control.activeDialog() is False))
        support.drawn()
        self.assertEqual(self.obj.Style, "technical")


class Panel(Case):
    def open(self):
        self.obj.ViewObject.Proxy.doubleClicked(self.obj.ViewObject)
        support.settle(50)
        return support.panel()

    def test_the_wheel_over_the_panel_changes_nothing(self):
        for show in (self.open, lambda: Gui.runCommand("Burin_Style")):
            show()
            form = support.panel().form
            form.setFocus()
            support.settle(50)
            fields = [w for kind in (QtGui.QComboBox, QtGui.QAbstractSpinBox) for w in form.findChildren(kind)]
            self.assertGreater(len(fields), 5)
            values = lambda: [w.currentIndex() if isinstance(w, QtGui.QComboBox) else w.text() for w in fields]  # noqa: E731
            before, properties = values(), self.asked()
            for field in fields:
                for widget in [field, *field.findChildren(QtGui.QLineEdit)]:
                    self.turn(widget)
            self.assertEqual(values(), before)
            self.assertEqual(self.asked(), properties)
            support.panel().reject()
            support.settle(50)

    def asked(self):
        return (self.obj.Width.Value, self.obj.Height.Value, self.obj.Style, self.obj.Seed, self.obj.HiddenLines,
                self.obj.Projection, tuple(self.obj.ViewDirection), dict(self.obj.StyleKeys))

    @staticmethod
    def turn(widget):
        at = QtCore.QPointF(widget.rect().center())
        event = QtGui.QWheelEvent(at, QtCore.QPointF(widget.mapToGlobal(at.toPoint())), QtCore.QPoint(),
                                  QtCore.QPoint(0, -240), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
                                  QtCore.Qt.NoScrollPhase, False)
        QtGui.QApplication.sendEvent(widget, event)

    def test_the_table_of_objects_follows_the_document(self):
        table = self.open().table
        names = lambda: [table.item(r, 0).text() for r in range(table.rowCount())]  # noqa: E731
        self.assertEqual(names(), ["Box", "Ball"])
        table.item(1, 2).setCheckState(QtCore.Qt.Checked)
        self.box.Label = "Housing"
        self.assertTrue(support.until(lambda: names() == ["Housing", "Ball"]), names())
        cone = self.document.addObject("Part::Cone", "Cone")
        self.document.recompute()
        self.obj.Sources = [*self.obj.Sources, (cone, ("",))]
        self.assertTrue(support.until(lambda: names() == ["Housing", "Ball", "Cone"]), names())
        self.assertEqual(table.item(1, 2).checkState(), QtCore.Qt.Checked)
        self.document.removeObject("Cone")
        self.assertTrue(support.until(lambda: names() == ["Housing", "Ball"]), names())
        support.panel().reject()


class Copying(Case):
    def accept(self):
        """The box that asks what else to copy."""
        box = QtGui.QApplication.activeModalWidget()
        if box is not None:
            box.accept()

    def check(self, copy):
        for name in ("Drawing", "Picture"):
            self.assertNotEqual(getattr(copy, name), getattr(self.obj, name))
        before = read(self.obj.Drawing), read(self.obj.Picture)
        self.assertTrue(read(copy.Drawing) == before[0])
        copy.Style = "outline"
        copy.recompute()
        support.drawn()
        self.assertTrue((read(self.obj.Drawing), read(self.obj.Picture)) == before, "the copy overwrites its original")
        self.assertTrue(read(copy.Drawing) != before[0])
        self.assertGreater(copy.ViewObject.Proxy._ink.getNumChildren(), 0)
        self.document.removeObject(copy.Name)
        self.assertTrue(os.path.exists(self.obj.Drawing))

    def newest(self):
        from freecad.burin_wb.features import is_illustration

        return [o for o in self.document.Objects if is_illustration(o) and o is not self.obj][-1]

    def test_duplicate(self):
        self.select(self.obj)
        QtCore.QTimer.singleShot(300, self.accept)
        Gui.runCommand("Std_DuplicateSelection")
        support.settle(100)
        self.check(self.newest())

    def test_copy_and_paste(self):
        self.select(self.obj)
        QtCore.QTimer.singleShot(300, self.accept)
        Gui.runCommand("Std_Copy")
        support.settle(400)
        Gui.runCommand("Std_Paste")
        support.settle(400)
        self.check(self.newest())


class Slices(Case):
    """Shapes are written a few at a time."""

    def many(self, count):
        import Part

        from freecad.burin_wb.view import runs as module

        solids = []
        for k in range(count):
            solids.append(self.document.addObject("Part::Feature", "Solid"))
            solids[-1].Shape = Part.makeBox(5, 5, 5 + k).fuse(Part.makeSphere(3, V(5, 5, 5)))
            solids[-1].Placement.Base = V(12 * k, 0, 0)
        self.document.recompute()
        return unittest.mock.patch.object(module, "SLICE", 0.0), solids

    def test_many_shapes_are_written_between_other_events(self):
        patch, solids = self.many(12)
        with patch:
            self.obj.Sources = [(s, ("",)) for s in solids]
            self.document.recompute()
            self.assertTrue(scheduler().running(self.obj))
            self.assertIsNone(scheduler()._current)
            self.assertEqual(len(scheduler()._writing), 1)
            support.drawn(self.obj)
        self.assertEqual(self.obj.Message, "")
        self.assertEqual(len(json.loads(read(self.obj.Drawing))["parts"]), 12)
        self.assertNotIn("Touched", self.obj.State)

    def test_what_is_written_has_its_digest(self):
        """Those of all parts at once would hold the window."""
        from freecad.burin_wb.features.sources import collect

        patch, solids = self.many(12)
        with patch:
            self.obj.Sources = [(s, ("",)) for s in solids]
            self.obj.recompute()
            key, writing = next(iter(scheduler()._writing.items()))
            self.assertEqual(len(writing.pieces), 12, "the click itself writes")
            while not writing.go_on():
                pass
            parts, _ = collect(self.obj.Sources)
            self.assertNotIn(None, [part.brep.digest for part in parts])
            support.drawn()
        self.assertEqual(self.obj.Message, "")

    def test_stopped_meanwhile_and_begun_again(self):
        patch, solids = self.many(12)
        before = read(self.obj.Drawing)
        with patch:
            self.obj.Sources = [(s, ("",)) for s in solids]
            self.document.recompute()
            scheduler().cancel(self.obj)
            support.drawn()
            self.assertIn("cancelled", self.obj.Message)
            self.assertTrue(read(self.obj.Drawing) == before)
            self.obj.touch()
            self.document.recompute()
            self.document.removeObject(solids[-1].Name)  # while it waits to be written
            support.drawn()
            self.document.recompute()
            support.drawn()
        self.assertEqual(len(json.loads(read(self.obj.Drawing))["parts"]), 11)


support.run(__name__)
