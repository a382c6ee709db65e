"""Sections, exploded views, numbers and lists as properties: what a macro sets is what the kernel is asked for."""

import json
import os

import Import
import Mesh
from assembly_stand_in import exploded_view
from pump import pump
from support import V, App, Case, burin, content, drawn

from freecad.burin_wb import illustration_file
from freecad.burin_wb.errors import Refused
from freecad.burin_wb import item_numbers
from freecad.burin_wb.features import asking, assembly_view, explosion, items, place_on_page, section, spreadsheet, visible
from freecad.burin_wb.features.chosen import numbers_of
from freecad.burin_wb.features.extent import Extent
from freecad.burin_wb.features.free_place import extent
from freecad.burin_wb.features.illustration import make_illustration, make_job
from freecad.burin_wb.features.sheet import Sheet
from freecad.burin_wb.preferences import PIXELS_PER_MM


class Apart(Case):
    def stack(self):
        return pump(self.doc)

    def kinds(self, obj):
        return {path["kind"] for _, path in Sheet(obj.Drawing).paths()}

    def test_nothing_is_asked_for_where_nothing_is_said(self):
        obj = self.illustration(self.stack(), Style="outline")
        self.assertTrue({"illustration", "callouts", "parts_list"}.isdisjoint(make_job(obj).options))
        self.assertEqual(obj.getTypeIdOfProperty("Sections"), "App::PropertyStringList")

    def test_a_section_cuts_all_but_what_it_excludes(self):
        obj = self.illustration(self.stack(), Style="outline", Sections=["y"])
        self.assertIn("section", self.kinds(obj))
        self.assertEqual(make_job(obj).options["illustration"], {"section": ["y"]})
        self.assertEqual(obj.Message, "2 parts stay whole, as drawings do not cut along them (bolt); Cut in the panel Section cuts them too")
        obj.Sections = ['{"plane": "y", "exclude": []}']
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        cut = {path["part"] for _, path in Sheet(obj.Drawing).paths() if path["kind"] == "section"}
        self.assertEqual(cut, {0, 1, 2, 3})
        whole = section.plane(V(0, -1, 0), -20, ["Pump.Bolt", "Bolt001"])
        obj.Sections = [section.text_of(whole)]
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        self.assertEqual(make_job(obj).options["illustration"]["section"][0]["exclude"], ["@index=2", "@index=3"])
        self.assertEqual({path["part"] for _, path in Sheet(obj.Drawing).paths() if path["kind"] == "section"}, {0, 1})

    def test_several_sections_and_what_is_not_known_yet_pass_through(self):
        obj = self.illustration(self.stack(), Style="outline", Sections=['{"plane": "y", "exclude": []}', '{"plane": "-x=30", "exclude": []}'])
        self.assertEqual(obj.Message, "")
        obj.Sections = ['{"kind": "quarter", "planes": ["x", "y"], "exclude": "Pump.Lid"}']
        said = make_job(obj).options["illustration"]["section"][0]
        self.assertEqual(said, {"kind": "quarter", "planes": ["x", "y"], "exclude": ["@index=1"]})

    def test_broken_sections_are_told_once(self):
        obj = self.illustration(self.stack(), Style="outline", Sections=["+y=900"])
        self.assertRegex(obj.Message, "^the section at 900 mm, of a model from 0 to 40 mm, cuts nothing$")
        before = content(obj.Drawing)
        for text, words in (("w", '^"section" takes.*; the drawing before is kept$'),
                            ('{"plane": ', "^section 1 of the property Sections is no JSON"),
                            ("-y=900", "^the section at 900 mm.*takes all of it away; the drawing")):
            obj.Sections = [text]
            self.doc.recompute()
            self.assertRegex(obj.Message, words)
            self.assertEqual(content(obj.Drawing), before)
        obj.Sections = [section.text_of(section.plane(V(0, -1, 0), -20, ["Gone"]))]
        self.doc.recompute()
        self.assertRegex(obj.Message, "^section 1 leaves Gone whole, which is not drawn here; choose again")

    def test_an_exploded_view_is_found_and_kept_as_steps(self):
        pump_ = self.stack()
        obj = self.illustration(pump_, Style="outline", Explode=True)
        self.assertIn("trail", self.kinds(obj))
        steps, said = asking.find_steps(obj)
        self.assertEqual(said, [])
        self.assertEqual([step.move for step in steps], [["Pump.Bolt", "Pump.Bolt001"], ["Pump.Lid"]])
        self.assertTrue(all(step.along == (0, 0, 1) and step.by > 4 for step in steps), steps)
        found = content(obj.Picture)
        explosion.set_steps(obj, steps)
        self.doc.recompute()
        self.assertEqual(len(self.trails(content(obj.Picture))), len(self.trails(found)))
        steps[0].by, steps[0].trail = 77.0, False
        explosion.set_steps(obj, steps)
        self.doc.recompute()
        self.assertEqual(explosion.steps_of(obj)[0].by, 77.0)
        moves = explosion.moves_of(steps, [part.source for part in make_job(obj).parts], 0.5)
        self.assertEqual([round(move.z, 3) for move in moves], [0, round(steps[1].by / 2, 3), 38.5, 38.5])
        self.assertEqual({o.Placement.Base.z for o in pump_.Group}, {0.0}, "the model stays as it is")

    @staticmethod
    def trails(svg):
        return [line for line in svg.split(b"\n") if b"trail" in line]

    def test_steps_along_one_axis_and_together_again(self):
        obj = self.illustration(self.stack(), Style="outline", Explode=True, ExplodeAlong="+z")
        steps, _ = asking.find_steps(obj)
        self.assertEqual({step.along for step in steps}, {(0, 0, 1)})
        obj.ExplodeAlong = "x"
        steps, said = asking.find_steps(obj)
        self.assertEqual(steps, [])
        self.assertRegex(said[0], "Bolt")
        obj.ExplodeAlong = "sideways"
        with self.assertRaisesRegex(Refused, '^Illustration: "along" takes auto, none, an axis'):
            asking.find_steps(obj)
        obj.ExplodeAlong = ""
        obj.ExplodeFactor = 0
        self.doc.recompute()
        apart = Sheet(obj.Drawing).scale
        obj.Explode = False
        self.doc.recompute()
        self.assertAlmostEqual(Sheet(obj.Drawing).scale, apart, 6)

    def test_broken_steps_are_told_once(self):
        pump_ = self.stack()
        obj = self.illustration(pump_, Style="outline", Explode=True)
        explosion.set_steps(obj, asking.find_steps(obj)[0])
        self.doc.removeObject("Lid")
        self.doc.recompute()
        self.assertEqual(obj.Message.count("Lid"), 1)
        self.assertRegex(obj.Message, "step 2 of the exploded view moves Pump.Lid, which is not drawn here; delete the step")
        self.assertIn("trail", self.kinds(obj), "the others are carried out")
        for text in ("{", "[]", '{"move": [], "along": [0, 0, 1], "by": 3}', '{"move": ["Lid"], "along": [0, 0, 0], "by": 3}'):
            obj.ExplodeSteps = [text]
            self.doc.recompute()
            self.assertRegex(obj.Message, "^step 1 of the property ExplodeSteps is none", text)
        obj.ExplodeSteps = [explosion.Step(["Gone"]).text()]
        self.doc.recompute()
        self.assertRegex(obj.Message, "moves Gone")
        self.assertNotIn("trail", self.kinds(obj))

    def test_numbers_are_kept_and_cost_no_run(self):
        pump_ = self.stack()
        obj = self.illustration(pump_, Style="outline", Callouts=True, PartsList=True)
        self.assertEqual(dict(obj.ItemNumbers), {"1": "Plate", "2": "Lid", "3": "Bolt"})
        before, inputs = content(obj.Drawing), obj.Inputs
        self.redraw(obj)
        self.assertEqual((content(obj.Drawing), obj.Inputs), (before, inputs), "the numbers that it gave are no change")
        self.assertEqual(inputs.partition(":")[2], make_job(obj).fingerprint())
        pump_.addObject(self.box(5, 5, 5, "Nose"))
        self.doc.removeObject("Lid")
        self.doc.recompute()
        self.assertEqual(dict(obj.ItemNumbers), {"1": "Plate", "2": "Lid", "3": "Bolt", "4": "Nose"})
        self.assertEqual([(i["number"], i["name"], i["quantity"]) for i in burin().Drawing.load(obj.Drawing).items],
                         [(1, "Plate", 1), (3, "Bolt", 2), (4, "Nose", 1)])
        obj.ItemNumbers = {"7": "Bolt"}
        self.doc.recompute()
        self.assertEqual(dict(obj.ItemNumbers), {"7": "Bolt", "8": "Plate", "9": "Nose"})

    def test_numbers_change_places_and_begin_anew(self):
        self.assertEqual(items.renumbered({"1": "a", "2": "b", "7": "gone"}, "1", "2"), {"2": "a", "1": "b", "7": "gone"})
        self.assertEqual(items.renumbered({"1": "a", "2": "b"}, "1", "9"), {"2": "b", "9": "a"})
        self.assertEqual(items.renumbered({"1": "a"}, "1", "1"), {"1": "a"})
        found = [{"number": 3, "name": "b", "parts": [4]}, {"number": 8, "name": "a", "parts": [0, 5]}]
        self.assertEqual(items.in_order(found), {"1": "a", "2": "b"})
        found.append({"number": 1, "name": "c", "parts": [6]})
        self.assertEqual(items.clockwise(found, {8: (-10, 0), 3: (10, 3)}), {"1": "b", "2": "a", "3": "c"})
        found.pop()
        self.assertEqual(item_numbers.kept({"5": "gone"}, found), {"5": "gone", "3": "b", "8": "a"})

    def test_the_list_as_a_spreadsheet(self):
        pump_ = self.stack()
        obj = self.illustration(pump_, Style="outline")
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        drawn_ = place_on_page(page, obj)
        listed = asking.items_of(obj)
        sheet = spreadsheet.write(obj, listed)
        view = spreadsheet.place_on_page(page, sheet, len(listed) + 1)
        self.assertEqual([sheet.getContents(f"B{row}").lstrip("'") for row in (2, 3, 4)], ["Plate", "Lid", "Bolt"])
        self.assertEqual([sheet.get(f"C{row}") for row in (2, 3, 4)], [1, 1, 2])
        width, height = extent(view)
        self.assertGreater(abs(view.Y.Value - drawn_.Y.Value), height / 2, "beside the drawing")
        self.assertAlmostEqual(width, 660 / PIXELS_PER_MM, 1)
        self.doc.removeObject("Lid")
        self.doc.recompute()
        self.assertIs(spreadsheet.write(obj, asking.items_of(obj)), sheet)
        self.assertEqual((sheet.getContents("B4"), view.CellEnd), ("", "E3"))
        self.assertIs(spreadsheet.place_on_page(page, sheet, 3), view)
        self.assertEqual(spreadsheet.pages_of(obj), [page])
        name = sheet.Name
        obj = self.reopen(obj)
        self.assertEqual(spreadsheet.sheet_of(obj).Name, name)
        self.assertEqual(spreadsheet.sheet_of(obj).get("B3"), "Bolt")

    def test_how_far_meshes_bodies_and_turned_assemblies_reach(self):
        part = self.doc.addObject("App::Part", "Part")
        mesh = self.doc.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        mesh.Placement.Base = V(100, 0, 0)
        body = self.doc.addObject("PartDesign::Body", "Body")
        inside = body.newObject("PartDesign::AdditiveBox", "Inside")
        inside.Length = inside.Width = inside.Height = 4
        part.addObjects([mesh, body])
        part.Placement = App.Placement(V(0, 0, 7), App.Rotation(V(0, 0, 1), 90))
        self.doc.recompute()
        extent_ = Extent(self.illustration(part, Style="outline"))
        self.assertEqual(extent_.sources, ["Part.Mesh", "Part.Body"])
        box = extent_.boxes["Part.Mesh"]
        for value, wanted in ((box.XMin, -10), (box.XMax, 10), (box.YMin, 95), (box.YMax, 105), (box.ZMin, -8), (box.ZMax, 22)):
            self.assertAlmostEqual(value, wanted, 5)
        low, high = extent_.along(V(0, 1, 0))
        self.assertAlmostEqual(low, 0, 5)
        self.assertAlmostEqual(high, 105, 5)
        self.assertAlmostEqual(extent_.whole({"Part.Body"}).XMin, -4, 5)
        self.assertFalse(extent_.whole(set()).isValid())

    def test_everything_survives_save_and_restore_without_a_run(self):
        obj = self.illustration(self.stack(), Style="outline", Explode=True, ExplodeFactor=0.8, Sections=["y"], Callouts=True)
        explosion.set_steps(obj, asking.find_steps(obj)[0])
        self.doc.recompute()
        kept = [obj.Sections, obj.ExplodeSteps, obj.ExplodeFactor, dict(obj.ItemNumbers), obj.Callouts, obj.Explode]
        before = content(obj.Drawing)
        obj = self.reopen(obj)
        self.redraw(obj)
        self.assertEqual([obj.Sections, obj.ExplodeSteps, obj.ExplodeFactor, dict(obj.ItemNumbers), obj.Callouts, obj.Explode], kept)
        self.assertEqual(content(obj.Drawing), before)

    def test_illustration_files_carry_it_there_and_back(self):
        obj = self.illustration(self.stack(), Style="outline", Explode=True, ExplodeFactor=0.75, Callouts=True, PartsList=True, Legend=True,
                                Sections=["-x=30", section.text_of(section.plane(V(0, -1, 0), -20, ["Pump.Bolt", "Pump.Bolt001"]))])
        explosion.set_steps(obj, asking.find_steps(obj)[0])
        self.doc.recompute()
        obj.ItemNumbers = {"2": "Gone", "5": "Bolt", "6": "Plate", "7": "Lid"}
        self.doc.recompute()
        path = os.path.join(self.folder, "pump.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.assertEqual(data["section"][1]["exclude"], ["/Bolt", "/Bolt001"])
        self.assertEqual((data["callouts"], data["parts_list"], data["legend"], data["explode"]["factor"]), (True, "sheet", True, 0.75))
        self.assertEqual(data["items"], {"2": "Gone", "5": "Bolt", "6": "Plate", "7": "Lid"})
        kernels = burin().draw(path)
        self.assertEqual([(i["number"], i["name"]) for i in kernels.items], [(5, "Bolt"), (6, "Plate"), (7, "Lid")])
        self.assertEqual(len(kernels.arrays()["first"]), len(burin().Drawing.load(obj.Drawing).arrays()["first"]))
        read = illustration_file.read(self.doc, path)
        for name in ("Explode", "ExplodeFactor", "Callouts", "PartsList", "Legend", "Sections"):
            self.assertEqual(getattr(read, name), getattr(obj, name), name)
        self.assertEqual(dict(read.ItemNumbers), dict(obj.ItemNumbers))
        self.assertEqual(make_job(read).fingerprint(), make_job(obj).fingerprint())

    def test_files_of_others_that_name_by_selectors(self):
        self.stack()
        path = os.path.join(self.folder, "by-hand.burin.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"burin": "illustration", "parts": [{"file": "pump.step", "name": "Pump"}],
                       "section": {"plane": "y", "exclude": "*olt*"}, "explode": {"along": [0, 0, 1], "fit": 0.1, "factor": 0.5}}, file)
        read = illustration_file.read(self.doc, path)
        self.assertEqual(section.entries_of(read), [{"plane": "y", "exclude": ["Pump.Bolt", "Pump.Bolt001"]}])
        self.assertEqual((read.Explode, read.ExplodeAlong, read.ExplodeSteps, read.ExplodeFactor), (True, "0,0,1", [], 0.5))
        self.doc.recompute()
        self.assertEqual(read.Message, "")
        self.assertEqual(drawn(read).diagnostics, [])

    def test_exploded_views_of_the_assembly_workbench(self):
        pump_ = self.stack()
        for in_group in (True, False):
            view = exploded_view(self.doc, pump_, in_group)
            steps, notes = assembly_view.steps_of(view)
            self.assertEqual([(step.move, step.along, step.by) for step in steps],
                             [(["Pump.Bolt", "Pump.Bolt001"], (0, 0, 1), 50), (["Pump.Lid"], (0, 1, 0), 30)])
            self.assertEqual([note.split(":")[0].rstrip("01") for note in notes], ["Turned", "Round"])
        self.assertEqual(len(assembly_view.exploded_views(self.doc)), 2)
        obj = self.illustration(pump_, Style="outline", Explode=True)
        explosion.set_steps(obj, steps)
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        self.assertIn("trail", self.kinds(obj))

    def test_link_arrays_are_no_assemblies(self):
        imported = App.newDocument("Imported")
        for file in ("gear_pump", "coupling"):
            Import.insert(os.path.join(os.environ["BURIN_SOURCE_DIR"], "samples", file + ".step"), imported.Name, merge=False)
            obj = make_illustration(imported, [next(o for o in imported.Objects if o.Label in ("gear pump", "flange coupling") and not o.InList)])
            # Without a window FreeCAD shows what the arrays link to as well.
            top = obj.Sources[0][0]  # a link group, a part in FreeCAD 1.0
            held = top.ElementList if hasattr(top, "ElementList") else top.Group
            self.assertEqual([o for o in visible(imported) if o in held], [], "what it holds is not drawn twice")
            steps, _ = asking.find_steps(obj)
            theirs = burin().explode_steps(os.path.join(os.environ["BURIN_SOURCE_DIR"], "samples", file + ".step"))["steps"]
            sources = [part.source for part in make_job(obj).parts]
            ours = [sorted({k for word in step.move for k in numbers_of(word, sources)}) for step in steps]
            self.assertEqual([len(numbers) for numbers in ours], [len(step["parts"]) for step in theirs], file)
            self.assertEqual([step.along for step in steps], [tuple(round(a, 6) + 0 for a in step["along"]) for step in theirs])
            for step, other in zip(steps, theirs):
                self.assertAlmostEqual(step.by, other["by"], delta=0.03 * other["by"])
            explosion.set_steps(obj, steps)
            obj.Explode = obj.Callouts = True
            imported.recompute()
            path = os.path.join(self.folder, file + ".burin.json")
            illustration_file.write(obj, path)
            self.assertEqual([(i["number"], i["name"], i["quantity"]) for i in burin().draw(path, style="outline").items],
                             [(i["number"], i["name"], i["quantity"]) for i in burin().Drawing.load(obj.Drawing).items])
            read = illustration_file.read(imported, path)
            self.assertEqual(read.Sources, obj.Sources)
            self.assertEqual(make_job(read).fingerprint(), make_job(obj).fingerprint())
            for o in imported.Objects[::-1]:
                imported.removeObject(o.Name)
