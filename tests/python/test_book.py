"""Sheets with several views and details, and step books: kernel/docs/views.md, step_books.md."""

import tempfile
import unittest
from pathlib import Path

import burin
from support import SAMPLES, cube


class Views(unittest.TestCase):
    def test_several_and_a_detail(self):
        for views in ("front,top,iso", ["front", "top", "iso"]):
            drawing = burin.draw(SAMPLES / "coupling.step", style="outline", paper="A3", views=views,
                                 projection="third", detail=["*key*", "0,0,0,5=2:1"])
            names = [view["name"] for view in drawing.views]
            self.assertEqual(names, ["front", "top", "iso", "A", "B"])
            scales = [view["view"].scale for view in drawing.views]
            self.assertEqual(len(set(scales[:3])), 1)
            self.assertAlmostEqual(scales[4], 2)
        again = burin.Drawing.from_json(drawing.to_bytes("json"))
        for view, kept in zip(drawing.views, again.views):
            self.assertEqual(kept["name"], view["name"])
            for a, b in zip(kept["box"], view["box"]):
                self.assertAlmostEqual(a, b, places=3)

    def test_a_session_draws_the_same(self):
        asked = {"style": "engraving", "views": "front,iso", "detail": ["0,0,0,6=5:1"], "paper": "A6"}
        for file in ("bracket.off", "blend.implicit"):
            scene, session = burin.Scene.read(SAMPLES / file), burin.Session()
            fresh = burin.draw(scene, **asked).to_bytes("json")
            for _ in range(2):
                self.assertEqual(burin.draw(scene, session=session, **asked).to_bytes("json"), fresh, file)

    def test_one_alone_has_none(self):
        self.assertEqual(burin.draw(SAMPLES / "bracket.off", style="outline").views, [])

    def test_what_an_illustration_says(self):
        said = burin.illustration({"burin": "illustration", "parts": [{"file": str(SAMPLES / "bracket.off")}],
                                   "views": ["front", "left"], "projection": "third",
                                   "details": [{"at": [0, 0, 0], "radius": 5}, "bracket=2:1"],
                                   "dimensions": ["overall", {"radius": [1, 2, 3]}]})
        self.assertEqual(said["views"], ["front", "left"])
        self.assertEqual(said["projection"], "third")
        self.assertEqual(said["dimensions"], ["overall", {"radius": [1, 2, 3]}])
        self.assertEqual(said["details"], [{"at": [0, 0, 0], "radius": 5}, "bracket=2:1"])

    def test_errors(self):
        with self.assertRaisesRegex(burin.UsageError, "argument views takes each view once"):
            burin.draw(SAMPLES / "bracket.off", views="front,front")


class Books(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.book = burin.steps(SAMPLES / "gear_pump.step", style="outline")

    def test_pages(self):
        book = self.book
        self.assertEqual(book.title, "gear pump")
        self.assertEqual(len(book.pages), 11)
        added = [(part["name"], part["quantity"]) for part in book.pages[-1]["added"]]
        self.assertEqual(added, [("screw M6", 6)])
        self.assertIsInstance(book.pages[0]["drawing"], burin.Drawing)
        self.assertEqual(len({page["scale"] for page in book.pages}), 5)
        self.assertEqual({page["title"] for page in book.pages},
                         {"", "idler", "idler shaft + key", "drive", "drive shaft + key"})
        self.assertEqual(sum(item["quantity"] for item in book.items), 23)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            self.book.save(Path(folder, "a.pdf"), Path(folder, "a.md"), Path(folder, "a.html"))
            names = {path.name for path in Path(folder).iterdir()}
            self.assertEqual(len(names), 3 + 11)
            self.assertIn("a-step-11.svg", names)

    def test_fewer_items_a_step(self):
        scene = burin.Scene.read(SAMPLES / "gear_pump.step")
        one = burin.steps(scene, new_items=1, style="outline", hide=["gear ?"], explode="z")
        for page in one.pages:
            self.assertLessEqual(len(page["added"]), 1 + 1)  # and what the first stands on

    def test_what_is_about_one_drawing_is_told(self):
        scene = burin.Scene()
        for height in (0, 10):
            vertices, triangles = cube()
            scene.add_mesh(vertices + [0, 0, height], triangles, name=f"box {height}")

        def unused(**options):
            book = burin.steps(scene, style="outline", **options)
            return [d.message for d in book.diagnostics if d.code == "option.unused"]

        self.assertEqual(unused(), [])
        self.assertEqual(unused(legend=True), ["legend has no effect on a step book"])
        self.assertEqual(unused(views=["front", "top"], legend=True),
                         ["views, legend have no effect on a step book"])
        with self.assertRaisesRegex(burin.UsageError, "session is for draw"):
            burin.steps(scene, session=burin.Session())

    def test_errors(self):
        with self.assertRaisesRegex(burin.UsageError, "from 1"):
            burin.steps(SAMPLES / "bracket.off", new_items=0)
        with self.assertRaisesRegex(burin.UsageError, ".pdf, .html, .md or .json"):
            self.book.save("book.svg")
        with self.assertRaises(burin.UsageError):
            self.book.save()


if __name__ == "__main__":
    unittest.main()
