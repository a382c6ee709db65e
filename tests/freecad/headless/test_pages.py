"""Illustrations on TechDraw pages: true scale, few elements, and lines that TechDraw can measure."""

import glob
import math
import os
import re
import xml.etree.ElementTree as xml

import Part
import TechDraw

from support import V, App, Case, features, visible_edges

from freecad.burin_wb.features.sheet import Sheet
from freecad.burin_wb.features.free_place import extent, free_place
from freecad.burin_wb.features.sheet_view import add_template, blank_template, sheet_center
from freecad.burin_wb.features.symbol import Window, parted, to_symbol
from freecad.burin_wb.preferences import PIXELS_PER_MM

SVG = "{http://www.w3.org/2000/svg}"


class Pages(Case):
    def page(self):
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        return page

    def test_a_symbol_has_true_scale(self):
        # 100 mm of sheet at TechDraw's pixels a mm: the size is whole pixels, a user unit is exactly 1 mm.
        for width, height in ((100, 100), (180, 130), (33.3, 77.7)):
            svg = f'<svg xmlns="x" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"/>'
            symbol = to_symbol(svg, Window(0, 0, width, height))
            found = re.search(r'width="(\d+)" height="(\d+)" viewBox="0.0+ 0.0+ (\S+) (\S+)"', symbol)
            w, h, vw, vh = (float(v) for v in found.groups())
            self.assertAlmostEqual(w / vw, PIXELS_PER_MM, delta=1e-6)
            self.assertAlmostEqual(h / vh, PIXELS_PER_MM, delta=1e-6)
            self.assertTrue(0 <= vw - width < 1 / PIXELS_PER_MM + 1e-6 and 0 <= vh - height < 1 / PIXELS_PER_MM + 1e-6)
        with self.assertRaises(ValueError):
            to_symbol("<svg/>", Window(0, 0, 1, 1))

    def test_100_mm_are_100_mm(self):
        obj = self.illustration(self.box(100, 50, 20), Style="outline", ViewDirection=V(0, 0, 1), ViewUp=V(0, 1, 0),
                                FitScale=False, Scale=1.0)
        view = features.place_on_page(self.page(), obj)
        root = xml.fromstring(view.Symbol)
        places = [place for p in root.iter(SVG + "path") for place in self.walk(p.get("d"))]
        xs, ys = zip(*places)
        pixels = float(root.get("width")) / float(root.get("viewBox").split()[2])
        self.assertAlmostEqual((max(xs) - min(xs)) * pixels / PIXELS_PER_MM, 100, delta=0.005)
        self.assertAlmostEqual((max(ys) - min(ys)) * pixels / PIXELS_PER_MM, 50, delta=0.005)

    @staticmethod
    def walk(d):
        """Points of a path made of moves and straight lines, closed or not."""
        x = y = 0.0
        for letter, numbers in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", d):
            values = [float(n) for n in re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers)]
            if letter in "hv":
                x, y = (x + values[0], y) if letter == "h" else (x, y + values[0])
                yield x, y
                continue
            if letter == "z":
                continue  # back to where the ring began
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
        self.assertLess(abs(float(re.search(r'width="(\d+)"', view.Symbol).group(1)) / PIXELS_PER_MM - self.ink(obj)[0]), 2)
        view.Trim = False
        self.doc.recompute()
        self.assertIn(f'width="{round(100 * PIXELS_PER_MM)}"', view.Symbol)
        self.assertEqual((view.ScaleType, view.Scale), ("Custom", 1.0))

    def test_what_is_filled_has_no_pen(self):
        """Qt 6 strokes it with one in a PDF."""
        view = features.place_on_page(self.page(), self.illustration(self.box(), Style="engraving"))
        self.doc.recompute()
        filled = [e for e in xml.fromstring(view.Symbol).iter() if e.get("stroke") == "none"]
        self.assertGreater(len(filled), 0)
        self.assertEqual({e.get("stroke-width") for e in filled}, {"0"})

    @staticmethod
    def ink(obj):
        """Width and height of the lines of an illustration, in mm."""
        points = [p for _, path in Sheet(obj.Drawing).paths() for p in path["points"]]
        return tuple(max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1))

    def test_what_is_drawn_stays_where_it_is_while_its_ink_changes(self):
        obj = self.illustration(self.box(), FitScale=False, Scale=1.0)
        view = features.place_on_page(self.page(), obj)
        self.doc.recompute()
        view.X, view.Y = 100, 90
        where = sheet_center(view)
        self.box(30, 5, 5, "More").Placement.Base = V(40, 0, 0)
        obj.Sources = [self.doc.Box, self.doc.More]
        self.doc.recompute()
        self.assertNotEqual(view.X.Value, 100)
        for a, b in zip(sheet_center(view), where):
            self.assertAlmostEqual(a, b, delta=1e-6)

    def test_views_of_older_versions_stay_where_they_are(self):
        obj = self.illustration(self.box(), Width=100.1, Height=80.1)
        view = features.place_on_page(self.page(), obj)
        view.Trim = False
        self.doc.recompute()
        view.X, view.Y = 120, 90
        where = sheet_center(view)
        view.removeProperty("Middle")
        view.removeProperty("Trim")
        view = self.reopen(view)
        for a, b in zip(sheet_center(view), where):
            self.assertAlmostEqual(a, b, delta=1e-6)
        view.touch()
        self.doc.recompute()
        self.assertTrue(view.Trim)
        for a, b in zip(sheet_center(view), where):
            self.assertAlmostEqual(a, b, delta=1e-6)

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


    def test_long_paths_that_older_versions_kept_are_parted(self):
        lines = "".join(f"M{k} 1l2 3-4 5c1 1 2 2 3 3" for k in range(9000))  # 54,000 elements
        old = f'<svg width="9mm" height="9mm" viewBox="0 0 9 9"><path stroke-width="0.3" d="{lines}"/></svg>'
        paths = re.findall(r'<path stroke-width="0.3" d="([^"]*)"/>', parted(old))
        self.assertEqual("".join(paths), lines)
        self.assertGreater(len(paths), 1)
        self.assertLess(max(path.count("M") for path in paths), 5000)
        short = old.replace(lines, lines[:999])
        self.assertEqual(parted(short), short)
        obj = self.illustration(self.box())
        view = features.place_on_page(self.page(), obj)
        view.Symbol, view.Illustration = old, None
        view = self.reopen(view)
        self.assertEqual(view.Symbol.count("<path"), len(paths))


