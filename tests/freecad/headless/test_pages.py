"""Illustrations on TechDraw pages: true scale, few elements, and lines that TechDraw can measure."""

import math
import os
import re
import xml.etree.ElementTree as xml

import Part
import TechDraw

from support import V, App, Case, features

from freecad.burin_wb.features.sheet import Sheet
from freecad.burin_wb.features.sheet_view import sheet_center
from freecad.burin_wb.features.symbol import to_symbol

SVG = "{http://www.w3.org/2000/svg}"


class Pages(Case):
    def page(self):
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        return page

    def test_a_symbol_has_true_scale(self):
        # 100 mm of sheet at TechDraw's 3.78 pixels a mm: the size is whole pixels, a user unit is exactly 1 mm.
        for width, height in ((100, 100), (180, 130), (33.3, 77.7)):
            svg = f'<svg xmlns="x" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"/>'
            found = re.search(r'width="(\d+)" height="(\d+)" viewBox="0 0 (\S+) (\S+)"', to_symbol(svg, width, height))
            w, h, vw, vh = (float(v) for v in found.groups())
            self.assertAlmostEqual(w / vw, 3.78, delta=1e-6)
            self.assertAlmostEqual(h / vh, 3.78, delta=1e-6)
            self.assertTrue(0 <= vw - width < 1 / 3.78 + 1e-6 and 0 <= vh - height < 1 / 3.78 + 1e-6)
        with self.assertRaises(ValueError):
            to_symbol("<svg/>", 1, 1)

    def test_100_mm_are_100_mm(self):
        obj = self.illustration(self.box(100, 50, 20), Style="outline", ViewDirection=V(0, 0, 1), ViewUp=V(0, 1, 0),
                                FitScale=False, Scale=1.0)
        view = features.place_on_page(self.page(), obj)
        root = xml.fromstring(view.Symbol)
        places = [place for p in root.iter(SVG + "path") for place in self.walk(p.get("d"))]
        xs, ys = zip(*places)
        pixels = float(root.get("width")) / float(root.get("viewBox").split()[2])
        self.assertAlmostEqual((max(xs) - min(xs)) * pixels / 3.78, 100, delta=0.005)
        self.assertAlmostEqual((max(ys) - min(ys)) * pixels / 3.78, 50, delta=0.005)

    @staticmethod
    def walk(d):
        """Points of a path made of moves and straight lines."""
        x = y = 0.0
        for letter, numbers in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", d):
            values = [float(n) for n in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers)]
            if letter in "hv":
                x, y = (x + values[0], y) if letter == "h" else (x, y + values[0])
                yield x, y
                continue
            assert letter in "Mml", letter
            for dx, dy in zip(values[0::2], values[1::2]):
                x, y = (dx, dy) if letter == "M" else (x + dx, y + dy)
                yield x, y

    def test_it_follows_the_illustration(self):
        obj = self.illustration(self.box())
        view = features.place_on_page(self.page(), obj)
        self.doc.recompute()
        before = view.Symbol
        self.doc.Box.Length = 25
        self.doc.recompute()
        self.assertNotEqual(view.Symbol, before)
        obj.Width = 100
        self.doc.recompute()
        self.assertIn('width="378"', view.Symbol)
        self.assertEqual((view.ScaleType, view.Scale), ("Custom", 1.0))

    def test_it_comes_back_from_a_file(self):
        view = features.place_on_page(self.page(), self.illustration(self.box()))
        self.doc.recompute()
        before = view.Symbol
        view = self.reopen(view)
        self.assertEqual(view.Symbol, before)
        self.assertEqual((type(view.Proxy).__module__, type(view.Proxy).__name__),
                         ("freecad.burin_wb.features", "SheetView"))
        self.doc.Box.Length = 25
        self.doc.recompute()
        self.assertNotEqual(view.Symbol, before)

    def test_many_strokes_are_few_elements(self):
        obj = self.illustration(self.solid(Part.makeSphere(20)), Style="engraving", Width=100, Height=100)
        strokes = [p for _, p in Sheet(obj.Drawing).paths() if p["kind"] == "stroke"]
        view = features.place_on_page(self.page(), obj)
        self.assertGreater(len(strokes), 100)
        self.assertLess(len(list(xml.fromstring(view.Symbol).iter())), 60)


