"""Dimensions of illustrations: what features have, what is written, what follows the model, what is told."""

import json
import math
import os

import Part
from pump import pump
from support import V, Case, burin, content

from freecad.burin_wb import features, illustration_file, step_book
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import make_dimension
from freecad.burin_wb.features.asking import steps_job
from freecad.burin_wb.features.dimension import dimensions_of, illustrations_of, tolerance_of, tolerance_text
from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.features.measured import kind_of, may_have
from freecad.burin_wb.features.properties import DIMENSION, READ_ONLY


def facing(obj, normal):
    """The name of the flat face that looks that way and lies farthest there."""
    flat = [(face.CenterOfMass.dot(normal), f"Face{k}") for k, face in enumerate(obj.Shape.Faces, 1)
            if face.findPlane() is not None and face.normalAt(0, 0).dot(normal) > 0.999]
    return max(flat)[1]


def round_one(obj, radius, kind="Faces"):
    """The name of the first round face or edge of a radius."""
    for k, element in enumerate(getattr(obj.Shape, kind), 1):
        if getattr(element.Surface if kind == "Faces" else element.Curve, "Radius", 0) == radius:
            return f"{kind[:-1]}{k}"
    raise ValueError(radius)


class Dimensions(Case):
    def setUp(self):
        super().setUp()
        self.part = self.solid(Part.makeBox(60, 40, 10).cut(Part.makeCylinder(5, 30, V(20, 20, -5))), "Plate")

    def sheet(self, **properties):
        return self.illustration(self.part, **{"Style": "outline", "Width": 297, "Height": 210, "Margin": 10, "Views": ["front", "top"], **properties})

    def add(self, obj, *subs, **more):
        made = make_dimension(obj, [(self.part, sub) for sub in subs], **more)
        self.doc.recompute()
        return made

    def numbers(self, obj):
        return [text["text"] for layer in json.loads(content(obj.Drawing))["layers"] for text in layer.get("texts", ()) if text["role"] == "dimension"]

    def test_two_faces_a_hole_and_overall(self):
        obj = self.sheet()
        self.assertEqual((list(obj.Dimensions), "illustration" in make_job(obj).options and "dimensions" in make_job(obj).options["illustration"]),
                         ([], False))
        height = self.add(obj, facing(self.part, V(0, 0, 1)), facing(self.part, V(0, 0, -1)), Tolerance="+0.1/0")
        hole = self.add(obj, round_one(self.part, 5), Tolerance="H7", View="top")
        self.assertEqual([(one.Kind, one.Label) for one in obj.Dimensions], [("Distance", "Distance"), ("Diameter", "Diameter")])
        self.assertEqual(obj.Message, "")
        self.assertEqual(sorted(self.numbers(obj)), sorted(["10", "+0.1", "0", "⌀10 H7"]))
        self.add(obj)
        self.assertEqual(obj.Dimensions[2].Kind, "Overall")
        self.assertEqual(sorted(self.numbers(obj)), sorted(["10", "+0.1", "0", "⌀10 H7", "60", "40", "10"]))
        with self.assertRaisesRegex(Refused, "^Illustration has its overall dimensions already"):
            make_dimension(obj)
        height.Text, hole.Decimals, hole.Tolerance = "t = {value}", 1, ""
        self.doc.recompute()
        self.assertIn("t = 10", self.numbers(obj))
        self.assertEqual([illustrations_of(one) for one in (height, hole)], [[obj], [obj]])

    def test_it_follows_the_model(self):
        box = self.box(60, 40, 10)
        obj = self.illustration(box, Style="outline", Views=["front"])
        make_dimension(obj, [(box, facing(box, V(0, 0, 1))), (box, facing(box, V(0, 0, -1)))])
        make_dimension(obj, [(box, "Vertex1"), (box, "Vertex2")])
        self.doc.recompute()
        self.assertEqual(self.numbers(obj), ["10", "10"])
        box.Height = 12.5
        self.doc.recompute()
        self.assertEqual(self.numbers(obj), ["12.5", "12.5"])

    def test_saved_and_opened_it_is_as_it_was(self):
        obj = self.sheet()
        self.add(obj, round_one(self.part, 5), Tolerance="H7", Decimals=2)
        kept = content(obj.Drawing)
        obj = self.reopen(obj)
        self.part = self.doc.Plate
        one, = dimensions_of(obj)
        self.assertEqual((one.Kind, one.Tolerance, one.Decimals, one.Features), ("Diameter", "H7", 2, [(self.part, (round_one(self.part, 5),))]))
        self.assertEqual(type(one.Proxy).__module__, "freecad.burin_wb.features")
        self.redraw(obj)
        self.assertEqual((obj.Message, content(obj.Drawing)), ("", kept))
        one.Tolerance = "H8"
        self.doc.recompute()
        self.assertEqual(self.numbers(obj), ["⌀10 H8"])

    def test_deleted_and_undone(self):
        self.doc.UndoMode = 1
        obj = self.sheet()
        self.doc.openTransaction("add")
        one = self.add(obj, round_one(self.part, 5))
        self.doc.commitTransaction()
        self.assertEqual(self.numbers(obj), ["⌀10"])
        self.doc.openTransaction("delete")
        self.doc.removeObject(one.Name)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertEqual((list(obj.Dimensions), self.numbers(obj)), ([], []))
        self.doc.undo()
        self.redraw(obj)
        self.assertEqual(([one.Kind for one in dimensions_of(obj)], self.numbers(obj)), (["Diameter"], ["⌀10"]))
        self.doc.undo()
        self.redraw(obj)
        self.assertEqual((list(obj.Dimensions), self.numbers(obj)), ([], []))

    def test_what_is_gone_is_told_and_the_others_are_drawn(self):
        obj = self.sheet()
        hole, height = round_one(self.part, 5), (facing(self.part, V(0, 0, 1)), facing(self.part, V(0, 0, -1)))
        lost, kept = self.add(obj, "Face7"), self.add(obj, *height)
        self.assertEqual(hole, "Face7")
        self.part.Shape = Part.makeBox(60, 40, 8)
        kept.Features = [(self.part, (facing(self.part, V(0, 0, 1)), facing(self.part, V(0, 0, -1))))]
        self.doc.recompute()
        self.assertEqual(lost.Message, "Plate.Face7 is gone; choose its Features again, or delete it")
        self.assertEqual((kept.Message, lost.State), ("", ["Up-to-date"]))
        self.assertEqual(obj.Message, "Diameter: Plate.Face7 is gone; choose its Features again, or delete it")
        self.assertEqual(self.numbers(obj), ["8"])
        drawing = obj.Drawing
        self.doc.removeObject(lost.Name)
        self.doc.recompute()
        self.assertEqual((obj.Message, obj.Drawing), ("", drawing), "nothing is drawn anew, and nothing left out")
        lost = kept
        self.doc.removeObject("Plate")
        self.doc.recompute()
        self.assertRegex(lost.Message, "^its features are gone; choose its Features again")

    def test_what_no_longer_fits_is_told(self):
        obj = self.sheet()
        one = self.add(obj, facing(self.part, V(0, 0, 1)), facing(self.part, V(0, 0, -1)))
        one.Features = [(self.part, (facing(self.part, V(0, 0, 1)), facing(self.part, V(1, 0, 0))))]
        self.doc.recompute()
        self.assertEqual(obj.Message, "Distance: its features have Kind Angle, not Distance; change Kind, or choose its Features again")
        one.Kind = "Angle"
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["90°"]))
        for kind, words in (("Diameter", "needs one round face or edge"), ("Thread", "needs one round face or edge")):
            one.Kind = kind
            self.doc.recompute()
            self.assertIn(words, one.Message)
        one.Features = [(self.part, (round_one(self.part, 5),))]
        self.doc.recompute()
        self.assertRegex(one.Message, "^a thread needs Text")
        one.Text = "M10"
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["M10"]))
        one.Kind, one.Text = "Distance", ""
        self.doc.recompute()
        self.assertRegex(one.Message, "^Kind Distance needs two faces, edges or vertices")
        obj.Looks = {"Plate": "not drawn"}
        one.Kind = "Diameter"
        self.doc.recompute()
        self.assertIn("Distance: Plate is not drawn here; add it to Sources, or choose other Features", make_job(obj).notes)

    def test_the_kernels_words_name_the_dimension(self):
        obj = self.sheet(Views=["front"])
        one = self.add(obj, facing(self.part, V(0, 1, 0)), facing(self.part, V(0, -1, 0)), Label="Depth of the plate")
        self.add(obj, facing(self.part, V(1, 0, 0)), facing(self.part, V(-1, 0, 0)))
        self.assertRegex(obj.Message, "^Depth of the plate is not drawn: no view of the sheet shows it as it is")
        one.View = "top"
        self.doc.recompute()
        self.assertRegex(obj.Message, "^Depth of the plate is not drawn: no view is called 'top'")

    def test_in_assemblies_that_move_and_in_bodies(self):
        part = pump(self.doc)
        part.Placement.Base = V(100, 0, 0)
        self.doc.recompute()
        obj = self.illustration(part, Style="outline", Views=["front"])
        plate, lid = self.doc.Plate001, self.doc.Lid
        one = make_dimension(obj, [(plate, facing(plate, V(0, 0, -1))), (lid, facing(lid, V(0, 0, 1)))])
        self.doc.recompute()
        self.assertEqual([(top, sub) for top, sub in one.Features], [(part, (f"Plate001.{facing(plate, V(0, 0, -1))}", f"Lid.{facing(lid, V(0, 0, 1))}"))])
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["16"]))
        body = self.doc.addObject("PartDesign::Body", "Body")
        box = body.newObject("PartDesign::AdditiveBox", "Step")
        box.Length, box.Width, box.Height = 30, 20, 7
        self.doc.recompute()
        obj = self.illustration(body, Style="outline", Views=["front"])
        for feature, way in (("Step.", V(1, 0, 0)), ("", V(0, 0, 1))):
            make_dimension(obj, [(body, feature + facing(body, way)), (body, feature + facing(body, -way))])
        self.doc.recompute()
        self.assertEqual((obj.Message, sorted(self.numbers(obj))), ("", ["30", "7"]))

    def test_what_features_have(self):
        box, hole = Part.makeBox(10, 20, 30), Part.makeCylinder(4, 9)
        turned = Part.makeBox(10, 20, 30)
        turned.rotate(V(), V(0, 1, 0), 30)
        x, z = (sorted((f for f in box.Faces if abs(f.normalAt(0, 0).dot(axis)) > 0.9), key=lambda f: -f.CenterOfMass.Length)
                for axis in (V(1, 0, 0), V(0, 0, 1)))
        quarter = Part.makeCylinder(4, 9, V(), V(0, 0, 1), 90)
        lines = box.Edges
        along_x = [e for e in lines if e.BoundBox.XLength > 9]
        along_z = [e for e in lines if e.BoundBox.ZLength > 9]
        skew = next(e for e in along_z if e.distToShape(along_x[0])[0] > 1)
        met = next(e for e in along_z if e.distToShape(along_x[0])[0] < 1e-9)
        axis = [f for f in hole.Faces if f.findPlane() is None]
        self.assertEqual(len(axis), 1)
        ball, ring, cone = Part.makeSphere(5).Faces[0], Part.makeTorus(10, 2).Faces[0], Part.makeCone(5, 3, 8).Faces[0]
        for shapes, kind in (([], "Overall"), (x, "Distance"), ([x[0], z[0]], "Angle"), ([x[0], turned.Faces[0]], "Angle"), (axis, "Diameter"),
                             ([hole.Edges[0]], "Diameter"), ([quarter.Faces[0]], "Radius"), ([ball], "Diameter"), ([ring], "Radius"), ([cone], "Diameter"),
                             ([lines[0]], "Distance"), ([along_x[0], along_x[1]], "Distance"), ([along_x[0], skew], "Distance"),
                             ([along_x[0], met], "Angle"), ([axis[0], x[0]], "Distance"), ([axis[0], z[0]], "Angle"), (box.Vertexes[:2], "Distance"),
                             ([Part.Vertex(3, 4, 5), x[1]], "Distance"), ([ball, x[0]], "Distance")):
            self.assertEqual(kind_of(shapes), (kind, ""), [s.ShapeType for s in shapes])
        spline = Part.BSplineCurve([V(0, 0, 0), V(1, 2, 0), V(3, 1, 0), V(5, 5, 0)]).toShape()
        for shapes, words in (([x[0]], "a flat face alone"), ([box.Vertexes[0]], "a vertex alone"), (lines[:3], "one or two faces, edges or vertices; 3 are"),
                              ([spline], "neither flat nor straight nor round"), ([spline, x[0]], "one of both is neither"),
                              ([axis[0], axis[0]], "at one place"), ([box.Vertexes[0]] * 2, "at one place"), ([x[0], x[0]], "at one place")):
            kind, why = kind_of(shapes)
            self.assertEqual(kind, "")
            self.assertIn(words, why)

    def test_kinds_that_round_ones_may_have(self):
        bored = Part.makeBox(10, 20, 30).cut(Part.makeCylinder(4, 9, V(5, 10, -1)))
        hole = next(face for face in bored.Faces if face.findPlane() is None)
        rim = next(edge for edge in hole.Edges if isinstance(edge.Curve, Part.Circle))
        ball, ring, cone = Part.makeSphere(5).Faces[0], Part.makeTorus(10, 2).Faces[0], Part.makeCone(5, 3, 8).Faces[0]
        kinds = ("Diameter", "Radius", "Depth", "Thread")
        for shape, may in ((hole, kinds), (rim, ("Diameter", "Radius", "Thread")), (ball, ("Diameter", "Radius")), (ring, ("Radius",)),
                           (cone, ("Diameter", "Depth", "Thread")), (bored.Faces[0], ()), (bored.Edges[0], ()), (bored.Vertexes[0], ())):
            self.assertEqual(tuple(kind for kind in kinds if may_have(kind, shape)), may, shape.ShapeType)

    def test_the_kernel_measures_what_is_said_to_be_there(self):
        """That the kinds that are found are those that the kernel takes: on all pairs of a part with slopes and holes."""
        wedge = Part.makeBox(60, 40, 30).cut(Part.makeCylinder(5, 80, V(20, 20, -5))).cut(Part.makeCylinder(4, 80, V(45, -5, 12), V(0, 1, 0)))
        wedge = wedge.cut(Part.makeBox(80, 80, 80, V(30, -10, 40), V(math.sin(0.5), 0, math.cos(0.5))))
        self.part.Shape = wedge
        obj = self.sheet()
        elements = [f"Face{k}" for k in range(1, len(wedge.Faces) + 1)] + ["Edge1", "Edge7", "Vertex1"]
        for k, one in enumerate(elements):
            for other in (None, *elements[k + 1:]):
                try:
                    make_dimension(obj, [(self.part, sub) for sub in ([one] if other is None else [one, other])])
                except Refused:
                    pass
        made = dimensions_of(obj)
        self.assertGreater(len(made), 40)
        self.doc.recompute()
        self.assertFalse([one.Message for one in made if one.Message])
        self.assertRegex(obj.Message, "^the sheet has no room for the views with their dimensions", "which is looked at when all are measured")

    def test_refused_and_nothing_is_made(self):
        obj = self.sheet()
        other = self.box(name="Other")
        self.doc.recompute()
        for features_, words in (([(other, "Face1"), (other, "Face2")], "^Other is not drawn here"), ([(self.part, "Face1")], "^a flat face alone"),
                                 ([(self.part, "Face99")], "^Plate.Face99 is gone"), ([(self.part, "")], "^Plate is gone"),
                                 ([(self.part, "Facet3")], "^Plate.Facet3 is gone"), ([(self.part, "?Face7")], "^Plate.Face7 is gone")):
            with self.assertRaisesRegex(Refused, words):
                make_dimension(obj, features_)
        self.assertEqual((list(obj.Dimensions), [o for o in self.doc.Objects if o.Name.startswith("Dimension")]), ([], []))

    def test_tolerances(self):
        for text, said in (("H7", "H7"), ("0.1", "±0.1"), ("±0.1", "±0.1"), ("+0.1/-0.2", ["+0.1", "-0.2"]), (" +0.1 ; 0 ", ["+0.1", "0"]), ("", ""),
                           ("H7/g6", "H7/g6")):
            self.assertEqual(tolerance_of(text), said)
        self.assertEqual([tolerance_text(said) for said in ("H7", ["+0.1", 0], [0.1, -0.2], 0.1)], ["H7", "+0.1/+0", "+0.1/-0.2", "0.1"])

    def test_in_illustration_files_both_ways(self):
        obj = self.sheet()
        self.add(obj)
        self.add(obj, round_one(self.part, 5), Tolerance="H7", Decimals=1, View="top")
        self.add(obj, facing(self.part, V(0, 0, 1)), facing(self.part, V(0, 0, -1)), Tolerance="+0.1/-0.2", Text="t = {value}")
        self.add(obj, "Vertex1", "Vertex3", Along=V(0, 1, 0))
        self.add(obj, facing(self.part, V(0, 0, 1)), facing(self.part, V(1, 0, 0)), Supplement=True)
        path = os.path.join(self.folder, "plate.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.assertEqual(data["dimensions"][:2], ["overall", {"diameter": {"part": "/Plate", "face": int(round_one(self.part, 5)[4:]) - 1}, "decimals": 1,
                                                              "tolerance": "H7", "view": "top"}])
        kernels = [text["text"] for layer in json.loads(burin().draw(path).to_bytes("json"))["layers"] for text in layer.get("texts", ())]
        for number in self.numbers(obj):
            self.assertIn(number, kernels)
        read_ = illustration_file.read(self.doc, path)
        self.assertEqual([(one.Kind, one.Features, one.Tolerance, one.Text, one.View, one.Decimals) for one in dimensions_of(read_)],
                         [(one.Kind, one.Features, one.Tolerance, one.Text, one.View, one.Decimals) for one in dimensions_of(obj)])
        self.assertEqual(make_job(read_).fingerprint(), make_job(obj).fingerprint())

    def test_files_of_others_that_name_by_points(self):
        path = os.path.join(self.folder, "by-hand.burin.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"burin": "illustration", "parts": [{"file": "plate.step", "name": "Plate"}], "views": ["top"], "dimensions": [
                {"diameter": [25, 20, 5], "unit": "inch"}, {"distance": [{"edge": [30, 0, 10]}, {"point": [0, 40, 0]}]}, {"radius": {"part": "none", "face": 1}},
                {"distance": [{"point": [0, 0, 0]}, {"point": [30, 20, 5]}]}]}, file)
        read_ = illustration_file.read(self.doc, path)
        self.doc.recompute()
        kinds = [(one.Kind, [sub.rstrip("0123456789") for _, subs in one.Features for sub in subs]) for one in dimensions_of(read_)]
        self.assertEqual(kinds, [("Diameter", ["Face"]), ("Distance", ["Edge", "Vertex"])])
        self.assertIn("⌀10", self.numbers(read_))

    def test_step_books_and_steps_have_none(self):
        obj = self.illustration(pump(self.doc), Style="outline")
        make_dimension(obj)
        self.doc.recompute()
        self.assertEqual(make_job(obj).options["illustration"]["dimensions"], ["overall"])
        self.assertNotIn("dimensions", steps_job(obj).options["illustration"])
        self.assertNotIn("dimensions", step_book.job_of(obj, ["book.pdf"]).options["illustration"])

    def test_every_property_is_grouped_and_documented(self):
        made = make_dimension(self.sheet())
        for row in DIMENSION:
            self.assertEqual((made.getTypeIdOfProperty(row.name), made.getGroupOfProperty(row.name)), (row.kind, row.group))
            self.assertGreater(len(made.getDocumentationOfProperty(row.name)), 9, row.name)
            self.assertEqual("ReadOnly" in made.getEditorMode(row.name), row.name in READ_ONLY, row.name)

    def test_saved_without_the_add_on_and_repaired(self):
        obj = self.sheet()
        one = self.add(obj, round_one(self.part, 5))
        obj.Proxy = one.Proxy = None
        self.reopen(obj)
        obj, one = self.doc.Illustration, self.doc.Dimension
        self.assertEqual(features.repair(self.doc), [obj, one])
        self.redraw(obj)
        self.assertEqual(self.numbers(obj), ["⌀10"])
