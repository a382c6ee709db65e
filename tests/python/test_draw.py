"""Drawing: options, styles, fields and tones, and what comes out."""

import csv
import importlib.util
import inspect
import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import burin
import numpy as np
from support import COMMAND, SAMPLES, cube, sphere


def mesh_scene(shape=cube):
    scene = burin.Scene()
    scene.add_mesh(*shape())
    return scene


class Verified(unittest.TestCase):
    """verify=True tests the drawing and tells what it found."""

    def test_a_true_drawing(self):
        scene = mesh_scene()
        drawing = burin.draw(scene, style="outline", verify=True)
        proof = drawing.stats["verify"]
        self.assertGreaterEqual(proof["spans"], 10)
        self.assertGreater(proof["length"], 100)
        self.assertEqual((proof["contradicted"], proof["count"], proof["loose_ends"]), (0, 0, 0))
        self.assertEqual(proof["contradictions"], [])
        again = burin.Drawing.from_json(drawing.to_bytes("json"))
        self.assertEqual(again.stats["verify"], proof)
        self.assertNotIn("verify", burin.draw(scene, style="outline").stats)


class Areas(unittest.TestCase):
    """Flat colours under the lines."""

    def test_they_are_there_where_they_are_asked_for(self):
        scene = mesh_scene()
        self.assertEqual(burin.draw(scene, style="outline").areas, [])
        drawing = burin.draw(scene, style="shaded")
        shadow, *parts = drawing.areas
        self.assertEqual((shadow["part"], shadow["fill"]), (-1, "#d1d1d1"))
        self.assertEqual({area["part"] for area in parts}, {0})
        self.assertEqual({area["tone"] for area in parts}, {0, 1})
        self.assertEqual(parts[0]["rings"][0].shape[1], 2)
        for area in drawing.areas:
            rings = [ring for shell, holes in area["polygons"] for ring in (shell, *holes)]
            self.assertEqual(sorted(map(id, rings)), sorted(map(id, area["rings"])))
        again = burin.Drawing.from_json(drawing.to_bytes("json"))
        self.assertEqual([a["fill"] for a in again.areas], [a["fill"] for a in drawing.areas])

    def test_some_parts_are_highlighted(self):
        drawing = burin.draw(SAMPLES / "coupling.step", style="outline", highlight={"bolt": "blue"})
        of_bolts = {part["id"] for part in drawing.parts if part["name"].startswith("bolt")}
        self.assertEqual({area["fill"] for area in drawing.areas if area["part"] in of_bolts}, {"#3b7dd8"})
        self.assertEqual({area["fill"] for area in drawing.areas if area["part"] not in of_bolts}, {"#f4f4f4"})

    def test_what_comes_apart_casts_no_shadow_on_the_ground_unless_that_is_asked_for(self):
        def has_one(**options):
            drawing = burin.draw(SAMPLES / "coupling.step", **options)
            return any(area["part"] == -1 for area in drawing.areas)

        self.assertTrue(has_one(style="shaded"))
        self.assertFalse(has_one(style="shaded", explode="auto"))
        self.assertTrue(has_one(style={"base": "flat", "shadow.ground": True}, explode="auto"))

    def test_highlights_of_a_style_with_a_spot_ink_are_printed_in_inks(self):
        def inks_of(highlight):
            drawing = burin.draw(SAMPLES / "coupling.step", style="duotone", highlight=highlight)
            inks = [d.code for d in drawing.diagnostics if d.code.startswith("fill.ink")]
            self.assertEqual(inks, [])
            names = {part["id"]: part["name"] for part in drawing.parts}
            found = {True: set(), False: set()}
            for area in drawing.areas:
                found[names[area["part"]].startswith("bolt")].add((area["ink"], area["fill"]))
            self.assertEqual(found[False], {("", "#f4f4f4")})
            darkest = [fill for ink, fill in found[True] if fill in ("#0078bf", "#3b7dd8", "#000000")]
            return {ink for ink, fill in found[True]}, darkest

        self.assertEqual(inks_of(["bolt"]), ({"Spot"}, ["#0078bf"]))
        self.assertEqual(inks_of({"bolt": "blue"}), ({"Highlight blue"}, ["#3b7dd8"]))
        self.assertEqual(inks_of({"bolt": "black"}), ({""}, ["#000000"]))

    @unittest.skipUnless(shutil.which("gs"), "needs Ghostscript")
    def test_a_spot_ink_has_a_plate_of_its_own(self):
        drawing = burin.draw(SAMPLES / "coupling.step", style="duotone")
        self.assertEqual({area["ink"] for area in drawing.areas}, {"Spot"})
        with tempfile.TemporaryDirectory() as folder:
            pdf = Path(folder) / "a.pdf"
            drawing.save(pdf)
            subprocess.run(["gs", "-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=tiffsep", "-sCompression=none", "-r20",
                            f"-sOutputFile={folder}/plate.tif", str(pdf)], check=True, capture_output=True)
            inked = {}
            for plate in Path(folder).glob("plate(*).tif"):
                pixels = np.frombuffer(plate.read_bytes(), np.uint8)
                inked[plate.name[6:-5]] = np.count_nonzero(pixels < 250) / len(pixels)
        # A header of some bytes is all that the plates have which print nothing.
        self.assertGreater(inked.pop("Spot"), 0.1)
        self.assertGreater(inked.pop("Black"), 0.02)
        self.assertEqual(sorted(inked), ["Cyan", "Magenta", "Yellow"])
        self.assertLess(max(inked.values()), 0.02)

    def test_a_legend_lists_the_colours_that_are_seen(self):
        def rows(**options):
            drawing = burin.draw(SAMPLES / "coupling.step", legend=True, **options)
            squares = [a for a in drawing.areas if a["role"] == "legend"]
            texts = [text for layer in drawing.layers if layer.name == "legend" for text in layer.texts]
            self.assertEqual(len(squares), len(texts))
            return drawing, [text["text"] for text in texts], [a["fill"] for a in squares]

        drawing, names, fills = rows(style="flat")
        self.assertIn("bolt M10", names)
        self.assertEqual(len(names), len(set(names)), "copies have one row")
        self.assertEqual(rows(style="outline", highlight={"bolt": "blue"})[1:], (["bolt M10"], ["#3b7dd8"]))
        drawing, names, _ = rows(style="outline")
        self.assertEqual(names, [])
        self.assertIn("legend.empty", [d.code for d in drawing.diagnostics])
        self.assertTrue(burin.illustration({"burin": "illustration", "version": 1, "parts": [{"file": "a.step"}], "legend": True})["legend"])


