"""`burin book`: figures and fragments, made once and made anew where what they show has changed."""

import json
import os
import re
import subprocess
import unittest

from batch_support import COMMAND, SAMPLES, BatchTest, box_off
from burin.book import figures

BOOK = """
title = "Two boxes"
formats = ["svg", "pdf"]
options = {style = "house.json", paper = "A6"}

[[figures]]
name = "both"
model = ["parts/a.off", "parts/b.off"]
caption = "Both *boxes*"
parts_list = true
options = {callouts = true}

[[figures]]
name = "alone"
model = "parts/a.off"
"""


class FigureTest(BatchTest):
    def setUp(self):
        super().setUp()
        self.parts("a.off", "b.off")
        (self.folder / "house.json").write_text('{"base": "outline"}')

    def book(self, text=None, *words, status=0):
        if text is not None:
            (self.folder / "book.toml").write_text(text)
        run = subprocess.run([COMMAND, "book", "book.toml", *words], cwd=self.folder, capture_output=True, text=True)
        self.said = run.stderr
        self.assertEqual(run.returncode, status, run.stderr + run.stdout)
        return sorted(run.stdout.splitlines())


class Figures(FigureTest):
    def test_are_made_once(self):
        self.assertEqual(self.book(BOOK), ["made  alone", "made  both"])
        out = self.folder / "figures"
        self.assertEqual({p.name for p in out.glob("*.*") if p.is_file()},
                         {"alone.md", "alone.pdf", "alone.svg", "book.json", "book.md", "both.items.json", "both.md", "both.pdf", "both.svg"})
        self.assertEqual(
            (out / "both.md").read_text(),
            "![Both \\*boxes\\*](both.svg)\n\n*Both \\*boxes\\**\n\n| No. | Qty | Name |\n| ---: | ---: | --- |\n| 1 | 1 | a |\n| 2 | 1 | b |\n",
        )
        self.assertEqual((out / "alone.md").read_text(), "![alone](alone.svg)\n")
        self.assertTrue((out / "book.md").read_text().startswith("# Two boxes\n\n![Both"))
        self.assertEqual([f["name"] for f in json.loads((out / "book.json").read_text())["figures"]], ["both", "alone"])
        before = {p: p.stat().st_mtime_ns for p in out.iterdir()}
        self.assertEqual(self.book(None, "--check"), ["kept  alone", "kept  both"])
        self.assertEqual({p: p.stat().st_mtime_ns for p in out.iterdir() if p.name[0] != "."}, {p: t for p, t in before.items() if p.name[0] != "."})

    def test_are_made_anew_where_something_changed(self):
        self.book(BOOK)
        (self.folder / "parts/b.off").write_text(box_off(5, 5, 5))
        self.assertEqual(self.book(None, "--check", status=6), ["kept  alone", "made  both"])
        os.utime(self.folder / "parts/b.off", (1, 1))
        self.assertEqual(self.book(None), ["kept  alone", "kept  both"])
        (self.folder / "house.json").write_text('{"base": "outline", "line.outer": 0.9}')
        self.assertEqual(self.book(None), ["made  alone", "made  both"])
        (self.folder / "figures/alone.svg").write_text("mine")
        self.assertEqual(self.book(None), ["kept  both", "made  alone"])
        self.assertEqual(self.book(BOOK.replace("Both *boxes*", "Two"), "--check", status=6), ["kept  alone", "kept  both"])
        self.assertIn("*Two*", (self.folder / "figures/both.md").read_text())

    def test_one_that_fails_is_told_and_the_others_are_made(self):
        text = BOOK + '\n[[figures]]\nname = "gone"\nmodel = "parts/gone.off"\n'
        self.assertEqual(self.book(text, status=1), ["made  alone", "made  both"])
        self.assertRegex(self.said, r"^burin: error: figure gone: .*gone\.off.*\n$")
        self.parts("gone.off")
        self.assertEqual(self.book(None), ["kept  alone", "kept  both", "made  gone"])

    def test_step_books(self):
        text = f'[[figures]]\nname = "steps"\nmodel = "{SAMPLES / "coupling.step"}"\nsteps = true\nparts_list = true\nformats = ["svg", "pdf"]\noptions = {{style = "outline"}}\nlink = "x"\n'
        self.book(text, status=3)
        self.assertIn("has no key 'link'", self.said)
        self.assertEqual(self.book('link = "figures/"\n' + text.replace('link = "x"\n', "")), ["made  steps"])
        fragment = (self.folder / "figures/steps.md").read_text()
        steps = fragment.count("### Step ")
        self.assertGreaterEqual(steps, 3)
        for number in range(1, steps + 1):
            self.assertIn(f"](figures/steps-step-{number:02}.svg)", fragment)
            for suffix in ("svg", "pdf"):
                self.assertGreater((self.folder / f"figures/steps-step-{number:02}.{suffix}").stat().st_size, 1000)
        self.assertIn("| No. | Qty | Name |", fragment)
        self.assertEqual(self.book(None, "--check"), ["kept  steps"])
        (self.folder / "figures/steps-step-01.svg").unlink()
        self.assertEqual(self.book(None), ["made  steps"])

    def test_what_the_book_no_longer_has_is_removed(self):
        out = self.folder / "figures"
        self.book(BOOK)
        (self.folder / "parts/a.off").write_text(box_off(3, 3, 3))
        self.book(None)
        (out / "mine.txt").write_text("mine")
        fewer = BOOK.replace('name = "both"', 'name = "pair"')
        self.book(fewer)
        self.assertTrue((out / "both.svg").exists())
        (out / "both.pdf").write_text("edited by hand")
        said = self.book(None, "--prune", "--check", status=6)
        self.assertEqual(said, ["kept  alone", "kept  pair", "left, it has changed since  both.pdf", "removed  both.items.json", "removed  both.md", "removed  both.svg"])
        self.assertEqual({p.name for p in out.glob("*.*") if p.is_file()},
                         {"alone.md", "alone.pdf", "alone.svg", "book.json", "book.md", "both.pdf", "mine.txt", "pair.items.json", "pair.md", "pair.pdf", "pair.svg"})  # fmt: skip
        self.assertEqual(self.book(None, "--prune", "--check"), ["kept  alone", "kept  pair"])
        # Not where a figure fails: what it was may be wanted still.
        self.book(fewer.replace('name = "pair"', 'name = "two"').replace("parts/b.off", "parts/gone.off"), "--prune", status=1)
        self.assertTrue((out / "pair.svg").exists())

    def test_only(self):
        self.assertEqual(self.book(BOOK, "--only", "alone"), ["made  alone"])
        self.assertFalse((self.folder / "figures/book.md").exists())
        self.book(None, "--only", "other", status=2)
        self.assertIn("there are both, alone", self.said)


