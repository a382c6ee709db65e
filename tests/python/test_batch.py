"""`burin batch` on one machine: plan, run, report; what is done, what fails, what is told."""

import html
import importlib.util
import json
import os
import re
import shutil
import signal
import subprocess
import unittest

from batch_support import COMMAND, SAMPLES, BatchTest, box_off

PLAIN = '[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline"]\n'


class Plan(BatchTest):
    def test_what_it_makes(self):
        self.parts("a.off", "b c.off", "new\nline.off", "deep/a.off")
        said = self.plan('views = ["front", "iso"]\n[[parts]]\nfiles = ["parts/**/*.off"]\nexclude = ["*/b*"]\nstyles = ["outline"]')
        self.assertEqual(said, "jobs.jsonl: 3 parts, 6 drawings\n")
        names = {d["outputs"][0] for d in self.drawings()}
        self.assertEqual(len(names), 6)
        self.assertTrue({"parts/a-front.svg", "parts/deep/a-iso.svg", "parts/new\nline-iso.svg"} <= names)
        self.assertEqual(len({d["id"] for d in self.drawings()}), 6)

    def test_ids_are_of_what_is_drawn(self):
        self.parts("a.off", "b.off")
        (self.folder / "house.json").write_text('{"base": "outline", "line.outer": 0.4}')
        text = '[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline", "house.json"]'
        ids = []
        for change in (
            lambda: None,
            lambda: os.utime(self.folder / "parts/a.off", (1, 1)),
            lambda: (self.folder / "house.json").write_text('{"base": "outline", "line.outer": 0.6}'),
            lambda: (self.folder / "parts/b.off").write_text(box_off(1, 2, 3)),
        ):
            change()
            self.plan(text)
            ids.append([d["id"] for d in self.drawings()])
        first, touched, style, part = ids
        self.assertEqual(first, touched)
        self.assertEqual([a == b for a, b in zip(touched, style)], [True, False, True, False])
        self.assertEqual([a == b for a, b in zip(style, part)], [True, True, False, False])

    def test_bad_catalogues(self):
        self.parts("a.off", "a.stl")
        for text, part, status in (
            ("parts = 3", "names no parts", 3),
            ("[[parts]\n", "is no TOML", 3),
            ('vews = ["iso"]\n' + PLAIN, "no key 'vews'; the nearest is 'views'", 3),
            ('[[parts]]\nfile = ["x"]', "the nearest is 'files'", 3),
            ('[[parts]]\nfiles = ["nowhere/*.off"]', "'nowhere/*.off' matches no file", 3),
            ('[[parts]]\nfiles = ["parts/*"]', "is also one of parts/a.off", 3),
            ('[[parts]]\nfiles = ["parts/a.off"]\noutputs = "{nam}.svg"', "'{nam}' is no placeholder; the nearest is '{name}'", 3),
            ('[[parts]]\nfiles = ["parts/a.off"]\noutputs = "../{name}.svg"', "is not below the folder of outputs", 3),
            ('[[parts]]\nfiles = ["parts/a.off"]\noutputs = "{name}.bmp"', "does not name a format", 2),
            ('[[parts]]\nfiles = ["parts/a.off"]\nviews = ["fron"]', "unknown view 'fron'", 2),
            ('[[parts]]\nfiles = ["parts/a.off"]\noptions = {papr = "A4"}', "paper", 2),
            ('[[parts]]\nfiles = ["parts/a.off"]\noptions = {threads = 2}', "threads is set by burin batch run --threads", 3),
            ('[[parts]]\nfiles = ["parts/a.off"]\noptions = {set = {"hatch.spacin" = 1}}', "hatch.spac", 2),
            ('limits = {memory = "much"}\n' + PLAIN, "limits: memory takes an amount of memory", 2),
            ('out = "/"\n' + PLAIN, "is not below the folder of the jobs", 3),
            ('out = "."\n[[parts]]\nfiles = ["parts/a.stl"]\noutputs = "parts/a.stl.svg"\n[[parts]]\nillustrations = ["i.json"]\noutputs = "i.json"', "is also an input", 3),
        ):
            with self.subTest(part):
                (self.folder / "i.json").write_text("{}")
                self.plan(text, status=status)
                self.refused(part)
                self.assertFalse((self.folder / "jobs.jsonl").exists())

    def test_bad_words(self):
        for words, part in (
            ([], "COMMAND"),
            (["drw"], "drw"),
            (["run"], "JOBS.jsonl"),
            (["run", "none.jsonl", "--shard", "3/2"], "none.jsonl"),
        ):
            self.batch(*words, status=3 if "none.jsonl" in words else 2)
            self.refused(part)
        self.parts("a.off")
        self.plan(PLAIN)
        for words, part in (
            (["--shard", "3/2"], "--shard takes I/N"),
            (["--timeout", "0"], "--timeout takes seconds"),
            (["--memory", "4X"], "--memory takes an amount"),
            (["--jobs", "0"], "--jobs takes"),
            (["--on", "spark://x"], "--on takes dask://HOST:PORT"),
        ):
            self.batch("run", "jobs.jsonl", *words, status=2)
            self.assertIn(part, self.said)
        (self.folder / "bad.jsonl").write_text((self.folder / "jobs.jsonl").read_text() + "{]\n")
        self.batch("run", "bad.jsonl", status=3)
        self.refused("bad.jsonl:3: is not one JSON object")
        (self.folder / "old.jsonl").write_text((self.folder / "jobs.jsonl").read_text().replace('"program": "', '"program": "9'))
        self.batch("run", "old.jsonl", status=3)
        self.refused("plan it again")