class Textures(unittest.TestCase):
    """u and v of a mesh."""

    def test_laws_know_them(self):
        vertices, triangles = sphere()
        keys = {"hatch.ink_law": "ink*step(u)"}

        def draw(texture):
            scene = burin.Scene()
            scene.add_mesh(vertices, triangles, "ball", texture=texture)
            return burin.draw(scene, style="engraving", paper="A6", set=keys)

        def codes(drawing):
            return [d.code for d in drawing.diagnostics]

        without, textured = draw(None), draw(vertices[:, [0, 2]])
        self.assertIn("strokes.no_parameters", codes(without))
        self.assertNotIn("strokes.no_parameters", codes(textured))
        self.assertLess(textured.stats["strokes"], without.stats["strokes"])
        strokes = [path for layer in textured.layers for path in layer.paths if path.kind == "stroke"]
        self.assertGreater(len(strokes), 20)
        for path in strokes:
            self.assertGreater(path.points3[:, 0].mean(), -0.5)

    def test_bad_ones_are_told(self):
        scene = burin.Scene()
        with self.assertRaisesRegex(burin.UsageError, "texture takes u and v of each of 8 vertices, not 3"):
            scene.add_mesh(*cube(), texture=np.zeros((3, 2)))
        with self.assertRaisesRegex(burin.UsageError, "argument texture"):
            scene.add_mesh(*cube(), texture=np.zeros((8, 3)))


