"""Threads of the holes of bodies."""

import math

import FreeCAD as App
import Part
from support import Case, V, drawn


class Threads(Case):
    def plate(self, **placement):
        """60 x 40 x 20, with a threaded hole of M6 all through and one of M10, 14 deep with a thread of 10."""
        body = self.doc.addObject("PartDesign::Body", "Body")
        for name, value in placement.items():
            setattr(body, name, value)
        box = self.doc.addObject("PartDesign::AdditiveBox", "Block")
        body.addObject(box)
        box.Length, box.Width, box.Height = 60, 40, 20
        self.doc.recompute()
        self.hole(body, box, 15, ThreadSize="M6", DepthType="ThroughAll")
        self.hole(body, box, 42, ThreadSize="M10", DepthType="Dimension", Depth=14, ThreadDepthType="Dimension", ThreadDepth=10)
        return body

    def hole(self, body, box, x, **keys):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        body.addObject(sketch)
        attached = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
        setattr(sketch, attached, (box, ["Face6"]))
        sketch.MapMode = "FlatFace"
        sketch.addGeometry(Part.Circle(V(x, 20, 0), V(0, 0, 1), 3), False)
        self.doc.recompute()
        hole = self.doc.addObject("PartDesign::Hole", "Hole")
        body.addObject(hole)
        hole.Profile = sketch
        for key, value in dict(Threaded=True, ThreadType="ISOMetricProfile", **keys).items():
            setattr(hole, key, value)
            self.doc.recompute()
        return hole

    def lines(self, obj):
        return [p for layer in drawn(obj).layers if layer.name == "thread" for p in layer.paths if p.visible]

    def test_arcs_of_threaded_holes_from_above(self):
        obj = self.illustration(self.plate(), ViewDirection=V(0, 0, 1), Style="outline")
        arcs = self.lines(obj)
        self.assertEqual(len(arcs), 2)
        for arc in arcs:
            x, y, z = arc.points3[0]
            middle, radius = (15, 3) if x < 30 else (42, 5)
            self.assertAlmostEqual(math.hypot(x - middle, y - 20), radius, 5)
            self.assertAlmostEqual(z, 20, 5)

    def test_threads_go_with_the_body(self):
        turned = App.Placement(V(100, 0, 0), App.Rotation(V(0, 0, 1), 90))
        obj = self.illustration(self.plate(Placement=turned), ViewDirection=V(0, 0, 1), Style="outline")
        arcs = self.lines(obj)
        self.assertEqual(len(arcs), 2)
        for arc in arcs:
            x, y, _ = arc.points3[0]
            middle, radius = (15, 3) if y < 30 else (42, 5)  # (x, y) of the body is at (100 - y, x)
            self.assertAlmostEqual(math.hypot(x - 80, y - middle), radius, 5)

    def test_patterns_repeat_them(self):
        from freecad.burin_wb.features.threads import threads_of

        body = self.plate()
        hole = body.Tip

        def pattern(kind, **keys):
            made = self.doc.addObject("PartDesign::" + kind, kind)
            body.addObject(made)
            made.Originals = [hole]
            for key, value in keys.items():
                setattr(made, key, value)
            body.Tip = made
            self.doc.recompute()
            return [t["at"] for t in threads_of(body, App.Matrix())]

        sketch = hole.Profile[0]
        at = pattern("LinearPattern", Direction=(sketch, ["H_Axis"]), Reversed=True, Length=24, Occurrences=3)
        self.assertEqual(sorted(round(p[0], 6) for p in at), [15, 18, 30, 42])
        at = pattern("Mirrored", MirrorPlane=(self.doc.Block, ["Face1"]))  # x = 0
        self.assertIn(-42, [round(p[0], 6) for p in at])
        self.assertEqual(len(at), 5)
        at = pattern("PolarPattern", Axis=(sketch, ["N_Axis"]), Angle=360, Occurrences=4)
        self.assertEqual(len(at), 8)

    def test_a_key_turns_them_off(self):
        obj = self.illustration(self.plate(), ViewDirection=V(0, 0, 1), Style="outline", StyleKeys={"feature.threads": "false"})
        self.assertEqual(self.lines(obj), [])

    def test_modelled_threads_are_left_alone(self):
        body = self.plate()
        from freecad.burin_wb.features.threads import threads_of

        self.assertEqual(len(threads_of(body, App.Matrix())), 2)
        body.Tip.Threaded = False
        self.assertEqual(len(threads_of(body, App.Matrix())), 1)
