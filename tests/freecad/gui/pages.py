"""Pages are whole: what TechDraw shows and exports has the ink of the illustration itself, stroke for stroke."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import numpy  # noqa: E402
import support  # noqa: E402
from similarity import grey  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "freecad_wb" / "docs"))
import bearing  # noqa: E402

# With half as many, strokes that converge are up to a pixel wider in TechDraw's PDF: 0.026 of the darkest cell.
DPI = 300
# Cells of paper whose ink is compared, in mm, and the share of black that they may differ by.
CELL, OFF = 5.0, 0.02


def elements(data):
    """The elements that Qt makes of path data: one a move, a line and a closing, three a curve."""
    count = 0
    for letter, numbers in re.findall(r"([Mlhvcz])([^Mlhvcz]*)", data):
        many = len(re.findall(r"-?(?:\d+\.?\d*|\.\d+)", numbers))
        count += 1 if letter == "z" else many if letter in "hv" else many // 2
    return count


def ink(picture):
    """Ink of a picture at half of DPI: 0 = white, 1 = black, (height, width)."""
    return 1.0 - grey(picture)


def cells(black, left, top, width, height, more=0):
    """Ink of the cells of a part of a picture, as shares of a cell; all in mm from its top left. `more`: pixels that each
    cell reaches beyond its sides."""
    per_mm = DPI / 2 / 25.4
    size = CELL * per_mm
    sums = numpy.zeros((black.shape[0] + 1, black.shape[1] + 1))
    sums[1:, 1:] = black.cumsum(0).cumsum(1)

    def sides(start, length, most):
        first = numpy.round(start * per_mm + size * numpy.arange(int(length / CELL))).astype(int)
        return (first - more).clip(0, most), (first + round(size) + more).clip(0, most)

    (r0, r1), (c0, c1) = sides(top, height, black.shape[0]), sides(left, width, black.shape[1])
    at = lambda rows, columns: sums[numpy.ix_(rows, columns)]  # noqa: E731
    return (at(r1, c1) - at(r0, c1) - at(r1, c0) + at(r0, c0)) / size**2


def lost(these, those):
    """The most ink that a cell of one picture has and the other has not, also where that is a pixel off."""
    return (cells(*these) - cells(*those, more=1)).max()


@unittest.skipUnless(shutil.which("pdftoppm") and shutil.which("rsvg-convert"), "poppler-utils or librsvg2-bin is not installed")
class Whole(support.Case):
    def raster(self, path):
        """A PDF or SVG as a PNG at DPI."""
        png = path.with_suffix(path.suffix + ".png")
        if path.suffix == ".pdf":
            subprocess.run(["pdftoppm", "-r", str(DPI), "-png", "-singlefile", str(path), str(png.with_suffix(""))], check=True)
        else:
            subprocess.run(["rsvg-convert", "--unlimited", "-d", str(DPI), "-p", str(DPI), "-b", "white", "-o", str(png), str(path)],
                           check=True)
        return ink(png)

    def check(self, obj):
        """The page's PDF and SVG against the illustration's own."""
        import TechDrawGui
        from freecad.burin_wb import export
        from freecad.burin_wb.features.sheet_view import sheet_center

        page = bearing.page_with(self.document, obj)
        page.ViewObject.show()
        support.settle(200)
        width, height = obj.Width.Value, obj.Height.Value
        x, y = sheet_center(page.Views[0])
        left, top = x - width / 2, page.Template.Height.Value - y - height / 2
        for suffix, write in (("pdf", TechDrawGui.exportPageAsPdf), ("svg", TechDrawGui.exportPageAsSvg)):
            own, path = support.OUT / f"own.{suffix}", support.OUT / f"whole.{suffix}"
            export.export([obj], str(own))
            write(page, str(path))
            wanted, black = self.raster(own), self.raster(path)
            share = black.sum() / wanted.sum()
            here, there = (black, left, top, width, height), (wanted, 0, 0, width, height)
            print(f"{suffix}: {100 * share:.2f} % of the ink; of a cell of {CELL:.0f} mm at most {lost(there, here):.4f} is "
                  f"lost, {lost(here, there):.4f} is new")
            self.assertAlmostEqual(share, 1.0, delta=0.01, msg=suffix)
            self.assertLess(lost(there, here), OFF, suffix)
            self.assertLess(lost(here, there), OFF, suffix)
        return page

    def test_the_engraved_bearing_of_the_tutorial(self):
        obj = bearing.illustration(self.document, bearing.assembly(self.document))
        obj.StyleKeys = {"hatch.spacing_min": "0.48"}
        self.document.recompute()
        support.drawn()
        page = self.check(obj)
        counts = [elements(data) for data in re.findall(r' d="([^"]*)"', page.Views[0].Symbol)]
        print(f"elements of its paths: {sorted(counts)}")
        self.assertGreater(sum(counts), 32_767, "the test is of a drawing that needs several paths")
        self.assertLessEqual(max(counts), 30_000)

    def test_colors_of_parts_and_their_shadow(self):
        obj = self.illustrate(*self.box_and_ball())
        obj.Style = "shaded"
        self.document.recompute()
        support.drawn()
        page = self.check(obj)
        self.assertIn('fill="#', page.Views[0].Symbol)
        self.assertNotIn("fill-opacity", page.Views[0].Symbol)

    def test_parts_are_seen_through_as_in_the_3d_view(self):
        box, ball = self.box_and_ball()
        ball.ViewObject.Transparency = 60
        obj = self.illustrate(box, ball)
        obj.Style = "flat"
        self.document.recompute()
        support.drawn()
        self.assertIn('fill-opacity="0.4', self.check(obj).Views[0].Symbol)


support.run(__name__)