class Flat(Case):
    def flat(self, *sources, **properties):
        obj = self.illustration(*sources, Style="outline", **properties)
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        symbol = features.place_on_page(page, obj)
        symbol.X, symbol.Y = 150, 120
        view = features.make_flat_edges(page, obj)
        self.doc.recompute()
        return obj, page, view

    def test_a_dimension_tells_the_projected_length(self):
        _, page, view = self.flat(self.box(40, 30, 20))
        flat = view.Source[0]
        self.assertEqual(len(flat.Shape.Edges), 9)
        self.assertTrue(all(type(e.Curve).__name__ == "Line" for e in flat.Shape.Edges))
        # Seen along (1, -1, 1): edges along x and y are shortened by sqrt(2/3), as is z.
        expected = {round(length * math.sqrt(2 / 3), 3) for length in (40, 30, 20)}
        found = {}
        for k, edge in enumerate(view.getVisibleEdges()):
            dimension = self.doc.addObject("TechDraw::DrawViewDimension", "Dimension")
            dimension.Type = "Distance"
            dimension.References2D = [(view, f"Edge{k}")]
            page.addView(dimension)
            self.doc.recompute()
            found[k] = dimension.getRawValue()
            nearest = min(expected, key=lambda length: abs(length - found[k]))
            # Paper numbers have 0.0001 mm; a line may be fitted 0.02 mm of paper off.
            self.assertAlmostEqual(found[k], nearest, delta=0.002)
            self.assertAlmostEqual(edge.Length, found[k] * view.Scale, delta=0.002)  # on paper
        self.assertEqual(len(found), 9)

    def test_circles_are_circles(self):
        _, page, view = self.flat(self.solid(Part.makeCylinder(12, 5)), ViewDirection=V(0, 0, 1), ViewUp=V(0, 1, 0))
        circles = [e.Curve for e in view.Source[0].Shape.Edges if type(e.Curve).__name__ == "Circle"]
        self.assertTrue(circles)
        for circle in circles:
            self.assertAlmostEqual(circle.Radius, 12, delta=0.02)
        dimension = self.doc.addObject("TechDraw::DrawViewDimension", "Dimension")
        dimension.Type = "Diameter"
        dimension.References2D = [(view, "Edge0")]
        page.addView(dimension)
        self.doc.recompute()
        self.assertAlmostEqual(dimension.getRawValue(), 24, delta=0.03)

    def test_it_lies_over_the_drawing(self):
        obj, page, view = self.flat(self.solid(Part.makeBox(40, 30, 20).cut(Part.makeCylinder(5, 50, V(10, 10, -9)))))
        path = os.path.join(self.folder, "page.dxf")
        TechDraw.writeDXFPage(page, path)
        lines = self.dxf_lines(path)
        sheet = Sheet(obj.Drawing)
        # The symbol's middle is at (150, 120) of the page; the sheet begins at its top left.
        x0, y0 = sheet_center(next(v for v in page.Views if v.TypeId.endswith("SymbolPython")))
        wanted = [p["points"] for _, p in sheet.paths() if p["visible"] and p["edge"] >= 0 and len(p["points"]) == 2]
        self.assertGreater(len(wanted), 8)
        for points in wanted:
            ends = [(x - sheet.middle[0] + x0, y - sheet.middle[1] + y0) for x, y in points]
            away = min(min(max(math.dist(a, ends[0]), math.dist(b, ends[1])),
                           max(math.dist(a, ends[1]), math.dist(b, ends[0]))) for a, b in lines)
            self.assertLess(away, 0.05)

    @staticmethod
    def dxf_lines(path):
        with open(path) as file:
            text = [line.strip() for line in file]
        pairs = list(zip(text[0::2], text[1::2]))
        found, at = [], None
        for code, value in pairs:
            if code == "0":
                if at and {"10", "20", "11", "21"} <= set(at):
                    found.append(((at["10"], at["20"]), (at["11"], at["21"])))
                at = {} if value == "LINE" else None
            elif at is not None and code in ("10", "20", "11", "21"):
                at[code] = float(value)
        return found

    def test_curves_become_splines_and_stay_near(self):
        torus = Part.makeTorus(30, 8)
        obj, _, view = self.flat(self.solid(torus))
        flat = view.Source[0]
        sheet = Sheet(obj.Drawing)
        shape = Part.makeCompound(flat.Shape.Edges)
        kinds = {type(e.Curve).__name__ for e in flat.Shape.Edges}
        self.assertIn("BSplineCurve", kinds)
        for _, path in sheet.paths():
            for point in path["points"][:: max(1, len(path["points"]) // 7)]:
                away = shape.distToShape(Part.Vertex(V(*sheet.flat(point), 0)))[0]
                self.assertLess(away * sheet.scale, 0.025)

    def test_it_follows_and_comes_back(self):
        _, _, view = self.flat(self.box(40, 30, 20))
        before = view.Source[0].Shape.BoundBox.DiagonalLength
        self.doc.Box.Length = 80
        self.doc.recompute()
        self.assertGreater(view.Source[0].Shape.BoundBox.DiagonalLength, before + 10)
        self.assertAlmostEqual(view.Scale, self.doc.Illustration.DrawnScale)
        flat = self.reopen(view.Source[0])
        self.assertEqual((type(flat.Proxy).__module__, type(flat.Proxy).__name__),
                         ("freecad.burin_wb.features", "FlatEdges"))

    def test_hidden_lines_and_strokes_on_demand(self):
        obj, _, view = self.flat(self.box(40, 30, 20), HiddenLines="Dashed")
        flat = view.Source[0]
        self.assertEqual(len(flat.Shape.Edges), 9)
        flat.Hidden = True
        self.doc.recompute()
        self.assertEqual(len(flat.Shape.Edges), 12)
        obj.Style = "engraving"
        self.doc.recompute()
        few = len(flat.Shape.Edges)
        flat.Strokes = True
        self.doc.recompute()
        self.assertGreater(len(flat.Shape.Edges), few + 20)
