"""Dimensions by the selection in the 3-D view: added, deleted, undone, redone, told."""

import json
import os
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from annotation_case import Annotations, facing  # noqa: E402
from PySide import QtGui  # noqa: E402

V = FreeCAD.Vector


class Measured(Annotations):
    """What is measured of the pump."""

    def numbers(self):
        return sorted(self.texts("dimension"))

    def heights(self):
        plate, lid = self.document.Plate, self.document.Lid
        return self.sub("Plate", facing(plate, V(0, 0, -1))), self.sub("Lid", facing(lid, V(0, 0, 1)))

    def hole(self):
        return self.sub("Lid", next(f"Face{k}" for k, face in enumerate(self.document.Lid.Shape.Faces, 1) if face.findPlane() is None))


class Dimensions(Measured):
    def test_added_by_clicks_undone_and_redone(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.assertEqual((self.numbers(), self.obj.Message, self.told), (["16"], "", []))
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
        support.drawn()
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])
        self.document.redo()
        support.drawn()
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
        support.drawn()
        self.assertEqual((self.document.getObject(name), self.numbers()), (None, ["16"]))
        self.document.undo()
        support.drawn()
        self.assertEqual((self.numbers(), self.obj.Dimensions[1].ViewObject.Proxy.getIcon()[-19:]), (["16", "⌀6.2"], "burin_dimension.svg"))
        self.select(self.obj)
        with unittest.mock.patch.object(QtGui.QMessageBox, "warning", lambda *_, **__: QtGui.QMessageBox.Yes):
            Gui.runCommand("Std_Delete")
        support.settle()
        self.assertEqual([o.Name for o in self.document.Objects if o.Name.startswith(("Illustration", "Dimension"))], [])
        self.document.undo()
        self.obj = self.document.Illustration
        support.drawn()
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])

    def test_wrong_selections_are_told_in_one_line(self):
        plate, = self.heights()[:1]
        for chosen, words in (([plate], "a flat face alone has no dimension"), ([self.obj, self.pump], "Pump is selected as a whole"),
                              ([plate, plate[:1] + ("Lid.Vertex1",), self.hole()], "one or two faces, edges or vertices; 3 are selected"),
                              ([self.obj, (self.document.addObject("Part::Box", "Other"), "Face1")], "Other is not drawn here")):
            self.document.recompute()
            undos = self.document.UndoCount
            self.run_on("Burin_Dimension", *chosen)
            self.assertIn(words, self.told[-1])
            self.assertNotIn("\n", self.told[-1])
            self.assertEqual((list(self.obj.Dimensions), self.document.UndoCount), ([], undos))
        self.document.removeObject(self.obj.Name)
        for chosen in (self.heights(), [self.pump], []):
            self.run_on("Burin_Dimension", *chosen)
            self.assertEqual(self.told.pop(), "there is no illustration yet; make one with New illustration first")

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
        self.assertEqual(self.told, ["select the illustration too: this document has several"])
        self.run_on("Burin_Dimension", other.Dimensions[0])
        self.assertEqual([one.Kind for one in other.Dimensions], ["Distance", "Overall"], "a dimension stands for its illustration")
        page = self.document.addObject("TechDraw::DrawPage", "Page")
        from freecad.burin_wb.features import place_on_page

        view = place_on_page(page, self.obj)
        self.document.recompute()
        self.wait()
        self.run_on("Burin_Dimension", view)
        self.assertEqual([one.Kind for one in self.obj.Dimensions], ["Overall"], "and its view on a page")

    def test_the_same_again_is_told(self):
        for _ in range(2):
            self.run_on("Burin_Dimension", self.hole())
        self.assertEqual((self.told, len(self.obj.Dimensions), self.document.UndoCount),
                         (["Diameter measures this already; select other faces or edges"], 1, self.undos + 1))

    def test_a_copy_has_its_own(self):
        self.run_on("Burin_Dimension", self.hole())
        copy = self.document.copyObject(self.obj, False)
        self.document.recompute()
        self.wait()
        one, other = *self.obj.Dimensions, *copy.Dimensions
        self.assertNotEqual(one.Name, other.Name)
        self.assertEqual((copy.ViewObject.Proxy.claimChildren(), other.ViewObject.Proxy.getIcon()[-19:]), ([other], "burin_dimension.svg"))
        self.assertEqual(self.obj.ViewObject.Proxy.claimChildren(), [one])
        self.obj = copy
        self.redraw()
        self.assertEqual(self.numbers(), ["⌀6.2"])

    def test_what_the_kernel_refuses_is_marked_in_the_tree(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.run_on("Burin_Dimension", self.hole())
        height, hole = self.obj.Dimensions
        hole.View = "left"
        self.document.recompute()
        self.wait()
        self.assertEqual((self.numbers(), self.obj.Message), (["16"], "Diameter is not drawn: no view is called 'left': there is front, top"))
        self.assertEqual([one.ViewObject.Proxy.getIcon().rpartition("/")[2] for one in (height, hole)], ["burin_dimension.svg", "burin_stale.svg"])
        self.assertFalse([one.Name for one in (self.obj, height, hole) if "Touched" in one.State])
        hole.View = ""
        self.document.recompute()
        self.wait()
        self.assertEqual((self.numbers(), self.obj.Message, hole.ViewObject.Proxy.getIcon()[-19:]), (["16", "⌀6.2"], "", "burin_dimension.svg"))

    def test_a_body_is_measured_through_its_steps(self):
        """As clicks name them: by the body and the step."""
        from freecad.burin_wb.features import make_illustration

        body = self.document.addObject("PartDesign::Body", "Body")
        for kind, name, sizes, x in (("AdditiveBox", "Block", {"Length": 60, "Width": 40, "Height": 15}, 0),
                                     ("SubtractiveCylinder", "One", {"Radius": 4, "Height": 15}, 20), ("SubtractiveCylinder", "Two", {"Radius": 4, "Height": 15}, 45)):
            step = body.newObject("PartDesign::" + kind, name)
            step.Placement.Base = V(x, 20 if x else 0, 0)
            for size, value in sizes.items():
                setattr(step, size, value)
        self.document.recompute()
        self.obj = make_illustration(self.document, [body])
        self.obj.Width, self.obj.Height, self.obj.Margin, self.obj.Views = 297, 210, 10, ["front", "top"]
        self.document.recompute()
        self.wait()
        holes = [f"Two.Face{k}" for k, face in enumerate(body.Shape.Faces, 1) if face.findPlane() is None]
        self.run_on("Burin_Dimension", *((body, name) for name in holes))
        self.assertEqual(self.numbers(), ["25"])
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        for edge in ("Edge1", "Edge2", "Edge12"):
            chamfer.Base, chamfer.Size = (self.document.Two, [edge]), 1
            self.document.recompute()
            self.wait()
            self.assertEqual((self.numbers(), self.obj.Message), (["25"], ""), edge)

    def test_what_is_gone_is_marked_in_the_tree(self):
        self.run_on("Burin_Dimension", self.hole())
        one, = self.obj.Dimensions
        import Part

        self.document.Lid.Shape = Part.makeBox(60, 40, 6, V(0, 0, 10))
        self.document.recompute()
        self.wait()
        self.assertEqual((self.numbers(), one.ViewObject.Proxy.getIcon()[-15:]), ([], "burin_stale.svg"))
        self.assertRegex(self.obj.Message, "^Diameter: Pump.Lid.Face[0-9]+ is gone; choose its Features again, or delete it")


class Panel(Measured):
    def edit(self, dimension):
        self.assertTrue(dimension.ViewObject.Proxy.doubleClicked(dimension.ViewObject))
        self.wait()
        return support.panel()

    def rows(self, panel):
        return [panel.list.item(row).text() for row in range(panel.list.count())]

    def write(self, panel, name, text):
        panel.texts[name].setText(text)
        panel.texts[name].editingFinished.emit()

    def click(self, panel, name):
        panel.form.findChild(QtGui.QPushButton, name).click()
        self.wait()

    def test_edited_added_and_deleted_are_one_undo(self):
        self.run_on("Burin_Dimension", *self.heights())
        self.run_on("Burin_Dimension", self.hole())
        undos = self.document.UndoCount
        Gui.Selection.clearSelection()
        panel = self.edit(self.obj.Dimensions[1])
        self.is_narrow_and_told(panel)
        self.assertEqual(self.rows(panel), ["Distance", "Diameter"])
        self.assertEqual(self.chosen(), ["Pump." + self.hole()[1]], "what it measures lights up")
        self.assertEqual((panel.kind.currentData(), panel.decimals.value()), ("Diameter", -1))
        self.write(panel, "Tolerance", "H7")
        self.write(panel, "Text", "2x ⌀{value}")
        panel.decimals.setValue(0)
        self.wait()
        self.assertEqual(self.numbers(), ["16", "2x ⌀6 H7"])
        support.screenshot("dimensions-panel")
        panel.kind.setCurrentIndex(panel.kind.findData("Radius"))
        self.write(panel, "Text", "")
        self.wait()
        self.assertEqual((self.numbers(), self.rows(panel)), (["16", "R3 H7"], ["Distance", "Diameter H7"]))
        panel.kind.setCurrentIndex(panel.kind.findData("Angle"))
        self.wait()
        self.assertIn("Diameter: Kind Angle needs two faces, edges or vertices in Features", panel.message.text())
        panel.kind.setCurrentIndex(panel.kind.findData("Diameter"))
        Gui.Selection.clearSelection()
        self.click(panel, "add")
        self.assertEqual((self.numbers(), panel.kind.currentData()), (["16", "24", "40", "60", "⌀6 H7"], "Overall"))
        self.click(panel, "add")
        self.assertIn("has its overall dimensions already", panel.message.text())
        panel.list.setCurrentRow(0)
        self.click(panel, "delete")
        self.assertEqual((self.numbers(), self.rows(panel)), (["24", "40", "60", "⌀6 H7"], ["Diameter H7", "Overall dimensions"]))
        self.close(panel)
        self.assertEqual(self.document.UndoCount, undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual(self.numbers(), ["16", "⌀6.2"])

    def test_cancel_takes_everything_back(self):
        self.run_on("Burin_Dimension", self.hole())
        panel = self.edit(self.obj.Dimensions[0])
        self.write(panel, "Tolerance", "H7")
        self.select(*self.heights())
        self.click(panel, "add")
        self.assertEqual(self.numbers(), ["16", "⌀6.2 H7"])
        panel.reject()
        self.wait()
        self.assertEqual((self.numbers(), len(self.obj.Dimensions), [o.Name for o in self.document.Objects if o.Name.startswith("Dimension")]),
                         (["⌀6.2"], 1, ["Dimension"]))


class SectionViews(Annotations):
    def said(self):
        return [json.loads(text) for text in self.obj.Sections]

    def views(self):
        with open(self.obj.Drawing, encoding="utf-8") as file:
            return [view["name"] for view in json.load(file).get("views", ())]

    def test_across_y_edited_and_one_undo(self):
        panel = self.open("Burin_SectionView")
        self.is_narrow_and_told(panel)
        self.assertEqual(self.said(), [{"plane": {"normal": [0, -1, 0], "offset": -20}, "view": True}], "through the middle")
        self.assertEqual((panel.list.item(0).text(), panel.own.isChecked(), panel.letter.text()), ("A-A: -y at 20 mm", True, ""))
        self.assertEqual((self.views(), self.texts().count("A"), self.texts().count("A-A")), (["front", "top", "A-A"], 2, 1))
        support.screenshot("section-view-panel")
        panel.letter.setText("K")
        panel.letter.editingFinished.emit()
        panel.slider.setValue(750)
        self.wait()
        self.assertEqual(self.said(), [{"plane": {"normal": [0, -1, 0], "offset": -30}, "view": "K"}])
        self.assertEqual((self.views(), panel.list.item(0).text()), (["front", "top", "K-K"], "K-K: -y at 30 mm"))
        panel.own.click()
        self.wait()
        self.assertEqual((self.said(), self.views()), ([{"plane": {"normal": [0, -1, 0], "offset": -30}}], ["front", "top"]))
        self.assertFalse(panel.letter.isEnabled())
        panel.own.click()
        self.close(panel)
        self.assertEqual((self.views(), self.document.UndoCount), (["front", "top", "A-A"], self.undos + 1))
        self.document.undo()
        support.drawn()
        self.assertEqual((self.said(), self.views()), ([], ["front", "top"]))
        self.document.redo()
        support.drawn()
        self.assertEqual(self.views(), ["front", "top", "A-A"])
        self.save_and_open()
        self.assertEqual(self.views(), ["front", "top", "A-A"])
        self.redraw()
        self.assertEqual(len(self.said()), 1)

    def test_through_a_face_and_a_datum_plane(self):
        datum = self.document.addObject("PartDesign::Plane", "Datum")
        datum.Placement = FreeCAD.Placement(V(12, 0, 0), FreeCAD.Rotation(V(0, 0, 1), V(1, 0, 0)))
        self.document.recompute()
        self.close(self.open("Burin_SectionView", self.obj, datum))
        self.assertEqual([round(n, 6) for n in self.said()[0]["plane"]["normal"]], [1, 0, 0])
        self.assertAlmostEqual(self.said()[0]["plane"]["offset"], 12)
        self.close(self.open("Burin_SectionView", self.obj, self.sub("Lid", facing(self.document.Lid, V(0, 0, -1)))))
        self.assertAlmostEqual(self.said()[1]["plane"]["offset"], -10, msg="the lower face of the lid lies inside the model")
        self.close(self.open("Burin_SectionView", self.obj, self.sub("Plate", facing(self.document.Plate, V(0, -1, 0)))))
        self.assertEqual(self.said()[2]["plane"], {"normal": [0, -1, 0], "offset": -20}, "a face at the end of the model: through the middle")
        self.assertEqual(self.views(), ["front", "top", "A-A", "B-B", "C-C"])

    def test_another_one_takes_a_place_of_its_own(self):
        for _ in range(3):
            self.close(self.open("Burin_SectionView"))
        offsets = [one["plane"]["offset"] for one in self.said()]
        self.assertEqual((offsets, self.views()), ([-20, -30, -10], ["front", "top", "A-A", "B-B", "C-C"]))
        datum = self.document.addObject("PartDesign::Plane", "Datum")
        datum.Placement = FreeCAD.Placement(V(0, 30, 0), FreeCAD.Rotation(V(0, 0, 1), V(0, 1, 0)))
        self.document.recompute()
        panel = self.open("Burin_SectionView", self.obj, datum)
        self.assertEqual((panel.list.currentRow(), len(self.said())), (1, 3), "the one that lies there")
        self.assertEqual(panel.message.text(), "a section lies in this plane already; move it, or add another one")
        self.close(panel)

    def test_letters_of_details_come_after(self):
        self.obj.Sections, self.obj.Details = ['{"plane": "y", "view": true}'], ["Pump.Bolt"]
        self.redraw()
        self.assertIn("B (1:1)", self.texts())
        panel = self.open("Burin_Detail")
        self.assertEqual(panel.table.item(0, 1).text(), "B")
        panel.reject()
        self.wait()

    def test_wrong_selections_are_told_in_one_line(self):
        self.run_on("Burin_SectionView", self.obj, self.sub("Bolt", "Face1"))
        self.assertEqual((self.told, list(self.obj.Sections), Gui.Control.activeDialog(), self.document.UndoCount),
                         (["a section needs a flat face or a datum plane; this one is curved"], [], False, self.undos))


class CentreLines(Annotations):
    def lines(self):
        with open(self.obj.Drawing, encoding="utf-8") as file:
            return sum(len(layer["paths"]) for layer in json.load(file)["layers"] if layer["name"] == "centre")

    def test_on_and_off_are_a_step_of_undo_each(self):
        from freecad.burin_wb.features import place_on_page

        view = place_on_page(self.document.addObject("TechDraw::DrawPage", "Page"), self.obj)
        self.document.recompute()
        undos = self.document.UndoCount
        self.run_on("Burin_CentreLines", view)
        self.assertTrue(self.obj.CentreLines)
        self.assertGreater(self.lines(), 3)
        self.assertEqual(self.document.UndoCount, undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual((self.obj.CentreLines, self.lines()), (False, 0))
        self.document.redo()
        support.drawn()
        self.run_on("Burin_CentreLines", self.obj)
        self.assertEqual((self.obj.CentreLines, self.lines()), (False, 0))
        self.obj.StyleKeys = {"feature.centre_lines": "true", "line.outer": "0.5"}
        self.run_on("Burin_CentreLines", self.obj)
        self.assertEqual((self.obj.CentreLines, dict(self.obj.StyleKeys), self.lines()), (False, {"line.outer": "0.5"}, 0))


support.run(__name__)