class Run(BatchTest):
    def test_draws_what_the_command_draws(self):
        self.parts("a.off", "b b.off", "new\nline.off")
        self.plan('views = ["front", "iso"]\noptions = {hidden = "dashed", set = {"line.outer" = 0.7}}\noutputs = ["{name}-{view}.svg", "{name}-{view}.json"]\n' + PLAIN)
        self.run_all()
        self.assertIn("6 of 6 drawings", self.said)
        self.assertEqual(len(self.outputs()), 12)
        options = ["--view", "iso", "--style", "outline", "--hidden", "dashed", "--set", "line.outer=0.7", "--quiet"]
        subprocess.run([COMMAND, "draw", "parts/new\nline.off", "-o", "x.svg", "-o", "x.json", *options], cwd=self.folder, check=True)
        for suffix in ("svg", "json"):
            self.assertEqual(self.outputs()[f"new\nline-iso.{suffix}"], (self.folder / f"x.{suffix}").read_bytes())

    def test_nothing_is_done_twice(self):
        self.parts("a.off", "b.off", "c.off")
        (self.folder / "house.json").write_text('{"base": "outline", "line.outer": 0.4}')
        self.plan('[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline", "house.json"]')
        self.run_all()
        before = self.identities()
        # Clocks tell nothing.
        for name in ["parts/a.off", "house.json", "out/parts/a-iso-outline.svg"]:
            os.utime(self.folder / name, (4e9, 4e9))
        self.assertIn("6 of them were done", self.run_all())
        self.assertEqual(self.identities(), before)

        def redrawn():
            self.run_all()
            now = self.identities()
            names = {name for name in now if now[name] != before.get(name)}
            before.update(now)
            return names

        # Files are looked at when they are drawn, too, not only when they are planned.
        (self.folder / "house.json").write_text('{"base": "outline", "line.outer": 0.6}')
        self.assertEqual(redrawn(), {f"parts/{n}-iso-house.svg" for n in "abc"})
        (self.folder / "parts/b.off").write_text(box_off(3, 4, 5))
        self.assertEqual(redrawn(), {"parts/b-iso-outline.svg", "parts/b-iso-house.svg"})
        (self.folder / "out/parts/c-iso-house.svg").write_text("else")
        self.assertEqual(redrawn(), {"parts/c-iso-house.svg"})
        output = self.folder / "out/parts/a-iso-house.svg"
        output.write_bytes(output.read_bytes().replace(b"0", b"1", 1))  # as many bytes as before
        self.assertEqual(redrawn(), {"parts/a-iso-house.svg"})
        self.assertEqual(redrawn(), set())

    def test_what_a_model_names_counts(self):
        self.parts("a.off")
        house = {"burin": "illustration", "style": "outline", "view": {"from": "front"}}
        own = {"burin": "illustration", "extends": "house.json", "parts": [{"file": "parts/a.off"}]}
        (self.folder / "house.json").write_text(json.dumps(house))
        (self.folder / "a.burin.json").write_text(json.dumps(own))
        self.plan('[[parts]]\nillustrations = ["*.burin.json"]')
        self.run_all()
        first = self.outputs()["a.svg"]
        for change in (
            lambda: (self.folder / "parts/a.off").write_text(box_off(3, 4, 5)),
            lambda: (self.folder / "house.json").write_text(json.dumps({**house, "view": {"from": "iso"}})),
        ):
            change()
            self.assertIn("1 of 1 drawings, ", self.run_all())
            self.assertNotEqual(self.outputs()["a.svg"], first)
            first = self.outputs()["a.svg"]

    def test_rings_of_files_fail_alone(self):
        self.parts("a.off")
        for one, other in ("ab", "ba"):
            (self.folder / f"{one}.burin.json").write_text(json.dumps({"burin": "illustration", "extends": f"{other}.burin.json"}))
        (self.folder / "ring.scad").write_text("use <gnir.scad>\nring();\n")
        (self.folder / "gnir.scad").write_text("use <ring.scad>\nmodule ring() cube([10, 20, 30]);\n")
        (self.folder / "self.scad").write_text("include <self.scad>\ncube([10, 20, 30]);\n")
        self.plan(PLAIN + '[[parts]]\nillustrations = ["*.burin.json"]\n[[parts]]\nfiles = ["ring.scad", "self.scad"]\nstyles = ["outline"]\n')
        said = self.run_all(status=1)
        for name in "ab":
            self.assertRegex(said, rf'failed: {name}\.svg: usage: {name}\.burin\.json:1: "extends" makes a chain .* or a ring')
        # Libraries of OpenSCAD may use each other; what includes itself is what OpenSCAD makes of it.
        self.assertEqual(set(self.outputs()), {"parts/a-iso.svg", "ring-iso.svg", "self-iso.svg"})

    @unittest.skipUnless(shutil.which("openscad"), "openscad is not installed")
    def test_what_openscad_includes_counts(self):
        self.parts()
        (self.folder / "sizes.scad").write_text("w = 10;\n")
        (self.folder / "a.scad").write_text("include <sizes.scad>\ncube([w, 20, 30]);\n")
        self.plan('[[parts]]\nfiles = ["a.scad"]\nstyles = ["outline"]')
        self.run_all()
        first = self.outputs()["a-iso.svg"]
        self.assertIn("1 of them were done", self.run_all())
        (self.folder / "sizes.scad").write_text("w = 20;\n")
        self.run_all()
        self.assertNotEqual(self.outputs()["a-iso.svg"], first)

    def test_same_hash_whoever_draws(self):
        self.parts(*(f"{n}.off" for n in range(12)))
        text = 'views = ["front", "iso"]\n' + PLAIN
        self.plan(text)
        self.run_all("--jobs", "1")
        told, known = self.report()
        self.assertEqual(told, "24 drawn, 0 failed")
        shutil.rmtree(self.folder / "out")
        left = 24
        for i in (3, 1, 5, 2, 4):
            said = self.run_all("--shard", f"{i}/5", "--jobs", "2", "--threads", "2")
            left -= int(re.search(r"(\d+) of \1 drawings", said)[1])
        self.assertEqual(left, 0)
        self.assertEqual(self.report(), (told, known))
        # And wherever it stands.
        moved = self.folder / "elsewhere"
        moved.mkdir()
        shutil.move(self.folder / "parts", moved / "parts")
        self.folder = moved
        self.plan(text)
        self.run_all()
        self.assertEqual(self.report(), (told, known))

    def test_parts_lists_are_outputs(self):
        shutil.copy(SAMPLES / "bolt.3mf", self.folder)
        self.plan('[[parts]]\nfiles = ["bolt.3mf"]\nstyles = ["outline"]\noptions = {callouts = true, parts_list = ["sheet", "{name}.csv"]}')
        self.run_all()
        self.assertEqual(set(self.outputs()), {"bolt-iso.svg", "bolt.csv"})
        self.assertIn(b"1", self.outputs()["bolt.csv"])

    def test_the_sample(self):
        self.batch("plan", SAMPLES / "catalogue.toml", "-o", "jobs.jsonl")
        self.run_all()
        self.assertIn("bolt-iso.svg", self.outputs("catalogue"))
        self.assertIn("coupling.csv", self.outputs("catalogue"))
        self.assertEqual(self.report()[0], f"{len(self.drawings())} drawn, 0 failed")


