"""The panels of assemblies: parts numbered, cut open, taken apart; the 3-D view and the document beside them."""

import json
import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "headless"))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from pivy import coin  # noqa: E402
from pump import pump  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402


SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"


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

    def texts(self):
        """What is written in the 3-D view."""
        search = coin.SoSearchAction()
        search.setType(coin.SoAsciiText.getClassTypeId())
        search.setInterest(coin.SoSearchAction.ALL)
        search.apply(self.obj.ViewObject.Proxy._ink)
        return [path.getTail().string.getValues(0)[0] for path in search.getPaths()]

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
        self.assertEqual(self.texts()[:3], ["1", "2", "3"])
        self.assertIn("Bolt", self.texts())
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
            support.settle()
            self.assertEqual(panel.message.text(), "an item has a number from 1 to 99999")
            self.assertEqual(panel.table.item(0, 1).text(), "1")
        panel.table.item(0, 1).setText("12")
        support.settle()
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


class Section(Case):
    def planes(self):
        return [json.loads(text) for text in self.obj.Sections]

    def is_cut(self):
        return 'id="section"' in open(self.obj.Picture).read()

    def scene(self):
        return Gui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren()

    def test_a_plane_is_moved_flipped_and_taken_back(self):
        nodes = self.scene()
        panel = self.open("Burin_Section")
        self.is_narrow_and_told(panel)
        self.wait()
        self.assertEqual(self.planes(), [{"plane": {"normal": [1, 0, 0], "offset": 30}}], "across the view, in the middle")
        self.assertTrue(self.is_cut())
        self.assertEqual((self.scene(), panel._plane.is_shown()), (nodes + 1, True))
        panel.axis.setCurrentIndex(panel.axis.findData("y"))
        self.assertEqual(self.planes(), [{"plane": {"normal": [0, -1, 0], "offset": -20}}])
        self.assertEqual((panel.list.item(0).text(), panel.slider.value()), ("-y at 20 mm", 500))
        panel.slider.setValue(250)
        self.assertEqual(self.planes()[0]["plane"], {"normal": [0, -1, 0], "offset": -10})
        panel.offset.setProperty("rawValue", 12.5)
        self.assertEqual(self.planes()[0]["plane"]["offset"], -12.5)
        panel.form.findChild(QtGui.QPushButton, "flip").click()
        self.assertEqual(self.planes()[0]["plane"], {"normal": [0, 1, 0], "offset": 12.5})
        panel.form.findChild(QtGui.QPushButton, "flip").click()
        self.wait()
        support.screenshot("section-panel")
        self.assertEqual(panel.message.text(), "drawn")
        self.close(panel)
        self.assertEqual(self.scene(), nodes)
        self.assertEqual(self.document.UndoCount, self.undos + 1)
        self.document.undo()
        support.drawn()
        self.assertEqual((self.obj.Sections, self.is_cut()), ([], False))

    def test_through_a_face_and_a_datum_plane(self):
        self.select((self.pump, "Lid.Face6"))  # z = 16
        panel = self.open("Burin_Section", (self.pump, "Lid.Face6"))
        panel.form.findChild(QtGui.QPushButton, "delete").click()
        self.assertEqual(self.planes(), [])
        panel.form.findChild(QtGui.QPushButton, "face").click()
        self.assertEqual(len(self.planes()), 1)
        normal, offset = self.planes()[0]["plane"]["normal"], self.planes()[0]["plane"]["offset"]
        face = self.document.Lid.Shape.Face6
        self.assertAlmostEqual(offset, FreeCAD.Vector(*normal).dot(face.CenterOfMass), 6)
        self.assertGreater(FreeCAD.Vector(*normal).dot(face.normalAt(0, 0)), 0.999)
        Gui.Selection.clearSelection()
        panel.form.findChild(QtGui.QPushButton, "face").click()
        self.assertEqual(panel.message.text(), "select a flat face or a datum plane")
        self.select((self.pump, "Bolt.Face1"))
        panel.form.findChild(QtGui.QPushButton, "face").click()
        self.assertIn("curved", panel.message.text())
        self.assertEqual(len(self.planes()), 1)
        panel.reject()
        self.wait()
        self.assertEqual(self.obj.Sections, [])

    def test_through_datum_planes(self):
        datum = self.document.addObject("PartDesign::Plane", "Datum")
        datum.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7), FreeCAD.Rotation())
        self.document.recompute()
        self.assertEqual(tuple(self.pump.Origin.OriginFeatures[5].Placement.Base), (0, 0, 0))
        panel = self.open("Burin_Section")
        for chosen, offset in ((datum, 7), (next(o for o in self.pump.Origin.OriginFeatures if "XY" in o.Name), 0)):
            self.select(chosen)
            panel.form.findChild(QtGui.QPushButton, "face").click()
            plane = self.planes()[-1]["plane"]
            self.assertAlmostEqual(plane["normal"][2], 1)
            self.assertAlmostEqual(plane["offset"], offset)
        panel.reject()
        self.wait()

    def test_what_stays_whole_and_what_it_does_not_know(self):
        self.obj.Sections = ["y", '{"kind": "quarter"}']
        panel = self.open("Burin_Section")
        self.assertEqual([panel.list.item(k).text() for k in range(2)], ["-y at 20 mm", '{"kind": "quarter"}'])
        panel.list.setCurrentRow(1)
        self.assertFalse(panel.offset.isEnabled())
        panel.form.findChild(QtGui.QPushButton, "delete").click()
        self.assertEqual(self.obj.Sections, ["y"])
        panel.form.findChild(QtGui.QPushButton, "exclude").click()
        self.assertIn("select objects", panel.message.text())
        self.select((self.pump, "Bolt."), (self.pump, "Bolt001.Face2"))
        panel.form.findChild(QtGui.QPushButton, "exclude").click()
        self.assertEqual(self.planes(), [{"plane": "y", "exclude": ["Pump.Bolt", "Pump.Bolt001"]}])
        panel.slider.setValue(600)
        self.assertEqual(self.planes(), [{"plane": {"normal": [0, -1, 0], "offset": -24}, "exclude": ["Pump.Bolt", "Pump.Bolt001"]}])
        self.wait()
        self.assertEqual(self.obj.Message, "")
        panel.form.findChild(QtGui.QPushButton, "include").click()
        self.assertNotIn("exclude", self.planes()[0])
        panel.slider.setValue(0)
        panel.form.findChild(QtGui.QPushButton, "flip").click()
        self.wait()
        self.assertRegex(panel.message.text(), "takes all of it away")
        self.close(panel)


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

        imported = FreeCAD.newDocument("Imported")
        ImportGui.insert(str(SAMPLES / "gear_pump.step"), imported.Name, merge=False)
        top = next(o for o in imported.Objects if o.Label == "gear pump")
        shown = {path: top.ViewObject.getBoundingBox(path).Center for path in ("Solid002.", "LinkGroup.Solid003.", "Link002.0.", "Link002.3.")}
        self.document = imported
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(imported.Name, top.Name)
        Gui.runCommand("Burin_NewIllustration")
        support.panel().change("Style", "outline")
        self.wait()
        obj = support.panel().obj
        support.panel().accept()
        support.settle()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(imported.Name, obj.Name)
        Gui.runCommand("Burin_Explode")
        self.wait()
        panel = support.panel()
        from freecad.burin_wb.features.explosion import moves_of

        self.assertGreater(len(panel.steps), 8)
        moves = dict(zip(panel.extent.sources, moves_of(panel.steps, panel.extent.sources, 1.0)))
        for path, before in shown.items():
            now = top.ViewObject.getBoundingBox(path).Center
            self.assertLess((now - before - moves[f"{top.Name}.{path[:-1]}"]).Length, 0.01, path)
        self.assertGreater(moves[f"{top.Name}.Link002.0"].Length, 100)
        support.screenshot("explode-step")
        panel.reject()
        self.wait()
        for path, before in shown.items():
            self.assertLess((top.ViewObject.getBoundingBox(path).Center - before).Length, 1e-6, path)
        self.document = FreeCAD.getDocument("Test")

    def test_an_arrow_changes_the_distance(self):
        panel = self.begin()
        self.assertEqual(len(panel.arrows.arrows), 2)
        arrow, by = panel.arrows.arrows[1], self.steps()[1]["by"]
        self.assertAlmostEqual(arrow.distance(), by, 3)
        arrow.dragger.translation = (arrow.dragger.translation.getValue()[0] * 3, 0, 0)
        support.settle(100)
        self.assertAlmostEqual(self.steps()[1]["by"], 3 * by, 3)
        self.assertAlmostEqual(panel.displaced.moves()["Pump.Lid"].z, 3 * by, 3)
        self.assertEqual(self.rows(panel)[1][2], f"{3 * by:.4g}")
        arrow.dragger.translation = (-5, 0, 0)
        support.settle(100)
        self.assertEqual(self.steps()[1]["by"], 0.01, "a step moves its parts")
        self.close(panel)
        self.assertEqual(self.document.UndoCount, self.undos + 1)

    def test_an_arrow_is_dragged_by_the_mouse(self):
        panel = self.begin()
        view = Gui.ActiveDocument.ActiveView
        view.viewFront()
        view.fitAll()
        support.settle(300)
        arrow, by = panel.arrows.arrows[1], self.steps()[1]["by"]
        foot, way, _ = panel._place(1, 1.0)
        glass = self.glass()
        tip, there = (self.pixel(view, glass, foot + way * mm) for mm in (by, by + 15))
        mouse = QtCore.QPointF
        for kind, at, button in ((QtCore.QEvent.MouseMove, tip, QtCore.Qt.NoButton), (QtCore.QEvent.MouseButtonPress, tip, QtCore.Qt.LeftButton),
                                 *((QtCore.QEvent.MouseMove, (tip[0], tip[1] + (there[1] - tip[1]) * k / 5), QtCore.Qt.NoButton) for k in range(1, 6)),
                                 (QtCore.QEvent.MouseButtonRelease, there, QtCore.Qt.LeftButton)):
            held = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseButtonRelease or at == tip and button == QtCore.Qt.NoButton else QtCore.Qt.LeftButton
            QtGui.QApplication.sendEvent(glass, QtGui.QMouseEvent(kind, mouse(*at), mouse(glass.mapToGlobal(mouse(*at).toPoint())), button, held,
                                                                  QtCore.Qt.NoModifier))
            support.settle(80)
        self.assertAlmostEqual(self.steps()[1]["by"], by + 15, delta=1.5)
        self.assertAlmostEqual(arrow.distance(), self.steps()[1]["by"], 2)
        panel.reject()
        self.wait()

    @staticmethod
    def glass():
        """What the 3-D view is painted on."""
        inside = [w for window in Gui.getMainWindow().findChildren(QtGui.QMdiSubWindow) if window.isVisible() for w in window.findChildren(QtGui.QWidget)]
        return next(w for w in inside if w.metaObject().className() == "SIM::Coin3D::Quarter::QuarterWidget").viewport()

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
        from freecad.burin_wb.view import scheduler

        for x in range(40):  # long enough to be stopped
            box = self.document.addObject("Part::Box", "Block")
            box.Placement.Base = FreeCAD.Vector(80 + 11 * x, 0, 0)
            self.pump.addObject(box)
        self.document.recompute()
        support.drawn()
        undos = self.document.UndoCount
        self.select(self.obj)
        Gui.runCommand("Burin_Explode")
        panel = support.panel()
        support.settle(20)
        self.assertTrue(panel.stop.isEnabled())
        panel.stop.click()
        self.assertTrue(support.until(lambda: not scheduler.scheduler.busy(self.obj), 5))
        support.settle()
        self.assertEqual((panel.said.text(), self.steps(), panel.wanted.isChecked()), ("cancelled", [], False))
        self.assertTrue(panel.find_button.isEnabled())
        panel.reject()
        self.wait()
        self.assertEqual((self.obj.Explode, self.document.UndoCount), (False, undos))

    def test_closing_the_document_and_undo_end_the_panel(self):
        before = self.scene()
        panel = self.begin()
        self.document.undo()
        support.settle(100)
        self.assertTrue(panel.over)
        self.assertEqual(self.scene(), before)
        panel = self.begin()
        FreeCAD.closeDocument(self.document.Name)
        support.settle(100)
        self.assertTrue(panel.over)
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
