"""Notes by the selection in the 3-D view: written in their panel, undone, redone, edited, told."""

import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from annotation_case import Annotations, facing  # noqa: E402
from FreeCAD import Vector as V  # noqa: E402
from PySide import QtGui  # noqa: E402


class Notes(Annotations):
    def notes(self):
        return sorted(self.texts("note"))

    def open_note(self, *selection):
        self.run_on("Burin_Note", *selection)
        self.assertTrue(Gui.Control.activeDialog())
        return support.panel()

    def write(self, panel, text):
        panel.words.setPlainText(text)
        self.wait()

    def top(self):
        return self.sub("Lid", facing(self.document.Lid, V(0, 0, 1)))

    def rows(self, panel):
        return [panel.list.item(row).text() for row in range(panel.list.count())]

    def icons(self):
        return [one.ViewObject.Proxy.getIcon().rpartition("/")[2] for one in self.obj.Dimensions]


class Command(Notes):
    def test_written_undone_and_redone(self):
        panel = self.open_note(self.top())
        self.is_narrow_and_told(panel)
        self.assertTrue(panel.words.hasFocus(), "one may type at once")
        self.assertFalse(panel.words.visibleRegion().isEmpty(), "and sees it")
        one, = self.obj.Dimensions
        self.assertEqual((one.Kind, self.rows(panel), self.icons()), ("Note", ["Note"], ["burin_stale.svg"]))
        self.assertIn("Note: it has no words; write some in Text", panel.message.text())
        self.assertTrue(panel.words.isVisible() and panel.symbol.isVisible() and panel.frame.isVisible())
        self.assertFalse(panel.texts["Tolerance"].isVisible() or panel.texts["Text"].isVisible())
        self.assertEqual(self.chosen(), ["Pump." + self.top()[1]], "what it points at lights up")
        self.write(panel, "Grease\nthe lid")
        panel.frame.setChecked(True)
        self.wait()
        self.assertEqual((self.notes(), one.Frame, self.rows(panel), self.icons()), (["Grease", "the lid"], True, ["Note Grease the lid"], ["burin_note.svg"]))
        support.screenshot("notes-panel")
        self.close(panel)
        self.assertEqual((self.document.UndoCount, self.obj.Message, self.told), (self.undos + 1, "", []))
        self.assertEqual(self.obj.ViewObject.Proxy.claimChildren(), [one])
        self.document.undo()
        support.drawn()
        self.assertEqual((list(self.obj.Dimensions), self.notes()), ([], []))
        self.document.redo()
        support.drawn()
        self.assertEqual((self.notes(), self.icons()), (["Grease", "the lid"], ["burin_note.svg"]))

    def test_cancel_leaves_none(self):
        panel = self.open_note(self.top())
        self.write(panel, "no")
        panel.reject()
        self.wait()
        self.assertEqual((list(self.obj.Dimensions), self.notes(), self.document.UndoCount), ([], [], self.undos))
        self.assertFalse([o.Name for o in self.document.Objects if o.Name.startswith("Note")])

    def test_a_vertex_an_edge_and_whole_objects(self):
        panel = self.open_note((self.pump, "Bolt."), self.sub("Plate", "Vertex1"), self.sub("Plate", "Edge1"))
        one, = self.obj.Dimensions
        self.assertEqual(one.Features, [(self.pump, ("Bolt.", "Plate.Vertex1", "Plate.Edge1"))])
        self.write(panel, "{part.name}")
        self.close(panel)
        self.assertEqual((self.notes(), self.obj.Message), ([self.document.Bolt.Label], ""))
        panel = self.open_note(self.pump)
        self.write(panel, "all of it")
        self.close(panel)
        self.assertEqual((self.notes(), self.obj.Dimensions[1].Features), ([self.document.Bolt.Label, "all of it"], [(self.pump, ("",))]))

    def test_wrong_selections_are_told_in_one_line(self):
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        undos = self.document.UndoCount
        for chosen, words in (([], "select what the note is about"), ([self.obj], "select what the note is about"), ([self.obj, other], "Other is not drawn here")):
            self.run_on("Burin_Note", *chosen)
            self.assertIn(words, self.told[-1])
            self.assertEqual((list(self.obj.Dimensions), Gui.Control.activeDialog(), self.document.UndoCount), ([], False, undos))
        self.document.removeObject(self.obj.Name)
        self.run_on("Burin_Note", self.top())
        self.assertEqual(self.told[-1], "there is no illustration yet; make one with New illustration first")


