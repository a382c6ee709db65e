"""Notes of illustrations: what they point at and say, what follows the model, what is told, and their way into files and back."""

import json
import os
from unittest import mock

import Part
from pump import pump
from support import Case, V, burin, content
from test_dimensions import facing, round_one

from freecad.burin_wb import features, illustration_file, offers, step_book
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import make_dimension, make_note
from freecad.burin_wb.features.asking import items_of, steps_job
from freecad.burin_wb.features.dimension import illustrations_of
from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.features.properties import DIMENSION, NOT_OF_NOTES, OF_NOTES

TOP, BOTTOM = V(0, 0, 1), V(0, 0, -1)


class Notes(Case):
    def plate(self, **properties):
        """A plate of 60 x 40 x 10 with a hole, on a sheet."""
        self.part = self.solid(Part.makeBox(60, 40, 10).cut(Part.makeCylinder(5, 30, V(20, 20, -5))), "Plate")
        return self.sheet(self.part, **properties)

    def sheet(self, *sources, **properties):
        return self.illustration(*sources, **{"Style": "outline", "Width": 297, "Height": 210, "Margin": 10, **properties})

    def add(self, obj, *subs, **properties):
        made = make_note(obj, [(self.part, sub) for sub in subs], **properties)
        self.doc.recompute()
        return made

    def layer(self, obj):
        return next((one for one in json.loads(content(obj.Drawing))["layers"] if one["name"] == "notes"), {"paths": [], "texts": []})

    def texts(self, obj, role="note"):
        """The texts of notes, or of what else."""
        return sorted(text["text"] for layer in json.loads(content(obj.Drawing))["layers"] for text in layer.get("texts", ()) if text["role"] == role)

    def leaders(self, obj):
        """Parts with the faces or edges that leaders point at."""
        return [[path.get("part"), path.get("face", path.get("edge"))] for path in self.layer(obj)["paths"] if path.get("part", -1) >= 0]


