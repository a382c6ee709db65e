"""`burin book --since` and `--compare`: what has changed of the figures of a book."""

import json
import re
import shutil
import signal
import subprocess
import time
import unittest
from html.parser import HTMLParser

from batch_support import COMMAND, SAMPLES, box_off
from git_support import GitTest, off_again


class _Pictures(HTMLParser):
    """What a page loads and where it leads."""

    def __init__(self, text):
        super().__init__()
        self.sources, self.links, self.all = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.all.append(tag)
        self.sources += [given["src"]] if "src" in given else []
        self.links += [given["href"]] if "href" in given else []


class Since(GitTest):
    def test_each_figure_is_told(self):
        self.first()
        self.second()
        found = self.compare("--since", "HEAD^", status=6)
        self.assertEqual(self.said, "")
        self.assertEqual(self.statuses(found), {"both": "changed", "same": "same", "styled": "changed", "come": "added", "gone": "removed"})
        both = found["both"]
        self.assertEqual(both["models"], ["moved pin: moved by 10 mm (0, 0, 10)"])
        self.assertEqual({kind: n for kind, n in both["parts"].items() if n}, {"moved": 1, "same": 1})
        self.assertEqual(both["words"], ["caption 'Both boxes' to 'Both'"])
        self.assertEqual([(p["old"], p["new"], p["difference"], p["page"]) for p in both["shown"]], [("old/both.svg", "new/both.svg", "diff/both.svg", "diff/both.html")])
        self.assertIn("moved-to-", (self.repository / "differences/diff/both.svg").read_text())
        self.assertEqual(found["styled"]["words"], ["the models are the same, the drawing is not", "outline: width 0.5 mm to 0.9 mm"])
        self.assertEqual(found["come"]["shown"][0]["old"], "")
        self.assertEqual(found["gone"]["shown"][0]["new"], "")
        self.no_tree_is_left()

    def test_the_page_needs_nothing_but_what_lies_beside_it(self):
        self.first()
        self.second()
        self.compare("--since", "HEAD^", status=6)
        folder = self.repository / "differences"
        page = _Pictures((folder / "index.html").read_text())
        self.assertNotIn("script", page.all)
        self.assertEqual(sorted(page.sources), sorted(["diff/both.svg", "old/both.svg", "new/both.svg", "old/styled.svg", "new/styled.svg", "new/same.svg", "new/come.svg", "old/gone.svg"]))
        for name in page.sources + [link for link in page.links if not link.startswith("#")]:
            self.assertTrue((folder / name).is_file(), name)
        for link in (link[1:] for link in page.links if link.startswith("#")):
            self.assertIn(f'id="{link}"', (folder / "index.html").read_text())
        short = (folder / "differences.md").read_text()
        self.assertTrue(short.startswith("### Drawings of Two boxes: 2 changed, 1 added, 1 removed, 1 same\n"), short)
        self.assertIn("| both | changed | moved pin: moved by 10 mm (0, 0, 10)<br>caption 'Both boxes' to 'Both' |\n", short)
        self.assertIn("| gone | removed |  |\n\nSame: same\n", short)
        self.assertEqual(short.index("| both "), min(short.index(f"| {name} ") for name in ("both", "styled", "come", "gone")))

    def test_a_file_that_was_exported_again_is_the_same(self):
        self.first()
        text = (self.manual / "pin.off").read_text()
        self.commit(pin__off=off_again(text), base__off=off_again((self.manual / "base.off").read_text()))
        self.assertNotEqual((self.manual / "pin.off").read_text(), text)
        found = self.compare("--since", "HEAD^")
        self.assertEqual(set(self.statuses(found).values()), {"same"})
        self.assertEqual(found["both"]["parts"]["same"], 2)
        self.assertIn("4 same", (self.repository / "differences/differences.md").read_text())
        # The same work tree, nothing committed.
        self.assertEqual(set(self.statuses(self.compare("--since", "HEAD")).values()), {"same"})

    def test_what_lies_there_uncommitted_counts(self):
        self.first()
        self.write(pin__off=box_off(5, 6, 9))
        found = self.compare("--since", "HEAD", status=6)
        self.assertEqual(self.statuses(found), {"both": "changed", "same": "changed", "styled": "changed", "gone": "same"})
        self.assertIn("volume 210 to 270 mm3", found["same"]["models"][0])

    def test_files_that_a_model_includes_count(self):
        self.first()
        self.commit(house__burin__json=json.dumps({"burin": "illustration", "style": "outline", "looks": [{"select": "pin", "drawn": False}]}))
        found = self.compare("--since", "HEAD^", status=6)
        self.assertEqual({n: s for n, s in self.statuses(found).items() if s != "same"}, {"both": "changed"})

    @unittest.skipUnless(shutil.which("openscad"), "OpenSCAD is not there: openscad")
    def test_files_that_an_openscad_model_includes_count(self):
        book = '[[figures]]\nname = "lid"\nmodel = "lid.scad"\noptions = {style = "outline", csg = "burin"}\n'
        self.commit(book__toml=book, lid__scad="include <size.scad>\ncube([size, 10, 5]);\n", size__scad="size = 20;\n")
        self.commit(size__scad="size = 25;\n")
        found = self.compare("--since", "HEAD^", status=6)
        self.assertIn("volume 1000 to 1250 mm3", found["lid"]["models"][0])

    def test_a_change_that_a_figure_does_not_show(self):
        inner = {"burin": "illustration", "style": "outline", "parts": [{"file": "base.off"}, {"file": "pin.off", "place": {"translate": [5, 5, 5]}}]}
        book = '[[figures]]\nname = "shell"\nmodel = "a.burin.json"\n'
        self.commit(book__toml=book, base__off=box_off(20, 20, 30), pin__off=box_off(5, 6, 7), a__burin__json=json.dumps(inner))
        inner["parts"][1]["place"]["translate"] = [5, 5, 15]
        self.commit(a__burin__json=json.dumps(inner))
        found = self.compare("--since", "HEAD^")
        self.assertEqual(found["shell"]["models"], ["moved pin: moved by 10 mm (0, 0, 10)"])
        self.assertEqual(found["shell"]["words"], ["the models have changed, but not where this figure shows them"])
        self.assertEqual(found["shell"]["shown"][0]["status"], "same")

    @unittest.skipUnless(shutil.which("openscad"), "OpenSCAD is not there: openscad")
    def test_options_that_make_another_model(self):
        book = '[[figures]]\nname = "lid"\nmodel = "lid.scad"\noptions = {style = "outline", csg = "burin", define = {size = 20}}\n'
        self.commit(book__toml=book, lid__scad="size = 1;\ncube([size, 10, 5]);\n")
        self.commit(book__toml=book.replace("20", "25"))
        found = self.compare("--since", "HEAD^", status=6)
        self.assertIn("volume 1000 to 1250 mm3", found["lid"]["models"][0])

    def test_a_part_that_was_not_there(self):
        book = '[[figures]]\nname = "both"\nmodel = ["a.off", "b.off"]\noptions = {style = "outline"}\n'
        self.commit(book__toml=book, a__off=box_off(9, 9, 9), b__off=box_off(20, 20, 3))
        self.commit(book__toml=book.replace('"b.off"]', '"c.off"]').replace('"outline"', '"outline", hide = ["c"]'), c__off=box_off(4, 5, 6))
        found = self.compare("--since", "HEAD^", status=6)["both"]
        self.assertEqual({kind: n for kind, n in found["parts"].items() if n}, {"changed": 1, "same": 1})
        self.assertNotIn("cannot be compared", " ".join(found["words"]))

    def test_another_version_of_the_command(self):
        """One that draws thicker lines, as an older Burin might."""
        self.first()
        older = self.folder / "older"
        older.write_text(
            f"""#!/usr/bin/python3
import json, subprocess, sys
if sys.argv[1:] == ["batch", "job"]:
    asked = json.load(sys.stdin)
    for drawing in asked["drawings"]:
        drawing["options"]["set"] = ["line.outer=1.1"]
    run = subprocess.run([{COMMAND!r}, "batch", "job"], input=json.dumps(asked), capture_output=True, text=True)
else:
    run = subprocess.run([{COMMAND!r}, *sys.argv[1:]], capture_output=True, text=True)
now = subprocess.run([{COMMAND!r}, "--version"], capture_output=True, text=True).stdout.split()[1]
sys.stdout.write(run.stdout.replace(now, "0.0.1"))
sys.stderr.write(run.stderr)
sys.exit(run.returncode)
"""
        )
        older.chmod(0o755)
        found = self.compare("--since", "HEAD", "--old-burin", older, status=6)
        self.assertEqual(set(self.statuses(found).values()), {"changed"})
        self.assertEqual(found["styled"]["words"], ["the models are the same, the drawing is not", "outline: width 1.1 mm to 0.5 mm"])

    def test_figures_that_both_revisions_share_are_drawn_once(self):
        self.first()
        self.second()
        log = self.folder / "log"
        counting = self.folder / "counting"
        counting.write_text(f'#!/bin/sh\n[ "$1 $2" != "batch job" ] || echo drawn >>"{log}"\n[ "$1" != diff ] || echo diff >>"{log}"\nexec "{COMMAND}" "$@"\n')
        counting.chmod(0o755)

        def drawn(*words, status):
            log.write_text("")
            self.compare("--burin", counting, *words, status=status)
            lines = log.read_text().split()
            return lines.count("drawn"), lines.count("diff")

        # Two that changed twice each, one that is the same, one that came, one that went; models and lines of what changed.
        self.assertEqual(drawn("--since", "HEAD^", status=6), (7, 3))
        self.assertEqual(drawn("--since", "HEAD^", status=6), (0, 0))
        # What is old now was new before.
        self.assertEqual(drawn("--since", "HEAD", status=0), (0, 0))
        folder = self.repository / "differences"
        self.assertEqual([p.name for p in (folder / "diff").glob("*.*") if not p.name.startswith(".")], [])
        self.assertEqual({p.name for p in (folder / "old").glob("*.svg")}, {"both.svg", "same.svg", "styled.svg", "come.svg"})

    def test_one_that_fails_is_told_and_the_others_go_on(self):
        self.first()
        self.commit(pin__off="OFF\nnonsense\n")
        found = self.compare("--since", "HEAD^", status=1)
        self.assertEqual(self.statuses(found), {"both": "failed", "same": "failed", "styled": "failed", "gone": "same"})
        self.assertIn("pin.off", found["same"]["errors"]["new"])
        self.assertEqual(found["same"]["shown"][0]["old"], "old/same.svg")
        self.assertEqual(self.said.count("burin: error: figure "), 3)
        # And the other way round: the old one cannot be read.
        self.commit(pin__off=box_off(5, 6, 7))
        found = self.compare("--since", "HEAD^", status=1)
        self.assertEqual(self.statuses(found), {"both": "failed", "same": "failed", "styled": "failed", "gone": "same"})
        self.assertIn("pin.off", found["same"]["errors"]["old"])
        self.assertEqual(found["same"]["shown"][0]["new"], "new/same.svg")
        self.assertIn("| same | failed | old revision: pin.off", (self.repository / "differences/differences.md").read_text())

    def test_lists_and_captions(self):
        book = '[[figures]]\nname = "both"\nmodel = ["a.off", "b.off"]\nparts_list = true\noptions = {callouts = true, explode = "auto", style = "outline"}\n'
        self.commit(book__toml=book, a__off=box_off(9, 9, 9), b__off=box_off(20, 20, 3), c__off=box_off(4, 5, 6))
        self.commit(book__toml=book.replace('"b.off"]', '"b.off", "c.off"]'))
        found = self.compare("--since", "HEAD^", status=6)["both"]
        self.assertIn("added c: volume 120 mm3", found["models"][0])
        self.assertIn("parts list: c is new, 1 x", found["words"])
        # Options about reading belong to the files of a figure that has several.
        wide = book.replace("options = {", "options = {define = [\"w=7\"], ")
        self.commit(book__toml=wide, b__off=box_off(20, 20, 4))
        self.assertIn("volume 1200 to 1600 mm3", self.compare("--since", "HEAD^", status=6)["both"]["models"][0])
        self.assertEqual(found["shown"][0]["difference"], "diff/both.svg")

    def test_step_books(self):
        book = '[[figures]]\nname = "steps"\nmodel = "coupling.step"\nsteps = true\noptions = {style = "outline", paper = "A6"}\n'
        shutil.copy(SAMPLES / "coupling.step", self.manual)
        self.commit(book__toml=book)
        shutil.copy(SAMPLES / "coupling_revised.step", self.manual / "coupling.step")
        found = self.compare("--since", "HEAD", status=6)["steps"]
        self.assertEqual(found["parts"]["moved"], 1)
        whole, *steps = found["shown"]
        self.assertEqual((whole["heading"], whole["difference"]), ("The whole", "diff/steps.svg"))
        statuses = [s["status"] for s in steps]
        self.assertEqual(statuses.count("removed"), 1)
        self.assertGreaterEqual(statuses.count("changed"), 5)
        washers = next(s for s in steps if "adds 5 x washer 10" in s["words"])
        self.assertIn("no longer adds 6 x washer 10", washers["words"])
        self.assertRegex(" ".join(washers["words"]), r"was Step \d+ .*\d+ lines new")
        for name in (washers["old"], washers["new"], washers["difference"]):
            self.assertTrue((self.repository / "differences" / name).is_file(), name)
        # A step book that became a drawing.
        self.write(book__toml=book.replace("steps = true\n", ""))
        found = self.compare("--since", "HEAD", status=6)["steps"]
        self.assertIn("was a step book, is a drawing", found["words"])
        self.git("checkout", "-q", ".")
        self.assertEqual(self.statuses(self.compare("--since", "HEAD")), {"steps": "same"})