class SameAsCommand(unittest.TestCase):
    """The same options give the same bytes."""

    def check(self, model, words, formats=("svg", "json"), **keywords):
        with tempfile.TemporaryDirectory() as folder:
            theirs = [Path(folder, "a." + suffix) for suffix in formats]
            outputs = [word for path in theirs for word in ("-o", path)]
            subprocess.run([COMMAND, "draw", SAMPLES / model, *outputs, "--quiet", *words], check=True, timeout=60)
            drawing = burin.draw(SAMPLES / model, **keywords)
            for path in theirs:
                ours = path.with_stem("b")
                drawing.save(ours)
                self.assertEqual(path.read_bytes(), ours.read_bytes())

    def test_defaults(self):
        self.check("spindle.stl", [])

    def test_many_options(self):
        self.check(
            "coupling.step",
            ["--view=2,-3,1.5", "--up=0,0.1,1", "--paper=200x150", "--margin=7.5", "--style=engraving"]
            + ["--set=line.outer=0.9", "--set=hatch.direction=1,0,0.25"]
            + ["--light=-1,0.5,0.25", "--hidden=dashed", "--seed=7", "--threads=1", "--tolerance=0.05"],
            view=(2, -3, 1.5),
            up=np.array([0, 0.1, 1]),
            paper=(200, 150),
            margin=7.5,
            style="engraving",
            set={"line.outer": 0.9, "hatch.direction": (1, 0, 0.25)},
            light=[-1, 0.5, 0.25],
            hidden="dashed",
            seed=7,
            threads=1,
            tolerance=0.05,
        )

    def test_keys_of_a_format(self):
        # The command knows which files it writes and warns in others that a key of SVG shapes nothing there.
        self.check("spindle.stl", ["--paper=A6", "--set=svg.flatten=polylines"], formats=("svg",), paper="A6", set={"svg.flatten": True})

    def test_perspective_scale_and_center(self):
        self.check(
            "bracket.off",
            ["--perspective=40", "--scale=0.5", "--center=10,5,2", "--style=outline"],
            perspective=40,
            scale=0.5,
            center=(10, 5, 2),
            style="outline",
        )

    def test_info(self):
        said = subprocess.run(
            [COMMAND, "info", "--json", SAMPLES / "bracket.off"], check=True, timeout=60, capture_output=True
        )
        self.assertEqual(burin.info(SAMPLES / "bracket.off"), json.loads(said.stdout)["files"])


class Items(unittest.TestCase):
    """What an assembly is made of: kernel/docs/numbers_and_lists.md."""

    def test_lists_and_callouts(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "parts.csv")
            drawing = burin.draw(SAMPLES / "coupling.step", style="outline", callouts=True,
                                 parts_list=["sheet", str(file)])
            with open(file, newline="", encoding="utf-8") as rows:
                listed = [(int(row["number"]), row["name"], int(row["quantity"])) for row in csv.DictReader(rows)]
        self.assertEqual(listed, [(i["number"], i["name"], i["quantity"]) for i in drawing.items])
        self.assertEqual(sum(i["quantity"] for i in drawing.items), len(drawing.parts))
        self.assertIn((7, "washer 10", 12), listed)
        layers = {layer.name: layer for layer in drawing.layers}
        numbers = [int(text["text"]) for text in layers["callouts"].texts]
        self.assertEqual(sorted(numbers), list(range(1, 9)))
        self.assertEqual({path.kind for path in layers["callouts"].paths}, {"leader", "frame"})
        self.assertEqual({path.item for path in layers["callouts"].paths}, set(numbers))
        again = burin.Drawing.from_json(drawing.to_bytes("json"))
        self.assertEqual(again.items, drawing.items)
        self.assertEqual(again.layers[-1].texts[0]["text"], drawing.layers[-1].texts[0]["text"])
        self.assertTrue(drawing.to_bytes("html").startswith(b"<!DOCTYPE html>"))

    def test_nothing_is_found_where_nothing_asks(self):
        self.assertEqual(burin.draw(SAMPLES / "coupling.step", style="outline").items, [])

    def test_bad_lists_are_told(self):
        with self.assertRaisesRegex(burin.UsageError, "argument parts_list takes sheet, FILE.csv or FILE.json"):
            burin.draw(SAMPLES / "coupling.step", parts_list="parts.txt")