class Room(Case):
    """Where views are put."""

    def page(self, template="A3_Landscape_blank.svg"):
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        folder = os.path.join(App.getResourceDir(), "Mod", "TechDraw", "Templates")
        add_template(page, glob.glob(os.path.join(folder, "**", template), recursive=True)[0])
        return page

    def place(self, page, **properties):
        obj = self.illustration(self.box(name="Part"), Style="outline", **properties)
        view = features.place_on_page(page, obj)
        self.doc.recompute()
        return view

    @staticmethod
    def bounds(view):
        (w, h), x, y = extent(view), view.X.Value, view.Y.Value
        return x - w / 2, y - h / 2, x + w / 2, y + h / 2

    def apart(self, a, b):
        a, b = self.bounds(a), self.bounds(b)
        return max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3])

    def test_the_first_is_in_the_middle_and_trimmed_to_its_ink(self):
        view = self.place(self.page())
        self.assertAlmostEqual(view.X.Value, 210, delta=1)
        self.assertAlmostEqual(view.Y.Value, 148.5, delta=1)
        ink = Pages.ink(view.Illustration)
        for mm, of_ink in zip(extent(view), ink):
            self.assertTrue(of_ink < mm < of_ink + 2, (mm, of_ink))

    def test_others_are_beside_it(self):
        page = self.page()
        views = [self.place(page, Width=100, Height=80) for _ in range(5)]
        for k, a in enumerate(views):
            x0, y0, x1, y1 = self.bounds(a)
            self.assertTrue(4 < x0 and x1 < 416 and 4 < y0 and y1 < 293)
            for b in views[:k]:
                self.assertGreater(self.apart(a, b), 3.9)

    def test_the_title_block_and_the_frame_stay_free(self):
        # Its comments say: working space 10 10 410 287, title block 220 227 410 287.
        page = self.page("A3_Landscape*TD.svg")  # FreeCAD 1.0 has one _ more in its name
        views = [self.place(page, Width=150, Height=90) for _ in range(4)]
        for view in views:
            x0, y0, x1, y1 = self.bounds(view)
            self.assertTrue(10 < x0 and x1 < 410 and 10 < y0 and y1 < 287, self.bounds(view))
            self.assertFalse(x1 > 220 and y0 < 70, self.bounds(view))

    def test_a_new_page_is_the_smallest_that_holds_the_sheets(self):
        for sheets, size in ((((180, 130),), "A4_Landscape"), (((287, 200),), "A4_Landscape"), (((288, 200),), "A3_Landscape"),
                             (((130, 180),), "A4_Portrait"), (((200, 220),), "A4_Portrait"), (((200, 300),), "A2_Landscape"),
                             (((180, 130), (180, 130)), "A4_Portrait"), (((180, 150), (180, 150)), "A3_Landscape"),
                             (((2000, 90),), "A0_Landscape"), ((), "A4_Landscape")):
            file = blank_template(sheets)
            self.assertTrue(os.path.isfile(file), file)
            self.assertEqual(os.path.basename(file), size + "_blank.svg", sheets)

    def test_a_drawing_is_clear_of_the_edge_of_its_new_page(self):
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        view = self.place(page, Width=287, Height=200)
        self.assertEqual((page.Template.Width.Value, page.Template.Height.Value), (297, 210))
        x0, y0, x1, y1 = self.bounds(view)
        self.assertTrue(4 < x0 and x1 < 293 and 4 < y0 and y1 < 206, self.bounds(view))

    def test_every_template_has_room(self):
        folder = os.path.join(App.getResourceDir(), "Mod", "TechDraw", "Templates")
        page = self.page("A3_Landscape_blank.svg")
        few = []
        for file in sorted(glob.glob(os.path.join(folder, "**", "*.svg"), recursive=True)):
            if os.path.basename(file).startswith("ISO7200_titleblock"):  # of FreeCAD 1.0: pieces to make templates of
                continue
            page.Template.Template = file
            place = free_place(page, 60, 60)
            if not place.free:
                few.append(os.path.basename(file))
        self.assertEqual(few, [])

    def test_views_of_techdraw_are_not_covered(self):
        page = self.page()
        part = self.doc.addObject("TechDraw::DrawViewPart", "View")
        part.Source = [self.box(100, 60, 40, "Other")]
        page.addView(part)
        self.doc.recompute()
        self.assertTrue(visible_edges(part))
        part.X, part.Y = 210, 148
        view = self.place(page, Width=100, Height=80)
        self.assertGreater(self.apart(view, part), 3.9)

    def test_a_page_without_room_says_so(self):
        page = self.page()
        self.place(page, Width=400, Height=280, Margin=0)
        place = free_place(page, 300, 200)
        self.assertFalse(place.free)


