"""Functions of a program, and packages, as rows of the kernel's catalogues."""
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

import numpy as np

import burin

ROOT = pathlib.Path(__file__).resolve().parents[2]
VASE = str(ROOT / "samples" / "vase.ply")
SMALL = {"paper": (60, 60), "style": "engraving"}


def codes(drawing):
    return [d.code for d in drawing.diagnostics]


def spin(positions, normals, climb):
    around = np.cross([0, 0, 1], positions - [0, 0, 0])
    return around + climb * np.linalg.norm(around, axis=1)[:, None] * [0, 0, 1]


class Registered(unittest.TestCase):
    def test_a_direction_draws_as_the_same_function_given_to_draw(self):
        burin.register_direction("spin", spin, "round z", {"climb": {"default": 0.25, "low": -9, "high": 9}})
        by_name = burin.draw(VASE, set={"hatch.field": "spin", "hatch.spin.climb": 1}, **SMALL)
        # Beside a direction that asks for no curvature either.
        given = burin.draw(VASE, field=lambda p, n: spin(p, n, 1.0), set={"hatch.field": "fixed"}, **SMALL)
        a, b = by_name.arrays(), given.arrays()
        self.assertGreater(len(a["points"]), 1000)
        np.testing.assert_array_equal(a["points"], b["points"])
        self.assertNotIn("plugin.quarantined", codes(by_name))
        keys = {row["key"]: row for row in burin.style_keys()}
        self.assertEqual(keys["hatch.spin.climb"]["high"], 9)
        self.assertIn("spin", keys["hatch.field"]["words"])
        self.assertIn(("Python", "spin"), {(p["file"], o["name"]) for p in burin.plugins() for o in p["offers"]})
        with self.assertRaisesRegex(burin.UsageError, "takes -9 to 9"):
            burin.draw(VASE, set={"hatch.spin.climb": 10})

    def test_a_name_that_comes_again_is_another_function(self):
        draws = []
        for turn in ([0, 0, 1], [1, 0, 0]):
            burin.register_direction("again", lambda p, n, turn=turn: np.broadcast_to(turn, p.shape))
            draws.append(burin.draw(VASE, set={"hatch.field": "again"}, **SMALL).arrays()["points"])
        self.assertFalse(np.array_equal(*draws))

    def test_a_law_is_darkness(self):
        burin.register_law("half", lambda p, n, dark: np.full(len(p), dark), options={"dark": {"default": 0.5}})
        light, dark = (burin.draw(VASE, set={"tone.law": "half", "tone.half.dark": d}, **SMALL) for d in (0.2, 0.8))
        ink = [float(np.sum(d.arrays()["width"])) for d in (light, dark)]
        self.assertGreater(ink[1], 1.5 * ink[0])

    def test_a_symbol_stands_at_the_end_of_a_note(self):
        def box(text, height, line, wide):
            return {"size": (wide, 2 * height), "lines": [(np.array([[0, 0], [wide, 0], [wide, 2 * height]]), line)],
                    "fills": [([[(0, 0), (1, 0), (0, 1)]], "#ff0000")], "texts": [(1, 1, height, text)]}

        burin.register_symbol("box", box, options={"wide": {"default": 20.0, "low": 5, "high": 50}})
        plan = {"notes": [{"at": "vase", "text": "clay", "symbol": "box", "box_wide": 30}]}
        drawing = burin.draw(VASE, illustration=plan, **SMALL)
        layer = next(layer for layer in drawing.layers if layer.name == "notes")
        self.assertEqual([t["text"] for t in layer.texts], ["clay"])
        self.assertIn("symbol", [a["role"] for a in drawing.areas])
        widest = max(max(x for x, _ in p.points) - min(x for x, _ in p.points) for p in layer.paths if len(p.points) == 3)
        self.assertAlmostEqual(widest, 30, 3)
        burin.register_symbol("box", lambda text, height, line: {"size": (0, 1)})
        self.assertIn("plugin.quarantined", codes(burin.draw(VASE, illustration={"notes": [{"at": "vase", "text": "clay", "symbol": "box"}]}, **SMALL)))

    def test_what_fails_is_left_out_with_a_diagnostic(self):
        def broken(positions, normals):
            raise ValueError("no way\nout")

        burin.register_direction("broken", broken)
        drawing = burin.draw(VASE, set={"hatch.field": "broken"}, **SMALL)
        told = [d.message for d in drawing.diagnostics if d.code == "plugin.quarantined"]
        self.assertEqual(len(told), 1)
        self.assertIn("ValueError: no way", told[0])
        plain = burin.draw(VASE, set={"hatch.field": "fixed-auto"}, **SMALL)
        np.testing.assert_array_equal(drawing.arrays()["points"], plain.arrays()["points"])

        burin.register_law("short", lambda p, n: np.zeros(3))
        self.assertIn("plugin.quarantined", codes(burin.draw(VASE, set={"tone.law": "short"}, **SMALL)))

    def test_a_form_is_an_input(self):
        def ball(radius):
            def values(p):
                return np.linalg.norm(p, axis=1) - radius

            return values, (-radius - 1,) * 3 + (radius + 1,) * 3

        burin.register_form("ball", ball, "a ball", {"radius": {"default": 5.0, "low": 1, "high": 100, "unit": "mm"}})
        part = burin.info("form:ball", ball_radius=8)[0]["parts"][0]
        self.assertAlmostEqual(part["volume"], 4 / 3 * np.pi * 8**3, delta=5)
        drawing = burin.draw("form:ball", ball_radius=8, **SMALL)
        self.assertEqual(drawing.parts[0]["name"], "ball")
        with self.assertRaisesRegex(burin.Error, "form"):
            burin.draw("form:no-such-form")

    def test_a_reader_reads_bytes(self):
        def read(data, scale):
            size = float(data) * scale
            points = size * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
            return [("corner", points, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]))]

        burin.register_reader("corner", [".corner"], read, options={"scale": {"default": 1.0, "low": 0, "high": 10}})
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.corner"
            path.write_text("3")
            part = burin.info(path, corner_scale=2)[0]["parts"][0]
            self.assertAlmostEqual(part["volume"], 6**3 / 6)
            path.write_text("three")
            with self.assertRaisesRegex(burin.InputError, "ValueError"):
                burin.draw(path)
        with self.assertRaisesRegex(burin.UsageError, "reads itself"):
            burin.register_reader("mine", [".stl"], read)

    def test_the_sample_writes_hpgl(self):
        sys.path.insert(0, str(ROOT / "samples" / "plugins"))
        self.addCleanup(sys.path.pop, 0)
        import hpgl

        hpgl.register()
        drawing = burin.draw(VASE, paper=(60, 60), style="plotter")
        text = drawing.to_bytes("plt", plt_pen=3).decode()
        visible = sum(path.visible for layer in drawing.layers for path in layer.paths)
        self.assertEqual(text.count("PD"), visible)
        self.assertIn("SP3;", text)
        self.assertTrue(all(line.endswith(";") for line in text.splitlines()))
        self.assertIn("plt", burin.formats())

        burin.register_writer("nul", lambda drawing: b"")
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(burin.OutputError, "writes nothing"):
                drawing.save(pathlib.Path(folder) / "a.nul")
            self.assertEqual(os.listdir(folder), [])

    def test_names_of_our_own_are_not_given_away(self):
        for register in (burin.register_direction, burin.register_law):
            with self.assertRaisesRegex(burin.UsageError, "taken|made of"):
                register("smoothed" if register is burin.register_direction else "lambert", spin)
            with self.assertRaisesRegex(burin.UsageError, "made of a-z"):
                register("Two Words", spin)
        with self.assertRaisesRegex(burin.UsageError, "writes .svg itself"):
            burin.register_writer("svg", str)
        with self.assertRaises(TypeError):
            burin.register_law("none", 3)
        with self.assertRaisesRegex(burin.UsageError, "option 'a'"):
            burin.register_law("none", spin, options={"a": {"low": 1}})


class Packages(unittest.TestCase):
    def test_an_entry_point_is_asked_once_and_one_that_fails_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "stripes.py").write_text(textwrap.dedent("""
                import burin, numpy
                def register():
                    burin.register_law("stripes", lambda p, n: 0.5 + 0.4 * numpy.sin(p[:, 2]))
                def fail():
                    raise RuntimeError("not today")
                """))
            meta = root / "stripes-1.dist-info"
            meta.mkdir()
            (meta / "METADATA").write_text("Metadata-Version: 2.1\nName: stripes\nVersion: 1\n")
            (meta / "entry_points.txt").write_text("[burin.plugins]\ngood = stripes:register\nbad = stripes:fail\n")
            code = textwrap.dedent("""
                import burin
                print([p["refused"] for p in burin.plugins() if p["refused"]])
                print([o["name"] for p in burin.plugins() for o in p["offers"]])
                """)
            path = os.pathsep.join([folder, *sys.path])
            said = subprocess.run([sys.executable, "-c", code], env=dict(os.environ, PYTHONPATH=path),
                                  capture_output=True, text=True, check=True).stdout
        self.assertIn("RuntimeError: not today", said)
        self.assertIn("stripes", said.splitlines()[1])


if __name__ == "__main__":
    unittest.main()
