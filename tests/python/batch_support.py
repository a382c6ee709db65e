"""What the tests of `burin batch` share. Nothing here needs the compiled module."""

import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

COMMAND = os.environ["BURIN_COMMAND"]
SAMPLES = Path(os.environ["BURIN_SOURCE_DIR"]) / "samples"

# Stands for the command: what a part is called tells what becomes of it. All else is drawn by the command itself.
ODD = """#!/usr/bin/python3
import os, signal, subprocess, sys, time
if sys.argv[1:] != ["batch", "job"]:
    os.execv({command!r}, [{command!r}, *sys.argv[1:]])
text = sys.stdin.read()
name = text if '"check": true' not in text else ""
if "slow" in name:
    time.sleep(0.2)
if "hang" in name:
    time.sleep(1000)
if "crash" in name:
    os.kill(os.getpid(), signal.SIGSEGV)
if "eats" in name:
    held = []
    while True:
        held.append(b"x" * (4 << 20))
if "parent" in name:
    os.kill(os.getppid(), signal.SIGKILL)
    time.sleep(10)
sys.exit(subprocess.run([{command!r}, "batch", "job"], input=text.encode()).returncode)
"""


def box_off(x, y, z):
    """A box as an OFF file."""
    corners = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
    faces = ["0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"]
    lines = [f"{x * a} {y * b} {z * c}" for a, b, c in corners] + [f"4 {face}" for face in faces]
    return "OFF\n8 6 0\n" + "\n".join(lines) + "\n"


class BatchTest(unittest.TestCase):
    """A folder with a catalogue in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def parts(self, *names):
        """A box each, no two alike."""
        for number, name in enumerate(names):
            path = self.folder / "parts" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(box_off(10 + number, 20, 30))

    def odd(self):
        """The command that stands for burin."""
        path = self.folder / "odd"
        path.write_text(ODD.format(command=COMMAND))
        path.chmod(0o755)
        return str(path)

    def batch(self, *words, status=0, env=None):
        """Runs `burin batch`; what it says."""
        run = subprocess.run(
            [COMMAND, "batch", *map(str, words)], cwd=self.folder, capture_output=True, text=True, env={**os.environ, **(env or {})}
        )
        self.said = run.stderr
        self.assertEqual(run.returncode, status, run.stderr + run.stdout)
        return run.stdout

    def plan(self, text, **more):
        (self.folder / "catalogue.toml").write_text(text)
        return self.batch("plan", "catalogue.toml", "-o", "jobs.jsonl", **more)

    def run_all(self, *words, status=0):
        self.batch("run", "jobs.jsonl", *words, status=status)
        return self.said

    def report(self):
        """(first words, hash)"""
        lines = self.batch("report", "jobs.jsonl").splitlines()
        return lines[0].partition(": ")[2], lines[1].removeprefix("hash ")

    def refused(self, part):
        """That the last command said one line of error."""
        self.assertTrue(self.said.startswith("burin: error: "), self.said)
        self.assertEqual(self.said.count("\n"), 1, self.said)
        self.assertIn(part, self.said)

    def drawings(self):
        """The drawings of the file of jobs."""
        lines = (self.folder / "jobs.jsonl").read_text().splitlines()[1:]
        return [drawing for line in lines for drawing in json.loads(line)["drawings"]]

    def outputs(self, out="out"):
        """{name: bytes} of all that stands in the folder of outputs but what the batch keeps for itself and the report."""
        root = self.folder / out
        found = {}
        for folder, folders, names in os.walk(root):
            folders[:] = [name for name in folders if name != ".burin-batch"]
            for name in names:
                path = Path(folder) / name
                if name != "index.html":
                    found[str(path.relative_to(root))] = path.read_bytes()
        return found

    def identities(self):
        """What changes when an output is written again, even with the same bytes."""
        return {name: (self.folder / "out" / name).stat().st_ino for name in self.outputs()}

    def start(self, *words):
        """A process of `burin batch` that goes on."""
        process = subprocess.Popen(
            # Where the tests run in the background of a shell, Ctrl-C would be ignored for this, too.
            ["env", "--default-signal=INT", COMMAND, "batch", *map(str, words)],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(end, process)
        return process

    def wait_for(self, what, seconds=250):
        """Waits until something holds."""
        end_time = time.monotonic() + seconds
        while not what():
            if time.monotonic() > end_time:
                self.fail("nothing came of it")
            time.sleep(0.05)


def end(process):
    """Ends a process that a test started, and its group where it has one of its own."""
    if process.poll() is None:
        process.send_signal(signal.SIGKILL)
    process.communicate()