class Options(unittest.TestCase):
    def test_errors_name_the_keyword(self):
        scene = mesh_scene()
        bad = [
            ({"scale": -1}, "argument scale takes a number over 0"),
            ({"perspective": 500}, "argument perspective takes 1 to 120"),
            ({"margin": 200}, "argument margin takes"),
            ({"light": (0, 0, 0)}, "argument light takes a direction"),
            ({"center": (1, 2)}, "argument center takes a point"),
            ({"hidden": "dotted"}, "argument hidden takes none or dashed"),
            ({"threads": 0}, "argument threads takes"),
            ({"seed": -1}, "argument seed takes"),
            ({"tolerance": 0}, "argument tolerance takes"),
            ({"view": "frnt"}, "unknown view 'frnt'"),
            ({"paper": "B9"}, "unknown paper 'B9'"),
            ({"style": "tecnical"}, "the nearest is 'technical'"),
            ({"style": {"line.outr": 1}}, "^unknown style key 'line.outr'; the nearest is 'line.outer'"),
            ({"set": {"line.outer": "thick"}}, "'line.outer' takes 0.01 to 10, not 'thick'"),
            ({"set": {"hatch.spacing_min": 5}}, "more than 'hatch.spacing_max'"),
            ({"tolerence": 1}, "unknown argument 'tolerence'; the nearest is 'tolerance'"),
            ({"bounds": (0, 0, 0, 1, 1, 1)}, "Scene.read"),
            ({"view": ""}, "argument view has an empty value"),
            ({"scale": ""}, "argument scale has an empty value"),
            ({"up": ()}, "argument up has an empty value"),
            ({"hide": [""]}, "argument hide has an empty value"),
        ]
        for keywords, message in bad:
            with self.subTest(keywords), self.assertRaisesRegex(burin.UsageError, message):
                burin.draw(scene, **keywords)

    def test_wrong_types(self):
        scene = mesh_scene()
        bad = [{"scale": True}, {"scale": [1]}, {"view": 3}, {"light": "abc".split}, {"hidden": 3}]
        bad += [{"set": ["line.outer=1"]}, {"style": 3}, {"field": 3}, {"tone": "dark"}, {"progress": 1}, {"cancel": 1}]
        for keywords in bad:
            with self.subTest(keywords), self.assertRaises(TypeError):
                burin.draw(scene, **keywords)
        for source in (3, None, [3]):
            with self.assertRaises(TypeError):
                burin.draw(source)

    def test_usage_errors_are_value_errors(self):
        self.assertTrue(issubclass(burin.UsageError, ValueError))
        self.assertTrue(issubclass(burin.OutputError, OSError))
        for error in (burin.UsageError, burin.InputError, burin.GeometryError, burin.OutputError, burin.Cancelled):
            self.assertTrue(issubclass(error, burin.Error))
            self.assertEqual(error.__module__, "burin")

    def test_nothing_to_draw(self):
        with self.assertRaises(burin.GeometryError):
            burin.draw(burin.Scene())
        with self.assertRaises(burin.UsageError):
            burin.draw([])

    def test_center_is_in_the_middle_of_the_sheet(self):
        for extra in ({"scale": 2}, {}, {"scale": 2, "perspective": 30}):
            drawing = burin.draw(mesh_scene(), style="outline", center=(1, 2, 3), **extra)
            np.testing.assert_allclose(drawing.view.project([[1, 2, 3]]), [[297 / 2, 105]], atol=1e-9)
        with self.assertRaisesRegex(burin.UsageError, "scale"):
            burin.draw(mesh_scene(), center=(1, 2, 3), perspective=30)
        # Without a scale all of it is on the sheet, and just so.
        drawing = burin.draw(mesh_scene(), style="outline", center=(1, 2, 3))
        points = drawing.arrays()["points"]
        self.assertTrue((points > 9.9).all() and (points < [287.1, 200.1]).all())
        margins = [*points.min(axis=0), *([297, 210] - points.max(axis=0))]
        self.assertLess(min(margins), 10.1)


class Sheets(unittest.TestCase):
    def test_names_of_views_and_papers(self):
        self.assertLessEqual({"front", "iso", "trimetric"}, set(burin.views()))
        for name, (direction, up) in burin.views().items():
            by_name, by_vectors = (burin.draw(mesh_scene(), view=v, up=u, style="outline").view
                                   for v, u in ((name, None), (direction, up)))
            for axis in ("direction", "right", "up"):
                np.testing.assert_allclose(getattr(by_name, axis), getattr(by_vectors, axis), atol=1e-12, err_msg=name)
        self.assertEqual(burin.papers()["A4"], (297, 210))
        for name, (width, height) in burin.papers().items():
            self.assertEqual(burin.draw(mesh_scene(), paper=name, style="outline").paper, (width, height), name)
            self.assertEqual(burin.draw(mesh_scene(), paper=name + "p", style="outline").paper, (height, width), name)

    def test_paper_scale_and_margin(self):
        drawing = burin.draw(mesh_scene(), view="FRONT", paper="fit", scale="2:1", margin=(1, 2, 3, 4), style="outline")
        np.testing.assert_allclose(drawing.paper, (26, 24), atol=1e-9)
        points = drawing.arrays()["points"]
        np.testing.assert_allclose([points.min(axis=0), points.max(axis=0)], [[4, 3], [24, 23]], atol=1e-6)
        self.assertEqual(burin.draw(mesh_scene(), paper="legal", style="outline").paper, (355.6, 215.9))
        self.assertEqual(burin.draw(mesh_scene(), margin=5, scale=0.5).view.scale, 0.5)


