"""Dimensions while the model, the sheet and the illustration change: each measures what it was made for, or is left out and named."""

import json
import os

import Mesh
import Part
from support import App, Case, V, burin, content

from freecad.burin_wb import illustration_file
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import kept, make_dimension
from freecad.burin_wb.features.asking import items_of
from freecad.burin_wb.features.found import features_of

TOP, LEFT, RIGHT, FRONT, BACK, BOTTOM = V(0, 0, 1), V(-1, 0, 0), V(1, 0, 0), V(0, -1, 0), V(0, 1, 0), V(0, 0, -1)


def facing(shape, normal):
    """The name of the flat face that looks that way and lies farthest there."""
    return max((face.CenterOfMass.dot(normal), f"Face{k}") for k, face in enumerate(shape.Faces, 1)
               if face.findPlane() is not None and face.normalAt(0, 0).dot(normal) > 0.999)[1]


def hole(shape, x):
    """The name of the cylinder whose axis is there."""
    return next(f"Face{k}" for k, face in enumerate(shape.Faces, 1) if isinstance(face.Surface, Part.Cylinder) and abs(face.Surface.Center.x - x) < 1e-6)


class Sheets(Case):
    def sheet(self, *sources, **properties):
        return self.illustration(*sources, **{"Style": "outline", "Width": 297, "Height": 210, "Margin": 10, "Views": ["front", "top", "left"], **properties})

    def numbers(self, obj):
        return sorted(text["text"] for layer in json.loads(content(obj.Drawing))["layers"] for text in layer.get("texts", ()) if text["role"] == "dimension")