class Revisions(GitTest):
    def refused(self, words, *given, status=2, **more):
        run = subprocess.run([COMMAND, "book", "manual/book.toml", *given], cwd=more.get("cwd", self.repository), env=self.env, capture_output=True, text=True)
        self.assertEqual(run.returncode, status, run.stderr)
        self.assertRegex(run.stderr, rf"^burin: error: .*{words}.*\n$")

    def test_what_cannot_be_is_one_line(self):
        self.first()
        self.refused("has no revision 'nowhere'; a shallow clone lacks older ones: git fetch --depth=1 origin nowhere", "--since", "nowhere")
        self.refused("there is no file 'manual/none.toml' in HEAD", "--since", "HEAD:manual/none.toml")
        self.refused("not allowed with argument", "--since", "HEAD", "--compare", "x.toml")
        self.refused("--check is for making a book", "--since", "HEAD", "--check")
        self.refused("--line-tolerance is for --since or --compare", "--line-tolerance", "1")
        self.refused("--line-tolerance takes mm", "--since", "HEAD", "--line-tolerance", "x")
        self.refused("there is no figure 'none'", "--since", "HEAD", "--only", "none")
        self.refused("none.toml: cannot be read", "--compare", "none.toml", status=3)
        shutil.rmtree(self.repository / ".git")
        self.refused("lies in no repository of Git.*--compare OLD.toml takes any folder", "--since", "HEAD")

    def test_two_folders(self):
        self.first()
        shutil.copytree(self.manual, self.folder / "was")
        shutil.rmtree(self.repository / ".git")
        self.write(pin__off=box_off(1, 2, 3))
        words = ["--compare", self.folder / "was/book.toml", "-o", "told", "--only", "same"]
        run = subprocess.run([COMMAND, "book", "manual/book.toml", *words], cwd=self.repository, env=self.env, capture_output=True, text=True)
        self.assertEqual(run.returncode, 6, run.stderr)
        self.assertTrue(run.stdout.startswith("changed  same: parts: 1 changed\n"), run.stdout)
        found = self.data("told")
        self.assertEqual(self.statuses(found), {"same": "changed"})
        self.assertFalse((self.repository / "differences").exists())

    def test_where_there_was_no_book(self):
        nothing = self.commit("nothing")
        self.first()
        found = self.compare("--since", nothing[:10], status=6)
        self.assertEqual(set(self.statuses(found).values()), {"added"})
        self.assertIn(f"there was no manual/book.toml in {nothing[:10]}", self.said)
        self.assertIn("there was no manual/book.toml", (self.repository / "differences/index.html").read_text())
        # What a push says that makes a branch.
        found = self.compare("--since", "0" * 40, status=6)
        self.assertEqual(set(self.statuses(found).values()), {"added"})

    def test_a_book_that_had_another_name(self):
        self.first()
        self.git("mv", "manual", "guide")
        self.git("mv", "guide/book.toml", "guide/figures.toml")
        self.git("commit", "-q", "-m", "moved")
        found = self.compare("--since", "HEAD^:manual/book.toml", book="guide/figures.toml")
        self.assertEqual(set(self.statuses(found).values()), {"same"})

    def test_an_old_book_that_cannot_be_read(self):
        self.commit(book__toml="figures = [", pin__off=box_off(1, 2, 3))
        self.first()
        found = self.compare("--since", "HEAD^", status=1)
        self.assertEqual(set(self.statuses(found).values()), {"added"})
        self.assertRegex(self.said, r"the book of HEAD\^ \(\w+\) cannot be read: is no TOML")
        self.assertNotIn(self.env.get("TMPDIR", "/tmp") + "/burin-since", self.said)

    def test_from_a_folder_below_and_within_a_hook(self):
        self.first()
        self.second()
        self.env |= {"GIT_DIR": str(self.folder / "elsewhere"), "GIT_INDEX_FILE": str(self.folder / "index")}
        run = subprocess.run([COMMAND, "book", "book.toml", "--since", "HEAD^", "-o", "../differences"], cwd=self.manual, env=self.env, capture_output=True, text=True)
        self.assertEqual(run.returncode, 6, run.stderr)
        self.assertEqual(self.data()["both"]["status"], "changed")

    def test_submodules(self):
        models = self.folder / "models"
        models.mkdir()
        self.git("init", "-q", "-b", "main", ".", cwd=models)
        for k, text in enumerate((box_off(9, 9, 9), box_off(9, 9, 12))):
            (models / "part.off").write_text(text)
            self.git("add", "-A", cwd=models)
            self.git("commit", "-q", "-m", str(k), cwd=models)
        self.git("-c", "protocol.file.allow=always", "submodule", "--quiet", "add", str(models), "manual/models")
        self.git("checkout", "-q", "HEAD^", cwd=self.manual / "models")
        self.commit(book__toml='[[figures]]\nname = "part"\nmodel = "models/part.off"\noptions = {style = "outline"}\n')
        self.git("checkout", "-q", "main", cwd=self.manual / "models")
        self.commit("newer models")
        found = self.compare("--since", "HEAD^", status=6)
        self.assertIn("volume 729 to 972 mm3", found["part"]["models"][0])
        self.assertEqual(self.said, "")
        self.no_tree_is_left()
        self.no_tree_is_left(self.manual / "models")
        # One that is nowhere: its figure fails, by name.
        self.git("rm", "-q", "-f", "manual/models")
        shutil.rmtree(self.repository / ".git/modules")
        shutil.rmtree(models)
        self.write(**{"book__toml": '[[figures]]\nname = "part"\nmodel = "part.off"\n', "part__off": box_off(9, 9, 12)})
        found = self.compare("--since", "HEAD", status=1)
        self.assertIn("the submodule manual/models is missing: ", self.said)
        self.assertIn("models/part.off", found["part"]["errors"]["old"])

    @unittest.skipUnless(shutil.which("git-lfs"), "Git LFS is not there: git-lfs")
    def test_files_of_git_lfs(self):
        self.git("lfs", "install")
        (self.repository / ".gitattributes").write_text("*.off filter=lfs diff=lfs merge=lfs -text\n")
        self.first()
        self.assertIn("git-lfs", self.git("cat-file", "-p", "HEAD:manual/pin.off"))
        self.write(pin__off=box_off(5, 6, 9))
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "longer")
        found = self.compare("--since", "HEAD^", status=6)
        self.assertIn("volume 210 to 270 mm3", found["same"]["models"][0])
        self.assertEqual(self.statuses(found)["gone"], "same")
        # Where the old file is nowhere its figures fail, by name, and no others.
        old = re.search(r"oid sha256:((..)(..)\w+)", self.git("cat-file", "-p", "HEAD^:manual/pin.off"))
        (self.repository / f".git/lfs/objects/{old[2]}/{old[3]}/{old[1]}").unlink()
        shutil.rmtree(self.repository / "differences")
        found = self.compare("--since", "HEAD^", status=1)
        self.assertEqual(self.statuses(found)["same"], "failed")
        self.assertIn("is a pointer of Git LFS", found["same"]["errors"]["old"])
        self.assertIn("files of Git LFS are missing", self.said)

    def test_cancelled_it_leaves_nothing_behind(self):
        book = '[[figures]]\nname = "hang"\nmodel = "hang.off"\n'
        self.commit(book__toml=book, hang__off=box_off(1, 2, 3))
        process = subprocess.Popen(
            ["env", "--default-signal=INT", COMMAND, "book", "manual/book.toml", "--since", "HEAD", "--burin", self.odd()],
            cwd=self.repository, env={**self.env, "TMPDIR": str(self.folder)}, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        self.addCleanup(process.kill)
        self.wait_for(lambda: list(self.folder.glob("repository/differences/*/.burin-batch/aside/*")))
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        self.assertEqual((process.returncode, said), (5, "burin: error: cancelled\n"))
        self.assertEqual(list(self.folder.glob("burin-since-*")), [])
        self.no_tree_is_left()

    def test_the_help_tells_it(self):
        said = subprocess.run([COMMAND, "book", "--help"], capture_output=True, text=True).stdout
        for word in ("--since", "--compare", "--line-tolerance", "--old-burin"):
            self.assertIn(word, said)


if __name__ == "__main__":
    unittest.main()