class Panel(Notes):
    def test_symbols_are_chosen_and_edited_with_dimensions(self):
        self.run_on("Burin_Dimension", self.obj)
        panel = self.open_note(self.top())
        self.write(panel, "Ra 1.6")
        panel.symbol.setCurrentIndex(panel.symbol.findData("surface"))
        self.assertEqual([panel.symbol_kind.itemData(k) for k in range(panel.symbol_kind.count())], ["any", "removed", "kept"])
        panel.symbol_kind.setCurrentIndex(panel.symbol_kind.findData("removed"))
        self.wait()
        one = self.obj.Dimensions[1]
        support.screenshot("notes-symbols")
        self.assertEqual((one.Symbol, dict(one.SymbolKeys), self.notes(), self.obj.Message), ("surface", {"surface_material": "removed"}, ["Ra 1.6"], ""))
        panel.symbol.setCurrentIndex(panel.symbol.findData("balloon"))
        self.assertFalse(panel.symbol_kind.isEnabled())
        panel.list.setCurrentRow(0)
        self.assertEqual((panel.kind.currentData(), panel.words.isVisible(), panel.texts["Tolerance"].isVisible()), ("Overall", False, True))
        panel.list.setCurrentRow(1)
        self.assertEqual((panel.kind.currentData(), panel.words.toPlainText(), panel.symbol.currentData()), ("Note", "Ra 1.6", "balloon"))
        self.select((self.pump, "Bolt."))
        panel.form.findChild(QtGui.QPushButton, "add-note").click()
        self.write(panel, "bolt")
        self.assertEqual((self.notes(), self.rows(panel)), (["Ra 1.6", "bolt"], ["Overall dimensions", "Note Ra 1.6", "Note001 bolt"]))
        panel.form.findChild(QtGui.QPushButton, "delete").click()
        self.wait()
        self.assertEqual(self.notes(), ["Ra 1.6"])
        self.close(panel)
        self.assertEqual(self.document.UndoCount, self.undos + 2)

    def test_a_double_click_edits_and_lines_of_a_script_are_shown(self):
        from freecad.burin_wb.features import make_note

        one = make_note(self.obj, [self.top()], Text="a\\nb", Symbol="warning", SymbolKeys={"warning_of": "hot"})
        self.document.recompute()
        self.wait()
        self.assertEqual(self.notes(), ["a", "b"])
        self.assertTrue(one.ViewObject.Proxy.doubleClicked(one.ViewObject))
        panel = support.panel()
        self.assertEqual((panel.words.toPlainText(), panel.symbol_kind.currentData(), one.Text), ("a\nb", "hot", "a\\nb"))
        self.write(panel, "a\nc")
        self.close(panel)
        self.assertEqual(self.notes(), ["a", "c"])

    def test_saved_opened_and_deleted_with_its_illustration(self):
        panel = self.open_note(self.top())
        self.write(panel, "kept")
        self.close(panel)
        self.save_and_open()
        self.assertEqual((self.notes(), self.icons(), self.obj.ViewObject.Proxy.claimChildren()), (["kept"], ["burin_note.svg"], list(self.obj.Dimensions)))
        self.select(self.obj)
        with unittest.mock.patch.object(QtGui.QMessageBox, "warning", lambda *_, **__: QtGui.QMessageBox.Yes):
            Gui.runCommand("Std_Delete")
        support.settle()
        self.assertEqual([o.Name for o in self.document.Objects if o.Name.startswith(("Illustration", "Note"))], [])


support.run(__name__)