class Failures(BatchTest):
    def kinds(self):
        return {m[1]: m[2] for m in re.finditer(r"failed(?: before \(.*?\))?: (\S+): (\w+): ", self.said)}

    def test_each_alone_and_by_name(self):
        self.parts("a.off", "b.off", "hang.off", "crash.off", "eats.off")
        (self.folder / "parts/broken.off").write_text("OFF\n8 6 0\n0 0")
        ring = {"burin": "illustration", "extends": "ring.burin.json"}
        (self.folder / "ring.burin.json").write_text(json.dumps(ring))
        self.plan(
            'views = ["front", "iso"]\n[[parts]]\nfiles = ["parts/*.off", "parts/gone.off"]\nstyles = ["outline"]\n'
            '[[parts]]\nillustrations = ["ring.burin.json"]\n'
        )
        words = ("--burin", self.odd(), "run", "jobs.jsonl", "--jobs", "2")
        self.batch(*words, "--timeout", "10", "--memory", "150M", status=1)
        expected = {f"parts/{n}-{v}.svg": k for n, k in (("hang", "timeout"), ("crash", "crash"), ("eats", "memory"), ("broken", "input"), ("gone", "missing")) for v in ("front", "iso")}
        expected["ring.svg"] = "usage"
        self.assertEqual(self.kinds(), expected)
        self.assertIn("SIGSEGV", self.said)
        self.assertIn("parts/gone.off: there is no such file", self.said)
        self.assertIn("chain of more than 16 files, or a ring", self.said)
        drawn = {f"parts/{n}-{v}.svg" for n in "ab" for v in ("front", "iso")}
        self.assertEqual(set(self.outputs()), drawn)
        told, known = self.report()
        self.assertEqual(told, "4 drawn, 11 failed")
        # What failed for good is not tried again ...
        before = self.identities()
        self.batch(*words, "--timeout", "10", "--memory", "150M", status=1)
        self.assertEqual(self.kinds(), expected)
        self.assertEqual(self.said.count("failed before"), 11)
        self.assertEqual(self.report(), (told, known))
        # ... but where it is told to, has wider limits, or what it read has changed.
        self.parts("gone.off")
        self.plan((self.folder / "catalogue.toml").read_text())
        self.run_all("--timeout", "60", "--memory", "4G", status=1)
        self.assertEqual(self.said.count("failed before"), 5)  # crash, broken, ring
        self.run_all("--again", status=1)
        self.assertEqual(set(self.kinds()), {"parts/broken-front.svg", "parts/broken-iso.svg", "ring.svg"})
        self.assertEqual(len(self.outputs()), 12)
        self.assertEqual({n: i for n, i in self.identities().items() if n in drawn}, before)

    def test_limits_of_the_command_itself(self):
        shutil.copy(SAMPLES / "gyroid_block.implicit", self.folder)
        self.plan('[[parts]]\nfiles = ["gyroid_block.implicit"]\nstyles = ["engraving"]')
        self.run_all("--memory", "100M", status=1)
        self.assertEqual(self.kinds(), {"gyroid_block-iso.svg": "memory"})
        self.run_all("--timeout", "0.2", "--again", status=1)
        self.assertEqual(self.kinds(), {"gyroid_block-iso.svg": "timeout"})
        self.assertEqual(self.outputs(), {})
        self.assertEqual(list((self.folder / "out/.burin-batch/aside").iterdir()), [])

    def test_two_with_one_output(self):
        self.parts("a.off", "b.off", "c.off")
        self.plan(PLAIN)
        lines = (self.folder / "jobs.jsonl").read_text().replace("b-iso.svg", "a-iso.svg")
        (self.folder / "jobs.jsonl").write_text(lines)
        self.run_all(status=1)
        self.assertIn("clash: parts/a-iso.svg is an output of two drawings (parts/a.off and parts/b.off)", self.said)
        self.assertEqual(set(self.outputs()), {"parts/c-iso.svg"})

    def test_an_output_that_is_a_folder(self):
        self.parts("a.off", "b.off")
        self.plan(PLAIN)
        (self.folder / "out/parts/a-iso.svg").mkdir(parents=True)
        self.run_all(status=1)
        self.assertEqual(self.kinds(), {"parts/a-iso.svg": "output"})
        self.assertEqual(set(self.outputs()), {"parts/b-iso.svg"})

    def test_a_full_disk_ends_it_and_nothing_is_lost(self):
        self.parts(*(f"{n}.off" for n in range(40)))
        self.plan(PLAIN)
        out = self.folder / "out"
        out.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "none", out], capture_output=True).returncode:
            self.skipTest("no file system can be mounted here")
        self.addCleanup(subprocess.run, ["umount", out], capture_output=True)
        self.run_all("--quiet", status=4)
        self.refused("the disk is full; free some space")
        drawn = len(self.outputs())
        self.assertTrue(0 < drawn < 40, drawn)
        subprocess.run(["mount", "-o", "remount,size=8m", out], check=True)
        self.assertIn(f", {drawn} of them were done", self.run_all())
        self.assertEqual(self.report()[0], "40 drawn, 0 failed")

    def test_a_pipe_is_no_part(self):
        self.parts("a.off")
        os.mkfifo(self.folder / "parts/b.off")
        self.plan(PLAIN)
        self.run_all("--timeout", "20", status=1)
        self.assertEqual(self.kinds(), {"parts/b-iso.svg": "input"})
        self.assertEqual(set(self.outputs()), {"parts/a-iso.svg"})

    def test_a_version_that_differs(self):
        self.parts("a.off")
        self.plan(PLAIN)
        (self.folder / "new").write_text('#!/bin/sh\necho "burin 99.0"\n')
        (self.folder / "new").chmod(0o755)
        self.batch("--burin", self.folder / "new", "run", "jobs.jsonl", status=3)
        self.refused("this is 99.0; plan it again")


