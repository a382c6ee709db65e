"""The illustration object: drawn, kept, restored, migrated."""

import json
import os
import zipfile

from support import V, App, Case, content, features

from freecad.burin_wb.features import illustration as module
from freecad.burin_wb.features.properties import HIDDEN, ILLUSTRATION, READ_ONLY, SCHEMA, SHEET_VIEW


class Counting:
    """Counts the runs of the kernel."""

    def __enter__(self):
        self.runs, self._before = 0, module.scheduler
        module.scheduler = self
        return self

    def __exit__(self, *_):
        module.scheduler = self._before

    def __call__(self, obj, job, finish):
        self.runs += 1
        self._before(obj, job, finish)


class Object(Case):
    def test_draws_and_keeps(self):
        obj = self.illustration(self.box())
        self.assertEqual(obj.Message, "")
        drawing = json.loads(content(obj.Drawing))
        self.assertEqual((drawing["paper"]["width"], drawing["paper"]["height"]), (180, 130))
        self.assertEqual([p["source"] for p in drawing["parts"]], ["Box"])
        self.assertIn(b'width="180mm"', content(obj.Picture))
        # The box seen along (1, -1, 1) is (10 + 20) / sqrt 2 wide and 30 sqrt(2/3) + 30 / sqrt 6 high.
        width, height = 30 / 2**0.5, 30 * (2 / 3) ** 0.5 + 30 / 6**0.5
        self.assertAlmostEqual(obj.DrawnScale, min(176 / width, 126 / height), delta=0.02 * obj.DrawnScale)

    def test_every_property_is_grouped_and_documented(self):
        obj = features.make_illustration(self.doc, [self.box()])
        view = features.place_on_page(self.doc.addObject("TechDraw::DrawPage", "Page"), obj)
        for made, rows in ((obj, ILLUSTRATION), (view, SHEET_VIEW)):
            for row in rows:
                self.assertEqual(made.getTypeIdOfProperty(row.name), row.kind)
                self.assertEqual(made.getGroupOfProperty(row.name), row.group)
                self.assertGreater(len(made.getDocumentationOfProperty(row.name)), 9, row.name)
                modes = made.getEditorMode(row.name)
                self.assertEqual("ReadOnly" in modes, row.name in READ_ONLY, row.name)
                self.assertEqual("Hidden" in modes, row.name in HIDDEN, row.name)

    def test_expressions(self):
        box = self.box()
        obj = self.illustration(box, FitScale=False)
        obj.setExpression("Scale", "Box.Height / 20mm")
        obj.setExpression("Width", "Box.Length * 12")
        self.doc.recompute()
        self.assertAlmostEqual(obj.DrawnScale, 1.5)
        self.assertEqual(json.loads(content(obj.Drawing))["paper"]["width"], 120)
        box.Height = 40
        self.doc.recompute()
        self.assertAlmostEqual(obj.DrawnScale, 2.0)

    def test_draws_again_when_and_only_when_something_changed(self):
        box = self.box()
        with Counting() as count:
            obj = self.illustration(box)
            self.redraw(obj)
            self.assertEqual(count.runs, 1)
            box.Length = 11
            self.doc.recompute()
            self.assertEqual(count.runs, 2)
            obj.Seed = 2
            self.doc.recompute()
            self.assertEqual(count.runs, 3)
            box.Shape.tessellate(0.1)  # as showing it in 3-D does
            self.redraw(obj)
            self.assertEqual(count.runs, 3)

    def test_reopened_as_it_was_without_a_run(self):
        cylinder = self.doc.addObject("Part::Cylinder", "Cyl")
        cylinder.Radius, cylinder.Height = 7.123456789, 21.3
        cylinder.Placement = App.Placement(V(1.1, 2.2, 3.3), App.Rotation(V(1, 2, 3), 33.3))
        obj = self.illustration(cylinder, self.box(), ViewDirection=V(1, -2, 0.7).normalize(), Label="Front of it",
                                StyleKeys={"line.outer": "0.6"}, Looks={"Box": "not hatched"})
        obj.setExpression("Scale", "Box.Height / 20mm")
        self.doc.recompute()
        before = content(obj.Drawing), content(obj.Picture), obj.Inputs, obj.DrawnScale
        with Counting() as count:
            again = self.reopen(obj)
            self.assertTrue(features.is_illustration(again))
            self.assertEqual(type(again.Proxy).__module__, "freecad.burin_wb.features")
            self.assertEqual((content(again.Drawing), content(again.Picture), again.Inputs, again.DrawnScale), before)
            self.redraw(again)
            self.assertEqual(count.runs, 0)
            # FreeCAD 1.0 writes "20 mm".
            self.assertEqual(again.ExpressionEngine[0][1].replace(" ", ""), "Box.Height/20mm")
            self.assertEqual((again.StyleKeys, again.Looks), ({"line.outer": "0.6"}, {"Box": "not hatched"}))
            self.doc.Box.Length = 12
            self.doc.recompute()
            self.assertEqual(count.runs, 1)
        self.assertNotEqual(content(again.Drawing), before[0])

    def test_the_file_names_what_it_promises(self):
        self.illustration(self.box())
        self.doc.saveAs(os.path.join(self.folder, "a.FCStd"))
        with zipfile.ZipFile(self.doc.FileName) as file:
            text = file.read("Document.xml").decode()
        self.assertIn('module="freecad.burin_wb.features" class="Illustration"', text)

    def test_an_older_schema_gets_what_it_lacks(self):
        obj = self.illustration(self.box(), Seed=5)
        for name in ("Light", "Looks", "HiddenLines", "Message"):
            obj.removeProperty(name)
        obj.Schema = 0
        obj = self.reopen(obj)
        self.assertEqual((obj.Schema, obj.Seed), (SCHEMA, 5))
        self.assertEqual(obj.HiddenLines, "None")
        self.assertEqual(obj.Light, V(-0.5, 0.65, 0.6))
        obj.Seed = 6
        self.doc.recompute()
        self.assertEqual(obj.Message, "")

    def test_a_newer_schema_is_shown_and_not_touched(self):
        box = self.box()
        obj = self.illustration(box)
        obj.removeProperty("Light")
        obj.addProperty("App::PropertyString", "FromTheFuture", "Source", "")
        obj.Schema = SCHEMA + 1
        before = content(obj.Drawing)
        with Counting() as count:
            obj = self.reopen(obj)
            self.assertFalse(hasattr(obj, "Light"))
            self.doc.Box.Length = 99
            self.redraw(obj)
            self.assertEqual(count.runs, 0)
        self.assertEqual(content(obj.Drawing), before)
        self.assertEqual(obj.Schema, SCHEMA + 1)

    def test_saved_without_the_add_on_and_repaired(self):
        obj = self.illustration(self.box())
        before = content(obj.Drawing)
        obj.Proxy = None  # what FreeCAD makes of it without the add-on
        obj = self.reopen(obj)
        self.assertFalse(features.is_illustration(obj))
        with Counting() as count:
            self.assertEqual(features.repair(self.doc), [obj])
            self.redraw(obj)
            self.assertEqual((content(obj.Drawing), count.runs), (before, 0))
            self.doc.Box.Length = 12
            self.doc.recompute()
            self.assertEqual(count.runs, 1)

    def test_pages_saved_without_the_add_on_are_repaired_too(self):
        obj = self.illustration(self.box())
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        view, lines = features.place_on_page(page, obj), features.make_flat_edges(page, obj)
        self.doc.recompute()
        names = [o.Name for o in (obj, view, lines.Source[0])]
        for name in names:
            self.doc.getObject(name).Proxy = None
        self.reopen(obj)
        obj, view, flat = (self.doc.getObject(name) for name in names)
        self.assertEqual(features.repair(self.doc), [obj, view, flat])
        self.assertEqual(features.repair(self.doc), [])
        symbol, length = view.Symbol, flat.Shape.BoundBox.DiagonalLength
        self.doc.Box.Length = 90
        self.doc.recompute()
        self.assertNotEqual(view.Symbol, symbol)
        self.assertNotAlmostEqual(flat.Shape.BoundBox.DiagonalLength, length, 1)


