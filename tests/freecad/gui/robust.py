"""Bad input and a kernel that dies: a message that says what to do, nothing lost, no hang."""

import os
import signal
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtGui  # noqa: E402


def worker():
    from freecad.burin_wb.view import scheduler

    return scheduler.scheduler._worker


class Crash(support.Case):
    def test_a_kernel_that_dies_leaves_freecad_and_the_document_alive(self):
        obj = self.illustrate(*self.box_and_ball())
        before = open(obj.Drawing).read()
        obj.Style = "engraving"
        obj.StyleKeys = {"hatch.spacing_min": "0.1", "hatch.spacing_max": "0.15"}
        with support.held() as process:
            obj.recompute()
            self.assertTrue(support.until(lambda: worker()._running is not None and worker()._sent))
            process.send_signal(signal.SIGSEGV)
        support.drawn(obj)
        self.assertIn("ended unexpectedly", obj.Message)
        self.assertIn("document is unchanged", obj.Message)
        self.assertEqual(open(obj.Drawing).read(), before)
        obj.StyleKeys = {}
        obj.recompute()
        support.drawn(obj)
        self.assertEqual(obj.Message, "", "the next run does not work")
        self.assertNotEqual(open(obj.Drawing).read(), before)

    def test_a_document_closed_while_it_is_drawn(self):
        obj = self.illustrate(*self.box_and_ball())
        obj.Style = "engraving"
        obj.recompute()
        FreeCAD.closeDocument(self.document.Name)
        support.drawn()

    def test_a_document_closed_while_its_panel_is_open(self):
        from freecad.burin_wb.view import scheduler

        self.select(*self.box_and_ball())
        Gui.runCommand("Burin_NewIllustration")
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(support.until(lambda: Gui.Control.activeDialog() is False))
        scheduler.scheduler.progressed.emit(support.panel().key, "trace", 0.5)
        support.drawn()

    def test_a_document_closed_while_its_picture_is_painted(self):
        from freecad.burin_wb.tasks.preview import Preview

        preview = Preview(self.illustrate(*self.box_and_ball()))
        FreeCAD.closeDocument(self.document.Name)
        preview._painting = [None]  # what the thread gives where the drawing file has gone
        preview._look()
        self.assertFalse(preview.busy())

    def test_an_illustration_deleted_while_it_is_drawn(self):
        obj = self.illustrate(*self.box_and_ball())
        obj.Style = "engraving"
        obj.recompute()
        self.document.removeObject(obj.Name)
        support.drawn()
        self.assertEqual(len(self.document.Objects), 2)


