"""Files: written whole or not at all, read back as they were."""

import os
import pickle
import tempfile
import unittest
from pathlib import Path

import burin
import numpy as np
from support import cube


class Save(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scene = burin.Scene()
        scene.add_mesh(*cube(), "cube", assembly=["top"], color="#ffcc00")
        cls.drawing = burin.draw(scene, style="engraving", paper="A6", hidden="dashed")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_each_format(self):
        self.assertTrue({"svg", "json"} <= set(burin.formats()))
        for suffix in burin.formats():
            path = self.folder / f"a.{suffix}"
            self.drawing.save(path)
            self.assertGreater(path.stat().st_size, 500)
            self.assertGreater(len(self.drawing.to_bytes(suffix)), 500)
        self.assertEqual((self.folder / "a.svg").read_bytes(), self.drawing.to_bytes("SVG"))

    def test_options(self):
        plain = self.drawing.to_bytes("svg")
        flat = self.drawing.to_bytes("svg", svg_flatten=True)
        self.assertNotEqual(plain, flat)
        self.assertIn(b"<polyline", flat)
        self.assertNotIn(b"<polyline", plain)
        self.assertEqual(plain, self.drawing.to_bytes("svg"))
        self.assertNotIn(b"points3", self.drawing.to_bytes("json", json_points3=False))
        with self.assertRaisesRegex(burin.UsageError, "'svg_flat'.*'svg_flatten'"):
            self.drawing.to_bytes("svg", svg_flat=True)
        with self.assertRaises(burin.UsageError):
            self.drawing.to_bytes("svg", hatch_enabled=False)
        with self.assertRaisesRegex(burin.UsageError, "argument format takes"):
            self.drawing.to_bytes("bmp")

    def test_whole_or_not_at_all(self):
        path = self.folder / "a.svg"
        path.write_text("what was there")
        with self.assertRaises(burin.UsageError):
            self.drawing.save(path, svg_fit_tolerance=100)
        self.assertEqual(path.read_text(), "what was there")
        self.drawing.save(path)
        self.assertTrue(path.read_text().endswith("</svg>\n"))
        self.assertEqual(os.listdir(self.folder), ["a.svg"])

    def test_what_cannot_be_written(self):
        with self.assertRaises(burin.OutputError) as caught:
            self.drawing.save(self.folder / "nowhere" / "a.svg")
        self.assertEqual(caught.exception.file, str(self.folder / "nowhere" / "a.svg"))
        with self.assertRaises(OSError):
            self.drawing.save("/dev/full/a.svg")
        for name in ("a.bmp", "a", ""):
            with self.assertRaises(burin.UsageError):
                self.drawing.save(self.folder / name if name else "")

    def test_names_that_are_no_utf8(self):
        path = os.fsencode(self.folder) + b"/\xff.json"
        self.drawing.save(path)
        self.assertEqual(os.listdir(os.fsencode(self.folder)), [b"\xff.json"])

    @unittest.skipUnless(hasattr(burin.Drawing, "load"), "no reader of drawings yet")
    def test_round_trip(self):
        path = self.folder / "a.json"
        self.drawing.save(path)
        again = burin.Drawing.load(path)
        self.assertEqual(again.to_bytes("json"), path.read_bytes())
        self.assertEqual(again.parts, self.drawing.parts)
        self.assertEqual(again.paper, self.drawing.paper)
        ours, theirs = self.drawing.arrays(), again.arrays()
        for name in ("first", "layer", "kind", "part", "face", "edge", "family", "visible", "closed"):
            np.testing.assert_array_equal(ours[name], theirs[name])
        np.testing.assert_allclose(ours["points"], theirs["points"], atol=1e-4)
        self.assertEqual(again.layers[0].name, self.drawing.layers[0].name)

    @unittest.skipUnless(hasattr(burin.Drawing, "load"), "no reader of drawings yet")
    def test_text_and_pickle(self):
        text = self.drawing.to_bytes("json")
        for given in (text, text.decode()):
            self.assertEqual(burin.Drawing.from_json(given).to_bytes("json"), text)
        self.assertEqual(pickle.loads(pickle.dumps(self.drawing)).to_bytes("json"), text)
        with self.assertRaises(burin.InputError) as caught:
            burin.Drawing.from_json(b'{"format":\n "burin-drawing", oops')
        self.assertEqual(caught.exception.line, 2)
        with self.assertRaises(burin.InputError) as caught:
            burin.Drawing.load(self.folder / "nowhere.json")
        self.assertEqual(caught.exception.file, str(self.folder / "nowhere.json"))


if __name__ == "__main__":
    unittest.main()