class NothingSilent(unittest.TestCase):
    def said(self, *arguments, **keywords):
        return [d.message for d in burin.draw(*arguments, **keywords).diagnostics]

    def test_what_has_no_effect(self):
        outline = {"style": "outline"}
        cases = [
            ({"tone": lambda p, n: n[:, 0], **outline}, "argument tone has no effect: style 'outline' draws no strokes"),
            ({"light": (1, 0, 0), **outline}, "argument light has no effect"),
            ({"set": {"hatch": {"taper": 1}}, **outline}, "style key hatch.taper has no effect"),
            ({"scale": 1000, **outline}, "what runs off it is cut"),
            ({"light": (1, 0, 0), "set": {"tone.law": "facing"}, "paper": "A6"}, "argument light has no effect: tone.law facing"),
        ]
        for keywords, message in cases:
            with self.subTest(message):
                said = self.said(mesh_scene(), **keywords)
                self.assertEqual(len(said), 1, said)
                self.assertIn(message, said[0])
        said = self.said(SAMPLES / "bracket.off", iso=3, style="outline")
        self.assertIn("argument iso has no effect on", said[0])

    def test_what_has(self):
        for keywords in (
            {"tone": lambda p, n: n[:, 0], "paper": "A6"},
            {"style": "outline", "light": burin.style("outline")["tone.light"]},
            {"set": {"hatch.taper": 1}, "paper": "A6"},
        ):
            self.assertEqual(self.said(mesh_scene(), **keywords), [])

    def test_parts_left_out(self):
        scene = mesh_scene()
        scene.parts[0].drawn = False
        self.assertIn("every part is left out", self.said(scene)[0])


