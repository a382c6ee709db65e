"""Sources: what is taken from the document, where it is placed, and which edges and faces lines tell of."""

import json
import os
import pickle
from unittest import mock

import numpy
import Mesh
import Part

from support import V, App, Case, burin, drawn, features

from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.features import shown
from freecad.burin_wb.features.shapes import Shapes, shapes
from freecad.burin_wb.features.sheet import Sheet
from freecad.burin_wb.features.sources import collect


def placed(x=0.0, y=0.0, z=0.0, axis=(0, 0, 1), angle=0.0):
    return App.Placement(V(x, y, z), App.Rotation(V(*axis), angle))


def box_of(part):
    """Bounds (2, 3) of one part as the kernel sees them."""
    scene = burin().Scene()
    if part.brep is not None:
        scene.add_brep(part.brep, part.name, placement=part.matrix())
    else:
        scene.add_mesh(part.vertices, part.triangles, part.name)
    return scene.bounds()


class Sources(Case):
    def check(self, obj, expected):
        """Paths of the parts, and each one's bounds against FreeCAD's own of the same sub-object."""
        obj = self.illustration(obj) if not isinstance(obj, list) else self.illustration(*obj)
        job = make_job(obj)
        self.assertEqual(sorted(p.source for p in job.parts), sorted(expected), job.notes)
        for part in job.parts:
            top, _, rest = part.source.partition(".")
            shape = Part.getShape(self.doc.getObject(top), rest + "." if rest else "", needSubElement=False,
                                  transform=True)
            own = shape.BoundBox
            lo, hi = box_of(part)
            for mine, theirs in zip([*lo, *hi], [own.XMin, own.YMin, own.ZMin, own.XMax, own.YMax, own.ZMax]):
                self.assertAlmostEqual(mine, theirs, delta=1e-3 * own.DiagonalLength, msg=part.source)
        return obj, job

    def assembly(self):
        """Outer (moved) > Inner (turned) > Box; Outer > Body."""
        box = self.box()
        box.Placement = placed(1, 2, 3, angle=30)
        inner = self.doc.addObject("App::Part", "Inner")
        inner.Placement = placed(50, 0, 0, (1, 0, 0), 90)
        inner.addObject(box)
        outer = self.doc.addObject("App::Part", "Outer")
        outer.Placement = placed(0, 100, 0, (0, 0, 1), 45)
        outer.addObject(inner)
        body = self.doc.addObject("PartDesign::Body", "Body")
        prism = self.doc.addObject("PartDesign::AdditiveBox", "Pad")
        body.addObject(prism)
        body.Placement = placed(0, 0, 40)
        outer.addObject(body)
        self.doc.recompute()
        return outer

    def test_nested_assembly(self):
        _, job = self.check(self.assembly(), ["Outer.Inner.Box", "Outer.Body"])
        names = {p.source: p.assembly for p in job.parts}
        self.assertEqual(names["Outer.Inner.Box"], ["Outer", "Inner"])
        # The corner (1, 2, 3) of the box, through 90 degrees about x and 45 about z.
        corner = placed(0, 100, 0, (0, 0, 1), 45).multVec(placed(50, 0, 0, (1, 0, 0), 90).multVec(V(1, 2, 3)))
        part = next(p for p in job.parts if p.source == "Outer.Inner.Box")
        shape = Part.Shape()
        shape.importBrepFromString(part.brep.decode())
        shape.Placement = App.Placement(App.Matrix(*part.placement))
        self.assertLess(min((v.Point - corner).Length for v in shape.Vertexes), 1e-9)

    def test_an_object_in_an_assembly_is_where_the_assembly_has_it(self):
        self.assembly()
        obj, job = self.check(self.doc.Box, ["Outer.Inner.Box"])
        before = obj.Inputs
        self.doc.Outer.Placement = placed(5, 6, 7, (0, 1, 0), 10)  # ... and moving that is noticed
        self.doc.recompute()
        self.assertNotEqual(obj.Inputs, before)
        before = obj.Inputs
        self.doc.Box.Length = 17
        self.doc.recompute()
        self.assertNotEqual(obj.Inputs, before)

    def test_links(self):
        self.assembly()
        self.doc.Box.Visibility = True
        for name, target in (("ToBox", "Box"), ("ToBody", "Body"), ("ToInner", "Inner"), ("ToOuter", "Outer")):
            link = self.doc.addObject("App::Link", name)
            link.LinkedObject = self.doc.getObject(target)
            link.Placement = placed(0, 0, 200, (0, 1, 0), 20)
        self.doc.recompute()
        self.check([self.doc.ToBox, self.doc.ToBody, self.doc.ToInner, self.doc.ToOuter],
                   ["ToBox", "ToBody", "ToInner.Box", "ToOuter.Inner.Box", "ToOuter.Body"])

    def test_link_arrays_and_groups(self):
        self.assembly()
        for name, shown in (("Shown", True), ("Folded", False)):
            array = self.doc.addObject("App::Link", name)
            array.LinkedObject = self.doc.Inner
            array.ShowElement = shown
            array.ElementCount = 3
            array.PlacementList = [placed(70 * k, 0, 0, angle=10 * k) for k in range(3)]
        group = self.doc.addObject("App::LinkGroup", "Group")
        link = self.doc.addObject("App::Link", "Copy")
        link.LinkedObject = self.doc.Body
        cone = self.doc.addObject("Part::Cone", "Cone")
        group.ElementList = [link, cone]
        group.Placement = placed(0, 0, -50)
        self.doc.recompute()
        self.check([self.doc.Shown, self.doc.Folded, group],
                   [f"{a}.{k}.Box" for a in ("Shown", "Folded") for k in range(3)] + ["Group.Copy", "Group.Cone"])

    def test_links_to_one_shape_are_written_once(self):
        box = self.box()
        self.doc.recompute()
        links = []
        for k in range(30):
            link = self.doc.addObject("App::Link", "Link")
            link.LinkedObject = box
            link.Placement = placed(20 * k, 0, 0, (1, 1, 0), 7 * k)
            links.append(link)
        self.doc.recompute()
        before = shapes.written
        _, job = self.check([box, *links], ["Box", *(link.Name for link in links)])
        self.assertEqual(len({id(part.brep) for part in job.parts}), 1)
        self.assertEqual(shapes.written - before, 1)
        self.assertLess(len(pickle.dumps(job, protocol=4)), 5 * len(job.parts[0].brep))
        box.Height = 31  # another shape
        self.doc.recompute()
        again = make_job(self.doc.Illustration)
        self.assertEqual(shapes.written - before, 2)
        self.assertNotEqual(again.exact_fingerprint(), job.exact_fingerprint())
        links[3].Placement.Base.z += 1
        self.doc.recompute()
        moved = make_job(self.doc.Illustration)
        self.assertEqual(shapes.written - before, 2)
        self.assertNotEqual(moved.exact_fingerprint(), again.exact_fingerprint())
        self.assertNotEqual(moved.fingerprint(), again.fingerprint())

    def test_instances_draw_as_shapes_of_their_own(self):
        solid = self.solid(Part.makeBox(40, 30, 20).cut(Part.makeCylinder(7, 90, V(20, 15, -5))))
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = solid
        link.Placement = placed(70, 10, 0, (1, 0, 0), 33)
        self.doc.recompute()
        obj = self.illustration(solid, link)
        linked = drawn(obj).arrays()
        alone = Part.getShape(link, "", needSubElement=False, transform=True).copy()
        obj.Sources = [(solid, ("",)), (self.solid(alone, "Alone"), ("",))]
        copied = drawn(obj).arrays()
        numpy.testing.assert_array_equal(linked["edge"], copied["edge"])
        numpy.testing.assert_array_equal(linked["first"], copied["first"])
        numpy.testing.assert_allclose(linked["points"], copied["points"], atol=0.01)

    def test_scaled_link(self):
        self.box()
        link = self.doc.addObject("App::Link", "Twice")
        link.LinkedObject = self.doc.Box
        link.Scale = 2
        self.doc.recompute()
        _, job = self.check(link, ["Twice"])
        numpy.testing.assert_allclose(box_of(job.parts[0])[1], (20, 40, 60), atol=1e-6)

    def test_visibility(self):
        outer = self.assembly()
        self.doc.Body.Visibility = False
        self.check(outer, ["Outer.Inner.Box"])
        self.doc.Inner.Visibility = False
        self.doc.Body.Visibility = True
        self.check(outer, ["Outer.Body"])
        self.check(self.doc.Box, ["Outer.Inner.Box"])  # asked for by itself
        self.box(name="Hidden").Visibility = False
        array = self.doc.addObject("App::Link", "Array")
        array.LinkedObject = self.doc.Hidden
        array.ShowElement = False
        array.ElementCount = 2
        self.doc.recompute()
        self.check(array, ["Array.0", "Array.1"])
        array.setElementVisible("1", False)
        self.check(array, ["Array.0"])

    def test_sub_names(self):
        outer = self.assembly()
        obj = features.make_illustration(self.doc, [(outer, ("Inner.Box.Face3", "Inner.Box.Edge1"))])
        self.doc.recompute()
        self.assertEqual([p.source for p in make_job(obj).parts], ["Outer.Inner.Box"])
        self.assertEqual(obj.Message, "")

    def test_group_folder(self):
        group = self.doc.addObject("App::DocumentObjectGroup", "Folder")
        group.addObject(self.box())
        self.check(group, ["Folder.Box"])

    def test_meshes(self):
        mesh = self.doc.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        mesh.Placement = placed(5, 6, 7)
        inner = self.doc.addObject("App::Part", "Part")
        inner.Placement = placed(0, 0, 100, (0, 0, 1), 90)
        other = self.doc.addObject("Mesh::Feature", "Inside")
        other.Mesh = Mesh.createBox(10, 20, 30)
        other.Placement = placed(50, 0, 0)
        inner.addObject(other)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = mesh
        link.LinkTransform = False
        link.Placement = placed(-100, 0, 0)
        self.doc.recompute()
        obj = self.illustration(mesh, inner, link)
        boxes = {p.source: box_of(p) for p in make_job(obj).parts}
        self.assertEqual(obj.Message, "")
        numpy.testing.assert_allclose(boxes["Mesh"], [(0, -4, -8), (10, 16, 22)], atol=1e-5)
        numpy.testing.assert_allclose(boxes["Part.Inside"], [(-10, 45, 85), (10, 55, 115)], atol=1e-5)
        numpy.testing.assert_allclose(boxes["Link"], [(-105, -10, -15), (-95, 10, 15)], atol=1e-5)

    def test_headless_there_are_no_colours(self):
        _, job = self.check(self.box(), ["Box"])
        self.assertEqual(job.parts[0].color, "")