class Drawn(Notes):
    def test_words_at_a_face_an_edge_a_vertex_and_a_part(self):
        obj = self.plate()
        side = facing(self.part, V(0, -1, 0))
        edge = next(f"Edge{k}" for k, one in enumerate(self.part.Shape.Edges, 1) if one.BoundBox.ZMin > 9 and one.BoundBox.YMax < 1)
        corner = next(f"Vertex{k}" for k, one in enumerate(self.part.Shape.Vertexes, 1) if one.Point == V(60, 0, 10))
        made = [self.add(obj, side, Text="{area} mm2"), self.add(obj, edge, Text="{length} mm"), self.add(obj, corner, Text="here"),
                self.add(obj, "", Text="{part.name}")]
        self.assertEqual((obj.Message, self.texts(obj)), ("", ["60 mm", "600 mm2", "Plate", "here"]))
        self.assertEqual([(one.Kind, one.Label, one.Name[:4], illustrations_of(one)) for one in made],
                         [("Note", label, "Note", [obj]) for label in ("Note", "Note001", "Note002", "Note003")])
        self.assertEqual(made[3].Features, [(self.part, ("",))])
        self.assertIn([0, int(side[4:]) - 1], self.leaders(obj))
        rows = make_job(obj).options["illustration"]
        self.assertEqual(list(rows), ["notes"])
        self.assertEqual([row["at"] for row in rows["notes"]], [{"part": "@index=0", "face": int(side[4:]) - 1},
                         {"part": "@index=0", "edge": int(edge[4:]) - 1}, {"point": [60, 0, 10]}, {"part": "@index=0"}])

    def test_several_lines_leaders_a_frame_a_mark_and_a_place(self):
        obj = self.plate()
        one = self.add(obj, facing(self.part, TOP), facing(self.part, V(0, -1, 0)), Text="Oil\\nbefore\nuse")
        self.assertEqual([text["text"] for text in self.layer(obj)["texts"]], ["Oil", "before", "use"])
        self.assertEqual(len({tuple(leader) for leader in self.leaders(obj)}), 2)
        plain = len(self.layer(obj)["paths"])
        one.Frame = True
        self.doc.recompute()
        self.assertGreater(len(self.layer(obj)["paths"]), plain)
        one.Mark = "Arrow"
        self.doc.recompute()
        self.assertEqual(make_job(obj).options["illustration"]["notes"][0]["mark"], "arrow")
        one.Features, one.Place = [], V(20, 15, 0)
        self.doc.recompute()
        self.assertEqual((obj.Message, one.Message, self.leaders(obj)), ("", "", []))
        self.assertAlmostEqual(self.layer(obj)["texts"][2]["at"][0], 20, delta=3)

    def test_symbols_with_their_options(self):
        obj = self.plate()
        one = self.add(obj, facing(self.part, TOP), Symbol="warning", Text="Hot")
        known = set()
        for keys in ({}, {"warning_of": "hot"}, {"warning_of": "electricity", "warning_size": "12"}, {"weld_joint": "v"}):
            one.SymbolKeys = keys
            self.doc.recompute()
            self.assertEqual((obj.Message, self.texts(obj)[-1]), ("", "Hot"))
            known.add(json.dumps(json.loads(content(obj.Drawing))["areas"]))
        self.assertEqual(len(known), 3, "those of other symbols are left aside")
        for name in offers.kept()["symbols"]:
            one.Symbol, one.SymbolKeys, one.Text = name, {}, ""
            self.doc.recompute()
            self.assertEqual((obj.Message, one.Message), ("", ""), f"{name} may stand without words")

    def test_an_assembly_is_pointed_at_where_one_of_its_parts_is_seen(self):
        part = pump(self.doc)
        obj = self.sheet(part)
        self.part = part
        self.add(obj, "", Text="{part.name}")
        at = make_job(obj).options["illustration"]["notes"][0]["at"]
        self.assertEqual((at, obj.Message), ({"part": f"/{part.Label}"}, ""))
        one = make_note(obj, [(self.doc.Bolt, "")], Text="bolt")
        self.doc.recompute()
        self.assertEqual((one.Features, obj.Message), ([(part, ("Bolt.",))], ""))
        self.assertIn("bolt", self.texts(obj))
        self.assertRegex(make_job(obj).options["illustration"]["notes"][1]["at"]["part"], "^@index=[0-9]+$")
        other = pump(self.doc)
        obj.Sources = [part, other]
        self.doc.recompute()
        labels = part.Label == other.Label
        at = make_job(obj).options["illustration"]["notes"][0]["at"]["part"]
        self.assertEqual(at.startswith("@index="), labels, "names that two have mean neither")

    def test_dimensions_and_notes_have_properties_of_their_own(self):
        obj = self.plate()
        note, dimension = self.add(obj, "", Text="a"), make_dimension(obj)
        for hidden, shown, one in ((NOT_OF_NOTES, OF_NOTES, note), (OF_NOTES, NOT_OF_NOTES, dimension)):
            self.assertTrue(all("Hidden" in one.getEditorMode(name) for name in hidden), one.Name)
            self.assertFalse(any("Hidden" in one.getEditorMode(name) for name in shown), one.Name)
        dimension.Kind = "Note"
        self.assertFalse(any("Hidden" in dimension.getEditorMode(name) for name in OF_NOTES))


