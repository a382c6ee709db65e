"""Illustrations written as illustration files: the kernel, without FreeCAD, draws the same from them."""

import json
import os
import re
import subprocess
import sys

import numpy
import Mesh
import Part

from support import V, App, Case, burin, content, features

from freecad.burin_wb import illustration_file
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features.sheet import Sheet, distance_to


def placed(x, y, z, axis=(0, 0, 1), angle=0.0):
    return App.Placement(V(x, y, z), App.Rotation(V(*axis), angle))


class IllustrationFile(Case):
    def write(self, obj):
        path = os.path.join(self.folder, "pump.burin.json")
        illustration_file.write(obj, path)
        with open(path, encoding="utf-8") as file:
            return path, json.load(file)

    def block(self, name="Block"):
        return self.solid(Part.makeBox(40, 30, 20).cut(Part.makeCylinder(7, 90, V(20, 15, -5))), name)

    def alike(self, obj, path, off=2e-4):
        """The kernel draws from the file what the document keeps: number by number."""
        kept, other = burin().Drawing.load(obj.Drawing).arrays(), burin().draw(path).arrays()
        self.assertGreater(len(kept["points"]), 20)
        for name in ("first", "kind", "part", "face", "edge", "visible"):
            numpy.testing.assert_array_equal(kept[name], other[name], name)
        for name in ("points", "width"):
            numpy.testing.assert_allclose(kept[name], other[name], atol=off)

    def test_it_draws_the_same(self):
        block = self.block()
        block.Placement = placed(10, 20, 30)
        ball = self.solid(Part.makeSphere(15), "Ball")
        ball.Placement = placed(70, 30, 0)
        obj = self.illustration(block, ball, Style="engraving", Width=150, Height=100, Margin=7, HiddenLines="Dashed", Seed=3,
                                Light=V(0.5, 0.2, 0.9), ViewDirection=V(1, -2, 0.7), StyleKeys={"line.outer": "0.8"})
        self.alike(obj, self.write(obj)[0])
        obj.Projection, obj.FieldOfView, obj.Style, obj.Tolerance = "Perspective", 20, "technical", 0.05
        self.doc.recompute()
        self.alike(obj, self.write(obj)[0])
        obj.Projection, obj.FitScale, obj.Scale = "Orthographic", False, 0.6
        self.doc.recompute()
        path, data = self.write(obj)
        self.assertEqual(data["view"]["scale"], 0.6)
        self.alike(obj, path)

    def test_the_command_draws_it_elsewhere(self):
        obj = self.illustration(self.block(), Style="outline")
        path, _ = self.write(obj)
        moved = os.path.join(self.folder, "moved")
        os.mkdir(moved)
        for name in ("pump.burin.json", "pump.models"):
            os.rename(os.path.join(self.folder, name), os.path.join(moved, name))
        out = os.path.join(self.folder, "a.json")
        program = "import sys; sys.path.append(sys.argv[1]); import burin; burin.draw(sys.argv[2]).save(sys.argv[3])"
        python = "/usr/bin/python%d.%d" % sys.version_info[:2]
        subprocess.run([python, "-c", program, os.path.dirname(os.path.dirname(burin().__file__)),
                        os.path.join(moved, "pump.burin.json"), out], check=True, timeout=60, stdin=subprocess.DEVNULL)
        self.assertEqual(len(list(Sheet(out).paths())), len(list(Sheet(obj.Drawing).paths())))

    def test_turned_assemblies_links_meshes_and_mirrors(self):
        block = self.block()
        part = self.doc.addObject("App::Part", "Part")
        part.Placement = placed(10, 20, 30, (1, 2, 3), 33)
        part.addObject(block)
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = block
        link.Placement = placed(0, -60, 0, (0, 1, 1), 70)
        mirror = self.doc.addObject("App::Link", "Mirror")
        mirror.LinkedObject = block
        mirror.ScaleVector = V(1, 1, -1)
        mirror.Placement.Base = V(90, 0, 0)
        net = self.doc.addObject("Mesh::Feature", "Net")
        net.Mesh = Mesh.createBox(20, 30, 10)
        net.Placement = placed(0, 80, 0, (1, 0, 0), 20)
        self.doc.recompute()
        obj = self.illustration(part, link, mirror, net, Style="outline")
        self.assertEqual(obj.Message, "")
        path, data = self.write(obj)
        self.assertEqual(data["parts"][0]["file"], data["parts"][1]["file"], "instances have one model")
        self.assertEqual(len(os.listdir(os.path.join(self.folder, "pump.models"))), 3, "FreeCAD makes a shape of its own of a link that mirrors")
        other = os.path.join(self.folder, "drawn.json")
        burin().draw(path).save(other)
        kept, drawn = ([p for _, p in Sheet(f).paths()] for f in (obj.Drawing, other))
        self.assertEqual(len(kept), len(drawn))
        for a, b in ((kept, drawn), (drawn, kept)):
            for line in a:
                others = [p for p in b if (p["part"], p["kind"]) == (line["part"], line["kind"])]
                for point in line["points"][:: max(1, len(line["points"]) // 5)]:
                    self.assertLess(min(distance_to(p, point) for p in others), 0.02)

    def test_a_mirror_image_is_placed_by_its_matrix(self):
        self.assertEqual(illustration_file._place((1, 0, 0, 5, 0, 1, 0, 6, 0, 0, -1, 7, 0, 0, 0, 1)),
                         {"matrix": [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, -1, 7]]})

    def test_looks_and_names(self):
        boxes = [self.box(name=n) for n in "ABCD"]
        for k, box in enumerate(boxes):
            box.Placement.Base = V(0, 40 * k, 0)
            box.Label = "M8/*bolt?"  # FreeCAD numbers labels that are there already
        style = os.path.join(self.folder, "mine.json")
        with open(style, "w") as file:
            json.dump({"base": "outline", "line.outer": 1.1}, file)
        obj = self.illustration(*boxes, Style="technical",
                                Looks={"A": "not drawn", "B": "not hatched;transparent", "C": "style=" + style, "D": "style=outline"})
        path, data = self.write(obj)
        names = [part["name"] for part in data["parts"]]
        self.assertEqual(len(set(names)), 4)
        self.assertFalse([name for name in names if re.search(r"[/*?]", name)])
        os.unlink(style)  # what it held stands in the file
        looks = {look["select"]: look for look in data["looks"]}
        self.assertEqual(looks["/" + names[0]], {"select": "/" + names[0], "drawn": False})
        self.assertEqual(looks["/" + names[1]], {"select": "/" + names[1], "hatched": False, "transparent": True})
        self.assertEqual(looks["/" + names[2]]["style"]["line.outer"], 1.1)
        self.assertEqual(looks["/" + names[3]]["style"], "outline")
        self.alike(obj, path)

    def test_a_style_file_of_the_illustration(self):
        style = os.path.join(self.folder, "mine.json")
        with open(style, "w") as file:
            json.dump({"base": "engraving", "line.outer": 1.1}, file)
        obj = self.illustration(self.block(), Style=style, StyleKeys={"hatch.spacing_min": "0.6"})
        path, _ = self.write(obj)
        os.unlink(style)
        self.alike(obj, path)

    def test_what_cannot_be_written_leaves_nothing_or_what_was_there(self):
        obj = self.illustration(self.block())
        path, _ = self.write(obj)
        before = content(path)
        obj.StyleKeys = {"line.outr": "1"}
        with self.assertRaisesRegex(Refused, "line.outr"):
            illustration_file.write(obj, path)
        obj.StyleKeys = {}
        with self.assertRaisesRegex(Refused, "end with .burin.json"):
            illustration_file.write(obj, os.path.join(self.folder, "pump.json"))
        with self.assertRaises(OSError):
            illustration_file.write(obj, os.path.join(self.folder, "nowhere", "pump.burin.json"))
        obj.Sources = []
        with self.assertRaisesRegex(Refused, "Sources is empty"):
            illustration_file.write(obj, path)
        self.assertEqual(content(path), before)
        self.assertEqual(sorted(os.listdir(self.folder)), ["pump.burin.json", "pump.models"])
