"""Fragments of a book in pages of others: MkDocs with snippets, and plain inclusion as GitBuilding has it."""

import importlib.util
import re
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

from batch_support import COMMAND, SAMPLES, BatchTest

BOOK = """
out = "docs/figures"
link = "../figures/"
options = {{style = "outline", paper = "A6"}}

[[figures]]
name = "two boxes"
model = ["parts/a.off", "parts/b.off"]
caption = "Both *boxes*"
parts_list = true
options = {{callouts = true}}

[[figures]]
name = "assembly"
model = "{samples}/coupling.step"
steps = true
"""
SITE = """
site_name: Boxes
theme: mkdocs
markdown_extensions:
  - tables
  - pymdownx.snippets:
      base_path: docs
      check_paths: true
"""
HAVE = all(importlib.util.find_spec(name) for name in ("mkdocs", "pymdownx"))


class _Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.pictures, self.headings, self._in = [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self._in = tag
        if tag == "img":
            self.pictures.append(dict(attributes))

    def handle_data(self, data):
        if self._in == "h3" and data.strip():
            self.headings.append(data)


class Included(BatchTest):
    def setUp(self):
        super().setUp()
        self.parts("a.off", "b.off")
        (self.folder / "book.toml").write_text(BOOK.format(samples=SAMPLES))
        run = subprocess.run([COMMAND, "book", "book.toml"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.guide = self.folder / "docs/guide"
        self.guide.mkdir(parents=True)

    @unittest.skipUnless(HAVE, "MkDocs and its snippets are not there: mkdocs python3-pymdownx")
    def test_mkdocs(self):
        (self.folder / "mkdocs.yml").write_text(SITE)
        (self.folder / "docs/index.md").write_text("# Boxes\n\n[More](guide/more.md)\n")
        (self.guide / "more.md").write_text('# More\n\nBefore.\n\n--8<-- "figures/two boxes.md"\n\nAfter.\n\n--8<-- "figures/assembly.md"\n')
        run = subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "-q"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertNotIn("WARNING", run.stderr)
        path = self.folder / "site/guide/more/index.html"
        page = _Page(path.read_text())
        steps = len(list((self.folder / "docs/figures").glob("assembly-step-*.svg")))
        self.assertGreaterEqual(steps, 5)
        self.assertEqual(len(page.pictures), 1 + steps)
        for picture in page.pictures:
            file = path.parent / unquote(urlsplit(picture["src"]).path)
            self.assertEqual(file.read_bytes(), (self.folder / "docs/figures" / file.name).read_bytes())
        self.assertEqual(page.pictures[0]["alt"], "Both *boxes*")
        for number, name in ((1, "a"), (2, "b")):
            self.assertRegex(path.read_text(), rf"<td[^>]*>{number}</td>\s*<td[^>]*>1</td>\s*<td[^>]*>{name}</td>")
        self.assertEqual(len(page.headings), steps)
        self.assertIn("<em>Both *boxes*</em>", path.read_text())

    def test_plain_inclusion(self):
        """As GitBuilding has it, which is not in Debian: the text of a file takes the place of {{include: FILE}}, as seen from the page."""
        page = self.guide / "more.md"
        page.write_text("# More\n\n{{include: ../figures/two boxes.md}}\n\n{{include: ../figures/assembly.md}}\n")
        text = re.sub(r"\{\{include: (.+?)\}\}", lambda m: (page.parent / m[1]).read_text(), page.read_text())
        links = re.findall(r"!\[(?:[^\]\\]|\\.)*\]\(([^)]+)\)", text)
        self.assertGreaterEqual(len(links), 6)
        for link in links:
            self.assertTrue((page.parent / unquote(link)).is_file(), link)
        self.assertEqual(links[0], "../figures/two%20boxes.svg")


if __name__ == "__main__":
    unittest.main()
