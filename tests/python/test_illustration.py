"""Illustrations as files and as dicts, their schema, and parts by name."""

import importlib.util
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import burin
from support import COMMAND, SAMPLES

TWO = {
    "burin": "illustration",
    "title": "A stand on a ring",
    "parts": [
        {"file": str(SAMPLES / "bracket.off"), "name": "stand"},
        {"function": "torus(60, 6)", "name": "ring", "place": {"translate": [0, 0, -20], "rotate": [0, 90, 0]}},
    ],
    "view": {"from": "iso"},
    "paper": {"size": "A5", "margin": [5, 6, 7, 8]},
    "lights": [{"ambient": 0.2}, {"from": [-0.5, 0.65, 0.6], "strength": 0.7}, {"at": [0, 0, 300], "strength": 0.2}],
    "style": {"base": "engraving", "hatch.spacing_min": 0.6},
    "looks": [{"select": "ring", "style": "outline", "transparent": False}],
}


class Illustrations(unittest.TestCase):
    def test_sections_of_all_kinds(self):
        stand = str(SAMPLES / "bracket.off")

        def cut(asked, **keywords):
            file = {"burin": "illustration", "parts": [{"file": stand}], "style": "outline", "section": asked}
            theirs, ours = burin.draw(file), burin.draw(stand, style="outline", **keywords)
            hatched = [
                [path.points.tolist() for layer in drawing.layers if layer.name == "pattern" for path in layer.paths]
                for drawing in (theirs, ours)
            ]
            self.assertGreater(len(hatched[0]), 2)
            self.assertEqual(*hatched)

        low, high = burin.Scene.read(stand).bounds().tolist()
        middle = [(a + b) / 2 for a, b in zip(low, high)]
        cut("y", section="y")
        cut({"planes": ["x", "y"]}, section="x,y")
        cut({"planes": ["x", "y"]}, section="quarter")
        cut({"box": [middle, [x + 1 for x in high]]}, section_box=[*middle, *[x + 1 for x in high]])
        with self.assertRaisesRegex(ValueError, "section_box takes a box"):
            burin.draw(stand, section_box=[0, 0, 0])

    def test_a_dict_draws_as_its_file_does(self):
        with tempfile.TemporaryDirectory() as folder:
            file, theirs, ours = (Path(folder, name) for name in ("two.burin.json", "a.svg", "b.svg"))
            file.write_text(json.dumps(TWO))
            subprocess.run([COMMAND, "draw", file, "-o", theirs, "-q"], check=True)
            drawing = burin.draw(TWO)
            drawing.save(ours)
            self.assertEqual(theirs.read_bytes(), ours.read_bytes())
            burin.draw(file).save(ours)
            self.assertEqual(theirs.read_bytes(), ours.read_bytes())
            self.assertEqual([part["name"] for part in drawing.parts], ["stand", "ring"])

    def test_what_an_illustration_says(self):
        said = burin.illustration({**TWO, "section": "y", "tolerance": 0.1})
        self.assertEqual((said["title"], said["paper"]), ("A stand on a ring", {"size": (210, 148), "margin": (5, 6, 7, 8)}))
        stand, ring = said["parts"]
        self.assertEqual((stand["file"], stand["name"], stand["function"]), (str(SAMPLES / "bracket.off"), "stand", ""))
        self.assertEqual((ring["file"], ring["function"]), ("", "torus(60, 6)"))
        self.assertEqual(stand["place"], [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
        self.assertEqual(ring["place"], [[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, -20], [0, 0, 0, 1]], "z to x: about y by 90 degrees")
        self.assertEqual(said["view"], {"from": [1, -1, 1], "up": [0, 0, 1], "perspective": None, "scale": None, "center": None})
        self.assertEqual(said["lights"], [{"ambient": 0.2}, {"from": [-0.5, 0.65, 0.6], "strength": 0.7}, {"at": [0, 0, 300], "strength": 0.2}])
        self.assertEqual((said["style"]["name"], said["style"]["hatch.spacing_min"]), ("engraving", 0.6))
        self.assertEqual(said["looks"], [{"select": ["ring"], "drawn": None, "hatched": None, "transparent": False, "listed": None, "style": "outline"}])
        self.assertEqual((said["hidden"], said["tolerance"], said["seed"], said["sections"]), ("none", 0.1, 1, ["y"]))
        self.assertEqual(burin.illustration({**TWO, "style": "patent"})["style"], "patent")

    def test_what_a_file_says_beside_parts_is_asked_of_a_scene(self):
        scene = burin.Scene.read(SAMPLES / "gear_pump.step")
        found = burin.explode_steps(scene)
        self.assertEqual([d.code for d in found["diagnostics"]], ["explode.directions"])
        first = found["steps"][0]
        self.assertEqual([scene.parts[k].name for k in first["parts"]], [f"screw {k}" for k in range(1, 7)])
        steps = [{key: step[key] for key in ("move", "along", "by", "trail")} for step in found["steps"]]
        given = {"section": {"plane": "y", "exclude": "*screw*"}, "explode": {"steps": steps, "factor": 0.5}, "items": {"7": "cover"}}
        drawing = burin.draw(scene, illustration=given, style="outline", callouts=True)
        self.assertEqual([(i["number"], i["name"]) for i in drawing.items][:2], [(7, "cover"), (8, "body")])
        file = {"burin": "illustration", "parts": [{"file": str(SAMPLES / "gear_pump.step")}], **given}
        same = burin.draw(file, style="outline", callouts=True)
        self.assertEqual(drawing.to_bytes("svg"), same.to_bytes("svg"))
        over = burin.draw(scene, illustration={**given, "style": "engraving"}, style="outline", callouts=False)
        self.assertEqual((over.style, over.items), ("outline", []), "keywords hold over it")
        self.assertEqual(burin.explode_steps(scene, illustration=given)["steps"], found["steps"], "those that were given")
        self.assertEqual(burin.items(scene, illustration=given), drawing.items)
        left = burin.items(scene, part="*screw*")
        self.assertEqual([(i["number"], i["name"], i["quantity"]) for i in left], [(10, "screw M6", 6)], "hiding changes no number")

    def test_settings_that_no_scene_takes(self):
        scene = burin.Scene.read(SAMPLES / "bracket.off")
        for given, words in (({"parts": [{"file": "a.off"}]}, "parts"), ({"sektion": "y"}, "section"),
                             ({"explode": {"steps": [{"move": ["lid"], "along": [0, 0, 1], "by": 3}]}}, "lid")):
            with self.assertRaisesRegex(burin.UsageError, f"^illustration.*{words}"):
                burin.draw(scene, illustration=given)
        with self.assertRaisesRegex(TypeError, "argument illustration takes a mapping"):
            burin.draw(scene, illustration=["y"])
        cancel = burin.Cancel()
        cancel.cancel()
        for what in (burin.explode_steps, burin.items):
            with self.assertRaises(burin.Cancelled):
                what(burin.Scene.read(SAMPLES / "gear_pump.step"), cancel=cancel)

    def test_a_file_is_read_with_what_it_extends_and_without_its_models(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "house.burin.json").write_text('{"burin": "illustration", "paper": "fit", "hidden": "dashed"}')
            file = Path(folder, "a.burin.json")
            file.write_text('{"burin": "illustration", "extends": "house.burin.json",\n "parts": [{"file": "gone.step", "heal": true}]}')
            said = burin.illustration(file)
            self.assertEqual((said["paper"]["size"], said["hidden"]), ("fit", "dashed"))
            self.assertEqual((said["parts"][0]["file"], said["parts"][0]["read"]), (str(Path(folder, "gone.step")), ["heal"]))
            file.write_text('{"burin": "illustration",\n "prts": []}')
            with self.assertRaisesRegex(burin.UsageError, "a.burin.json:2: unknown key 'prts'; did you mean 'parts'"):
                burin.illustration(file)
            with self.assertRaisesRegex(burin.InputError, "no such file"):
                burin.illustration(Path(folder, "none.burin.json"))

    def test_reader_and_schema_know_the_same_keys(self):
        properties = json.loads(burin.illustration_schema())["properties"]

        def objects(schema):
            """Objects that a value may be, or a list of which it may be."""
            own = [schema["properties"]] if "properties" in schema else []
            return own + [o for s in [*schema.get("anyOf", ()), *([schema["items"]] if "items" in schema else [])] for o in objects(s)]

        def keys(name):
            return [o for o in objects(properties[name]) if "qqq" not in o][-1]

        step = objects(keys("explode")["steps"])[0]
        place = keys("parts")["place"]["properties"]
        asked = {
            "": ({"qqq": 1}, properties), "view": ({"view": {"qqq": 1}}, keys("view")), "paper": ({"paper": {"qqq": 1}}, keys("paper")),
            "section": ({"section": {"qqq": 1}}, next(o for o in objects(properties["section"]) if "plane" in o)),
            "explode": ({"explode": {"qqq": 1}}, keys("explode")), "step": ({"explode": {"steps": [{"qqq": 1}]}}, step),
            "details": ({"details": [{"qqq": 1}]}, keys("details")), "dimensions": ({"dimensions": [{"qqq": 1}]}, keys("dimensions")),
            "breaks": ({"breaks": [{"qqq": 1}]}, keys("breaks")), "looks": ({"looks": [{"qqq": 1}]}, keys("looks")),
            "lights": ({"lights": [{"qqq": 1}]}, keys("lights")), "parts": ({"parts": [{"qqq": 1}]}, keys("parts")),
            "place": ({"parts": [{"file": "a.stl", "place": {"qqq": 1}}]}, place),
            "items": ({"items": {"1": {"qqq": 1}}}, objects(properties["items"]["additionalProperties"])[0]),
        }
        for name, (wrong, known) in asked.items():
            with self.subTest(name), self.assertRaises(burin.UsageError) as caught:
                burin.illustration({"burin": "illustration", **wrong})
            told = str(caught.exception).split("known here are ")[1].split(", ")
            self.assertEqual(sorted(told), sorted(known), name)

    def test_lights_reach_the_styles_of_parts(self):
        lit = {"illustration": {"lights": [{"ambient": 0.1}, {"from": [1, 0, 0.2], "strength": 0.9}]}, "style": "engraving", "paper": "A6"}
        plain, styled = burin.Scene.read(SAMPLES / "bracket.off"), burin.Scene.read(SAMPLES / "bracket.off")
        styled.parts[0].style = "engraving"
        self.assertEqual(burin.draw(styled, **lit).to_bytes("svg"), burin.draw(plain, **lit).to_bytes("svg"))
        styled.parts[0].style = "pencil"
        other = {**lit, "illustration": {"lights": [{"from": [-1, 0, 0.2], "strength": 0.9}]}}
        self.assertNotEqual(burin.draw(styled, **lit).to_bytes("svg"), burin.draw(styled, **other).to_bytes("svg"))

    def test_select(self):
        parts = [{"name": "bolt", "assembly": ["pump"]}, {"name": "cover", "color": "#88c0ff"}, {"name": "bolt 2", "source": "in/a.step"}]
        self.assertEqual(burin.select(parts, "pump/*bolt*"), [0])
        self.assertEqual(burin.select(parts, "bolt*"), [0, 2])
        self.assertEqual(burin.select(parts, "@color=#88C0FF"), [1])
        self.assertEqual(burin.select(parts, "@file=a.step"), [2])
        self.assertEqual(burin.select(burin.draw(TWO).parts, "ring"), [1])
        with self.assertRaisesRegex(burin.UsageError, "no part is named 'nut'"):
            burin.select(parts, "nut")
        with self.assertRaises(TypeError):
            burin.select(["bolt"], "bolt")
        with self.assertRaisesRegex(TypeError, "\"name\" is text, not 3"):
            burin.select([{"name": 3}], "bolt")

    def test_exploded_views(self):
        apart = {**TWO, "explode": {"steps": [{"move": "ring", "along": [0, 0, -1], "by": 80}]}}
        self.assertEqual(burin.illustration(apart)["explode"], apart["explode"])
        self.assertIsNone(burin.illustration(TWO)["explode"])
        together, drawn = burin.draw(TWO, style="outline"), burin.draw(apart, style="outline")
        self.assertLess(drawn.view.scale, together.view.scale, "it needs more of the sheet")
        self.assertEqual(burin.draw(apart, style="outline", explode="none").view.scale, together.view.scale)
        for way in ("auto", "z", [0, 0, 1]):
            drawing = burin.draw(SAMPLES / "gear_pump.step", style="outline", explode=way)
            self.assertIn("trail", [layer.name for layer in drawing.layers])
        with self.assertRaisesRegex(burin.UsageError, "argument explode takes auto, none"):
            burin.draw(SAMPLES / "bracket.off", explode="w")
        with self.assertRaisesRegex(burin.UsageError, "argument explode_factor takes 0 to 10"):
            burin.draw(SAMPLES / "bracket.off", explode_factor=11)

    def test_keywords_hold_over_the_illustration(self):
        drawing = burin.draw(TWO, paper="A6", hide="ring", style="outline")
        self.assertEqual(drawing.paper, (148, 105))
        self.assertEqual({path.part for layer in drawing.layers for path in layer.paths}, {0})

    def test_errors(self):
        with self.assertRaisesRegex(burin.UsageError, "unknown key 'loks'; did you mean 'looks'"):
            burin.draw({**TWO, "loks": []})
        with self.assertRaisesRegex(burin.UsageError, "no part is named 'rong'.*'ring'"):
            burin.draw(TWO, hide="rong")
        with self.assertRaisesRegex(burin.UsageError, "argument iso is about reading.*belongs to a part"):
            burin.draw(TWO, iso=3)
        with self.assertRaisesRegex(burin.UsageError, "argument heal is about reading"):
            burin.draw(TWO, heal=True)

    def test_standard_input_is_no_illustration(self):
        told = subprocess.run([COMMAND, "draw", "-", "-o", "-", "--format", "svg"], input=json.dumps(TWO), capture_output=True, text=True)
        self.assertEqual(told.returncode, 3)
        self.assertIn("standard input: is an illustration, which names files beside it", told.stderr)

    def test_parts_of_scenes_by_name(self):
        scene = burin.Scene.read(SAMPLES / "bracket.off", SAMPLES / "knot.ply")
        drawing = burin.draw(scene, part=["knot"], look={"knot": "outline"})
        self.assertEqual({path.part for layer in drawing.layers for path in layer.paths}, {1})
        self.assertFalse([layer for layer in drawing.layers if layer.name == "stroke" and layer.paths])

    @unittest.skipUnless(importlib.util.find_spec("jsonschema"), "python3-jsonschema is not installed")
    def test_reader_and_schema_accept_the_same(self):
        import jsonschema

        check = jsonschema.Draft202012Validator(json.loads(burin.illustration_schema()))
        right = (
            {"callouts": True}, {"seed": 3.0}, {"tolerance": 0.1}, {"items": {"10": "lid"}}, {"view": {"from": [1, 2, 3], "up": [0, 0, 1]}},
            {"paper": [100, 50]}, {"explode": {"along": "z", "fit": 0.1}}, {"details": [{"at": [1, 2, 3], "radius": 4}]},
            {"dimensions": "overall"}, {"dimensions": ["overall", {"diameter": [1, 2, 3]}]}, {"dimensions": [{"radius": {"part": "a", "face": 1}}]},
            {"dimensions": [{"distance": [{"edge": [1, 2, 3]}, {"point": [1, 2, 3]}], "along": [1, 0, 0], "tolerance": ["+0.1", 0], "unit": "inch"}]},
            {"dimensions": [{"angle": [[1, 2, 3], [4, 5, 6]], "supplement": True}]}, {"dimensions": [{"thread": [1, 2, 3], "text": "M8"}]},
            {"dimensions": [{"radius": {"part": "a", "face": 1, "kept": {"kind": "plane", "beside": ["cone"]}}}]},
            {"breaks": "z:1..2"}, {"breaks": ["auto"]}, {"breaks": [{"axis": "z", "from": 1, "to": 2}, {"axis": [0, 0, 1], "from": 3, "to": 4.5}]},
            {"details": [{"select": "lid", "radius": 4}]}, {"section": {"plane": "x", "exclude": []}}, {"lights": [{"ambient": 0.3}]},
        )
        step = {"move": "a", "along": [0, 0, 1], "by": 1}
        wrong = (
            {"callouts": 1}, {"callouts": "true"}, {"seed": 1.5}, {"seed": "1"}, {"tolerance": "0.1"}, {"items": {"01": "lid"}}, {"items": {"0": "lid"}},
            {"items": {"1": ""}}, {"view": {"up": 5}}, {"view": {"up": "0,0,1"}}, {"views": True}, {"title": ""}, {"title": 3}, {"hidden": 1},
            {"lights": 1}, {"lights": [{}]}, {"lights": [{"ambient": 0.1, "from": [1, 0, 0]}]}, {"lights": [{"ambient": 0.1, "strength": 1}]},
            {"dimensions": "all"}, {"dimensions": [{}]}, {"dimensions": [{"diameter": [1, 2, 3], "radius": [1, 2, 3]}]}, {"dimensions": [{"diameter": 3}]},
            {"dimensions": [{"diameter": {"face": 3}}]}, {"dimensions": [{"diameter": {"part": "a"}}]}, {"dimensions": [{"distance": [[1, 2, 3]]}]},
            {"dimensions": [{"diameter": {"part": "a", "point": [1, 2, 3]}}]}, {"dimensions": [{"diameter": [1, 2, 3], "along": [1, 0, 0]}]},
            {"dimensions": [{"diameter": [1, 2, 3], "supplement": True}]}, {"dimensions": [{"thread": [1, 2, 3]}]},
            {"dimensions": [{"diameter": [1, 2, 3], "decimals": 7}]}, {"dimensions": [{"diameter": [1, 2, 3], "unit": "yard"}]},
            {"dimensions": [{"diameter": [1, 2, 3], "tolerance": [1, 2, 3]}]}, {"dimensions": [{"diameter": {"part": "a", "face": 1.5}}]},
            {"dimensions": [{"diameter": {"part": "a", "face": [1, 2, 3], "kept": {"kind": "plane"}}}]}, {"dimensions": [{"radius": {"part": "a", "face": 1, "kept": {}}}]},
            {"breaks": 1}, {"breaks": [{"axis": "z", "from": 1}]}, {"breaks": {"axis": 1, "from": 1, "to": 2}}, {"breaks": [{"from": 1, "to": 2}]},
            {"details": [{"at": [1, 2, 3]}]}, {"details": [{"radius": 3}]}, {"details": [{"select": "a", "at": [1, 2, 3], "radius": 3}]},
            {"parts": [{"name": "a"}]}, {"parts": [{"file": "a.stl", "function": "sphere(1)"}]}, {"parts": [{"file": "a.stl", "bounds": True}]},
            {"parts": [{"file": "a.stl", "place": {"scale": 2, "matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]}}]},
            {"explode": {"steps": []}}, {"explode": {"steps": [step], "fit": 1}}, {"explode": {"steps": [{**step, "by": 0}]}},
            {"section": {"plane": "x", "box": [[0, 0, 0], [1, 1, 1]]}}, {"section": {}},
        )
        for expected, documents in ((True, right), (False, wrong)):
            for members in documents:
                with self.subTest(members):
                    document = {**TWO, **members}
                    self.assertEqual(check.is_valid(document), expected, "the schema")
                    if expected:
                        burin.illustration(document)
                    else:
                        with self.assertRaises(burin.UsageError):
                            burin.illustration(document)

    @unittest.skipUnless(importlib.util.find_spec("jsonschema"), "python3-jsonschema is not installed")
    def test_schema(self):
        import jsonschema

        schema = json.loads(burin.illustration_schema())
        told = subprocess.run([COMMAND, "options", "--illustration-schema"], check=True, capture_output=True, text=True)
        self.assertEqual(schema, json.loads(told.stdout))
        jsonschema.Draft202012Validator.check_schema(schema)
        check = jsonschema.Draft202012Validator(schema)
        self.assertTrue(check.is_valid(TWO))
        for wrong in (
            {"lok": []},
            {"view": {"form": "iso"}},
            {"looks": [{"drawn": True}]},
            {"style": {"line.outr": 1}},
            {"parts": [{"fil": "a"}]},
            {"lights": [{"ambient": -1}]},
            {"hidden": "dotted"},
        ):
            self.assertFalse(check.is_valid({**TWO, **wrong}), wrong)
        first = subprocess.run(
            [COMMAND, "illustrate", SAMPLES / "bracket.off", "-o", "-", "--set", "hatch.taper=1"],
            check=True, capture_output=True, text=True,
        )
        self.assertTrue(check.is_valid(json.loads(first.stdout)), list(check.iter_errors(json.loads(first.stdout))))


if __name__ == "__main__":
    unittest.main()