class Kept(Notes):
    def test_it_stays_at_its_face_when_steps_of_a_body_number_anew(self):
        body = self.doc.addObject("PartDesign::Body", "Body")
        for kind, name, sizes, x in (("AdditiveBox", "Block", {"Length": 60, "Width": 40, "Height": 15}, 0),
                                     ("SubtractiveCylinder", "Bore", {"Radius": 4, "Height": 15}, 20)):
            step = body.newObject("PartDesign::" + kind, name)
            step.Placement.Base = V(x, 20 if x else 0, 0)
            for size, value in sizes.items():
                setattr(step, size, value)
        self.doc.recompute()
        obj, step = self.sheet(body), self.doc.Bore
        make_note(obj, [(body, "Bore." + next(f"Face{k}" for k, f in enumerate(step.Shape.Faces, 1) if f.findPlane() is None))], Text="{diameter}")
        make_note(obj, [(body, facing(body, TOP))], Text="top")
        self.doc.recompute()
        self.assertEqual((obj.Message, self.texts(obj)), ("", ["8", "top"]))
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        for edge in ("Edge1", "Edge2", "Edge12"):
            chamfer.Base, chamfer.Size = (step, [edge]), 1
            self.doc.recompute()
            self.assertEqual((obj.Message, self.texts(obj)), ("", ["8", "top"]), edge)
        step.Radius = 5
        self.doc.recompute()
        self.assertEqual(self.texts(obj), ["10", "top"])

    def test_saved_opened_and_edited(self):
        obj = self.plate()
        self.add(obj, facing(self.part, TOP), "", Text="Ra 1.6", Symbol="surface", SymbolKeys={"surface_material": "removed"})
        self.add(obj, "", Text="two\nlines")
        kept = content(obj.Drawing)
        obj = self.reopen(obj)
        one, two = obj.Dimensions
        self.assertEqual(two.Text, "two\nlines")
        self.assertEqual((one.Kind, one.Symbol, dict(one.SymbolKeys), "Touched" in one.State), ("Note", "surface", {"surface_material": "removed"}, False))
        self.redraw(obj)
        self.assertEqual((obj.Message, content(obj.Drawing)), ("", kept))
        one.Text = "Ra 3.2"
        self.doc.recompute()
        self.assertEqual(self.texts(obj), ["Ra 3.2", "lines", "two"])

    def test_undone_and_copied(self):
        self.doc.UndoMode = 1
        obj = self.plate()
        self.doc.openTransaction("Note")
        one = self.add(obj, "", Text="one", Frame=True, Symbol="balloon", SymbolKeys={"warning_of": "hot"}, Place=V(30, 30, 0))
        self.doc.commitTransaction()
        copy = self.doc.copyObject(obj, False)
        self.doc.recompute()
        self.redraw(copy)
        other, = copy.Dimensions
        self.assertNotEqual(one.Name, other.Name)
        self.assertEqual([getattr(other, row.name) for row in DIMENSION], [getattr(one, row.name) for row in DIMENSION])
        self.assertEqual((self.texts(copy), other.Name[:4]), (["one"], "Note"))
        self.doc.undo()
        self.doc.undo()
        obj = self.doc.Illustration
        self.redraw(obj)
        self.assertEqual((list(obj.Dimensions), self.texts(obj)), ([], []))

    def test_documents_of_versions_without_notes(self):
        obj = self.plate()
        one = make_dimension(obj, [(self.part, round_one(self.part, 5))], Tolerance="H7")
        one.Kind = [word for word in one.getEnumerationsOfProperty("Kind") if word != "Note"]
        one.Kind = "Diameter"
        for name in OF_NOTES:
            one.removeProperty(name)
        self.doc.recompute()
        obj = self.reopen(obj)
        one, = obj.Dimensions
        self.assertEqual((one.Kind, one.Tolerance, one.Mark, one.Frame, one.State), ("Diameter", "H7", "Auto", False, ["Up-to-date"]))
        self.redraw(obj)
        self.assertEqual((obj.Message, self.texts(obj, "dimension")), ("", ["⌀10 H7"]))
        one.Kind, one.Text = "Note", "reamed"
        self.doc.recompute()
        self.assertEqual((obj.Message, self.texts(obj)), ("", ["reamed"]))

    def test_saved_without_the_add_on_and_repaired(self):
        obj = self.plate()
        one = self.add(obj, "", Text="kept")
        obj.Proxy = one.Proxy = None
        self.reopen(obj)
        obj, one = self.doc.Illustration, self.doc.Note
        self.assertEqual(features.repair(self.doc), [obj, one])
        self.redraw(obj)
        self.assertEqual(self.texts(obj), ["kept"])