class Edits(Sheets):
    def make_body(self):
        """A plate of 60 x 40 x 15 with two holes, 25 apart, by steps of PartDesign."""
        self.body = self.doc.addObject("PartDesign::Body", "Body")
        self.pad = self.step("PartDesign::Pad", "Pad", self.sketch([Part.LineSegment(a, b) for a, b in (
            (V(), V(60, 0, 0)), (V(60, 0, 0), V(60, 40, 0)), (V(60, 40, 0), V(0, 40, 0)), (V(0, 40, 0), V()))]), 15)
        self.holes = self.step("PartDesign::Pocket", "Holes", self.sketch([Part.Circle(V(x, 20, 0), TOP, 4) for x in (20, 45)], 15), 10)
        self.doc.recompute()
        return self.body

    def sketch(self, geometry, z=0):
        sketch = self.body.newObject("Sketcher::SketchObject", "Sketch")
        sketch.Placement.Base = V(0, 0, z)
        sketch.addGeometry(geometry, False)
        return sketch

    def step(self, kind, name, profile, length):
        made = self.body.newObject(kind, name)
        made.Profile, made.Length = profile, length
        return made

    def chamfer(self, edge):
        made = self.body.newObject("PartDesign::Chamfer", "Chamfer")
        made.Base, made.Size = (self.holes, [edge]), 1
        return made

    def measured(self, prefix="Holes."):
        """The plate with its holes' distance, a diameter, width, depth and height, by names of a step or of the body."""
        body, shape = self.make_body(), self.holes.Shape
        obj = self.sheet(body)
        for pair in ((hole(shape, 20), hole(shape, 45)), (hole(shape, 45),), (facing(shape, LEFT), facing(shape, RIGHT)),
                     (facing(shape, FRONT), facing(shape, BACK)), (facing(shape, BOTTOM), facing(shape, TOP))):
            make_dimension(obj, [(body, prefix + name) for name in pair])
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["15", "25", "40", "60", "⌀8"]))
        return obj

    def check_chamfers(self, obj):
        chamfer = self.chamfer("Edge1")
        for number in range(1, 13):
            chamfer.Base = (self.holes, [f"Edge{number}"])
            self.doc.recompute()
            if "Invalid" in chamfer.State:
                continue
            self.assertEqual((obj.Message, self.numbers(obj)), ("", ["15", "25", "40", "60", "⌀8"]), f"Edge{number}")
        self.body.removeObject(chamfer)
        self.doc.removeObject(chamfer.Name)
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["15", "25", "40", "60", "⌀8"]))

    def test_the_next_step_of_a_body_changes_none_by_names_of_a_step(self):
        self.check_chamfers(self.measured())

    def test_the_next_step_of_a_body_changes_none_by_names_of_the_body(self):
        self.check_chamfers(self.measured(""))

    def test_sizes_and_places_that_change_are_followed(self):
        for prefix in ("Holes.", ""):
            obj = self.measured(prefix)
            self.chamfer("Edge1")
            self.doc.recompute()
            self.pad.Length = 18
            self.holes.Profile[0].Placement.Base = V(3, 0, 18)
            self.doc.recompute()
            self.assertEqual((obj.Message, self.numbers(obj)), ("", ["18", "25", "40", "60", "⌀8"]), prefix)
            self.body.Placement = App.Placement(V(7, 8, 9), App.Rotation(V(0, 0, 1), 90))
            self.doc.recompute()
            self.assertEqual((obj.Message, self.numbers(obj)), ("", ["18", "25", "40", "60", "⌀8"]), prefix)
            App.closeDocument(self.doc.Name)
            self.doc = App.newDocument("Test")

    def test_what_a_step_takes_away_is_left_out_and_comes_back(self):
        for prefix in ("Holes.", ""):
            obj = self.measured(prefix)
            cut = self.step("PartDesign::Pocket", "Cut", self.sketch([Part.LineSegment(a, b) for a, b in (
                (V(35, 5, 0), V(55, 5, 0)), (V(55, 5, 0), V(55, 35, 0)), (V(55, 35, 0), V(35, 35, 0)), (V(35, 35, 0), V(35, 5, 0)))], 15), 12)
            self.doc.recompute()
            self.assertEqual(self.numbers(obj), ["15", "40", "60"], prefix)
            self.assertRegex(obj.Message, r"^Distance: Body\.(Holes\.)?Face\d+ is gone; choose its Features again, or delete it; Diameter: Body")
            self.assertEqual([bool(one.Message) for one in obj.Dimensions], [True, True, False, False, False], "the tree's mark")
            self.assertFalse([one.Name for one in obj.Dimensions if "Touched" in one.State])
            self.body.removeObject(cut)
            self.doc.removeObject(cut.Name)
            self.doc.recompute()
            self.assertEqual((obj.Message, self.numbers(obj)), ("", ["15", "25", "40", "60", "⌀8"]), prefix)
            self.assertEqual([one.Message for one in obj.Dimensions], [""] * 5)
            App.closeDocument(self.doc.Name)
            self.doc = App.newDocument("Test")

    def test_numbers_that_change_in_a_shape_of_its_own(self):
        plate = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(4, 30, V(20, 20, -5))).cut(Part.makeCylinder(4, 30, V(45, 20, -5)))
        part = self.solid(plate, "Plate")
        obj = self.sheet(part)
        one = make_dimension(obj, [(part, hole(plate, 20)), (part, hole(plate, 45))])
        rim = next(f"Edge{k}" for k, e in enumerate(plate.Edges, 1) if isinstance(e.Curve, Part.Circle) and e.Curve.Center.x == 20 and e.Curve.Center.z == 0)
        corner = [f"Vertex{k}" for k, v in enumerate(plate.Vertexes, 1) if v.Point in (V(), V(0, 40, 0))]
        make_dimension(obj, [(part, rim)])
        make_dimension(obj, [(part, name) for name in corner])
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["25", "40", "⌀8"]))
        part.Shape = Part.makeBox(9, 9, 9, V(60, 31, 0)).fuse(plate).removeSplitter()
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["25", "40", "⌀8"]))
        self.assertEqual(features_of(one), [(part, hole(part.Shape, 20)), (part, hole(part.Shape, 45))], "it names them as they are called now")
        obj = self.reopen(obj)
        self.doc.Plate.Shape = plate.cut(Part.makeBox(5, 5, 5))
        self.doc.recompute()
        self.assertEqual(self.numbers(obj), ["25", "⌀8"])
        self.assertRegex(obj.Message, r"^Distance001: Plate\.Vertex\d+ is gone")
        lost = obj.Dimensions[2]
        lost.Features = [(self.doc.Plate, ("Vertex1",)), (self.doc.Plate, ("Vertex2",))]
        self.doc.recompute()
        self.assertEqual((lost.Message, obj.Message), ("", ""), "features that are chosen again are taken as they are")

    def test_steps_that_change_places_number_anew(self):
        def plate(*holes):
            outline = Part.makePolygon([V(), V(60, 0, 0), V(60, 40, 0), V(0, 40, 0), V()])
            rims = [Part.Wire(Part.Circle(V(x, 20, 0), TOP, radius).toShape()) for x, radius in holes]
            return Part.Face([outline, *rims]).extrude(V(0, 0, 10))

        place, before, turned = ("Test", "Plate"), plate((15, 4), (45, 6)), plate((45, 6), (15, 4))
        for x in (15, 45):
            known = kept.keep(before, hole(before, x), place)
            self.assertNotEqual(hole(turned, x), known["name"])
            self.assertEqual(kept.whole_of(turned, place).structure, known["in"])
            self.assertEqual(kept.find(turned, known, place), hole(turned, x))
        before, moved, apart = plate((20, 4), (30, 4)), plate((30, 4), (40, 4)), plate((10, 4), (40, 4))
        for x, later, away in ((20, 30, 10), (30, 40, 40)):
            known = kept.keep(before, hole(before, x), place)
            self.assertEqual((kept.find(moved, known, place), kept.find(apart, known, place)), (hole(moved, later), hole(apart, away)), "these were moved")

    def test_faces_that_are_alike_in_number_only_are_not_taken(self):
        plate = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(4, 30, V(20, 20, -5)))
        known = kept.keep(plate, hole(plate, 20), ("Test", "Plate"))
        self.assertEqual(kept.find(plate.copy(), known, ("Test", "Other")), known["name"])
        moved = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(4, 30, V(30, 20, -5)))
        self.assertEqual(kept.find(moved, known, ("Test", "Plate")), known["name"], "of the same structure: its size or place changed")
        other = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(4, 30, V(30, 20, -5))).cut(Part.makeBox(5, 5, 5))
        self.assertEqual(kept.find(other, known, ("Test", "Plate")), "")
        boss = Part.makeCylinder(4, 10, V(20, 20, 0))
        self.assertEqual(kept.like(boss, "Face", known["like"]), "", "a boss is no hole")
        split = plate.cut(Part.makeBox(60, 40, 2, V(0, 0, 4)))
        self.assertEqual(kept.like(split, "Face", known["like"]), "", "which of both is not known")
        two = Part.makeBox(60, 40, 10).cut(Part.makeBox(10, 5, 10, V(20, 0, 0)))
        long = next(e for e in two.Edges if abs(e.Length - 30) < 1e-9 and e.CenterOfMass.distanceToPoint(V(45, 0, 0)) < 1e-9)
        cut = two.cut(Part.makeBox(31, 5, 10, V(29, 0, 0)))
        self.assertEqual(kept.like(cut, "Edge", kept.print_of(long)), "", "another edge of the same line")
        shorter = two.cut(Part.makeBox(3, 5, 10, V(57, 0, 0)))
        self.assertAlmostEqual(kept.element(shorter, kept.like(shorter, "Edge", kept.print_of(long))).Length, 27)
        self.assertEqual(kept.element(plate, kept.like(plate, "Face", known["like"])).Surface.Radius, 4)