class Styles(Case):
    def style(self, width):
        path = os.path.join(self.folder, "mine.json")
        with open(path, "w") as file:
            json.dump({"base": "outline", "line.outer": width}, file)
        return path

    def widths(self, obj):
        drawing = json.loads(content(obj.Drawing))
        return {w for layer in drawing["layers"] if layer["name"] == "outline" for p in layer["paths"]
                for w in p["width"]}

    def test_what_a_style_file_holds_counts(self):
        obj = self.illustration(self.box(), Style=self.style(0.5))
        self.assertEqual(self.widths(obj), {0.5})
        self.style(0.9)
        self.redraw(obj)
        self.assertEqual(self.widths(obj), {0.9})

    def test_a_style_file_beside_the_document(self):
        self.style(0.8)
        box = self.box()
        obj = self.illustration(self.reopen(box), Style="mine.json")
        self.assertEqual(obj.Message, "")
        self.assertEqual(self.widths(obj), {0.8})

    def test_looks_of_single_objects(self):
        boxes = [self.box(name="A"), self.box(name="B"), self.box(name="C")]
        for k, box in enumerate(boxes):
            box.Placement.Base = V(0, 40 * k, 0)
        path = self.style(1.1)
        obj = self.illustration(*boxes, Style="outline", Looks={"A": "not drawn", "B": "style=" + path})
        drawing = json.loads(content(obj.Drawing))
        ids = {p["source"]: p["id"] for p in drawing["parts"]}
        widths = {}
        for layer in drawing["layers"]:
            for p in layer["paths"]:
                widths.setdefault(p["part"], set()).update(p["width"])
        self.assertNotIn(ids.get("A"), widths)
        self.assertIn(1.1, widths[ids["B"]])
        self.assertNotIn(1.1, widths[ids["C"]])
        self.style(1.3)
        self.redraw(obj)
        self.assertIn(1.3, {w for layer in json.loads(content(obj.Drawing))["layers"] for p in layer["paths"]
                            for w in p["width"]})