class Told(Notes):
    def test_a_note_without_words(self):
        obj = self.plate()
        one = self.add(obj, "")
        words = "it has no words; write some in Text, or choose a Symbol"
        self.assertEqual((one.Message, obj.Message, self.texts(obj), one.State), (words, f"Note: {words}", [], ["Up-to-date"]))
        one.Text = " \\n "
        self.doc.recompute()
        self.assertEqual(one.Message, words)
        one.Text = "now"
        self.doc.recompute()
        self.assertEqual((one.Message, obj.Message, self.texts(obj)), ("", "", ["now"]))

    def test_what_is_gone(self):
        part = pump(self.doc)
        obj = self.sheet(part)
        make_note(obj, [(part, "Bolt.")], Text="bolt")
        lid = make_note(obj, [(self.doc.Lid, facing(self.doc.Lid, TOP))], Text="lid")
        self.doc.recompute()
        self.assertEqual(self.texts(obj), ["bolt", "lid"])
        self.doc.removeObject("Bolt")
        self.doc.recompute()
        self.assertEqual((obj.Message, self.texts(obj)), ("Note: Pump.Bolt is gone; choose its Features again, or delete it", ["lid"]))
        lid.Features = []
        self.doc.recompute()
        self.assertEqual(lid.Message, "its features are gone; choose its Features again, or delete it")

    def test_what_is_not_drawn_here(self):
        obj = self.plate()
        other = self.box(name="Other")
        self.doc.recompute()
        for sub in ("", "Face1"):
            with self.assertRaisesRegex(Refused, "^Other is not drawn here; add it to Sources, or choose other Features$"):
                make_note(obj, [(other, sub)], Text="a")
        with self.assertRaisesRegex(Refused, "^Plate.Face99 is gone"):
            make_note(obj, [(self.part, "Face99")], Text="a")
        self.assertEqual((list(obj.Dimensions), [o for o in self.doc.Objects if o.Name.startswith("Note")]), ([], []))
        self.add(obj, "", Text="a")
        obj.Looks = {"Plate": "not drawn"}
        self.doc.recompute()
        self.assertIn("Note: Plate is not drawn here; add it to Sources, or choose other Features", make_job(obj).notes)

    def test_what_the_kernel_refuses_is_left_out_and_named(self):
        """Dimensions among them: each is called by its own name."""
        obj = self.plate(Views=["front", "top"])
        make_dimension(obj)
        bore = make_dimension(obj, [(self.part, round_one(self.part, 5))])
        top, whole = self.add(obj, facing(self.part, TOP), Text="top"), self.add(obj, "", Text="all")
        self.assertEqual((obj.Message, self.texts(obj)), ("", ["all", "top"]))
        for change, why in (({"Text": "{mass}"}, r'"text" has \{mass\}: only \{part.name\}, .* are known'), ({"Text": "{radius}"}, r"what it points at has no \{radius\}"),
                            ({"Symbol": "circle"}, "\"symbol\" takes surface, "), ({"View": "left"}, "no view is called 'left': there is front, top")):
            before = {name: getattr(whole, name) for name in change}
            for name, value in change.items():
                setattr(whole, name, value)
            self.doc.recompute()
            self.assertRegex(obj.Message, f"^Note001 is not drawn: {why}")
            self.assertEqual((self.texts(obj), len(self.texts(obj, "dimension"))), (["top"], 4))
            self.assertEqual([bool(one.Message) for one in (bore, top, whole)], [False, False, True], "the tree's mark")
            self.assertFalse([one.Name for one in (obj, *obj.Dimensions) if "Touched" in one.State])
            self.assertEqual([item["name"] for item in items_of(obj)], ["Plate"])
            for name, value in before.items():
                setattr(whole, name, value)
            self.doc.recompute()
            self.assertEqual((obj.Message, whole.Message, self.texts(obj)), ("", "", ["all", "top"]))
        bore.Text, top.View = "{foo}", "left"
        self.doc.recompute()
        self.assertRegex(obj.Message, r'^Diameter is not drawn: "text" has \{foo\}: .*; Note is not drawn: no view is called')
        self.assertEqual((self.texts(obj), len(self.texts(obj, "dimension"))), (["all"], 3))

    def test_what_is_hidden_is_told_by_the_notes_name(self):
        obj = self.plate(Views=["top"])
        self.add(obj, facing(self.part, BOTTOM), Text="below", Label="About the base")
        self.assertRegex(obj.Message, "^About the base is not drawn: ")

    def test_step_books_and_steps_have_none(self):
        obj = self.sheet(pump(self.doc))
        make_note(obj, [(self.doc.Pump, "")], Text="a")
        self.doc.recompute()
        self.assertIn("notes", make_job(obj).options["illustration"])
        self.assertNotIn("notes", steps_job(obj).options["illustration"])
        self.assertNotIn("notes", step_book.job_of(obj, ["book.pdf"]).options["illustration"])


