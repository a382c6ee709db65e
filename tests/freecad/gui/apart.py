"""The panels of assemblies: parts numbered, cut open, taken apart; the 3-D view and the document beside them."""

import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "headless"))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from pump import pump  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402


class Case(support.Case):
    def setUp(self):
        super().setUp()
        self.pump = pump(self.document)
        Gui.ActiveDocument.ActiveView.viewIsometric()
        Gui.ActiveDocument.ActiveView.fitAll()
        self.obj = self.illustrate(self.pump)
        self.obj.Style = "outline"
        self.document.recompute()
        support.drawn()
        self.undos = self.document.UndoCount

    def open(self, command, *selection):
        self.select(*(selection or (self.obj,)))
        Gui.runCommand(command)
        support.drawn()
        self.assertTrue(Gui.Control.activeDialog())
        return support.panel()

    def wait(self):
        support.settle(300)
        support.drawn()

    def close(self, panel):
        panel.accept()
        self.wait()
        self.assertFalse(Gui.Control.activeDialog())

    def chosen(self):
        return sorted(s.ObjectName + "." + n for s in Gui.Selection.getSelectionEx("", 0) for n in s.SubElementNames or ("",))

    def is_narrow_and_told(self, panel):
        self.assertLessEqual(panel.form.minimumSizeHint().width(), 330)
        for kind in (QtGui.QComboBox, QtGui.QAbstractSpinBox, QtGui.QPushButton, QtGui.QCheckBox, QtGui.QSlider):
            for widget in panel.form.findChildren(kind):
                self.assertTrue(widget.toolTip(), widget.objectName())


class Items(Case):
    def rows(self, panel):
        return [tuple(panel.table.item(r, c).text() for c in range(3)) for r in range(panel.table.rowCount())]

    def test_numbers_are_given_drawn_and_one_undo(self):
        panel = self.open("Burin_NumberParts")
        self.is_narrow_and_told(panel)
        self.assertEqual(self.rows(panel), [("Plate", "1", "1"), ("Lid", "2", "1"), ("Bolt", "3", "2")])
        panel.callouts.setChecked(True)
        panel.list.setChecked(True)
        self.wait()
        panel.table.item(2, 1).setText("1")
        self.wait()
        self.assertEqual(self.rows(panel), [("Bolt", "1", "2"), ("Lid", "2", "1"), ("Plate", "3", "1")])
        support.screenshot("items-panel")
        self.close(panel)
        self.assertEqual(dict(self.obj.ItemNumbers), {"1": "Bolt", "2": "Lid", "3": "Plate"})
        self.assertIn('id="callouts"', open(self.obj.Picture).read())
        self.assertEqual(self.obj.Message, "")
        self.assertEqual(self.document.UndoCount, self.undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual((self.obj.Callouts, self.obj.PartsList, dict(self.obj.ItemNumbers)), (False, False, {}))
        self.assertNotIn('id="callouts"', open(self.obj.Picture).read())
        self.document.redo()
        support.drawn()
        self.assertIn('id="callouts"', open(self.obj.Picture).read())

    def test_cancel_and_wrong_numbers(self):
        panel = self.open("Burin_NumberParts")
        for text in ("0", "x", "100000"):
            panel.table.item(0, 1).setText(text)
            self.assertEqual(panel.message.text(), "an item has a number from 1 to 99999")
            self.assertEqual(panel.table.item(0, 1).text(), "1")
        panel.table.item(0, 1).setText("12")
        self.assertEqual(self.rows(panel)[-1], ("Plate", "12", "1"))
        child = panel.form.findChild(QtGui.QPushButton, "renumber")
        child.click()
        self.assertEqual(self.rows(panel), [("Plate", "1", "1"), ("Lid", "2", "1"), ("Bolt", "3", "2")])
        panel.reject()
        self.wait()
        self.assertEqual(dict(self.obj.ItemNumbers), {})
        self.assertEqual(self.document.UndoCount, self.undos)

    def test_rows_light_up_objects_and_objects_mark_rows(self):
        panel = self.open("Burin_NumberParts")
        panel.table.selectRow(2)
        support.settle()
        self.assertEqual(self.chosen(), ["Pump.Bolt.", "Pump.Bolt001."])
        self.select((self.pump, "Lid.Face3"))
        support.settle()
        self.assertEqual({index.row() for index in panel.table.selectionModel().selectedRows()}, {1})
        self.assertEqual(self.chosen(), ["Pump.Lid.Face3"], "the selection stays as it was made")
        Gui.Selection.clearSelection()
        support.settle()
        self.assertEqual(panel.table.selectionModel().selectedRows(), [])
        panel.reject()
        self.select((self.pump, "Lid."))
        support.settle()

    def test_the_list_as_a_spreadsheet_on_the_page(self):
        self.select(self.obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(300)
        page = self.document.Page
        self.undos = self.document.UndoCount
        panel = self.open("Burin_NumberParts")
        panel.form.findChild(QtGui.QPushButton, "spreadsheet").click()
        sheet = self.document.PartsList
        self.assertEqual([[sheet.get(f"{c}{r}") for c in "ABC"] for r in (2, 3, 4)], [[1, "Plate", 1], [2, "Lid", 1], [3, "Bolt", 2]])
        self.assertEqual(sheet.get("E4"), "Pump.Bolt, Pump.Bolt001")
        self.assertRegex(sheet.get("D2"), "#[0-9a-f]{6}")
        views = [v for v in page.Views if v.isDerivedFrom("TechDraw::DrawViewSpreadsheet")]
        self.assertEqual([(v.Source.Name, v.CellEnd) for v in views], [("PartsList", "E4")])
        self.assertIn("Bolt", views[0].Symbol)
        panel.form.findChild(QtGui.QPushButton, "renumber").click()
        panel.form.findChild(QtGui.QPushButton, "spreadsheet").click()
        self.assertEqual(len([o for o in self.document.Objects if o.isDerivedFrom("Spreadsheet::Sheet")]), 1, "written anew")
        self.assertEqual(len([v for v in page.Views if v.isDerivedFrom("TechDraw::DrawViewSpreadsheet")]), 1)
        self.close(panel)
        support.screenshot("items-page")
        self.assertEqual(self.document.UndoCount, self.undos + 1)
        support.close_pages()
        self.document.undo()
        support.drawn()
        self.assertIsNone(self.document.getObject("PartsList"))


support.run(__name__)
