"""kernel/docs/site.py: the links of pages, and the site made of them."""

import importlib.util
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import SOURCE

PAGE = """# Page

Good: [the other](../../other.md#two-words), [itself](#page), [a file](../../data/a%20b.txt), [a folder](../../data),
[away](https://example.org/none.md), `[code](none.md)`, ![a picture](../../p.png "a title").

    [code](none.md)

```
[code](none.md)
```

| a |
|---|
| `x\\|y` |

A line
- an item

  of two lines
    - within it
"""
OTHER = "# Other\n\n## Two words\n\n## Twice\n\n## Twice\n"
HAVE = all(importlib.util.find_spec(name) for name in ("mkdocs", "pymdownx"))


class Site(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        docs = self.root / "kernel/docs"
        (self.root / "data").mkdir()
        docs.mkdir(parents=True)
        for name in ("site.py", "mkdocs.yml"):
            shutil.copy(SOURCE / "kernel/docs" / name, docs)
        shutil.copytree(SOURCE / "kernel/docs/theme", docs / "theme")
        config = (docs / "mkdocs.yml").read_text().split("\nnav:\n")[0]
        (docs / "mkdocs.yml").write_text(config + "\nnav:\n  - Start: README.md\n  - Page: kernel/docs/page.md\n")
        (docs / "page.md").write_text(PAGE)
        (self.root / "other.md").write_text(OTHER)
        (self.root / "README.md").write_text("# Start\n\n[page](kernel/docs/page.md)\n")
        (self.root / "data/a b.txt").write_text("text")
        (self.root / "p.png").write_bytes((SOURCE / "samples/rings.png").read_bytes())

    def run_site(self, *words):
        return subprocess.run([sys.executable, self.root / "kernel/docs/site.py", *words], capture_output=True, text=True)

    def test_good_links(self):
        run = self.run_site("--check")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout, "3 pages, 6 relative links: each leads somewhere\n")

    def test_each_bad_link_is_a_line(self):
        (self.root / "README.md").write_text(
            "# Start\n\n[a](none.md), [b](other.md#three)\n[c](other.md#twice) [![d](none.png)](kernel)\n<img src=\"none.svg\">\n"
        )
        run = self.run_site("--check")
        self.assertEqual(run.returncode, 1)
        self.assertEqual(
            run.stderr.splitlines(),
            [
                "README.md:3: none.md: no such file",
                "README.md:3: other.md#three: no such heading",
                "README.md:4: other.md#twice: several headings have this anchor",
                "README.md:4: none.png: no such file",
                "README.md:5: none.svg: no such file",
                "site.py: 5 links lead nowhere",
            ],
        )

    @unittest.skipUnless(HAVE, "MkDocs is not there: mkdocs python3-pymdownx")
    def test_site(self):
        run = self.run_site()
        self.assertEqual(run.returncode, 0, run.stderr)
        site = self.root / "build/docs/site"
        page = (site / "kernel/docs/page.html").read_text()
        self.assertIn("<code>x|y</code>", page)
        # The item holds both lines and the inner list.
        self.assertRegex(page, re.compile(r"<li>\s*<p>an item</p>\s*<p>of two lines</p>\s*<ul>\s*<li>within it</li>\s*</ul>\s*</li>"))
        self.assertEqual(page.count("[code](none.md)"), 3)
        self.assertIn('href="a%20b.txt"', (site / "data/index.html").read_text())
        self.assertTrue((site / "data/a b.txt").is_file() and (site / "p.png").is_file())
        # A page that `nav` does not name is in a section of its own.
        self.assertRegex((site / "index.html").read_text(), r'href="other.html"[^>]*>Other<')


if __name__ == "__main__":
    unittest.main()