class Ended(BatchTest):
    def begin(self):
        self.parts(*(f"slow{n}.off" for n in range(24)))
        self.plan(PLAIN)
        process = self.start("--burin", self.odd(), "run", "jobs.jsonl", "--jobs", "2")
        self.wait_for(lambda: len(self.outputs()) >= 3)
        return process

    def nothing_is_left_running(self):
        found = subprocess.run(["pgrep", "-f", str(self.folder / "odd")], capture_output=True, text=True).stdout
        return not found

    def test_killed_it_goes_on(self):
        process = self.begin()
        process.kill()
        process.wait()
        self.wait_for(self.nothing_is_left_running)
        before = self.identities()
        self.assertLess(len(before), 24)
        self.run_all()
        now = self.identities()
        self.assertEqual(len(now), 24)
        # What had a record was not drawn again: at most the two that were under way.
        again = [name for name in before if before[name] != now[name]]
        self.assertLessEqual(len(again), 2)
        self.assertEqual(self.report()[0], "24 drawn, 0 failed")

    def test_cancelled_it_leaves_nothing(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.begin()
            process.send_signal(number)
            said = process.communicate()[1]
            self.assertEqual(process.returncode, 5, said)
            self.assertTrue(said.endswith("burin: error: cancelled\n"), said)
            self.wait_for(self.nothing_is_left_running)
            self.assertEqual(list((self.folder / "out/.burin-batch/aside").iterdir()), [])
            shutil.rmtree(self.folder / "out")


class Door(BatchTest):
    """How the command gets to its Python, and what it starts itself."""

    def job(self, text, status=0):
        run = subprocess.run([COMMAND, "batch", "job"], cwd=self.folder, input=text, capture_output=True, text=True)
        self.said = run.stderr
        self.assertEqual(run.returncode, status, run.stderr)
        return [json.loads(line) for line in run.stdout.splitlines()]

    def test_the_job(self):
        self.parts("a.off")
        drawings = [
            {"options": {"view": ["front"], "style": ["outline"]}, "outputs": ["a.svg", "a.json"], "lists": ["a.csv"]},
            {"options": {"view": ["nowhere"]}, "outputs": ["b.svg"]},
            {"options": {"vieww": ["front"]}, "outputs": ["b.svg"]},
            {"options": {"style": ["outline"]}, "outputs": ["none/c.svg"]},
        ]
        answers = self.job(json.dumps({"inputs": ["parts/a.off"], "drawings": drawings}))
        self.assertEqual(set(answers[0]), {"version"})
        self.assertEqual(answers[-1], {"done": True})
        ends = [a for a in answers if "seconds" in a]
        self.assertEqual([a["drawing"] for a in ends], [0, 1, 2, 3])
        self.assertEqual([a.get("error", {}).get("kind") for a in ends], [None, "usage", "usage", "output"])
        self.assertIn("'vieww'; the nearest is 'view'", ends[2]["error"]["message"])
        (name, stamp), = ends[0]["files"]
        s = os.stat(self.folder / "parts/a.off")
        self.assertEqual((name, stamp), ("parts/a.off", [s.st_dev, s.st_ino, s.st_size, s.st_mtime_ns, s.st_ctime_ns]))
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"parts", "a.svg", "a.json", "a.csv"})
        stages = [a["stage"] for a in answers if "stage" in a]
        self.assertEqual(stages.count("read"), 1)

    def test_what_is_no_job(self):
        for text in ("", "{", "[]", '{"inputs": 3}', '{"inputs": [], "drawings": [{}]}'):
            self.assertEqual(self.job(text, status=2), [])
            self.refused("reads a job as JSON from standard input")

    def test_what_is_missing_is_named(self):
        self.batch("plan", env={"BURIN_PYTHON": "/nowhere/python"}, status=1)
        self.refused("/nowhere/python cannot be started")
        (self.folder / "bin").mkdir()
        alone = shutil.copy(COMMAND, self.folder / "bin")
        libraries = os.path.join(os.path.dirname(COMMAND), "..", "lib")
        run = subprocess.run([alone, "batch", "plan"], env={"LD_LIBRARY_PATH": libraries}, capture_output=True, text=True)
        self.said = run.stderr
        self.assertEqual(run.returncode, 1)
        self.refused("the Python part of burin batch is missing")

    def test_help(self):
        for words in (["--help"], ["run", "--help"], ["slurm", "-h"]):
            self.assertIn("usage: burin batch", self.batch(*words))
        self.assertIn("batch", subprocess.run([COMMAND, "--help"], capture_output=True, text=True).stdout)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "python3-mypy is not installed")
    def test_mypy_reads_it(self):
        from mypy import api

        # The folder alone: the package around it is compiled. Not what it imports: distributed alone takes half a minute.
        folder = SAMPLES.parent / "converters/python/burin/batch"
        copy = self.folder / "burin" / "batch"
        shutil.copytree(folder, copy, ignore=shutil.ignore_patterns("__pycache__"))
        os.environ["MYPYPATH"] = str(self.folder)
        own = ["--no-site-packages", "--ignore-missing-imports", "--no-warn-unused-ignores"]
        out, _, status = api.run(["--strict", *own, "--namespace-packages", "-p", "burin.batch", "--cache-dir=/dev/null"])
        self.assertEqual(status, 0, out)


