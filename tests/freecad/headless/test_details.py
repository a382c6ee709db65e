"""Several views on a sheet and details as properties, and all that knows one view alone."""

import json
import os
import unittest.mock

from pump import pump
from support import V, Case, burin, content

from freecad.burin_wb import illustration_file
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import details, eye, make_flat_edges
from freecad.burin_wb.features.asking import items_job, steps_job
from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.features.sheet import Sheet
from freecad.burin_wb.kept_scene import KeptScene
from freecad.burin_wb.view.ink import read


class Details(Case):
    def stack(self, **properties):
        return self.illustration(pump(self.doc), Style="outline", **{"Width": 297, "Height": 210, "FitScale": False, "Scale": 0.5, **properties})

    def said(self, obj):
        return make_job(obj).options.get("illustration")

    def views(self, obj):
        return [view["name"] for view in Sheet(obj.Drawing).data.get("views", ())]

    def test_nothing_is_asked_for_where_nothing_is_said(self):
        obj = self.stack()
        self.assertIsNone(self.said(obj))
        self.assertEqual((list(obj.Views), obj.ProjectionMethod, list(obj.Details)), ([], "First angle", []))
        self.assertIsNone(Sheet(obj.Drawing).box)

    def test_a_detail_of_objects_and_one_about_a_point(self):
        obj = self.stack()
        details.set_details(obj, [details.of_objects(["Pump.Bolt"], letter="K"), details.of_point(V(48, 20, 16), 9, "2:1")])
        self.doc.recompute()
        self.assertEqual(obj.Message, "")
        self.assertEqual(self.said(obj), {"details": [{"select": ["@index=2"], "letter": "K"},
                                                      {"at": [48, 20, 16], "radius": 9, "scale": "2:1"}]})
        self.assertEqual(self.views(obj), ["", "K", "A"])
        self.assertEqual(details.letters_of(details.entries_of(obj)), ["K", "A"])
        self.assertIn("A (2:1)", [text["text"] for layer in Sheet(obj.Drawing).data["layers"] for text in layer.get("texts", ())])
        options = {key: value for key, value in make_job(obj).options.items() if key != "illustration"}
        kernels = burin().draw(scene_of(obj), detail=["Bolt", "48,20,16,9=2:1"], **options)
        boxes = [[a for corner in view["box"] for a in corner] for view in Sheet(obj.Drawing).data["views"]]
        for view, box in zip(kernels.views, boxes):
            for a, b in zip(view["box"], box):
                self.assertAlmostEqual(a, b, 3)

    def test_as_the_option_has_them_and_wrong_ones(self):
        obj = self.stack(Details=["Pump.Bolt=2:1", " 48, 20 ,16,9 = 3", "Bolt001"])
        self.assertEqual(details.entries_of(obj), [{"select": ["Pump.Bolt"], "scale": "2:1"}, {"at": [48, 20, 16], "radius": 9, "scale": "3"},
                                                   {"select": ["Bolt001"]}])
        self.assertRegex(obj.Message, "^the view is 35 mm large, its detail A 63 mm")
        self.assertEqual(self.views(obj), ["", "A", "B", "C"])
        before = content(obj.Drawing)
        for text, words in (('{"select"', "^detail 1 of the property Details is no JSON"), ("=2:1", "^detail 1 of the property Details shows nothing"),
                            ('{"at": [0, 0, 0]}', '^a detail at a point has "radius".*; the drawing before is kept$'),
                            ("0,0,0,9=500:1", "^details of up to 9000 mm have no room")):
            obj.Details = [text]
            self.doc.recompute()
            self.assertRegex(obj.Message, words)
            self.assertEqual(content(obj.Drawing), before)

    def test_what_is_gone_is_told_and_the_others_are_drawn(self):
        obj = self.stack(Details=["Pump.Lid", "Pump.Bolt"])
        self.doc.removeObject("Lid")
        self.doc.recompute()
        self.assertRegex(obj.Message, "^detail 1 shows Pump.Lid, which is not drawn here; delete the detail or choose its place again$")
        self.assertEqual(self.views(obj), ["", "A"])

    def test_scales_and_letters(self):
        self.assertEqual([details.scale_of(text) for text in ("5:1", "1:2", "2.5", " 3 / 2 ", "x", "", "1:0", "-2")], [5, 0.5, 2.5, 1.5, 0, 0, 0, 0])
        self.assertEqual(details.letters_of([{}, {"letter": "A"}, {}, {"letter": "C"}, {}]), ["B", "A", "D", "C", "E"])
        self.assertEqual(details.letters_of([{}] * 23)[-1], "Z")
        self.assertEqual([details.scale_text({"scale": s}) for s in (5, "1:2", 2.5)] + [details.scale_text({})], ["5:1", "1:2", "2.5:1", ""])

    def test_about_a_face_an_edge_and_a_vertex(self):
        part = pump(self.doc)
        part.Placement.Base = V(100, 0, 0)
        self.doc.recompute()
        shape = details.shape_at(part, "Plate.Face1")
        entry = details.of_shape(shape, 3)
        self.assertTrue((V(*entry["at"]) - shape.BoundBox.Center).Length < 1e-5)
        self.assertGreaterEqual(entry["at"][0], 100)
        self.assertAlmostEqual(entry["radius"], 0.575 * shape.BoundBox.DiagonalLength, 2)
        vertex = details.shape_at(part, "Plate.Vertex1")
        self.assertEqual(details.of_shape(vertex, 3)["radius"], 3)

    def test_several_views_by_both_methods(self):
        obj = self.stack(Views=["front", "left", "iso"])
        self.assertEqual(obj.Message, "")
        self.assertEqual(self.views(obj), ["front", "left", "iso"])
        box = {view["name"]: view["box"] for view in Sheet(obj.Drawing).data["views"]}
        self.assertGreater(box["left"][0][0], box["front"][1][0], "first angle: to the right")
        obj.ProjectionMethod = "Third angle"
        self.doc.recompute()
        box = {view["name"]: view["box"] for view in Sheet(obj.Drawing).data["views"]}
        self.assertLess(box["left"][1][0], box["front"][0][0], "third angle: to the left")
        self.assertEqual(self.said(obj), {"views": ["front", "left", "iso"], "projection": "third"})
        obj.Projection, obj.ProjectionMethod = "Perspective", "First angle"
        self.doc.recompute()
        self.assertEqual(obj.Message, "several views are parallel: the perspective is left out")
        self.assertEqual(self.views(obj), ["front", "left", "iso"])
        obj.Views = ["front", "sideways"]
        self.doc.recompute()
        self.assertRegex(obj.Message, "sideways.*; the drawing before is kept$")
        obj.Views = ["1,-1,2"]
        self.doc.recompute()
        self.assertRegex(obj.Message, "^Views has one direction alone, 1,-1,2: make it ViewDirection and leave Views empty")
        obj.Views = ["1,-1,2", "front"]
        self.doc.recompute()
        self.assertEqual((obj.Message.count("several views are parallel"), self.views(obj)), (1, ["1,-1,2", "front"]))
        eye.set_view(obj, eye.standard("top"))
        self.doc.recompute()
        self.assertEqual((list(obj.Views), "parallel" in obj.Message, self.views(obj)), ([], False, []))

    def test_to_the_viewer_of_the_first_view(self):
        obj = self.stack()
        for views, direction in (([], V(1, -1, 1)), (["Top", "front"], V(0, 0, 1)), (["0,1,0"], V(0, 1, 0)), (["none"], V(1, -1, 1))):
            obj.Views = views
            self.assertEqual(details.to_viewer(obj), direction, views)

    def test_only_the_first_view_is_taken_for_the_model(self):
        alone = self.stack()
        eye.set_view(alone, eye.standard("front"))
        obj = self.illustration(self.doc.Pump, Style="outline", Width=297, Height=210, Views=["front", "iso"], Details=["Pump.Bolt"],
                                Callouts=True)
        self.doc.recompute()
        one, several = Sheet(alone.Drawing), Sheet(obj.Drawing)
        lines = lambda sheet: sorted((path["kind"], path["part"], path["edge"], len(path["points"])) for _, path in sheet.paths()  # noqa: E731
                                     if path["part"] >= 0)
        self.assertEqual(lines(several), lines(one))
        everything = sum(len(layer["paths"]) for layer in several.data["layers"])
        self.assertGreater(everything, 2 * len(list(several.paths())))
        places = lambda sheet: [sheet.place(point) for _, path in sheet.paths() if path["part"] >= 0 for point in path["points"]]  # noqa: E731
        for place in places(several):
            self.assertTrue(-0.01 <= place.x <= 60.01 and -4.01 <= place.z <= 20.01, place)
        stand, pens, texts, painted = read(obj.Drawing)
        points = [point for pen in pens for point in pen.points.tolist() if abs(point[0] - 30) < 40]
        self.assertEqual(sum(len(pen.counts) for pen in pens), len(list(several.paths())))
        self.assertEqual(len(points), sum(len(pen.points) for pen in pens))
        self.assertEqual(sorted(text.text for text in texts), sorted(text["text"] for text in several.texts()))
        self.assertNotIn("1", [text.text for text in texts], "numbers stand about the view that is pictorial")

    def test_lines_for_dimensions_are_those_of_the_first_view(self):
        obj = self.stack(Views=["front", "iso"], Details=["Pump.Bolt"])
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        said = []
        with unittest.mock.patch("freecad.burin_wb.features.flat_edges.tell", lambda text, *_: said.append(text)):
            view = make_flat_edges(page, obj)
        self.assertEqual([text.partition(";")[0] for text in said], ["Illustration: the lines of the first view are there to be measured"])
        self.doc.recompute()
        box = view.Source[0].Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 60, 1)
        self.assertAlmostEqual(box.YLength, 24, 1)
        self.assertAlmostEqual(view.Scale, Sheet(obj.Drawing).scale, 6)

    def test_saved_and_opened_it_is_as_it_was(self):
        obj = self.stack(Views=["front", "iso"], ProjectionMethod="Third angle", Details=["Pump.Bolt=2:1"])
        kept = content(obj.Drawing)
        obj = self.reopen(obj)
        self.doc.recompute()
        self.assertEqual((list(obj.Views), obj.ProjectionMethod, list(obj.Details)), (["front", "iso"], "Third angle", ["Pump.Bolt=2:1"]))
        self.assertEqual(content(obj.Drawing), kept)

    def test_older_objects_get_the_properties(self):
        obj = self.stack()
        for name in ("Views", "ProjectionMethod", "Details"):
            obj.removeProperty(name)
        obj = self.reopen(obj)
        self.assertEqual((list(obj.Views), obj.ProjectionMethod, list(obj.Details)), ([], "First angle", []))

    def test_in_illustration_files_both_ways(self):
        obj = self.stack(Views=["front", "iso"], ProjectionMethod="Third angle")
        details.set_details(obj, [details.of_objects(["Pump.Bolt", "Pump.Bolt001"], "2:1", "K"), details.of_point((48, 20, 16), 9)])
        self.doc.recompute()
        self.assertRegex(obj.Message, "^the view is 30 mm large, its detail K 123 mm")
        path = os.path.join(self.folder, "pump.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.assertEqual((data["views"], data["projection"]), (["front", "iso"], "third"))
        self.assertEqual(data["details"], [{"select": ["/Bolt", "/Bolt001"], "scale": "2:1", "letter": "K"}, {"at": [48, 20, 16], "radius": 9}])
        kernels = burin().draw(path)
        self.assertEqual([view["name"] for view in kernels.views], ["front", "iso", "K", "A"])
        self.assertEqual(len(kernels.arrays()["first"]), len(burin().Drawing.load(obj.Drawing).arrays()["first"]))
        read_ = illustration_file.read(self.doc, path)
        self.assertEqual((list(read_.Views), read_.ProjectionMethod), (["front", "iso"], "Third angle"))
        self.assertEqual(details.entries_of(read_), details.entries_of(obj))
        self.assertEqual(make_job(read_).fingerprint(), make_job(obj).fingerprint())

    def test_files_of_others_that_name_by_selectors(self):
        pump(self.doc)
        path = os.path.join(self.folder, "by-hand.burin.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"burin": "illustration", "parts": [{"file": "pump.step", "name": "Pump"}], "views": "front; 1,-1,2",
                       "details": ["*olt*=2:1", "48,20,16,9", "*nothing*", {"select": "Lid"}]}, file)
        read_ = illustration_file.read(self.doc, path)
        self.assertEqual(details.entries_of(read_), [{"select": ["Pump.Bolt", "Pump.Bolt001"], "scale": "2:1"}, {"at": [48, 20, 16], "radius": 9},
                                                     {"select": ["Pump.Lid"]}])
        self.assertEqual(list(read_.Views), ["front", "1,-1,2"])
        read_.FitScale, read_.Scale = False, 0.2
        self.doc.recompute()
        self.assertRegex(read_.Message, "^the view is 12 mm large, its detail A 123 mm")

    def test_steps_and_items_ask_for_no_sheet(self):
        obj = self.stack(Views=["front"], Details=["Pump.Bolt"], Explode=True)
        self.assertEqual(set(steps_job(obj).options["illustration"]), {"explode"})
        self.assertIn("items", items_job(obj).options["illustration"])

    def test_refused_in_one_line(self):
        with self.assertRaisesRegex(Refused, "^detail 3 of the property Details is no JSON"):
            details.entry_of("{", 3)


def scene_of(obj):
    """The scene of an illustration."""
    return KeptScene(burin()).scene(make_job(obj))
