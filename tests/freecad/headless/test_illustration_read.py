"""Illustration files made into illustrations of a document: the same settings, and a word for all that has no place."""

import json
import os
import unittest.mock

import numpy
import Mesh
import Part

from support import V, App, Case, burin, content

from freecad.burin_wb import illustration_file, illustration_read
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.features.properties import ILLUSTRATION, default_of

# What the way there and back keeps as it was. `Sources` are compared by the parts that they make.
SETTINGS = [row.name for row in ILLUSTRATION if row.group in ("View", "Sheet", "Style")]


def placed(x, y, z, axis=(0, 0, 1), angle=0.0):
    return App.Placement(V(x, y, z), App.Rotation(V(*axis), angle))


class IllustrationRead(Case):
    def setUp(self):
        super().setUp()
        self.said = []
        patch = unittest.mock.patch.object(illustration_read, "tell", lambda text, *level: self.said.append(text))
        patch.start()
        self.addCleanup(patch.stop)
        self.path = os.path.join(self.folder, "pump.burin.json")

    def back(self, obj):
        """The illustration, out to a file and in again."""
        illustration_file.write(obj, self.path)
        return illustration_file.read(self.doc, self.path)

    def read(self, **keys):
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump({"burin": "illustration", **keys}, file)
        return illustration_file.read(self.doc, self.path)

    def settings(self, obj):
        values = {name: getattr(obj, name) for name in SETTINGS}
        return {name: tuple(v) if isinstance(v, App.Vector) else getattr(v, "Value", v) for name, v in values.items()}

    def alike(self, obj, other):
        self.assertEqual(self.settings(obj), self.settings(other))
        job, again = make_job(obj), make_job(other)
        self.assertEqual([part.source for part in job.parts], [part.source for part in again.parts])
        self.assertEqual(job.exact_fingerprint(), again.exact_fingerprint())
        self.assertEqual(len(self.said), 1)
        self.assertNotIn(";", self.said[0])

    def test_there_and_back(self):
        box, ball = self.box(), self.solid(Part.makeSphere(15), "Ball")
        ball.Placement = placed(70, 30, 0, (1, 2, 3), 40)
        obj = self.illustration(box, ball, Style="engraving", Width=150, Height=100, Margin=7, HiddenLines="Dashed", Seed=3,
                                Light=V(0.5, 0.2, 0.9), ViewDirection=V(1, -2, 0.7), ViewUp=V(0, 1, 0.5),
                                StyleKeys={"line.outer": "0.8", "hatch.taper": "1"}, CentreLines=True, Tolerance=0.05,
                                Looks={"Box": "not hatched;transparent", "Ball": "style=outline"})
        obj.Label = "A box and a ball"
        other = self.back(obj)
        self.alike(obj, other)
        self.assertEqual(dict(other.Looks), dict(obj.Looks))
        self.assertTrue(other.Label.startswith("A box and a ball"), other.Label)
        self.said.clear()
        obj.Projection, obj.FieldOfView, obj.Looks = "Perspective", 20, {"Ball": "not drawn"}
        self.alike(obj, self.back(obj))
        self.said.clear()
        obj.Projection, obj.FieldOfView = "Orthographic", default_of("FieldOfView")  # a parallel view has none
        obj.FitScale, obj.Scale, obj.Tolerance, obj.StyleKeys = False, 0.6, 0, {"strokes.2.kind": "dots"}
        self.alike(obj, self.back(obj))

    def test_it_is_drawn_the_same(self):
        obj = self.illustration(self.box(), Style="technical", ViewDirection=V(2, -1, 1))
        other = self.back(obj)
        self.doc.recompute()
        self.assertEqual(other.Message, "")
        self.assertGreater(len(content(obj.Drawing)), 1000)
        self.assertEqual(content(obj.Drawing), content(other.Drawing))


    def test_assemblies_links_and_meshes_are_found_by_name_and_place(self):
        block = self.solid(Part.makeBox(40, 30, 20), "Block")
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = placed(10, 20, 30, (1, 2, 3), 33)
        part.addObject(block)
        part.addObject(self.solid(Part.makeSphere(9), "Knob"))
        links = [self.doc.addObject("App::Link", "Link") for _ in range(2)]
        for k, link in enumerate(links):
            link.LinkedObject = part
            link.Placement.Base = V(0, 90 * (k + 1), 0)
        mirror = self.doc.addObject("App::Link", "Mirror")
        mirror.LinkedObject = block
        mirror.ScaleVector = V(1, 1, -1)
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createBox(20, 30, 10)
        net.Placement = placed(0, -80, 0, (1, 0, 0), 20)
        self.doc.recompute()
        obj = self.illustration(links[1], part, mirror, net, Style="outline", Looks={"Link001.Block": "transparent"})
        other = self.back(obj)
        self.alike(obj, other)
        self.assertEqual([o.Name for o, _ in other.Sources], ["Link001", "Part", "Mirror", "Net"], "assemblies as a whole")
        self.assertEqual(dict(other.Looks), {"Link001.Block": "transparent"})

    def test_one_object_of_an_assembly_and_what_is_hidden(self):
        part = self.doc.addObject("App::Part", "Part")
        boxes = [self.box(name=name) for name in ("In", "Beside", "Hidden")]
        for box in boxes[:2]:
            part.addObject(box)
        boxes[2].Visibility = False
        obj = self.illustration((part, ("Beside.",)), boxes[2])
        other = self.back(obj)
        self.alike(obj, other)
        self.assertEqual([(o.Name, subs) for o, subs in other.Sources], [("Part", ("Beside.",)), ("Hidden", ("",))])

    def test_what_the_document_lacks_is_told(self):
        self.box(name="Base")
        obj = self.read(parts=[{"file": "base.step", "name": "Base"}, {"file": "cover.step"}, {"function": "torus(20, 8)", "name": "ring"}],
                        looks=[{"select": "cover", "drawn": False}, {"select": "Base", "hatched": False}])
        self.assertEqual([o.Name for o, _ in obj.Sources], ["Base"])
        self.assertEqual(dict(obj.Looks), {"Base": "not hatched"})
        self.assertEqual((obj.Width.Value, obj.Height.Value, obj.Margin.Value), (297, 210, 10), "as burin draw takes them")
        self.assertRegex(self.said[0], r"the document lacks 'cover' \(cover.step\), 'ring' \(a function\): import and label")
        with self.assertRaisesRegex(Refused, r"no object of the file's parts, which are 'lid' \(lid.step\); import these"):
            self.read(parts=[{"file": "lid.step"}])

    def test_models_that_were_imported_into_another_document(self):
        block = self.solid(Part.makeBox(40, 30, 20), "Block")
        block.Label = "A/block"
        obj = self.illustration(block, self.box(), Style="outline", Looks={"Block": "not hatched"})
        illustration_file.write(obj, self.path)
        other = App.newDocument("Other")
        models = os.path.join(self.folder, "pump.models")
        for file in sorted(os.listdir(models)):
            Part.insert(os.path.join(models, file), other.Name)
        made = illustration_file.read(other, self.path)
        job, again = make_job(obj), make_job(made)
        self.assertEqual([(part.brep, part.hatched) for part in job.parts], [(part.brep, part.hatched) for part in again.parts])
        self.assertEqual(self.settings(made), self.settings(obj))

    def test_an_assembly_is_known_by_its_name_in_the_file(self):
        step = os.path.join(os.environ["BURIN_SOURCE_DIR"], "samples", "coupling.step")
        part = self.doc.addObject("App::Part", "Imported")
        part.Label = "flange coupling"
        hub = self.box(name="Hub")
        hub.Label = "driven hub"
        part.addObject(hub)
        part.addObject(self.box(name="Shaft"))
        self.doc.recompute()
        obj = self.read(parts=[{"file": step}], looks=[{"select": "/flange coupling/driven hub", "transparent": True}])
        self.assertEqual([(o.Name, subs) for o, subs in obj.Sources], [("Imported", ("",))])
        self.assertEqual(dict(obj.Looks), {"Imported.Hub": "transparent"})
        self.assertNotIn(";", self.said[-1])

    def test_objects_that_an_import_numbered_are_told(self):
        for label in ("coupling", "coupling001"):
            self.box(name="Box").Label = label
        self.read(parts=[{"file": "coupling.step"}])
        self.assertRegex(self.said[-1], r"may be of the file too and were not taken .*: coupling$")

    def test_of_equal_names_the_first_is_taken_and_told(self):
        block = self.solid(Part.makeBox(40, 30, 20), "Block")
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(block)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base = V(0, 90, 0)
        self.doc.recompute()
        numbered = [{"file": "a.brep", "name": "Block 2", "place": {"translate": [0, 90, 0]}}, {"file": "a.brep", "name": "Block"}]
        obj = self.read(parts=numbered)
        self.assertEqual([(o.Name, subs) for o, subs in obj.Sources], [("Link", ("",)), ("Part", ("",))])
        self.assertNotIn(";", self.said[-1])
        obj = self.read(parts=[{"file": "a.stl", "name": "Block", "place": {"translate": [0, 0, 7]}}])
        self.assertIn("are where the document has them, though the file has other places: Block", self.said[-1])
        self.assertIn("names that several objects have, of which the first was taken: Block (Part.Block)", self.said[-1])

    def test_other_places_are_told(self):
        box, net = self.box(), self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createBox(20, 30, 10)
        net.Placement = placed(1, 2, 3)
        parts = [{"file": "a.brep", "name": "Box"}, {"file": "b.off", "name": "Net"}]
        self.read(parts=parts)
        self.assertNotIn("place", self.said[-1])
        box.Placement = placed(0, 0, 5)
        self.read(parts=parts)
        self.assertRegex(self.said[-1], "the file has other places: Box$")
        self.read(parts=[parts[0], {**parts[1], "place": {"scale": 2}}])
        self.assertRegex(self.said[-1], "the file has other places: Box, Net$")

    def test_selectors_reach_what_they_reach_when_drawn(self):
        part = self.doc.addObject("App::Part", "pump")
        for name in ("bolt1", "bolt2", "cover"):
            part.addObject(self.box(name=name))
        self.doc.recompute()
        obj = self.read(parts=[{"file": "pump.step"}],
                        looks=[{"select": "pump/*bolt*", "style": "technical", "hatched": False}, {"select": ["/pump/bolt2", "@index=2"], "drawn": False},
                               {"select": "bolt1", "hatched": True}, {"select": "nut", "drawn": False}])
        self.assertEqual([(o.Name, subs) for o, subs in obj.Sources], [("pump", ("",))])
        self.assertEqual(dict(obj.Looks), {"pump.bolt1": "style=technical", "pump.bolt2": "not hatched;style=technical;not drawn",
                                           "pump.cover": "not drawn"})
        self.assertRegex(self.said[0], "no part is named 'nut'.*'bolt1'")

    def test_what_illustrations_of_documents_have_no_property_for_is_told(self):
        self.box()
        obj = self.read(parts=[{"file": "a.brep", "name": "Box", "heal": True}], view={"from": "top", "center": [1, 2, 3]}, seed=5_000_000_000,
                        paper={"size": "fit", "margin": [1, 2, 3, 4]}, explode={"base": "Box"},
                        lights=[{"ambient": 0.2}, {"from": [0, 0, 1], "strength": 0.7}, {"at": [0, 0, 9]}, {"ambient": 0.9}])
        self.assertEqual((tuple(obj.ViewDirection), tuple(obj.ViewUp)), ((0, 0, 1), (0, 1, 0)))
        self.assertEqual((obj.Width.Value, obj.Height.Value), (180, 130))
        self.assertEqual((obj.Margin.Value, obj.Seed, tuple(obj.Light)), (4, 2**31 - 1, (0, 0, 1)))
        self.assertEqual({k: float(v) for k, v in obj.StyleKeys.items()}, {"tone.ambient": 1, "tone.diffuse": 0.7})
        for words in ("that are there: heal", "view.center", "seed", "paper.size", "paper.margin", "explode: base", "lights: one from", "1 left out",
                      "tone.ambient is 1 at most here, which is taken for 1.1"):
            self.assertIn(words, self.said[0])

    def test_lights_that_have_a_counterpart_draw_the_same(self):
        obj = self.illustration(self.solid(Part.makeSphere(15), "Ball"), Style="engraving", Width=60, Height=60)
        illustration_file.write(obj, self.path)
        with open(self.path, encoding="utf-8") as file:
            data = json.load(file)
        data["lights"] = [{"ambient": 0.3}, {"from": [0.2, 0.9, 0.5], "strength": 0.5}]
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump(data, file)
        other = illustration_file.read(self.doc, self.path)
        self.doc.recompute()
        ours, theirs = burin().Drawing.load(other.Drawing).arrays(), burin().draw(self.path).arrays()
        self.assertGreater(len(ours["points"]), 500)
        numpy.testing.assert_allclose(ours["points"], theirs["points"], atol=2e-4)

    def test_styles_by_file_and_of_looks(self):
        style = os.path.join(self.folder, "mine.json")
        with open(style, "w", encoding="utf-8") as file:
            json.dump({"base": "outline", "line.outer": 1.1}, file)
        boxes = [self.box(name=name) for name in "AB"]
        parts = [{"file": "a.brep", "name": box.Name} for box in boxes]
        obj = self.read(parts=parts, style="mine.json", looks=[{"select": "A", "style": "mine.json"}, {"select": "B", "style": {"base": "outline"}}])
        self.assertEqual((obj.Style, dict(obj.StyleKeys)), (style, {}))
        self.assertEqual(dict(obj.Looks), {"A": "style=" + style, "B": "style=outline"})
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        obj = self.read(parts=parts, style={"base": "patent"}, looks=[{"select": "A", "style": {"line.outer": 2}}])
        self.assertEqual((obj.Style, dict(obj.StyleKeys), dict(obj.Looks)), ("patent", {}, {}))
        self.assertIn("look of A: its own style has no name, so it is left out", self.said[-1])

    def test_files_that_are_broken_leave_the_document(self):
        self.box()
        before = len(self.doc.Objects)
        part = {"file": "a.brep", "name": "Box"}
        for keys, words in (({"parts": [part], "loks": []}, r"pump.burin.json:1: unknown key 'loks'; did you mean 'looks'"),
                            ({"parts": []}, "has no parts"), ({"parts": [part], "view": {"from": "tip"}}, "pump.burin.json:1: unknown view 'tip'"),
                            ({"parts": [part], "style": "gone.json"}, "there is no style file"),
                            ({"parts": [part], "version": 2}, "reads version 1")):
            with self.assertRaisesRegex(Refused, words):
                self.read(**keys)
        with self.assertRaisesRegex(Refused, "there is no such file"):
            illustration_file.read(self.doc, os.path.join(self.folder, "gone.burin.json"))
        with open(self.path, "wb") as file:
            file.write(b"\xff\x00{")
        with self.assertRaisesRegex(Refused, "not valid JSON"):
            illustration_file.read(self.doc, self.path)
        self.assertEqual(len(self.doc.Objects), before)
        self.assertEqual(self.said, [])

    def test_one_step_of_undo(self):
        self.doc.UndoMode = 1
        obj = self.illustration(self.box())
        illustration_file.write(obj, self.path)
        self.doc.openTransaction("New illustration from file")
        name = illustration_file.read(self.doc, self.path).Name
        self.doc.recompute()
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.assertIsNotNone(self.doc.getObject(obj.Name))
