"""Sections with views of their own, as properties: what the kernel is asked for, and what knows of one view alone."""

import json
import os

from pump import pump
from support import V, Case, burin, content

from freecad.burin_wb import illustration_file, step_book
from freecad.burin_wb.features import details, make_dimension, section
from freecad.burin_wb.features.asking import steps_job
from freecad.burin_wb.features.illustration import make_job


class SectionViews(Case):
    def sheet(self, *sections, **properties):
        obj = self.illustration(pump(self.doc), Style="outline", **{"Width": 297, "Height": 210, "Margin": 10, "Views": ["front", "top"], **properties})
        obj.Sections = [section.text_of(one) for one in sections]
        self.doc.recompute()
        return obj

    def drawing(self, obj):
        return json.loads(content(obj.Drawing))

    def views(self, obj):
        return [view["name"] for view in self.drawing(obj).get("views", ())]

    def texts(self, obj):
        return [text["text"] for layer in self.drawing(obj)["layers"] for text in layer.get("texts", ())]

    def cut(self, **more):
        return section.in_view({**section.plane(V(0, -1, 0), -20, []), **more})

    def test_another_one_takes_a_place_of_its_own(self):
        normal, to_viewer, extent = V(0, -1, 0), V(0, -1, 0), lambda way: sorted((0.0, 40.0 * way.y))
        entries, offset = [], -20.0
        for wanted in (-20, -30, -10, -35):
            taken = section.offsets_along(entries, normal, to_viewer, extent)
            offset = section.free_offset(-20.0, [one for one in taken if one is not None], -40.0, 0.0)
            self.assertAlmostEqual(offset, wanted)
            entries.append(section.in_view(section.plane(-normal, -offset) if wanted == -30 else section.plane(normal, offset)))
        self.assertEqual(section.offsets_along(["y", "x", "y=5", {"box": 1}], normal, to_viewer, extent), [-20, None, -5, None])

    def test_a_view_that_alone_is_cut(self):
        obj = self.sheet(self.cut())
        self.assertEqual(obj.Message, "")
        self.assertEqual(make_job(obj).options["illustration"]["section"],
                         [{"plane": {"normal": [0, -1, 0], "offset": -20}, "exclude": [], "view": True}])
        self.assertEqual((self.views(obj), self.texts(obj)), (["front", "top", "A-A"], ["A", "A", "A-A"]))
        boxes = {view["name"]: view["box"] for view in self.drawing(obj)["views"]}
        cuts = [point for layer in self.drawing(obj)["layers"] for path in layer["paths"] if path["kind"] == "pattern" for point in path["points"]]
        (left, bottom), (right, top) = boxes["A-A"]
        self.assertGreater(len(cuts), 10)
        self.assertTrue(all(left - 0.01 <= x <= right + 0.01 and bottom - 0.01 <= y <= top + 0.01 for x, y in cuts), "the other views stay whole")
        kernels = burin().illustration({"burin": "illustration", "parts": [{"file": "a.step"}], "section": section.entries_of(obj)})
        self.assertEqual(kernels["sections"], section.entries_of(obj))

    def test_letters_on_and_off(self):
        plane = section.plane(V(1, 0, 0), 12)
        for entry in (plane, "x", {**plane, "exclude": ["Bolt"]}):
            self.assertTrue(section.may_have_view(entry))
            self.assertFalse(section.view_of(entry))
            self.assertEqual([section.view_of(section.in_view(entry, view)) for view in (True, "K", None)], [True, "K", None])
        self.assertEqual(section.in_view("x"), {"plane": "x", "view": True})
        self.assertEqual(section.in_view({**plane, "view": "K"}, False), plane)
        self.assertTrue(section.may_have_view({"steps": ["y=1", "x=2", "y=3"]}))
        for entry in ("quarter", "x,y", {"box": [[0, 0, 0], [1, 1, 1]]}, None):
            self.assertFalse(section.may_have_view(entry), entry)
        obj = self.sheet(self.cut(), section.in_view(plane, "K"), Details=["Pump.Bolt"])
        self.assertEqual(self.views(obj), ["front", "top", "A-A", "K-K", "B"])
        own = section.own_views(section.entries_of(obj))
        self.assertEqual((own, details.letters_of(own + details.entries_of(obj))), ([{}, {"letter": "K"}], ["A", "K", "B"]))

    def test_beside_one_view_and_a_perspective(self):
        obj = self.sheet(self.cut(), Views=[], Projection="Perspective")
        self.assertEqual(obj.Message, "several views are parallel: the perspective is left out")
        self.assertEqual(self.views(obj)[-1], "A-A")
        obj.Views = ["front"]
        self.doc.recompute()
        self.assertEqual(obj.Message.count("the perspective is left out"), 1)

    def test_a_dimension_in_it(self):
        obj = self.sheet(self.cut())
        lid = self.doc.Lid
        hole = next(f"Face{k}" for k, face in enumerate(lid.Shape.Faces, 1) if face.findPlane() is None)
        one = make_dimension(obj, [(lid, hole)], "Diameter", View="A-A")
        self.doc.recompute()
        text = f"\u2300{2 * lid.getSubObject(hole).Surface.Radius:g}"
        self.assertEqual((obj.Message, one.Message, text in self.texts(obj)), ("", "", True))

    def test_step_books_and_steps_have_none(self):
        obj = self.sheet(self.cut(), section.plane(V(1, 0, 0), 30))
        self.assertEqual(step_book.job_of(obj, ["book.pdf"]).options["illustration"]["section"], [{"plane": {"normal": [1, 0, 0], "offset": 30}}])
        self.assertNotIn("section", steps_job(obj).options["illustration"])

    def test_saved_and_in_illustration_files_both_ways(self):
        obj = self.sheet(section.in_view(section.plane(V(0, -1, 0), -20, ["Pump.Bolt"]), "K"))
        path = os.path.join(self.folder, "pump.burin.json")
        illustration_file.write(obj, path)
        self.assertEqual([view["name"] for view in burin().draw(path).views], ["front", "top", "K-K"])
        read_ = illustration_file.read(self.doc, path)
        self.assertEqual(section.entries_of(read_), section.entries_of(obj))
        kept = content(obj.Drawing)
        obj = self.reopen(obj)
        self.redraw(obj)
        self.assertEqual((content(obj.Drawing), self.views(obj)), (kept, ["front", "top", "K-K"]))
