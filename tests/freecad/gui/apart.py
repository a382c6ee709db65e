"""The panels of assemblies: parts numbered, and cut open; the 3-D view and the document beside them."""

import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from assembly_case import Case  # noqa: E402
from pivy import coin  # noqa: E402
from PySide import QtGui  # noqa: E402


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

    def test_numbers_go_clockwise_around_the_drawing(self):
        from freecad.burin_wb.features.items import places_of
        from freecad.burin_wb.features.sheet import Sheet

        panel = self.open("Burin_NumberParts")
        panel.form.findChild(QtGui.QPushButton, "clockwise").click()
        self.assertEqual(panel.message.text(), "the drawing has no numbers yet")
        panel.callouts.setChecked(True)
        self.wait()
        panel.form.findChild(QtGui.QPushButton, "clockwise").click()
        self.wait()
        places = places_of(Sheet(self.obj.Drawing))
        self.assertEqual(sorted(places), [1, 2, 3])
        x, y = (sum(at[k] for at in places.values()) / 3 for k in (0, 1))
        turns = [math.atan2(places[n][0] - x, places[n][1] - y) % (2 * math.pi) for n in (1, 2, 3)]
        self.assertEqual(turns, sorted(turns))
        self.assertEqual(dict(self.obj.ItemNumbers), {row[1]: row[0] for row in self.rows(panel)})
        panel.reject()
        self.wait()

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
        self.assertEqual(self.planes()[0]["exclude"], [], "what drawings leave whole by custom is cut too")
        panel.slider.setValue(0)
        panel.form.findChild(QtGui.QPushButton, "flip").click()
        self.wait()
        self.assertRegex(panel.message.text(), "takes all of it away")
        self.close(panel)


support.run(__name__)
