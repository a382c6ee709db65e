"""Repositories of Git with a book in them, for tests of what has changed between two revisions."""

import json
import os
import shutil
import subprocess
import unittest

from batch_support import COMMAND, BatchTest, box_off

# A part that moves is one of an assembly; what is included is what no book names.
ASSEMBLY = {"burin": "illustration", "extends": "house.burin.json", "parts": [{"file": "base.off"}, {"file": "pin.off", "place": {"translate": [5, 5, 30]}}]}
HOUSE = {"burin": "illustration", "style": "outline"}
BOOK = """
title = "Two boxes"
formats = ["svg", "pdf"]
options = {paper = "A6", style = "outline"}

[[figures]]
name = "both"
model = "assembly.burin.json"
caption = "Both boxes"

[[figures]]
name = "same"
model = "pin.off"

[[figures]]
name = "styled"
model = "pin.off"
options = {set = {"line.outer" = 0.5}}

[[figures]]
name = "gone"
model = "base.off"
"""
NEW_BOOK = BOOK.replace('"line.outer" = 0.5', '"line.outer" = 0.9').replace('"gone"', '"come"').replace('caption = "Both boxes"', 'caption = "Both"')


def off_again(text):
    """The same OFF model as another program would write it: corners and faces in another order."""
    lines = text.split("\n")
    points, faces = lines[2:10], [line.split() for line in lines[10:16]]
    order = [5, 2, 7, 0, 3, 6, 1, 4]
    moved = [" ".join([face[0]] + [str(order.index(int(k))) for k in face[2:] + face[1:2]]) for face in reversed(faces)]
    return "\n".join([*lines[:2], *(points[k] for k in order), *moved, ""])


@unittest.skipUnless(shutil.which("git"), "Git is not there: git")
class GitTest(BatchTest):
    """`repository` holds the book in the folder manual."""

    def setUp(self):
        super().setUp()
        self.repository = self.folder / "repository"
        self.manual = self.repository / "manual"
        self.manual.mkdir(parents=True)
        # Nothing of who runs the tests has a say.
        self.env = {
            **{k: v for k, v in os.environ.items() if not k.startswith(("GIT_", "GITHUB_", "CI_", "BURIN_"))},
            "BURIN_COMMAND": COMMAND,
            "HOME": str(self.folder),
            "XDG_CONFIG_HOME": str(self.folder / "none"),
            "GIT_CONFIG_NOSYSTEM": "1",
            "GIT_AUTHOR_NAME": "Us",
            "GIT_AUTHOR_EMAIL": "us@example.com",
            "GIT_COMMITTER_NAME": "Us",
            "GIT_COMMITTER_EMAIL": "us@example.com",
            "PATH": f"{self.bin()}:{os.environ['PATH']}",
        }
        self.git("init", "-q", "-b", "main", ".")
        (self.repository / ".gitignore").write_text("/differences/\nfigures/\n")

    def bin(self):
        """A folder with the command, as an installation has it."""
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "burin").write_text(f'#!/bin/sh\nexec "{COMMAND}" "$@"\n')
        (folder / "burin").chmod(0o755)
        return folder

    def git(self, *words, cwd=None):
        run = subprocess.run(["git", *words], cwd=cwd or self.repository, env=self.env, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout.strip()

    def write(self, **files):
        """Files of the folder of the book; dots of names are double underscores."""
        for name, text in files.items():
            (self.manual / name.replace("__", ".")).write_text(text)

    def commit(self, words="change", **files):
        """Returns the revision."""
        self.write(**files)
        self.git("add", "-A")
        self.git("commit", "-q", "-m", words)
        return self.git("rev-parse", "HEAD")

    def first(self):
        return self.commit(
            "first",
            book__toml=BOOK,
            base__off=box_off(20, 20, 30),
            pin__off=box_off(5, 6, 7),
            house__burin__json=json.dumps(HOUSE),
            assembly__burin__json=json.dumps(ASSEMBLY),
        )

    def second(self):
        """The pin of the assembly has moved, one figure came, one went, one has another style, one is the same."""
        moved = json.loads(json.dumps(ASSEMBLY))
        moved["parts"][1]["place"]["translate"] = [5, 5, 40]
        return self.commit("second", book__toml=NEW_BOOK, assembly__burin__json=json.dumps(moved))

    def compare(self, *words, status=0, book="manual/book.toml", cwd=None):
        """Runs `burin book` with these words; {figure: what is said of it}."""
        run = subprocess.run([COMMAND, "book", book, *map(str, words)], cwd=cwd or self.repository, env=self.env, capture_output=True, text=True)
        self.said = run.stderr
        self.assertEqual(run.returncode, status, run.stderr + run.stdout)
        return self.data()

    def data(self, folder="differences"):
        return {f["name"]: f for f in json.loads((self.repository / folder / "differences.json").read_text())["figures"]}

    def statuses(self, found):
        return {name: figure["status"] for name, figure in found.items()}

    def no_tree_is_left(self, repository=None):
        self.assertEqual(self.git("worktree", "list", "--porcelain", cwd=repository).count("worktree "), 1)