class Styles(unittest.TestCase):
    def test_built_in(self):
        self.assertEqual(list(burin.styles())[:3], ["outline", "technical", "engraving"])
        keys = [entry["key"] for entry in burin.style_keys()]
        style = burin.style("technical")
        self.assertEqual([key for key in style if key != "name"], keys)
        self.assertEqual(style["line.outer"], 0.5)
        self.assertIs(style["hatch.enabled"], True)
        self.assertEqual(style["hatch.direction"], [0, 0, 1])
        width = burin.style_keys()[0]
        self.assertEqual((width["key"], width["kind"], width["low"], width["high"], width["unit"], width["value"]),
                         ("line.outer", "number", 0.01, 10, "mm", "0.5"))
        rows = {row["key"]: row for row in burin.style_keys()}
        self.assertEqual(rows["hatch.plane"]["words"], ["differ", "direction"])
        self.assertEqual(rows["svg.flatten"]["words"], ["none", "polylines"])
        self.assertEqual(rows["tone.light"]["kind"], "direction")

    def test_kinds_of_strokes(self):
        kinds = {row["name"] for row in burin.catalogues()["stroke_kinds"]}
        self.assertLessEqual({"hatching", "pencil", "dots", "silhouette"}, kinds)
        style = burin.style({"base": "engraving", "strokes": [{"taper": 1}, {"kind": "dots"}]})
        self.assertEqual((style["hatch.taper"], style["strokes"][1]["placing"]), (1, "dots"))
        self.assertEqual(burin.style(style), style)
        rows = {row["key"]: row for row in burin.style_keys(style)}
        self.assertEqual(rows["strokes.2.placing"]["value"], "dots")
        self.assertNotIn("strokes.2.placing", {row["key"] for row in burin.style_keys()})
        # the order of a mapping does not matter: the kind goes first
        drawing = burin.draw(mesh_scene(sphere), paper="A6", style="engraving",
                             set={"strokes.2.width_max": 0.7, "strokes.2.kind": "dots", "hatch.taper": 1})
        self.assertEqual({path.stroke_kind for layer in drawing.layers for path in layer.paths if path.kind == "stroke"},
                         {1, 2})
        self.assertIn("stroke-1-kind-2", [layer.name for layer in drawing.layers])
        self.assertEqual(set(drawing.arrays()["stroke_kind"]), {1, 2})
        with self.assertRaisesRegex(burin.UsageError, "'dots'"):
            burin.draw(mesh_scene(), set={"strokes.2.kind": "dot"})

    @unittest.skipUnless(importlib.util.find_spec("jsonschema"), "python3-jsonschema is not installed")
    def test_schema_of_style_files(self):
        import jsonschema

        told = subprocess.run([COMMAND, "options", "--style-schema"], check=True, capture_output=True, text=True)
        schema = json.loads(told.stdout)
        jsonschema.Draft202012Validator.check_schema(schema)
        check = jsonschema.Draft202012Validator(schema)
        for name in burin.styles():
            shown = subprocess.run([COMMAND, "styles", "--show", name], check=True, capture_output=True, text=True)
            self.assertEqual(list(check.iter_errors(json.loads(shown.stdout))), [])
        mixed = {"base": "engraving", "line.outer": 0.5, "hatch": {"direction": [1, 0, 0], "field": "fixed"}}
        self.assertEqual(list(check.iter_errors(mixed)), [])
        wrong = ({"line.outer": 99}, {"hatch": {"field": "circle"}}, {"base": "mine"}, {"lines": {}}, {"hatch": {"tapr": 1}})
        for style in wrong:
            self.assertTrue(list(check.iter_errors(style)), style)
            with self.assertRaises(burin.UsageError):
                burin.style(style)

    def test_catalogues(self):
        told = burin.catalogues()
        command = subprocess.run([COMMAND, "options", "--json"], check=True, capture_output=True, text=True)
        self.assertEqual(told, json.loads(command.stdout))
        options = {row["name"]: row for row in told["options"]}
        self.assertEqual(set(options) | {"field", "tone", "progress", "cancel", "session", "illustration"}, set(inspect.signature(burin.draw).parameters) - {"source"})
        self.assertEqual(options["hidden"]["words"], ["none", "dashed"])
        self.assertEqual(options["style"]["choices"], list(burin.styles()))
        self.assertEqual(told["formats"], burin.formats())

    def test_mapping_is_a_style_file(self):
        mapping = {"base": "engraving", "line.outer": np.float64(0.5), "hatch": {"enabled": False}}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "mine.json")
            path.write_text('{"base": "engraving", "line.outer": 0.5, "hatch": {"enabled": false}}')
            by_file = burin.style(path)
        by_mapping = burin.style(mapping)
        self.assertEqual(by_file.pop("name"), "mine")
        by_mapping.pop("name")
        self.assertEqual(by_file, by_mapping)
        self.assertEqual(by_file["line.outer"], 0.5)

    def test_set_takes_groups(self):
        nested = {"hatch": {"spacing_min": 0.7, "direction": (1, 0, 0)}, "line.outer": 0.9}
        plain = {"hatch.spacing_min": 0.7, "hatch.direction": (1, 0, 0), "line.outer": 0.9}
        one, two = (burin.draw(mesh_scene(), paper="A6", set=keys).to_bytes("json") for keys in (nested, plain))
        self.assertEqual(one, two)
        with self.assertRaisesRegex(burin.UsageError, "'hatch.spacing_mn'; the nearest is 'hatch.spacing_min'"):
            burin.draw(mesh_scene(), set={"hatch": {"spacing_mn": 1}})
        for wrong in ({"hatch": {"a": {"b": 1}}}, {3: 1}, {"hatch": [1]}):
            with self.assertRaises((TypeError, burin.UsageError)):
                burin.draw(mesh_scene(), set=wrong)

    def test_what_style_gives_draw_takes(self):
        drawing = burin.draw(mesh_scene(), paper="A6", style=burin.style("engraving"))
        self.assertEqual(drawing.style, "engraving")
        self.assertEqual(drawing.to_bytes("json"), burin.draw(mesh_scene(), paper="A6", style="engraving").to_bytes("json"))


