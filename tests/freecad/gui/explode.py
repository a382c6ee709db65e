"""The panel that takes an assembly apart; the document stays as it is."""

import json
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from assembly_case import Case  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402

SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"


class Explode(Case):
    def rows(self, panel):
        return [tuple(panel.table.item(r, c).text() for c in range(3)) for r in range(panel.table.rowCount())]

    def steps(self):
        return [json.loads(text) for text in self.obj.ExplodeSteps]

    def begin(self):
        panel = self.open("Burin_Explode")
        self.wait()
        return panel

    def scene(self):
        """What the 3-D view has of its own, and of each object."""
        graph = Gui.ActiveDocument.ActiveView.getSceneGraph()
        return [graph.getNumChildren(), *(o.ViewObject.RootNode.getNumChildren() for o in self.pump.Group)]

    def is_apart(self):
        return 'id="trail"' in open(self.obj.Picture).read()

    def test_steps_are_found_shown_and_one_undo(self):
        before, places = self.scene(), [o.Placement.Base for o in self.document.Objects if hasattr(o, "Placement")]
        panel = self.begin()
        self.is_narrow_and_told(panel)
        self.assertEqual([row[:2] for row in self.rows(panel)], [("Bolt, Bolt001", "+z"), ("Lid", "+z")])
        self.assertTrue(self.is_apart())
        bolts, lid = (step["by"] for step in self.steps())
        shown = panel.displaced.moves()
        self.assertEqual(sorted(shown), ["Pump.Bolt", "Pump.Bolt001", "Pump.Lid"])
        self.assertAlmostEqual(shown["Pump.Bolt"].z, bolts, 3)
        self.assertAlmostEqual(shown["Pump.Lid"].z, lid, 3)
        self.assertEqual([o.Placement.Base for o in self.document.Objects if hasattr(o, "Placement")], places)
        support.screenshot("explode-panel")
        self.close(panel)
        self.assertEqual(self.scene(), before, "the 3-D view is as it was")
        self.assertEqual(self.document.UndoCount, self.undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual((self.obj.Explode, self.obj.ExplodeSteps, self.is_apart()), (False, [], False))
        self.document.redo()
        support.drawn()
        self.assertTrue(self.is_apart())

    def test_of_hidden_parts_the_panel_opens_and_says_so(self):
        for member in self.pump.Group:
            member.Visibility = False
        self.document.recompute()
        panel = self.begin()
        self.assertEqual(panel.displaced.moves(), {})
        self.assertIn("no visible shape", self.obj.Message)
        panel.reject()
        self.wait()

    def test_a_turned_assembly_is_shown_along_the_ways_of_the_model(self):
        self.pump.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
        self.document.recompute()
        support.drawn()
        panel = self.begin()
        self.assertEqual([row[1] for row in self.rows(panel)], ["-y", "-y"])
        moves = panel.displaced.moves()
        self.assertAlmostEqual(moves["Pump.Lid"].z, self.steps()[1]["by"], 3)  # in the axes of the assembly
        panel.reject()
        self.wait()

    def test_what_links_and_arrays_show_moves_too(self):
        import ImportGui

        from freecad.burin_wb.features import visible
        from freecad.burin_wb.features.explosion import moves_of

        imported = FreeCAD.newDocument("Imported")
        ImportGui.insert(str(SAMPLES / "gear_pump.step"), imported.Name, merge=False, useLinkGroup=True)
        top = next(o for o in imported.Objects if o.Label == "gear pump")
        self.assertEqual(visible(imported), [top], "what it holds is not drawn twice")
        paths = {label: path for path, label in support.leaves(top) if label in ("cover", "drive shaft")}
        screws = [path for path, label in support.leaves(top) if label.startswith("screw M")]
        self.assertEqual((sorted(paths), len(screws)), (["cover", "drive shaft"], 6))
        inside = {path: path.partition(".")[2] + "." for path in (*paths.values(), screws[0], screws[3])}
        shown = {path: top.ViewObject.getBoundingBox(sub).Center for path, sub in inside.items()}
        self.document = imported
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(imported.Name, top.Name)
        Gui.runCommand("Burin_NewIllustration")
        support.panel().change("Style", "outline")
        self.wait()
        obj = support.panel().obj
        support.panel().accept()
        self.wait()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(imported.Name, obj.Name)
        Gui.runCommand("Burin_Explode")
        self.wait()
        panel = support.panel()
        self.assertGreater(len(panel.steps), 8)
        moves = dict(zip(panel.extent.sources, moves_of(panel.steps, panel.extent.sources, 1.0)))
        for path, before in shown.items():
            now = top.ViewObject.getBoundingBox(inside[path]).Center
            self.assertLess((now - before - moves[path]).Length, 0.01, path)
        self.assertGreater(moves[screws[0]].Length, 100)
        support.screenshot("explode-step")
        self.slide_and_drag(panel)
        self.assertEqual(obj.ExplodeFactor, 0.45)
        panel.reject()
        self.wait()
        for path, before in shown.items():
            self.assertLess((top.ViewObject.getBoundingBox(inside[path]).Center - before).Length, 1e-6, path)
        self.document = FreeCAD.getDocument("Test")

    def slide_and_drag(self, panel):
        """The slider and an arrow move the objects at once, however long a drawing takes, and no shape is written for it."""
        from freecad.burin_wb.features.shapes import shapes

        written = shapes.written
        path, whole = max(((path, move.Length) for path, move in panel.displaced.moves().items()), key=lambda one: one[1])
        with support.held():
            for k in range(100, 40, -5):
                panel.slider.setValue(k)
                self.assertAlmostEqual(panel.displaced.moves()[path].Length, k / 100 * whole, 2)
                support.settle(30)
            self.assertTrue(support.at_work())
            for _ in range(5):
                dragger, by = panel.arrows.arrows[0].dragger, panel.steps[0].by
                dragger.translation = (1.05 * dragger.translation.getValue()[0], 0, 0)
                self.assertTrue(support.until(lambda: abs(panel.steps[0].by - 1.05 * by) < 1e-3 * by))
            self.assertTrue(panel.runs.running(panel.obj), "it waits for the drawing")
        self.assertEqual(shapes.written, written)

    def test_meshes_bodies_and_arrays_move_and_go_back(self):
        import Mesh

        from freecad.burin_wb.view.displaced import Displaced

        part, mesh, body = (self.document.addObject(kind, "Moved") for kind in ("App::Part", "Mesh::Feature", "PartDesign::Body"))
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        body.newObject("PartDesign::AdditiveBox", "Inside")
        array = self.document.addObject("App::Link", "Array")
        array.LinkedObject, array.ShowElement, array.ElementCount = self.document.Plate, False, 2
        part.addObjects([mesh, body, array])
        part.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        self.document.recompute()
        support.drawn()

        inside = [mesh.Name, body.Name, array.Name + ".0", array.Name + ".1"]

        def centers():
            return [part.ViewObject.getBoundingBox(name + ".").Center for name in inside]

        before, moves = centers(), [FreeCAD.Vector(1, 2, 9), FreeCAD.Vector(0, 5, 0), FreeCAD.Vector(), FreeCAD.Vector(3, 4, 0)]
        displaced = Displaced(self.document)
        displaced.show([f"{part.Name}.{name}" for name in inside], moves)
        for name, now, was, move in zip(inside, centers(), before, moves):
            self.assertLess((now - was - move).Length, 1e-4, name)
        displaced.restore()
        for name, now, was in zip(inside, centers(), before):
            self.assertLess((now - was).Length, 1e-6, name)

    def test_an_arrow_changes_the_distance(self):
        panel = self.begin()
        self.assertEqual(len(panel.arrows.arrows), 2)
        arrow, by = panel.arrows.arrows[1], self.steps()[1]["by"]
        self.assertAlmostEqual(arrow.distance(), by, 3)
        arrow.dragger.translation = (arrow.dragger.translation.getValue()[0] * 3, 0, 0)
        self.assertTrue(support.until(lambda: self.steps()[1]["by"] != by))
        self.assertAlmostEqual(self.steps()[1]["by"], 3 * by, 3)
        self.assertAlmostEqual(panel.displaced.moves()["Pump.Lid"].z, 3 * by, 3)
        self.assertEqual(self.rows(panel)[1][2], f"{3 * by:.4g}")
        by = self.steps()[1]["by"]
        arrow.dragger.translation = (-5, 0, 0)
        self.assertTrue(support.until(lambda: self.steps()[1]["by"] != by))
        self.assertEqual(self.steps()[1]["by"], 0.01, "a step moves its parts")
        self.close(panel)
        self.assertEqual(self.document.UndoCount, self.undos + 1)

    def test_an_arrow_is_dragged_by_the_mouse(self):
        panel = self.begin()
        view = Gui.ActiveDocument.ActiveView
        view.viewFront()
        view.fitAll()
        glass = support.glass()
        arrow, by = panel.arrows.arrows[1], self.steps()[1]["by"]
        foot, way, _ = panel._place(1, 1.0)
        tip, there = (self.pixel(view, glass, foot + way * mm) for mm in (by, by + 15))
        mouse = QtCore.QPointF
        for kind, at, button in ((QtCore.QEvent.MouseMove, tip, QtCore.Qt.NoButton), (QtCore.QEvent.MouseButtonPress, tip, QtCore.Qt.LeftButton),
                                 *((QtCore.QEvent.MouseMove, (tip[0], tip[1] + (there[1] - tip[1]) * k / 5), QtCore.Qt.NoButton) for k in range(1, 6)),
                                 (QtCore.QEvent.MouseButtonRelease, there, QtCore.Qt.LeftButton)):
            held = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease or at == tip and button == QtCore.Qt.NoButton else QtCore.Qt.LeftButton
            QtGui.QApplication.sendEvent(glass, QtGui.QMouseEvent(kind, mouse(*at), mouse(glass.mapToGlobal(mouse(*at).toPoint())), button, held,
                                                                  QtCore.Qt.NoModifier))
            support.settle(80)
        self.assertTrue(support.until(lambda: abs(arrow.distance() - self.steps()[1]["by"]) < 0.01 and arrow.moved() is None))
        self.assertAlmostEqual(self.steps()[1]["by"], by + 15, delta=1.5)
        panel.reject()
        self.wait()

    @staticmethod
    def pixel(view, glass, point):
        (x, y), (width, height) = view.getPointOnScreen(point), view.getSize()
        return x * glass.width() / width, (height - y) * glass.height() / height

    def test_steps_are_edited(self):
        panel = self.begin()
        panel.table.item(0, 2).setText("60 mm")
        support.settle()
        panel.table.item(0, 1).setText("x")
        support.settle()
        self.assertEqual((self.steps()[0]["by"], self.steps()[0]["along"]), (60, [1, 0, 0]))
        self.assertEqual(self.rows(panel)[0][1:], ("+x", "60"))
        for column, text, words in ((1, "up", "a way is"), (2, "-3", "more than 0 mm"), (2, "far", "more than 0 mm")):
            panel.table.item(0, column).setText(text)
            self.assertIn(words, panel.message.text())
            support.settle()
        self.assertEqual(self.rows(panel)[0][1:], ("+x", "60"))
        panel.table.item(1, 3).setCheckState(QtCore.Qt.Unchecked)
        support.settle()
        self.assertFalse(self.steps()[1]["trail"])
        panel.table.selectRow(1)
        panel.form.findChild(QtGui.QPushButton, "up").click()
        self.assertEqual([step["move"] for step in self.steps()], [["Pump.Lid"], ["Pump.Bolt", "Pump.Bolt001"]])
        self.select((self.pump, "Plate.Face1"))
        support.settle()
        panel.form.findChild(QtGui.QPushButton, "add").click()
        self.assertEqual(self.steps()[2]["move"], ["Pump.Plate"])
        panel.table.selectAll()
        panel.form.findChild(QtGui.QPushButton, "join").click()
        self.assertEqual([step["move"] for step in self.steps()], [["Pump.Lid", "Pump.Bolt", "Pump.Bolt001", "Pump.Plate"]])
        panel.table.selectRow(0)
        support.settle()
        self.assertEqual(self.chosen(), ["Pump.Bolt.", "Pump.Bolt001.", "Pump.Lid.", "Pump.Plate."])
        panel.form.findChild(QtGui.QPushButton, "delete").click()
        self.assertEqual((self.steps(), panel.wanted.isChecked()), ([], False))
        panel.reject()
        self.wait()

    def test_the_slider_is_the_factor(self):
        panel = self.begin()
        by = self.steps()[1]["by"]
        panel.slider.setValue(50)
        self.wait()
        self.assertEqual(self.obj.ExplodeFactor, 0.5)
        self.assertAlmostEqual(panel.displaced.moves()["Pump.Lid"].z, by / 2, 3)
        self.assertAlmostEqual(panel.arrows.arrows[1].distance(), by / 2, 3)
        panel.shown.setChecked(False)
        self.assertEqual((panel.displaced.moves(), panel.arrows.arrows), ({}, []))
        self.close(panel)
        self.assertEqual(self.obj.ExplodeFactor, 0.5)

    def test_finding_is_stopped(self):
        undos = self.document.UndoCount
        self.select(self.obj)
        with support.held():
            Gui.runCommand("Burin_Explode")
            panel = support.panel()
            self.assertTrue(support.until(panel.stop.isEnabled))
            self.assertTrue(support.at_work())
            panel.stop.click()
            self.assertFalse(panel.stop.isEnabled())
        self.wait()
        self.assertEqual((panel.said.text(), self.steps(), panel.wanted.isChecked()), ("cancelled", [], False))
        panel.find_button.click()
        self.wait()
        self.assertEqual(len(self.steps()), 2, "and begun again")
        panel.reject()
        self.wait()
        self.assertEqual((self.obj.Explode, self.document.UndoCount), (False, undos))

    def test_closing_the_document_and_undo_end_the_panel(self):
        before = self.scene()
        panel = self.begin()
        self.document.undo()
        self.assertTrue(support.until(lambda: panel.over and Gui.Control.activeDialog() is False))
        self.assertEqual(self.scene(), before)
        self.wait()
        panel = self.begin()
        FreeCAD.closeDocument(self.document.Name)
        self.assertTrue(support.until(lambda: panel.over and Gui.Control.activeDialog() is False))
        self.document = FreeCAD.newDocument("Test")

    def test_exploded_views_of_the_assembly_workbench_are_taken_over(self):
        from assembly_stand_in import exploded_view

        exploded_view(self.document, self.pump)
        panel = self.begin()
        panel.form.findChild(QtGui.QPushButton, "take-over").click()
        self.assertEqual([(step["move"], step["along"], step["by"]) for step in self.steps()],
                         [(["Pump.Bolt", "Pump.Bolt001"], [0, 0, 1], 50), (["Pump.Lid"], [0, 1, 0], 30)])
        self.assertRegex(panel.said.text(), "^Turned: turns parts.*; Round: moves parts away from a middle.*left out$")
        panel.reject()
        self.wait()


support.run(__name__)
