"""The directive of Sphinx: real builds of small projects."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import unittest

from batch_support import COMMAND, BatchTest, box_off

CONF = f"""
extensions = ["burin.sphinx"]
project = "Boxes"
author = "Us"
burin_command = {COMMAND!r}
burin_options = {{"style": "outline", "paper": "60x40"}}
exclude_patterns = ["_burin"]
"""
INDEX = """
Boxes
=====

.. burin:: parts/a.off
   :callouts:
   :list:
   :page:
   :width: 50%
   :name: first

   The *first* box.

   More of it.

See :ref:`the figure <first>`.

.. toctree::

   deep/other
"""
OTHER = """
Other
=====

.. burin:: ../parts/b.off
   :look: b=technical
   :view: 1,-1,1
"""


@unittest.skipUnless(importlib.util.find_spec("sphinx"), "Sphinx is not there: python3-sphinx")
class Sphinx(BatchTest):
    def setUp(self):
        super().setUp()
        self.parts("a.off", "b.off")
        (self.folder / "deep").mkdir()
        self.write("conf.py", CONF)
        self.write("index.rst", INDEX)
        self.write("deep/other.rst", OTHER)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def build(self, *words, builder="html"):
        """Runs Sphinx; what it warns of."""
        run = subprocess.run(
            [sys.executable, "-m", "sphinx", "-b", builder, *words, ".", "out"], cwd=self.folder, capture_output=True, text=True
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stderr

    def drawings(self):
        return {p.name: p.stat().st_mtime_ns for p in (self.folder / "_burin").iterdir() if p.suffix in (".svg", ".pdf", ".html")}

    def test_pages(self):
        self.assertEqual(self.build("-j", "2"), "")
        page = (self.folder / "out/index.html").read_text()
        image = re.search(r'<img alt="Drawing of a.off" src="(_images/a-\w+\.svg)"[^>]*50%', page)
        self.assertTrue(image, page)
        self.assertIn("<path", (self.folder / "out" / image[1]).read_text())
        self.assertIn("The <em>first</em> box.", page)
        self.assertIn("More of it.", page)
        self.assertRegex(page, r"<td><p>1</p></td>\s*<td><p>1</p></td>\s*<td><p>a</p></td>")
        link = re.search(r'href="(_burin/a-\w+\.html)">Open this figure', page)
        self.assertTrue(link, page)
        self.assertIn("data-item=", (self.folder / "out" / link[1]).read_text())
        self.assertRegex((self.folder / "out/deep/other.html").read_text(), r'src="\.\./_images/b-\w+\.svg"')

    def test_drawings_are_made_where_something_changed(self):
        self.build()
        before = self.drawings()
        self.assertEqual(len(before), 5)
        self.write("index.rst", INDEX + "\nMore text.\n")
        self.build()
        self.assertEqual(self.drawings(), before)
        # A model is what a document depends on; the drawing of what it was goes.
        (self.folder / "parts/b.off").write_text(box_off(3, 3, 3))
        os.utime(self.folder / "parts/b.off")
        self.build()
        after = self.drawings()
        self.assertEqual(len(after), 5)
        self.assertEqual({n for n in before if n.startswith("a-")}, {n for n in after if n.startswith("a-")})
        self.assertFalse({n for n in before if n.startswith("b-")} & {n for n in after if n.startswith("b-")})

    def test_the_command_is_asked_for_its_version_once(self):
        command = self.folder / "counting"
        command.write_text(f'#!/bin/sh\n[ "$1" != --version ] || echo asked >>"{self.folder}/asked"\nexec {COMMAND} "$@"\n')
        command.chmod(0o755)
        self.assertEqual(self.build("-j", "2", "-D", f"burin_command={command}"), "")
        self.assertEqual((self.folder / "asked").read_text(), "asked\n")
        # Nothing to read, nothing to ask.
        self.build("-D", f"burin_command={command}")
        self.assertEqual((self.folder / "asked").read_text(), "asked\n")

    def test_without_the_command_documents_are_built_all_the_same(self):
        said = self.build("-D", f"burin_command={self.folder}/none")
        self.assertEqual(said.count("WARNING: burin: "), 2, said)
        self.assertIn("is no command", said)
        self.assertTrue((self.folder / "out/index.html").exists())

    def test_what_is_wrong_is_a_warning_at_its_line(self):
        self.write("deep/other.rst", OTHER + "\n.. burin:: gone.off\n\n.. burin:: ../parts/a.off\n   :styl: outline\n\n.. burin:: ../parts/a.off\n   :style: none\n")
        said = self.build()
        self.assertRegex(said, r"deep/other\.rst:9: WARNING: burin: .*gone\.off")
        self.assertRegex(said, r'deep/other\.rst:11: ERROR: (.|\n)*unknown option: "styl"')
        self.assertRegex(said, r"deep/other\.rst:14: WARNING: burin: .*none")
        self.assertIn("_images/b-", (self.folder / "out/deep/other.html").read_text())

    def test_steps(self):
        model = os.path.relpath(os.environ["BURIN_SOURCE_DIR"] + "/samples/coupling.step", self.folder)
        self.write("deep/other.rst", f"Steps\n=====\n\n.. burin:: ../{model}\n   :steps:\n   :paper: A5\n")
        self.assertEqual(self.build(), "")
        page = (self.folder / "out/deep/other.html").read_text()
        self.assertGreaterEqual(len(re.findall(r'src="\.\./_images/coupling-\w+-step-\d\d\.svg"', page)), 3)
        self.assertIn('<p class="rubric">Step 1', page)

    def test_latex(self):
        self.assertEqual(self.build(builder="latex"), "")
        text = (self.folder / "out/boxes.tex").read_text()
        self.assertRegex(text, r"\\sphinxincludegraphics\[width=0\.50*\\linewidth\]\{\{a-\w+\}\.pdf\}")
        self.assertNotIn("Open this figure", text)
        self.assertGreater(len(pdf_pages(self, self.folder / "out", "boxes")), 2)


def pdf_pages(test, folder, name):
    """Runs LaTeX in the folder that Sphinx wrote; the text of each page."""
    if not shutil.which("latexmk"):
        test.skipTest("LaTeX is not there: latexmk texlive-latex-extra")
    run = subprocess.run(["make", "-C", folder, "LATEXMKOPTS=-silent"], capture_output=True, text=True)
    test.assertEqual(run.returncode, 0, run.stdout[-3000:])
    test.assertTrue((folder / f"{name}.pdf").read_bytes().startswith(b"%PDF"))
    return subprocess.run(["pdftotext", "-layout", folder / f"{name}.pdf", "-"], capture_output=True, text=True, check=True).stdout.split("\f")


@unittest.skipUnless(importlib.util.find_spec("sphinx"), "Sphinx is not there: python3-sphinx")
class Manual(BatchTest):
    """samples/manual, as it lies there."""

    def build(self, builder):
        samples = self.folder / "samples"
        samples.mkdir()
        source = os.environ["BURIN_SOURCE_DIR"] + "/samples"
        shutil.copytree(source + "/manual", samples / "manual", ignore=shutil.ignore_patterns("_burin"))
        shutil.copy(source + "/gear_pump.step", samples)
        run = subprocess.run(
            [sys.executable, "-m", "sphinx", "-W", "-b", builder, "-D", f"burin_command={COMMAND}", samples / "manual", self.folder / "out"],
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.folder / "out"

    def test_pages(self):
        out = self.build("html")
        self.assertEqual(len(list((out / "_images").glob("*.svg"))), 15)
        self.assertIn("screw M6", (out / "parts.html").read_text())
        if not shutil.which("chromium"):
            self.skipTest("chromium is not there to open the pages in")
        seen = 0
        for name in ("index", "parts", "assembly", "inside"):
            # The page tells by its title how large each of its pictures is: 0 where it cannot be shown.
            page = out / f"{name}.html"
            text = page.read_text()
            self.assertEqual(text.count("</body>"), 1)
            script = "<script>onload = () => { document.title = 'widths ' + [...document.images].map(i => i.naturalWidth).join(' '); }</script>"
            page.write_text(text.replace("</body>", script + "</body>"))
            run = subprocess.run(
                ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.folder}/profile",
                 "--virtual-time-budget=10000", "--dump-dom", page.as_uri()],
                capture_output=True,
                text=True,
                timeout=300,
            )
            title = re.search(r"<title>widths ([\d ]+)</title>", run.stdout)
            self.assertTrue(title, run.stderr[-2000:])
            widths = [int(word) for word in title[1].split()]
            self.assertTrue(all(width > 100 for width in widths), widths)
            seen += len(widths)
        self.assertEqual(seen, 15)

    def test_latex(self):
        out = self.build("latex")
        pages = pdf_pages(self, out, "gearpump")
        drawn = set(re.findall(r"^File: (gear_pump-\S+)\.pdf Graphic file", (out / "gearpump.log").read_text(errors="replace"), re.M))
        self.assertEqual(len(drawn), 15)
        # No page ends between what a step adds and its picture, and two fit on each.
        steps = [len(re.findall(r"^\s*Step \d+", page, re.M)) for page in pages]
        self.assertEqual([n for n in steps if n], [1, 2, 2, 2, 2, 2])


if __name__ == "__main__":
    unittest.main()
