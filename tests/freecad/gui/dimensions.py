"""Dimensions by the selection in the 3-D view: added, deleted, undone, redone, told."""

import json
import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from assembly_case import Case  # noqa: E402

V = FreeCAD.Vector


def facing(obj, normal):
    """The name of the flat face that looks that way and lies farthest there."""
    return max((face.CenterOfMass.dot(normal), f"Face{k}") for k, face in enumerate(obj.Shape.Faces, 1)
               if face.findPlane() is not None and face.normalAt(0, 0).dot(normal) > 0.999)[1]


class Annotations(Case):
    """The pump on a sheet that has room for what is written."""

    def setUp(self):
        super().setUp()
        self.obj.Width, self.obj.Height, self.obj.Margin, self.obj.Views = 297, 210, 10, ["front", "top"]
        self.document.recompute()
        support.drawn()
        self.undos = self.document.UndoCount
        self.said = []
        patch = unittest.mock.patch("freecad.burin_wb.commands.base.tell", lambda text, *_: self.said.append(text))
        patch.start()
        self.addCleanup(patch.stop)

    def sub(self, name, element):
        return self.pump, f"{name}.{element}"

    def run_on(self, command, *selection):
        self.select(*selection)
        Gui.runCommand(command)
        self.wait()

    def texts(self, role=None):
        with open(self.obj.Drawing, encoding="utf-8") as file:
            return [text["text"] for layer in json.load(file)["layers"] for text in layer.get("texts", ()) if role in (None, text["role"])]

    def redraw(self):
        self.obj.touch()
        self.document.recompute()
        self.wait()

    def save_and_open(self):
        path = str(support.OUT / "kept.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.obj, self.pump = self.document.Illustration, self.document.Pump
        self.wait()


class Dimensions(Annotations):
    def numbers(self):
        return sorted(self.texts("dimension"))

    def heights(self):
        plate, lid = self.document.Plate, self.document.Lid
        return self.sub("Plate", facing(plate, V(0, 0, -1))), self.sub("Lid", facing(lid, V(0, 0, 1)))

    def hole(self):
        return self.sub("Lid", next(f"Face{k}" for k, face in enumerate(self.document.Lid.Shape.Faces, 1) if face.findPlane() is None))

    def test_added_by_clicks_undone_and_redone(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.assertEqual((self.numbers(), self.obj.Message, self.said), (["16"], "", []))
        one, = self.obj.Dimensions
        self.assertEqual(Gui.Selection.getSelection(), [one], "its properties are shown")
        self.run_on("Burin_Dimension", self.hole())
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])
        self.run_on("Burin_Dimension", self.obj)
        self.assertEqual(self.numbers(), ["16", "24", "40", "60", "⌀6.2"])
        self.assertEqual([one.Kind for one in self.obj.Dimensions], ["Distance", "Diameter", "Overall"])
        self.assertEqual(self.document.UndoCount, self.undos + 3)
        self.assertEqual(self.obj.ViewObject.Proxy.claimChildren(), list(self.obj.Dimensions))
        self.assertTrue(all(one.ViewObject.isVisible() for one in self.obj.Dimensions), "the tree does not show them as hidden")
        support.screenshot("dimensions")
        self.document.undo()
        self.redraw()
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])
        self.document.redo()
        self.redraw()
        self.assertEqual(self.numbers(), ["16", "24", "40", "60", "⌀6.2"])

    def test_saved_and_opened(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.obj.Dimensions[0].Tolerance = "±0.1"
        self.redraw()
        self.save_and_open()
        one, = self.obj.Dimensions
        self.assertEqual((self.numbers(), one.Tolerance, one.ViewObject.Proxy.getIcon()[-19:]), (["16 ±0.1"], "±0.1", "burin_dimension.svg"))
        self.assertEqual(self.obj.ViewObject.Proxy.claimChildren(), [one])
        one.Tolerance = ""
        self.redraw()
        self.assertEqual(self.numbers(), ["16"])

    def test_deleted_alone_and_with_its_illustration(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.run_on("Burin_Dimension", self.hole())
        name = self.obj.Dimensions[1].Name
        self.select(self.obj.Dimensions[1])
        Gui.runCommand("Std_Delete")
        self.redraw()
        self.assertEqual((self.document.getObject(name), self.numbers()), (None, ["16"]))
        self.document.undo()
        self.redraw()
        self.assertEqual((self.numbers(), self.obj.Dimensions[1].ViewObject.Proxy.getIcon()[-19:]), (["16", "⌀6.2"], "burin_dimension.svg"))
        self.select(self.obj)
        with unittest.mock.patch.object(support.QtGui.QMessageBox, "warning", lambda *_, **__: support.QtGui.QMessageBox.Yes):
            Gui.runCommand("Std_Delete")
        support.settle()
        self.assertEqual([o.Name for o in self.document.Objects if o.Name.startswith(("Illustration", "Dimension"))], [])
        self.document.undo()
        support.settle()
        self.obj = self.document.Illustration
        self.redraw()
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])

    def test_wrong_selections_are_told_in_one_line(self):
        plate, = self.heights()[:1]
        for chosen, words in (([plate], "a flat face alone has no dimension"), ([self.obj, self.pump], "Pump is selected as a whole"),
                              ([plate, plate[:1] + ("Lid.Vertex1",), self.hole()], "one or two faces, edges or vertices; 3 are selected"),
                              ([self.obj, (self.document.addObject("Part::Box", "Other"), "Face1")], "Other is not drawn here")):
            self.document.recompute()
            undos = self.document.UndoCount
            self.run_on("Burin_Dimension", *chosen)
            self.assertIn(words, self.said[-1])
            self.assertNotIn("\n", self.said[-1])
            self.assertEqual((list(self.obj.Dimensions), self.document.UndoCount), ([], undos))
        self.document.removeObject(self.obj.Name)
        self.run_on("Burin_Dimension", *self.heights())
        self.assertEqual(self.said[-1], "there is no illustration yet; make one with New illustration first")

    def test_of_several_illustrations(self):
        from freecad.burin_wb.features import make_illustration

        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        other = make_illustration(self.document, [box])
        self.document.recompute()
        self.wait()
        self.run_on("Burin_Dimension", (box, "Face1"), (box, "Face2"))
        self.assertEqual(([one.Kind for one in other.Dimensions], list(self.obj.Dimensions)), (["Distance"], []), "the one that draws it")
        self.run_on("Burin_Dimension")
        self.assertEqual(self.said, ["select the illustration too: this document has several"])
        self.run_on("Burin_Dimension", other.Dimensions[0])
        self.assertEqual([one.Kind for one in other.Dimensions], ["Distance", "Overall"], "a dimension stands for its illustration")
        page = self.document.addObject("TechDraw::DrawPage", "Page")
        from freecad.burin_wb.features import place_on_page

        view = place_on_page(page, self.obj)
        self.document.recompute()
        self.wait()
        self.run_on("Burin_Dimension", view)
        self.assertEqual([one.Kind for one in self.obj.Dimensions], ["Overall"], "and its view on a page")

    def test_what_is_gone_is_marked_in_the_tree(self):
        self.run_on("Burin_Dimension", self.hole())
        one, = self.obj.Dimensions
        Gui.Selection.clearSelection()
        self.assertTrue(one.ViewObject.Proxy.doubleClicked(one.ViewObject))
        self.assertEqual(self.chosen(), ["Pump." + self.hole()[1]], "what it measures lights up")
        import Part

        self.document.Lid.Shape = Part.makeBox(60, 40, 6, V(0, 0, 10))
        self.document.recompute()
        self.wait()
        self.assertEqual((self.numbers(), one.ViewObject.Proxy.getIcon()[-15:]), ([], "burin_stale.svg"))
        self.assertRegex(self.obj.Message, "^Diameter: Pump.Lid.Face[0-9]+ is gone; choose its Features again, or delete it")


support.run(__name__)
