"""What has changed between two revisions: kernel/docs/changes.md."""

import json
import tempfile
import unittest
from pathlib import Path

import burin
from support import SAMPLES, cube


def scene(**parts):
    """Cubes by name: (side, corner)."""
    made = burin.Scene()
    for name, (side, corner) in parts.items():
        vertices, triangles = cube(side)
        made.add_mesh(vertices + corner, triangles, name=name)
    return made


class Models(unittest.TestCase):
    def test_a_model_is_the_same_as_itself(self):
        difference = burin.diff(SAMPLES / "coupling.step", SAMPLES / "coupling.step", style="outline")
        self.assertTrue(difference.same)
        self.assertEqual({part["change"] for part in difference.parts}, {"same"})
        self.assertEqual(difference.counts["same"], len(difference.parts))
        self.assertEqual(difference.lines, [])

    def test_changes_by_name(self):
        old = scene(base=(20, (0, 0, 0)), pin=(5, (30, 0, 0)), gone=(6, (60, 0, 0)), lid=(7, (0, 40, 0)))
        new = scene(base=(20, (0, 0, 0)), pin=(5, (30, 0, 9)), more=(3, (0, 0, 50)), lid=(8, (0, 40, 0)))
        difference = burin.diff(old, new, style="outline", view="iso")
        self.assertFalse(difference.same)
        found = {part["new"] or part["old"]: part["change"] for part in difference.parts}
        self.assertEqual(found, {"base": "same", "pin": "moved", "gone": "removed", "more": "added", "lid": "changed"})
        by_name = {part["new"]: part for part in difference.parts}
        self.assertAlmostEqual(by_name["pin"]["moved"]["distance"], 9)
        self.assertEqual(by_name["pin"]["moved"]["degrees"], 0)
        self.assertAlmostEqual(by_name["lid"]["volume"][0], 343)
        self.assertAlmostEqual(by_name["lid"]["volume"][1], 512)
        self.assertEqual(len(old.parts), 4)
        layers = {layer.name: layer for layer in difference.drawing.layers}
        self.assertEqual(layers["removed-outline"].color, "#d00000")
        self.assertEqual(layers["removed-outline"].dashes, [2, 1])
        self.assertEqual(layers["added-outline"].color, "#00802b")
        self.assertIn("moved-arrows", layers)
        items = difference.drawing.items
        self.assertEqual([item["number"] for item in items], [part["item"] for part in difference.parts])
        self.assertIn("removed  gone", str(difference))
        self.assertIn("1 moved", repr(difference))

    def test_files(self):
        difference = burin.diff(scene(a=(5, (0, 0, 0))), scene(a=(6, (0, 0, 0))), style="outline")
        with tempfile.TemporaryDirectory() as folder:
            names = [Path(folder, name) for name in ("d.svg", "d.json", "d.html", "d.drawing.json", "d.pdf")]
            difference.save(*names)
            self.assertEqual(json.loads(names[1].read_text()), json.loads(difference.to_json()))
            self.assertTrue(burin.Drawing.load(names[3]).layers)
            with self.assertRaises(burin.UsageError):
                difference.save(Path(folder, "d.txt"))
        with self.assertRaises(burin.UsageError):
            difference.save()

    def test_errors(self):
        one = scene(a=(5, (0, 0, 0)))
        with self.assertRaisesRegex(burin.UsageError, "argument callouts is not for two revisions"):
            burin.diff(one, one, callouts=True)
        with self.assertRaises(burin.MissingFile):
            burin.diff(SAMPLES / "coupling.step", SAMPLES / "none.step")
        with self.assertRaisesRegex(burin.UsageError, "nearest"):
            burin.diff(one, one, vieww="top")
        cancel = burin.Cancel()
        cancel.cancel()
        with self.assertRaises(burin.Cancelled):
            burin.diff(one, one, cancel=cancel)


class Drawings(unittest.TestCase):
    def test_lines(self):
        asked = {"style": "outline", "view": "front", "scale": 2, "center": (10, 10, 10)}
        old = burin.draw(scene(a=(10, (0, 0, 0)), b=(5, (20, 0, 0))), **asked)
        new = burin.draw(scene(a=(10, (0, 0, 0)), c=(6, (30, 0, 0))), **asked)
        self.assertTrue(burin.diff(old, old).same)
        difference = burin.diff(old, new)
        self.assertFalse(difference.same)
        self.assertEqual(difference.parts, [])
        by_change = {}
        for line in difference.lines:
            by_change.setdefault(line["change"], set()).add(line["part"])
        self.assertEqual(by_change, {"new": {"c"}, "gone": {"b"}})
        with self.assertRaisesRegex(burin.UsageError, "compare a drawing with a drawing"):
            burin.diff(old, SAMPLES / "bracket.off")
        with self.assertRaisesRegex(burin.UsageError, "line by line"):
            burin.diff(old, new, view="top")


if __name__ == "__main__":
    unittest.main()
