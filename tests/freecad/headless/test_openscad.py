"""Objects of FreeCAD's OpenSCAD workbench draw as what they are: their shapes, names and colours."""

import os
import unittest

from support import Case, drawn

try:
    import importCSG
except ImportError:  # a FreeCAD without the workbench, or without python3-ply
    importCSG = None

TREE = """
group() {
\tcolor([1, 0, 0, 1]) {
\t\tdifference() {
\t\t\tcube(size = [20, 20, 10], center = false);
\t\t\tmultmatrix([[1, 0, 0, 10], [0, 1, 0, 10], [0, 0, 1, 0], [0, 0, 0, 1]]) {
\t\t\t\tcylinder($fn = 0, $fa = 12, $fs = 2, h = 30, r1 = 4, r2 = 4, center = true);
\t\t\t}
\t\t}
\t}
\tmultmatrix([[1, 0, 0, 40], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {
\t\tsphere($fn = 0, $fa = 12, $fs = 2, r = 8);
\t}
\tlinear_extrude(height = 5, center = false, convexity = 1, scale = [1, 1], $fn = 0, $fa = 12, $fs = 2) {
\t\tpolygon(points = [[0, 40], [20, 40], [10, 60]], paths = undef, convexity = 1);
\t}
}
"""


@unittest.skipUnless(importCSG, "the OpenSCAD workbench is not there")
class OpenScad(Case):
    def imported(self):
        path = os.path.join(self.folder, "tree.csg")
        with open(path, "w") as file:
            file.write(TREE)
        importCSG.insert(path, self.doc.Name)
        self.doc.recompute()
        return [obj for obj in self.doc.Objects if not obj.InList and getattr(obj, "Shape", None) and not obj.Shape.isNull()]

    def test_what_it_makes_is_drawn_whole(self):
        roots = self.imported()
        self.assertTrue(roots)
        solids = sum(len(root.Shape.Solids) for root in roots)
        self.assertEqual(solids, 3)
        obj = self.illustration(*roots, Style="outline")
        self.assertEqual(obj.Message, "")
        drawing = drawn(obj)
        kinds = {path.kind for layer in drawing.layers for path in layer.paths}
        # The ball and the bore are round, so they have contours; the box has edges.
        self.assertTrue({"contour", "crease"} <= kinds, kinds)
        names = [part["name"] for part in drawing.parts]
        self.assertEqual(len(names), len(set(names)))

    def test_a_change_of_the_tree_is_followed(self):
        roots = self.imported()
        obj = self.illustration(*roots, Style="outline")
        before = obj.Drawing
        cube = next(o for o in self.doc.Objects if o.TypeId == "Part::Box")
        cube.Height = 25
        self.doc.recompute()
        self.assertNotEqual(obj.Drawing, before)