class Aids(Case):
    def test_datum_planes_in_assemblies_are_no_parts(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.box())
        for kind in ("PartDesign::Plane", "PartDesign::Line", "PartDesign::Point", "PartDesign::CoordinateSystem"):
            part.addObject(self.doc.addObject(kind, "Aid"))
        self.doc.recompute()
        parts, notes = collect([(part, ("",))])
        self.assertEqual(([p.source for p in parts], notes), (["Part.Box"], []))
        self.doc.addObject("PartDesign::Plane", "Alone")
        self.doc.recompute()
        self.assertEqual(features.visible(self.doc), [part])

    def test_an_assembly_of_aids_says_that_nothing_is_drawn(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.doc.addObject("PartDesign::Plane", "Plane"))
        self.doc.recompute()
        parts, notes = collect([(part, ("",))])
        self.assertEqual(len(parts), 0)
        self.assertIn("has no visible shape", notes[0])


class Elements(Case):
    """Numbers of edges and faces are FreeCAD's own."""

    def check(self, obj):
        drawing = json.loads(drawn(obj).to_bytes("json"))
        sources = {p["id"]: p["source"] for p in drawing["parts"]}
        near = 0.02 / drawing["view"]["scale"]
        edges = faces = 0
        for path in (p for layer in drawing["layers"] for p in layer["paths"]):
            source, _, rest = sources[path["part"]].partition(".")
            count = len(path["points3"])
            if path["edge"] >= 0:
                runs = [(count // 2, f"Edge{path['edge'] + 1}")]
                edges += 1
            elif path["kind"] == "contour" and path["face"] >= 0:
                firsts = path.get("faces") or [[0, path["face"]]]
                lasts = [first for first, _ in firsts[1:]] + [count - 1]
                runs = [((first + last) // 2, f"Face{face + 1}")
                        for (first, face), last in zip(firsts, lasts) if face >= 0]
                faces += len(runs)
            else:
                continue
            for point, element in runs:
                shape = Part.getShape(self.doc.getObject(source), (rest + "." if rest else "") + element,
                                      needSubElement=True, transform=True)
                away = shape.distToShape(Part.Vertex(V(*path["points3"][point])))[0]
                self.assertLess(away, near, f"{source}.{rest} {element} {path['kind']}")
        return edges, faces

    def test_a_part_with_curves(self):
        block = Part.makeBox(40, 30, 20).cut(Part.makeCylinder(6, 50, V(20, 15, -5)))
        block = block.fuse(Part.makeSphere(9, V(40, 15, 10))).fuse(Part.makeCone(5, 2, 12, V(8, 8, 20)))
        edges, faces = self.check(self.illustration(self.solid(block)))
        self.assertGreater(edges, 15)
        self.assertGreater(faces, 2)

    def test_in_an_assembly_and_through_links(self):
        solid = self.solid(Part.makeBox(40, 30, 20).cut(Part.makeCylinder(7, 90, V(20, 15, -5))))
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = placed(10, 20, 30, (1, 1, 1), 50)
        part.addObject(solid)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement = placed(0, 0, 80, (1, 0, 0), 33)
        self.doc.recompute()
        edges, _ = self.check(self.illustration(part, link))
        self.assertGreater(edges, 20)

    def test_a_compound_with_shared_faces(self):
        # One shape many times in a compound, and solids with a face in common.
        tool = Part.makeBox(5, 5, 5)
        copies = [tool.copy() for _ in range(3)]
        for k, copy in enumerate(copies):
            copy.Placement = placed(12 * k, 3 * k, 0, angle=15 * k)
        same = [tool.translated(V(0, 15 * k, 20)) for k in range(3)]
        edges, _ = self.check(self.illustration(self.solid(Part.makeCompound(copies + same))))
        self.assertGreater(edges, 40)

    def test_the_kept_drawing_tells_the_same(self):
        obj = self.illustration(self.box())
        sheet = Sheet(obj.Drawing)
        _, path = next((layer, p) for layer, p in sheet.paths() if p["edge"] >= 0)
        source, element = sheet.element(path)
        self.assertEqual((source, element), ("Box", f"Edge{path['edge'] + 1}"))
        edge = self.doc.Box.getSubObject(element)
        self.assertEqual(edge.ShapeType, "Edge")
        ends = [sheet.on_paper(v.Point) for v in edge.Vertexes]
        for end in ends:
            self.assertLess(min((end[0] - x) ** 2 + (end[1] - y) ** 2 for x, y in path["points"]), 1e-4)
        self.assertIn(path, list(sheet.paths_of("Box", element)))


class Collect(Case):
    def test_what_is_not_drawn_is_told(self):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(1, 0, 0)), False)
        self.doc.recompute()
        parts, notes = collect([(self.box(), ("",)), (sketch, ("",))])
        self.assertEqual(len(parts), 0 if not self.doc.Box.Shape.Faces else 1)
        self.assertIn("sketch", " ".join(notes))

    def test_a_lost_link_is_told_once(self):
        other = App.newDocument("Other")
        other.addObject("Part::Box", "Box")
        other.recompute()
        path = os.path.join(self.folder, "other.FCStd")
        other.saveAs(path)
        self.doc.saveAs(os.path.join(self.folder, "whole.FCStd"))
        self.box()
        self.doc.addObject("App::Link", "Link").LinkedObject = other.getObject("Box")
        self.doc.recompute()
        self.doc.save()
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        os.unlink(path)
        self.doc = App.openDocument(os.path.join(self.folder, "whole.FCStd"))
        sources = features.visible(self.doc)
        self.assertEqual([o.Name for o in sources], ["Box", "Link"])
        parts, notes = collect([(o, ("",)) for o in sources])
        self.assertEqual(([p.name for p in parts], len(notes)), (["Box"], 1), notes)
        self.assertIn("Link", notes[0])


class Instances(Case):
    def test_arrays_of_draft_are_their_links(self):
        import Draft

        box = self.box()
        self.doc.recompute()
        array = Draft.make_ortho_array(box, V(12, 0, 0), V(0, 30, 0), V(0, 0, 1), 3, 2, 1)
        array.Label = "Row"
        self.doc.recompute()
        parts, notes = collect([(o, ("",)) for o in features.visible(self.doc)])
        self.assertEqual((len(parts), notes), (7, []))
        self.assertEqual({p.definition for p in parts}, {"Box"})
        self.assertEqual(len({id(p.brep) for p in parts}), 1)
        scene = burin().Scene()
        for part in parts:
            scene.add_brep(part.brep, part.name, placement=part.matrix()).definition = part.definition
        self.assertEqual([(item["name"], item["quantity"]) for item in burin().items(scene)], [("Box", 7)])

    def test_elements_of_arrays_are_drawn_through_them_alone(self):
        box = self.box()
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = box
        link.ElementCount = 3
        self.doc.recompute()
        self.assertEqual([o.Name for o in features.visible(self.doc)], ["Box", "Link"])

    def test_containers_name_what_nobody_named(self):
        part = self.doc.addObject("App::Part", "Part")
        part.Label = "Bearing cap"
        body = self.doc.addObject("PartDesign::Body", "Body")
        body.addObject(self.doc.addObject("PartDesign::AdditiveBox", "Pad"))
        part.addObject(body)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = part
        self.doc.recompute()
        parts, _ = collect([(part, ("",)), (link, ("",))])
        self.assertEqual([p.definition for p in parts], ["Bearing cap", "Bearing cap"])


class Shown(Case):
    def test_a_saved_document_is_looked_at_once(self):
        for k in range(5):
            self.box(name=f"Box{k}")
        self.doc.recompute()
        self.doc.saveAs(os.path.join(self.folder, "many.FCStd"))
        with mock.patch.object(shown.zipfile, "ZipFile", wraps=shown.zipfile.ZipFile) as opened:
            self.assertEqual(len(features.visible(self.doc)), 5)
        self.assertEqual(opened.call_count, 1)

    def test_texts_of_shapes_are_found_and_forgotten(self):
        kept = Shapes()
        box = Part.makeBox(1, 2, 3)
        moved = Part.Shape(box)
        moved.Placement = placed(5)
        first, _ = kept.text(box, ("Doc", "A"))
        second, place = kept.text(moved, ("Doc", "B"))
        self.assertTrue(first is second)
        self.assertEqual((kept.written, place[3]), (1, 5.0))
        other, _ = kept.text(Part.makeBox(1, 2, 4), ("Doc", "A"))  # the object has another shape now
        self.assertFalse(other is first)
        self.assertTrue(kept.has(moved, ("Doc", "C")))
        kept.forget("Doc")
        self.assertFalse(kept.has(moved, ("Doc", "C")))
        self.assertEqual(kept._alike, {})
