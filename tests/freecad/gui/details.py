"""The panels of details and of several views, and step books beside the GUI."""

import json
import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from assembly_case import Case  # noqa: E402
from pivy import coin  # noqa: E402
from PySide import QtGui  # noqa: E402


class Details(Case):
    def setUp(self):
        super().setUp()
        self.obj.Width, self.obj.Height, self.obj.FitScale, self.obj.Scale = 297, 210, False, 0.5
        self.document.recompute()
        support.drawn()
        self.undos = self.document.UndoCount

    def said(self):
        return [json.loads(text) for text in self.obj.Details]

    def views(self):
        with open(self.obj.Drawing, encoding="utf-8") as file:
            return [view["name"] for view in json.load(file).get("views", ())]

    def click(self, panel, name):
        panel.form.findChild(QtGui.QPushButton, name).click()

    def rows(self, panel):
        return [tuple(panel.table.item(r, c).text() for c in range(4)) for r in range(panel.table.rowCount())]

    def test_of_objects_edited_and_one_undo(self):
        panel = self.open("Burin_Detail", self.obj, (self.pump, "Bolt."))
        self.is_narrow_and_told(panel)
        self.assertEqual(self.said(), [{"select": ["Pump.Bolt"]}], "what is selected is the first one")
        self.select((self.pump, "Bolt001."), (self.pump, "Lid."))
        self.click(panel, "objects")
        self.assertEqual(self.rows(panel), [("Bolt", "A", "", ""), ("Bolt001, Lid", "B", "", "")])
        panel.table.item(0, 1).setText("K")
        support.settle()
        panel.table.item(0, 2).setText("3:1")
        support.settle()
        panel.table.item(0, 3).setText("8")
        support.settle()
        self.assertEqual(self.rows(panel), [("Bolt", "K", "3:1", "8"), ("Bolt001, Lid", "A", "", "")])
        self.wait()
        self.assertEqual(self.views(), ["", "K", "A"])
        self.assertFalse(panel.preview.shown().isNull())
        support.screenshot("detail-panel")
        panel.table.selectRow(1)
        support.settle()
        self.assertEqual(self.chosen(), ["Pump.Bolt001.", "Pump.Lid."])
        self.click(panel, "delete")
        self.close(panel)
        self.assertEqual(self.said(), [{"select": ["Pump.Bolt"], "letter": "K", "scale": "3:1", "radius": 8.0}])
        self.assertEqual((self.views(), self.obj.Message), (["", "K"], ""))
        self.assertEqual(self.document.UndoCount, self.undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual((self.said(), self.views()), ([], []))
        self.document.redo()
        support.drawn()
        self.assertEqual(self.views(), ["", "K"])

    def test_about_faces_and_points(self):
        panel = self.open("Burin_Detail")
        self.assertEqual(self.said(), [])
        Gui.Selection.clearSelection()
        self.click(panel, "point")
        self.assertIn("select a face", panel.message.text())
        self.click(panel, "objects")
        self.assertIn("select objects", panel.message.text())
        self.select((self.pump, "Bolt.Face1"))
        self.click(panel, "point")
        box = self.document.Bolt.Shape.Face1.BoundBox
        at, radius = self.said()[0]["at"], self.said()[0]["radius"]
        self.assertTrue((FreeCAD.Vector(*at) - box.Center).Length < 1e-5)
        self.assertAlmostEqual(radius, 0.575 * box.DiagonalLength, 1)
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(self.document.Name, "Pump", "Lid.", 60, 20, 16)
        self.click(panel, "point")
        self.assertEqual(self.said()[1]["at"], [60, 20, 16])
        self.assertEqual(self.rows(panel)[1][0], "60, 20, 16")
        self.wait()
        self.assertEqual((panel.message.text(), self.views()), ("drawn", ["", "A", "B"]))
        panel.reject()
        self.wait()
        self.assertEqual((self.said(), self.views(), self.document.UndoCount), ([], [], self.undos))

    def test_wrong_words_are_told_and_not_taken(self):
        self.obj.Details = ['{"at": [48, 20, 16], "radius": 6, "letter": "K"}', "Pump.Bolt"]
        panel = self.open("Burin_Detail")
        before = self.rows(panel)
        self.assertEqual(before, [("48, 20, 16", "K", "", "6"), ("Bolt", "A", "", "")])
        for row, column, text, words in ((1, 1, "K", "another detail has this letter"), (0, 2, "large", "a scale is such as"),
                                         (0, 3, "", "a radius is more than 0 mm"), (1, 3, "-2", "a radius is more than 0 mm")):
            panel.table.item(row, column).setText(text)
            self.assertIn(words, panel.message.text())
            support.settle()
            self.assertEqual(self.rows(panel), before)
        panel.table.item(0, 1).setText("")
        support.settle()
        self.assertEqual(self.rows(panel)[0][1], "A")
        panel.table.item(0, 2).setText("300:1")
        self.wait()
        self.assertIn("have no room beside the drawing", panel.message.text())
        panel.reject()
        self.wait()

    def test_several_views_in_the_panel_of_the_illustration(self):
        self.select(self.obj)
        Gui.runCommand("Burin_Edit")
        panel = support.panel()
        views = panel.views
        self.assertEqual((views.button.text(), views.method.isEnabled()), ("One view", False))
        for name in ("iso", "front", "left"):
            views.actions[name].trigger()
        self.wait()
        self.assertEqual((list(self.obj.Views), views.button.text(), views.method.isEnabled()), (["front", "left", "iso"], "3 views", True))
        self.assertEqual(self.views(), ["front", "left", "iso"])
        views.method.setCurrentIndex(1)
        self.wait()
        support.screenshot("views-panel")
        self.assertEqual(self.obj.ProjectionMethod, "Third angle")
        panel.view.setCurrentIndex(panel.view.findData("top"))
        self.wait()
        self.assertEqual((list(self.obj.Views), views.button.text(), self.views()), ([], "One view", []))
        self.close(panel)

    def test_the_3d_view_has_the_first_view_alone(self):
        self.obj.Views, self.obj.Details = ["front", "iso"], ["Pump.Bolt"]
        self.document.recompute()
        self.wait()
        search = coin.SoSearchAction()
        search.setType(coin.SoCoordinate3.getClassTypeId())
        search.setInterest(coin.SoSearchAction.ALL)
        search.apply(self.obj.ViewObject.Proxy._ink)
        points = [point.getValue() for path in search.getPaths() for point in path.getTail().point.getValues(0)]
        self.assertGreater(len(points), 20)
        for x, _, z in points:
            self.assertTrue(-30 < x < 90 and -20 < z < 40, "a line of the first view, or the circle of the detail in it")
        self.assertLess(max(x for x, _, z in points if -4.1 < z < 20.1), 60.1)
        said = []
        with unittest.mock.patch("freecad.burin_wb.view.follow.tell", said.append):
            self.obj.ViewObject.Follow = True
        self.assertEqual(said, ["Illustration has several views; it follows the 3-D view as soon as it has one"])
        runs = self.runs().count
        Gui.ActiveDocument.ActiveView.viewTop()
        support.settle(600)
        support.drawn()
        self.assertEqual((self.runs().count, list(self.obj.Views)), (runs, ["front", "iso"]))
        self.obj.ViewObject.Follow = False

    def runs(self):
        from freecad.burin_wb.view import scheduler

        return scheduler.install()


class StepBook(Case):
    def make(self, name, items=6, chosen="PDF (*.pdf)"):
        """Runs the command with that choice of a file."""
        path = str(support.OUT / name)
        with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, chosen)), \
                unittest.mock.patch.object(QtGui.QInputDialog, "getInt", lambda *_: (items, True)):
            self.select(self.obj)
            Gui.runCommand("Burin_StepBook")
        return path

    def setUp(self):
        super().setUp()
        for file in support.OUT.glob("book*"):
            file.unlink()
        self.said = []
        for module in ("step_book", "view.book"):
            patch = unittest.mock.patch(f"freecad.burin_wb.{module}.tell", lambda text, *_: self.said.append(text))
            patch.start()
            self.addCleanup(patch.stop)

    def told(self):
        """What was told until the end."""
        from freecad.burin_wb.view import book

        self.assertTrue(support.until(lambda: not book.busy()))
        said, self.said[:] = list(self.said), []
        return said

    def test_it_is_written_beside_the_gui(self):
        from freecad.burin_wb.features.shapes import shapes

        shapes.forget(self.document.Name)
        with support.held():
            path = self.make("book", chosen="HTML (*.html)")
            self.assertTrue(support.at_work())
            self.assertFalse(os.path.exists(path + ".html"))
        said = self.told()
        self.assertEqual(said, [f"Illustration: step book written to {path}.html; steps: 2"])
        self.assertIn("<html", open(path + ".html", encoding="utf-8").read())
        self.assertEqual((self.document.UndoCount, "Touched" in self.obj.State), (self.undos, False))

    def test_it_can_be_ended_from_the_status_bar(self):
        from freecad.burin_wb.view import scheduler

        self.obj.Style = "engraving"
        runs = scheduler.install()
        with support.held():
            path = self.make("book.pdf")
            self.assertTrue(support.until(lambda: runs.running(self.obj)))
            button = next(w for w in Gui.getMainWindow().findChildren(QtGui.QWidget, "BurinStatus")).button
            button.click()
        self.assertEqual(self.told(), ["Illustration: cancelled"])
        self.assertFalse(os.path.exists(path))
        self.assertNotIn("cancelled", self.obj.Message)

    def test_what_cannot_be_written_is_told(self):
        self.make("book.doc")
        self.assertFalse(os.path.exists(support.OUT / "book.doc"))
        self.make("book-none/book.pdf")
        self.assertRegex(self.told()[0], "^Illustration: .*book-none")
        self.obj.Sources = []
        self.make("book.pdf")
        self.assertRegex(self.told()[0], "^Illustration: nothing to draw")

    def test_a_closed_document_ends_it(self):
        self.make("book.pdf")
        FreeCAD.closeDocument(self.document.Name)
        self.assertEqual(self.told(), [])


support.run(__name__)
