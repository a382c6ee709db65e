"""What is not up to date: marked in the tree, redrawn, asked about before an export; and lines that are measured."""

import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402


def marked(obj):
    """Whether the tree marks an illustration."""
    return obj.ViewObject.Proxy.getIcon().endswith("burin_stale.svg")


class Stale(support.Case):
    def setUp(self):
        super().setUp()
        self.box, self.ball = self.box_and_ball()
        self.obj = self.illustrate(self.box, self.ball)

    def redraw_all(self):
        from freecad.burin_wb.view import redraw

        said = []
        with unittest.mock.patch.object(redraw, "tell", lambda text, *_: said.append(text)):
            Gui.runCommand("Burin_RedrawAll")
            yield said
            self.assertTrue(support.until(lambda: not redraw.busy()))

    def test_the_tree_marks_it_and_redraw_all_takes_the_mark_away(self):
        support.settle(400)
        self.assertFalse(marked(self.obj))
        other = self.illustrate(self.ball)
        self.box.Length = 55
        self.assertTrue(support.until(lambda: marked(self.obj)))
        self.assertFalse(marked(other))
        support.screenshot("stale-tree")
        before = open(self.obj.Picture).read()
        run = self.redraw_all()
        said = next(run)
        next(run, None)
        self.assertEqual(said, ["1 illustrations drawn anew, 1 as they were"])
        self.assertNotEqual(open(self.obj.Picture).read(), before)
        self.assertTrue(support.until(lambda: not marked(self.obj)))

    def test_a_redraw_is_cancelled(self):
        from freecad.burin_wb.view import scheduler

        others = [self.illustrate(self.box, self.ball) for _ in range(2)]
        for obj in (self.obj, *others):
            obj.Style = "engraving"
        run = self.redraw_all()
        with support.held():
            said = next(run)
            text = next(w for w in Gui.getMainWindow().findChildren(QtGui.QWidget, "BurinStatus")).text
            self.assertTrue(support.until(lambda: "more)" in text.text()))
            scheduler.scheduler.cancel_all()
        next(run, None)
        self.assertRegex(said[0], "^0 illustrations drawn anew, 3 as they were; not drawn: Illustration")
        self.assertTrue(support.until(lambda: all(marked(obj) for obj in (self.obj, *others))))
        self.document.recompute()  # what was cancelled is not forgotten
        for obj in (self.obj, *others):
            obj.Style = "outline"
        run = self.redraw_all()
        said = next(run)
        next(run, None)
        self.assertEqual(said, ["3 illustrations drawn anew, 0 as they were"])

    def export(self, button, path):
        """Runs the command; presses a button of the question that it asks, whose text is returned."""
        asked = []

        def press():
            box = QtGui.QApplication.activeModalWidget()
            if box is None:
                QtCore.QTimer.singleShot(100, press)
                return
            asked.append(box.text())
            box.button(button).click()

        self.select(self.obj)
        if button is not None:
            QtCore.QTimer.singleShot(100, press)
        with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")):
            Gui.runCommand("Burin_Export")
        return asked

    def test_an_export_asks_first(self):
        path = str(support.OUT / "stale.svg")
        self.assertEqual(self.export(None, path), [])
        first = open(path).read()
        os.unlink(path)
        self.box.Length = 70
        self.assertEqual(self.export(QtGui.QMessageBox.Cancel, path), ["Illustration is not up to date."])
        self.assertFalse(os.path.exists(path))
        self.export(QtGui.QMessageBox.No, path)
        self.assertEqual(open(path).read(), first)
        self.export(QtGui.QMessageBox.Yes, path)
        self.assertNotEqual(open(path).read(), first)
        self.assertEqual(self.export(None, path), [])


class Lines(support.Case):
    def test_lines_for_dimensions_lie_over_the_picture_and_are_one_undo(self):
        box, _ = self.box_and_ball()
        obj = self.illustrate(box)
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(300)
        undos, objects = self.document.UndoCount, len(self.document.Objects)
        self.select(obj)
        self.assertTrue(Gui.Command.get("Burin_LinesForDimensions").isActive())
        Gui.runCommand("Burin_LinesForDimensions")
        support.settle(300)
        page = self.document.Page
        picture, lines = page.Views
        self.assertTrue(lines.isDerivedFrom("TechDraw::DrawViewPart"))
        self.assertEqual(self.document.UndoCount, undos + 1)
        lengths = sorted(round(edge.Length, 1) for edge in lines.Source[0].Shape.Edges)
        self.assertEqual(lengths, [16.3] * 3 + [24.5] * 3 + [32.7] * 3, "edges of 20, 30, 40 mm seen in isometry")
        dimension = self.document.addObject("TechDraw::DrawViewDimension", "Dimension")
        dimension.Type = "Distance"
        dimension.References2D = [(lines, "Edge0")]
        page.addView(dimension)
        self.document.recompute()
        self.assertIn(round(dimension.getRawValue(), 1), (16.3, 24.5, 32.7))
        support.screenshot("lines-page")
        self.document.removeObject(dimension.Name)
        support.close_pages()
        while len(self.document.Objects) > objects:
            self.document.undo()
        self.assertEqual((len(page.Views), len(self.document.Objects)), (1, objects))


support.run(__name__)