class Refusals(Sheets):
    """What the kernel refuses."""

    def plate(self, **properties):
        self.part = self.solid(Part.makeBox(60, 40, 10).cut(Part.makeCylinder(5, 30, V(20, 20, -5))), "Plate")
        obj = self.sheet(self.part, **properties)
        make_dimension(obj)
        shape = self.part.Shape
        self.height = make_dimension(obj, [(self.part, facing(shape, BOTTOM)), (self.part, facing(shape, TOP))], Text="h {value}")
        self.bore = make_dimension(obj, [(self.part, hole(shape, 20))], View="top")
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj)), ("", ["10", "40", "60", "h 10", "⌀10"]))
        return obj

    def check_left_out(self, obj, one, words, rest):
        self.doc.recompute()
        self.assertRegex(obj.Message, words)
        self.assertEqual((self.numbers(obj), obj.Message.count(one.Label)), (rest, 1))
        self.assertNotIn("the drawing before", obj.Message)
        self.assertEqual([bool(each.Message) for each in obj.Dimensions], [each.Name == one.Name for each in obj.Dimensions], "the tree's mark")
        self.assertFalse([each.Name for each in (obj, *obj.Dimensions) if "Touched" in each.State])

    def test_a_view_that_is_gone(self):
        obj = self.plate()
        obj.Views = ["front", "left"]
        words, rest = "^Diameter is not drawn: no view is called 'top': there is front, left$", ["10", "40", "60", "h 10"]
        self.check_left_out(obj, self.bore, words, rest)
        path = os.path.join(self.folder, "plate.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(len(json.load(file)["dimensions"]), 2)
        burin().draw(path)
        self.assertEqual([item["name"] for item in items_of(obj)], ["Plate"])
        drawing = obj.Drawing
        self.redraw(obj)
        self.assertEqual(obj.Drawing, drawing, "nothing is drawn anew")
        self.check_left_out(obj, self.bore, words, rest)
        obj = self.reopen(obj)
        self.redraw(obj)
        self.check_left_out(obj, obj.Dimensions[2], words, rest)
        obj.Views = ["front", "top"]
        self.doc.recompute()
        self.assertEqual((obj.Message, self.numbers(obj), [one.Message for one in obj.Dimensions]), ("", ["10", "40", "60", "h 10", "⌀10"], [""] * 3))

    def test_a_section_that_is_gone(self):
        obj = self.plate(Sections=['{"plane": "y", "view": true}'])
        self.bore.View = "A-A"
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        obj.Sections = []
        self.check_left_out(obj, self.bore, "^Diameter is not drawn: no view is called 'A-A'", ["10", "40", "60", "h 10"])

    def test_several_and_a_wrong_direction(self):
        obj = self.plate()
        self.height.Along = V(1, 0, 0)
        self.check_left_out(obj, self.height, "^Distance is not drawn: ", ["10", "40", "60", "⌀10"])
        obj.Views = ["front", "left"]
        self.doc.recompute()
        self.assertEqual((self.numbers(obj), [bool(one.Message) for one in obj.Dimensions]), (["10", "40", "60"], [False, True, True]))
        self.assertRegex(obj.Message, "^Distance is not drawn: .*; Diameter is not drawn: ")
        self.height.Along, self.bore.View = V(), ""
        self.doc.recompute()
        self.assertEqual([one.Message for one in obj.Dimensions], [""] * 3)

    def test_other_mistakes_still_stop_it(self):
        obj = self.plate()
        obj.StyleKeys = {"line.outer": "thick"}
        self.doc.recompute()
        self.assertRegex(obj.Message, "the drawing before is kept$")

    def test_the_same_again(self):
        obj = self.plate()
        shape = self.part.Shape
        for names in ((facing(shape, BOTTOM), facing(shape, TOP)), (facing(shape, TOP), facing(shape, BOTTOM)), (hole(shape, 20),)):
            with self.assertRaisesRegex(Refused, "^D[a-z]+ measures this already; "):
                make_dimension(obj, [(self.part, name) for name in names])
        self.assertEqual(len(obj.Dimensions), 3)
        make_dimension(obj, [(self.part, hole(shape, 20))], "Depth", View="front")
        make_dimension(obj, [(self.part, hole(shape, 20))], View="front")
        self.assertEqual(len(obj.Dimensions), 5, "another kind, or in another view")

    def test_meshes_are_told(self):
        mesh = self.doc.addObject("Mesh::Feature", "Scan")
        mesh.Mesh = Mesh.createBox(10, 10, 10)
        obj = self.sheet(mesh)
        for name in ("Facet3", "Face1"):
            with self.assertRaisesRegex(Refused, "^Scan is a mesh, which has no faces and edges that can be measured$"):
                make_dimension(obj, [(mesh, name)])

    def test_a_copy_has_its_own(self):
        self.doc.UndoMode = 1
        obj = self.plate()
        self.bore.Tolerance = "H7"
        self.doc.recompute()
        numbers, mine = self.numbers(obj), list(obj.Dimensions)
        self.doc.openTransaction("Copy")
        copy = self.doc.copyObject(obj, False)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.redraw(copy)
        self.assertEqual((list(obj.Dimensions), self.numbers(obj)), (mine, numbers))
        self.assertEqual((copy.Message, self.numbers(copy), len(copy.Dimensions)), ("", numbers, 3))
        self.assertFalse(set(copy.Dimensions) & set(mine))
        self.doc.openTransaction("Change")
        copy.Dimensions[2].Tolerance = ""
        self.doc.removeObject(copy.Dimensions[0].Name)
        self.doc.commitTransaction()
        self.doc.recompute()
        self.assertEqual((self.numbers(copy), self.numbers(obj)), (["h 10", "⌀10"], numbers))
        for _ in range(2):
            self.doc.undo()
        self.redraw(obj)
        self.assertEqual(([o.Name for o in self.doc.Objects if o.Name.startswith("Dimension")], self.numbers(obj)), ([one.Name for one in mine], numbers))
        whole = self.doc.copyObject(obj, True)
        self.doc.recompute()
        self.assertEqual((len(whole.Dimensions), list(obj.Dimensions), self.numbers(whole)), (3, mine, numbers))
        self.assertFalse(set(whole.Dimensions) & set(mine))