class Report(BatchTest):
    def test_failures_come_first(self):
        self.parts("<b>a&b.off", "c d.off", "z.off")
        (self.folder / "parts/z.off").write_text("OFF\nno")
        self.plan(PLAIN)
        told, empty = self.report()
        self.assertEqual(told, "0 drawn, 0 failed, 3 not drawn yet")
        self.run_all(status=1)
        told, known = self.report()
        self.assertEqual(told, "2 drawn, 1 failed")
        self.assertNotEqual(known, empty)
        page = (self.folder / "out/index.html").read_text()
        self.assertIn(known, page)
        self.assertLess(page.index("parts/z-iso.svg"), page.index("<figure"))
        self.assertIn(html.escape("parts/<b>a&b-iso.svg"), page)
        self.assertNotIn("<b>a&b", page)
        sources = re.findall(r'<img loading="lazy" alt="" src="([^"]+)"', page)
        self.assertEqual(sorted(sources), ["parts/%3Cb%3Ea%26b-iso.svg", "parts/c%20d-iso.svg"])
        # What does not hold what was drawn does not count.
        (self.folder / "out/parts/c d-iso.svg").write_text("else")
        self.assertEqual(self.report()[0], "1 drawn, 1 failed, 1 not drawn yet")


if __name__ == "__main__":
    unittest.main()