class Flat(Case):
    def flat(self, *sources, **properties):
        obj = self.illustration(*sources, Style="outline", **properties)
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        symbol = features.place_on_page(page, obj)
        symbol.X, symbol.Y = 150, 120
        view = features.make_flat_edges(page, obj)
        self.doc.recompute()
        self.assertTrue(visible_edges(view))
        return obj, page, view

    def test_a_dimension_tells_the_projected_length(self):
        _, page, view = self.flat(self.box(40, 30, 20))
        flat = view.Source[0]
        self.assertEqual(len(flat.Shape.Edges), 9)
        self.assertTrue(all(type(e.Curve).__name__ == "Line" for e in flat.Shape.Edges))
        # Seen along (1, -1, 1): edges along x and y are shortened by sqrt(2/3), as is z.
        expected = {round(length * math.sqrt(2 / 3), 3) for length in (40, 30, 20)}
        found = {}
        for k, edge in enumerate(visible_edges(view)):
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

    def test_numbers_ways_and_hatching_are_no_lines_of_the_model(self):
        block = self.box(40, 30, 20)
        plain = len(self.flat(block)[2].Source[0].Shape.Edges)
        obj, page, view = self.flat(block, Callouts=True, PartsList=True)
        self.assertRegex(page.Views[0].Symbol, '<text [^>]*font-family="osifont"', "Qt takes one family")
        self.assertEqual(len(view.Source[0].Shape.Edges), plain)
        obj.Sections = ["y"]
        self.doc.recompute()
        cut = len(view.Source[0].Shape.Edges)
        self.assertLess(cut, 3 * plain)
        view.Source[0].Strokes = True
        self.doc.recompute()
        self.assertGreater(len(view.Source[0].Shape.Edges), cut + 5)

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