class BadInput(support.Case):
    def refused(self, command, *words):
        """Runs a command that cannot be done: nothing changes, and a message holds the words."""
        objects, undos = [o.Name for o in self.document.Objects], self.document.UndoCount
        told = []
        module = sys.modules["freecad.burin_wb.commands.base"]
        with unittest.mock.patch.object(module, "tell", told.append):
            command.Activated()
        text = " ".join(told)
        for word in words:
            self.assertIn(word, text)
        self.assertEqual([o.Name for o in self.document.Objects], objects)
        self.assertEqual(self.document.UndoCount, undos)
        self.assertFalse(Gui.Control.activeDialog())

    @staticmethod
    def command(module, index=0):
        return __import__(f"freecad.burin_wb.commands.{module}", fromlist=["x"]).COMMANDS[index]

    def test_nothing_selected_and_nothing_shown(self):
        for obj in self.box_and_ball():
            obj.ViewObject.Visibility = False
        self.document.addObject("PartDesign::Plane", "Plane")
        self.document.recompute()
        self.select()
        self.assertFalse(self.command("new").IsActive())
        self.refused(self.command("new"), "select the parts")

    def test_a_sketch_only(self):
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        self.document.recompute()
        self.select(sketch)
        self.refused(self.command("new"), "nothing to draw", "choose")

    def test_a_shape_that_is_null(self):
        empty = self.document.addObject("Part::Feature", "Empty")
        self.select(empty)
        self.refused(self.command("new"), "nothing to draw", "no shape")

    def test_an_invisible_object_that_is_asked_for_is_drawn(self):
        box, ball = self.box_and_ball()
        box.ViewObject.Visibility = False
        obj = self.illustrate(box)
        self.assertEqual(obj.Message, "")
        self.assertTrue(obj.Drawing)

    def test_invisible_children_are_left_out_and_a_part_without_any_says_so(self):
        assembly = self.document.addObject("App::Part", "Assembly")
        box = self.document.addObject("Part::Box", "Box")
        assembly.addObject(box)
        self.document.recompute()
        box.ViewObject.Visibility = False
        self.select(assembly)
        self.refused(self.command("new"), "nothing to draw")

    def test_a_broken_feature_keeps_the_drawing(self):
        box, ball = self.box_and_ball()
        obj = self.illustrate(box, ball)
        before = open(obj.Drawing).read()
        box.Length = 0
        self.document.recompute()
        support.drawn()
        self.assertTrue(os.path.exists(obj.Drawing))
        box.Length = 40
        self.document.recompute()
        support.drawn()
        self.assertEqual(open(obj.Drawing).read(), before)

    def test_a_source_that_is_deleted(self):
        box, ball = self.box_and_ball()
        obj = self.illustrate(box, ball)
        self.document.removeObject("Ball")
        self.document.recompute()
        support.drawn()
        self.assertTrue(os.path.exists(obj.Drawing))
        self.document.removeObject("Box")
        self.document.recompute()
        support.drawn()
        self.assertTrue(obj.Message, "no word about an illustration of nothing")

    def test_the_page_is_deleted(self):
        obj = self.illustrate(*self.box_and_ball())
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(200)
        support.close_pages()
        self.document.removeObject("Page")
        support.settle(100)
        obj.ViewDirection = FreeCAD.Vector(0, -1, 0)
        self.document.recompute()
        support.drawn()
        self.assertEqual(obj.Message, "")
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(200)
        pages = [o for o in self.document.Objects if o.isDerivedFrom("TechDraw::DrawPage")]
        self.assertEqual(len(pages), 1)

    def test_the_illustration_is_deleted_and_its_view_stays(self):
        obj = self.illustrate(*self.box_and_ball())
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(200)
        view = self.document.Page.Views[0]
        symbol = view.Symbol
        self.document.removeObject(obj.Name)
        self.document.recompute()
        self.assertEqual(view.Symbol, symbol)

    def test_several_pages_and_none_chosen(self):
        obj = self.illustrate(*self.box_and_ball())
        for _ in range(2):
            self.document.addObject("TechDraw::DrawPage", "Page")
        self.select(obj)
        self.refused(self.command("page"), "select one")

    def test_the_template_of_the_preferences_is_gone(self):
        from freecad.burin_wb import preferences

        obj = self.illustrate(*self.box_and_ball())
        preferences.group().SetString("Template", "/nowhere/template.svg")
        try:
            self.select(obj)
            self.refused(self.command("page"), "template.svg", "preferences")
        finally:
            preferences.group().RemString("Template")

    def test_a_style_file_that_is_gone(self):
        obj = self.illustrate(*self.box_and_ball())
        before = open(obj.Drawing).read()
        obj.Style = "/nowhere/mine.json"
        self.document.recompute()
        support.drawn()
        self.assertIn("/nowhere/mine.json", obj.Message)
        self.assertEqual(open(obj.Drawing).read(), before)
        Gui.runCommand("Burin_Style")  # the panel opens and another style can be chosen
        support.settle(50)
        panel = support.panel()
        panel.base.setCurrentIndex(panel.base.findData("outline"))
        panel.draw()
        support.drawn()
        self.assertEqual(obj.Message, "")
        panel.accept()

    def test_a_kept_drawing_that_is_spoilt(self):
        obj = self.illustrate(*self.box_and_ball())
        path = str(support.OUT / "spoilt.json")
        with open(path, "w") as file:
            file.write("{")
        obj.Drawing = path
        obj.Inputs = ""
        support.settle(50)
        self.select(obj)
        self.refused(self.command("select"), "recompute")
        obj.touch()
        self.document.recompute()
        support.drawn()
        self.assertGreater(obj.ViewObject.Proxy._ink.getNumChildren(), 0)

    def test_export_where_nothing_can_be_written(self):
        obj = self.illustrate(*self.box_and_ball())
        self.select(obj)
        for path, word in (("/nowhere/at/all.svg", "/nowhere"), (str(support.OUT / "a.xyz"), "xyz")):
            with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")):
                self.refused(self.command("export"), word)

    def test_a_document_from_a_read_only_file(self):
        obj = self.illustrate(*self.box_and_ball())
        name, path = obj.Name, str(support.OUT / "read-only.FCStd")
        if os.path.exists(path):
            os.chmod(path, 0o644)
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        os.chmod(path, 0o444)
        try:
            self.document = FreeCAD.openDocument(path)
            obj = self.document.getObject(name)
            obj.Style = "outline"
            self.document.recompute()
            support.drawn()
            self.assertEqual(obj.Message, "")
            other = str(support.OUT / "copy.FCStd")
            self.document.saveAs(other)
            self.assertGreater(os.path.getsize(other), 1000)
        finally:
            os.chmod(path, 0o644)

    def test_a_newer_schema_is_shown_as_it_was_kept(self):
        obj = self.illustrate(*self.box_and_ball())
        before = open(obj.Drawing).read()
        obj.Schema = 99
        obj.Style = "outline"
        self.document.recompute()
        support.drawn()
        self.assertEqual(open(obj.Drawing).read(), before)
        self.assertGreater(obj.ViewObject.Proxy._ink.getNumChildren(), 0)


support.run(__name__)
