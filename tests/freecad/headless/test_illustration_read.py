"""Illustration files made into illustrations of a document: the same settings, and a word for all that has no place."""

import json
import os
import unittest.mock

import Part

from support import V, App, Case, content

from freecad.burin_wb import illustration_file, illustration_read
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
                                StyleKeys={"line.outer": "0.8", "hatch.taper": "1"}, Tolerance=0.05,
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