class Files(Notes):
    KEYS = ("Kind", "Features", "Text", "Frame", "Symbol", "SymbolKeys", "Mark", "Place", "Decimals", "View")

    def test_both_ways(self):
        obj = self.plate(Views=["front", "top"])
        make_dimension(obj)
        self.add(obj, facing(self.part, TOP), Text="two\nlines", Frame=True, Mark="Dot", View="top")
        self.add(obj, facing(self.part, TOP), round_one(self.part, 5), "", Text="{area}", Decimals=1)
        self.add(obj, "Vertex1", Text="corner", Symbol="warning", SymbolKeys={"warning_of": "hot", "warning_size": "12"})
        self.add(obj, Text="mm", Place=V(20, 15, 0))
        self.assertEqual(obj.Message, "")
        path = os.path.join(self.folder, "plate.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            notes = json.load(file)["notes"]
        self.assertEqual(notes[0], {"text": "two\nlines", "at": {"part": "/Plate", "face": int(facing(self.part, TOP)[4:]) - 1}, "frame": True, "mark": "dot",
                                    "view": "top"})
        self.assertEqual(notes[1]["at"][2], {"part": "/Plate"})
        kernels = [text["text"] for layer in json.loads(burin().draw(path).to_bytes("json"))["layers"] for text in layer.get("texts", ())]
        for text in self.texts(obj):
            self.assertIn(text, kernels)
        read_ = illustration_file.read(self.doc, path)
        self.assertEqual([[getattr(one, key) for key in self.KEYS] for one in read_.Dimensions[1:]],
                         [[getattr(one, key) for key in self.KEYS] for one in obj.Dimensions[1:]])
        self.assertEqual(make_job(read_).fingerprint(), make_job(obj).fingerprint())

    def test_one_that_the_kernel_refuses_is_not_written(self):
        obj = self.plate()
        self.add(obj, "", Text="{radius}")
        self.add(obj, "", Text="b")
        path = os.path.join(self.folder, "plate.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            self.assertEqual([note["text"] for note in json.load(file)["notes"]], ["b"])
        burin().draw(path)

    def test_an_assembly_has_its_first_part_in_the_file(self):
        part = pump(self.doc)
        obj = self.sheet(part)
        make_note(obj, [(part, "")], Text="a")
        self.doc.recompute()
        path, said = os.path.join(self.folder, "pump.burin.json"), []
        with mock.patch("freecad.burin_wb.illustration_file.tell", lambda text, *_: said.append(text)):
            illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["notes"], [{"text": "a", "at": {"part": "/" + make_job(obj).parts[0].name}}])
        self.assertIn(f"the note at {part.Label} points at {make_job(obj).parts[0].name} in the file, its first part", said[0])

    def test_files_of_others(self):
        part = pump(self.doc)
        path = os.path.join(self.folder, "by-hand.burin.json")
        names = [child.Label for child in part.Group if hasattr(child, "Shape")]
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"burin": "illustration", "parts": [{"file": "pump.step", "name": name} for name in names], "notes": [
                "Bolt=M6\\nby hand", "25,20,16=near", {"at": "*", "text": "all"}, {"at": ["Lid", [25, 20, 16]], "text": "two", "unit": "inch"},
                {"at": {"point": [1, 2, 3]}, "text": "nowhere"}, {"at": "@index=0", "text": "first", "symbol": "balloon"}]}, file)
        said = []
        with mock.patch("freecad.burin_wb.illustration_read.tell", lambda text, *_: said.append(text)):
            read_ = illustration_file.read(self.doc, path)
        self.doc.recompute()
        rows = [(one.Text, [sub.rstrip("0123456789") for _, subs in one.Features for sub in subs]) for one in read_.Dimensions]
        self.assertEqual(rows, [("M6\nby hand", ["Bolt."]), ("near", ["Lid.Face"]), ("all", [""]), ("two", ["Lid.", "Lid.Face"]), ("first", [names[0] + "."])])
        self.assertIn("note 4: unit: the style has it here", said[0])
        self.assertIn("note 5: the document has no vertex at 1, 2, 3, so it is left out", said[0])
        self.assertIn("by hand", self.texts(read_))