class Result(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.drawing = burin.draw(mesh_scene(sphere), style="engraving", paper="A5", seed=3, perspective=35)

    def test_head(self):
        d = self.drawing
        self.assertEqual((d.paper, d.seed, d.style), ((210, 148), 3, "engraving"))
        self.assertGreaterEqual(d.stats["triangles"], len(sphere()[1]))
        as_given = burin.draw(mesh_scene(sphere), style="outline", tolerance=1000)
        self.assertEqual(as_given.stats["triangles"], len(sphere()[1]))
        self.assertEqual(d.parts[0]["id"], 0)
        self.assertEqual(d.diagnostics, [])

    def test_arrays_are_the_paths(self):
        arrays = self.drawing.arrays()
        paths = [(i, path) for i, layer in enumerate(self.drawing.layers) for path in layer.paths]
        self.assertGreater(len(paths), 50)
        first = arrays["first"]
        self.assertEqual((len(first), first[0], first[-1]), (len(paths) + 1, 0, len(arrays["points"])))
        self.assertEqual(arrays["layers"], [layer.name for layer in self.drawing.layers])
        for k, (layer, path) in enumerate(paths):
            span = slice(first[k], first[k + 1])
            np.testing.assert_array_equal(arrays["points"][span], path.points)
            np.testing.assert_array_equal(arrays["points3"][span], path.points3)
            np.testing.assert_array_equal(arrays["width"][span], np.broadcast_to(path.width, len(path)))
            self.assertEqual(arrays["layer"][k], layer)
            self.assertEqual(arrays["kinds"][arrays["kind"][k]], path.kind)
            for name in ("part", "face", "edge", "family", "visible", "closed"):
                self.assertEqual(arrays[name][k], getattr(path, name))
            self.assertEqual(path.field != "", path.kind == "stroke")
        self.assertEqual([arrays[n].dtype.kind for n in ("points", "first", "part", "visible")], list("fiib"))

    def test_view_projects(self):
        view = self.drawing.view
        self.assertEqual((view.projection, view.field_of_view), ("perspective", 35))
        # On contours of meshes points and points3 are the same line but for the fairing.
        for layer in self.drawing.layers:
            for path in layer.paths:
                np.testing.assert_allclose(view.project(path.points3), path.points, atol=0.02)
        axes = np.array([view.right, view.up, view.direction])
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-12)

    def test_paths_outlive_the_drawing_and_cannot_be_written(self):
        drawing = burin.draw(mesh_scene(), style="outline")
        points = drawing.layers[0].paths[0].points
        copy = points.copy()
        del drawing
        np.testing.assert_array_equal(points, copy)
        with self.assertRaises(ValueError):
            points[0, 0] = 1

    def test_what_shells_show(self):
        self.assertRegex(repr(self.drawing), r"^<burin.Drawing 210 x 148 mm, \d+ paths>$")
        self.assertRegex(repr(self.drawing.view), r"^<burin.View perspective from \(0.57.*\), scale .*>$")
        scene = burin.Scene()
        self.assertEqual(repr(scene), "<burin.Scene of 0 parts>")
        for name in ("lid", "it's", "c", "d", "e"):
            scene.add_mesh(*cube(), name)
        self.assertEqual(repr(scene), "<burin.Scene of 5 parts: 'lid', \"it's\", 'c', 'd', ...>")
        svg = self.drawing._repr_svg_()
        self.assertEqual(svg.encode(), self.drawing.to_bytes("svg"))

    def test_the_signature_tells_the_keywords(self):
        parameters = inspect.signature(burin.draw).parameters
        for name in ("view", "paper", "set", "tone", "iso", "define", "object", "heal", "id_prefix"):
            self.assertIs(parameters[name].kind, inspect.Parameter.KEYWORD_ONLY)
        self.assertEqual(parameters["view"].default, "iso")

    def test_id_prefix(self):
        drawing = burin.draw(mesh_scene(), style="outline", id_prefix="fig1-")
        self.assertIn(b'id="fig1-outline"', drawing.to_bytes("svg"))
        self.assertIn(b'id="a-outline"', drawing.to_bytes("svg", id_prefix="a-"))
        with self.assertRaisesRegex(burin.UsageError, "argument id_prefix takes"):
            drawing.to_bytes("svg", id_prefix="1")
        with self.assertRaisesRegex(burin.UsageError, "unknown argument 'halo_gap'"):
            drawing.to_bytes("svg", halo_gap=1)

    def test_flat_is_fast(self):
        # Not a time: how many Python objects are made does not depend on the number of paths.
        arrays = self.drawing.arrays()
        self.assertEqual(len(arrays), 15)