class Nonsense(FigureTest):
    def refused(self, text, words, status=3):
        self.book(text, status=status)
        self.assertIn(words, self.said)
        self.assertEqual(self.said.count("\n"), 1, self.said)

    def test_is_one_line(self):
        self.refused("a = [", "is no TOML")
        self.refused("titel = 'x'", "no key 'titel'; the nearest is 'title'")
        self.refused("title = 'x'", "names no figures")
        self.refused("[[figures]]\nname = 'a'", "figures 1 has no model")
        one = "[[figures]]\nname = 'a'\nmodel = 'parts/a.off'\n"
        self.refused(one + one, "another figure of the name 'a'")
        self.refused(one.replace("'a'", "'../a'"), "is no name of a file")
        self.refused(one + "formats = ['svg', 'svg']", "each format once")
        self.refused(one + "steps = 0", "whole number from 1")
        self.refused(one + "options = {output = 'x.svg'}", "is set by formats")
        self.refused("out = '../x'\n" + one, "not below the folder of the book")
        self.refused(one + "options = {styl = 'outline'}", "styl", status=1)
        self.refused(one + "formats = ['bmp']", "bmp", status=1)

    def test_a_book_that_is_not_there(self):
        run = subprocess.run([COMMAND, "book", "none.toml"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (3, "burin: error: none.toml: cannot be read: No such file or directory\n"))
        run = subprocess.run([COMMAND, "book", "--help"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0)
        self.assertIn("BOOK.toml", run.stdout)


class Reading(unittest.TestCase):
    def test_options_about_reading_are_the_rows_of_the_readers(self):
        rows = "".join(p.read_text() for p in sorted((SAMPLES.parent / "converters/read").rglob("*.cpp")))
        self.assertEqual(set(figures._READING), set(re.findall(r'\{\.name = "(\w+)"', rows)))


if __name__ == "__main__":
    unittest.main()