class FieldAndTone(unittest.TestCase):
    # A face of the cube, from above, is SIDE mm wide on it.
    SIDE = 100
    SQUARE = (SIDE + 20, SIDE + 20)

    def strokes(self, drawing):
        return [path for layer in drawing.layers for path in layer.paths if path.kind == "stroke"]

    def test_strokes_follow_the_field(self):
        seen = []

        def swirl(positions, normals):
            seen.append(len(positions))
            self.assertEqual(positions.shape, normals.shape)
            np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-9)
            return np.stack([-(positions[:, 1] - 5), positions[:, 0] - 5, 0 * positions[:, 0]], -1)

        drawing = burin.draw(mesh_scene(), view="top", paper=self.SQUARE, style="engraving", field=swirl, set={"hatch.cross_from": 1.1})
        strokes = self.strokes(drawing)
        self.assertGreater(len(strokes), 20)
        self.assertTrue(all(s.field == "own" for s in strokes))
        self.assertLess(len(seen), 100)
        # Circles about the middle of the face: the radius stays along each stroke.
        for stroke in strokes:
            radius = np.hypot(*(stroke.points3[:, :2] - 5).T)
            if radius.min() > 1:
                self.assertLess(np.ptp(radius), 0.05)

    def test_no_strokes_where_the_field_is_none(self):
        def half(positions, normals):
            return np.where(positions[:, :1] < 5, np.nan, [[0.0, 1.0, 0.0]])

        strokes = self.strokes(burin.draw(mesh_scene(), view="top", paper=self.SQUARE, style="engraving", field=half))
        self.assertGreater(len(strokes), 10)
        least = min(s.points3[:, 0].min() for s in strokes)
        scale = self.SIDE / 10
        self.assertGreater(least, 5 - 1 / scale)

    def test_tone_is_darkness(self):
        def stripes(positions, normals):
            return np.where(positions[:, 0] < 5, 0.9, 0.0)

        drawing = burin.draw(mesh_scene(), view="top", paper=self.SQUARE, style="engraving", tone=stripes)
        ink = {True: 0.0, False: 0.0}
        for s in self.strokes(drawing):
            lengths = np.linalg.norm(np.diff(s.points, axis=0), axis=1)
            width = np.broadcast_to(s.width, len(s))
            for x, area in zip(s.points3[:-1, 0], lengths * (width[:-1] + width[1:]) / 2):
                ink[bool(x < 5)] += area
        dark = ink[True] / (self.SIDE**2 / 2)
        self.assertGreater(dark, 0.45)
        self.assertLess(ink[False], 0.02 * ink[True])

    def test_dark_and_light(self):
        areas = []
        for darkness in (0.2, 0.5):
            drawing = burin.draw(mesh_scene(), view="top", paper=self.SQUARE, style="engraving", tone=lambda p, n: np.full(len(p), darkness))
            areas.append(
                sum(
                    np.sum(np.linalg.norm(np.diff(s.points, axis=0), axis=1)) * np.mean(s.width)
                    for s in self.strokes(drawing)
                )
                / self.SIDE**2
            )
        self.assertAlmostEqual(areas[0], 0.2, delta=0.05)
        self.assertAlmostEqual(areas[1], 0.5, delta=0.1)

    def test_same_bytes_for_any_number_of_threads(self):
        def tone(positions, normals):
            return 0.5 + 0.5 * np.sin(positions[:, 0])

        def field(positions, normals):
            return positions[:, [1, 2, 0]]

        one, two = (
            burin.draw(mesh_scene(sphere), style="engraving", paper="A6", tone=tone, field=field, threads=n).to_bytes("json")
            for n in (1, 4)
        )
        self.assertEqual(one, two)

    def test_the_tone_is_asked_in_batches(self):
        """Slivers narrower than a sample, and what stands behind other parts, cost no call a point."""
        calls = []

        def tone(positions, normals):
            calls.append(len(positions))
            return np.full(len(positions), 0.6)

        scene = burin.Scene()
        for i in range(12):  # plates one behind the other, their edges a tenth of a mm wide
            v, t = cube()
            scene.add_mesh(v * [1, 0.01, 1] + [0.1 * i, i, 0.1 * i], t)
        burin.draw(scene, view=(0.05, -1, 0.05), style="engraving", tone=tone)
        self.assertLess(len(calls), 60)
        self.assertGreater(sum(calls), 10000)

    def test_one_point_forms_are_told(self):
        with self.assertRaisesRegex(ValueError, r"tone must give an array of shape \(\d+,\), not \(\)"):
            burin.draw(mesh_scene(), tone=lambda p, n: 0.5)

    def test_errors(self):
        def broken(positions, normals):
            raise ZeroDivisionError("mine")

        for name in ("field", "tone"):
            with self.assertRaisesRegex(ZeroDivisionError, "mine"):
                burin.draw(mesh_scene(), **{name: broken})
            with self.assertRaisesRegex(ValueError, f"{name} must give an array of shape"):
                burin.draw(mesh_scene(), **{name: lambda p, n: np.zeros((len(p), 2))})


if __name__ == "__main__":
    unittest.main()
