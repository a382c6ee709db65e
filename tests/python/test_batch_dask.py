"""`burin batch run --on dask://...`: a real scheduler and real workers on this machine."""

import importlib.util
import re
import shutil
import signal
import socket
import subprocess
import sys
import unittest

from batch_support import BatchTest, end

PLAIN = '[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline"]\n'


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


@unittest.skipUnless(importlib.util.find_spec("distributed"), "python3-distributed is not installed")
class Dask(BatchTest):
    def setUp(self):
        super().setUp()
        self.port = free_port()
        self.address = f"dask://127.0.0.1:{self.port}"
        self.scheduler = self.program("dask-scheduler", "--host", "127.0.0.1", "--port", self.port, "--no-dashboard")

    def program(self, name, *words):
        """A program of Dask, by the Python that has it; ended with the test, before what it was started after."""
        path = shutil.which(name)
        log = open(self.folder / f"{name}.log", "ab")
        self.addCleanup(log.close)
        process = subprocess.Popen([sys.executable, path, *map(str, words)], cwd=self.folder, stdout=log, stderr=log)
        self.addCleanup(end, process)
        return process

    def worker(self, name, *words):
        words = words or ("--no-nanny",)
        where = self.folder / "dask"
        options = ("--nthreads", 1, "--no-dashboard", "--memory-limit", 0, "--local-directory", where, "--name", name)
        return self.program("dask-worker", f"tcp://127.0.0.1:{self.port}", *options, *words)

    def test_a_worker_is_killed_at_a_third(self):
        self.parts(*(f"{n}.off" for n in range(60)))
        self.plan(PLAIN)
        self.run_all()
        told = self.report()
        self.assertEqual(told[0], "60 drawn, 0 failed")
        shutil.rmtree(self.folder / "out")
        first, _ = self.worker("first"), self.worker("second")
        run = self.start("run", "jobs.jsonl", "--on", self.address)
        self.wait_for(lambda: len(self.outputs()) >= 20)
        first.send_signal(signal.SIGKILL)
        self.assertLess(len(self.outputs()), 60)
        before = self.identities()
        said = run.communicate(timeout=280)[1]
        self.assertEqual(run.returncode, 0, said)
        self.assertIn("60 of 60 drawings", said)
        now = self.identities()
        # At most what the lost worker was at was drawn twice.
        self.assertLessEqual(sum(before[name] != now[name] for name in before), 1)
        self.assertEqual(self.report(), told)
        # Nothing is left to do.
        self.batch("run", "jobs.jsonl", "--on", self.address)
        self.assertIn("60 of them were done", self.said)
        self.assertEqual(self.identities(), now)

    def test_what_ends_its_worker_is_named(self):
        self.parts("a.off", "b.off", "parent.off", "c.off")
        self.plan(PLAIN)
        # A nanny starts a worker anew.
        self.worker("kept", "--nanny", "--nworkers", 1)
        self.batch("--burin", self.odd(), "run", "jobs.jsonl", "--on", self.address, "--patience", "250", status=1)
        self.assertRegex(self.said, r"failed: parts/parent-iso.svg: lost: its worker died 2 times")
        self.assertEqual(set(self.outputs()), {f"parts/{n}-iso.svg" for n in "abc"})

    def test_failures_are_those_of_one_machine(self):
        self.parts("a.off", "hang.off", "crash.off")
        self.plan('[[parts]]\nfiles = ["parts/*", "parts/gone.off"]\nstyles = ["outline"]\n')
        told = []
        for on in ([], ["--on", self.address]):
            if on:
                self.worker("one")
            self.batch("--burin", self.odd(), "run", "jobs.jsonl", "--timeout", "2", *on, status=1)
            self.assertEqual(len(re.findall("failed: ", self.said)), 3)
            told.append(self.report())
            shutil.rmtree(self.folder / "out")
        self.assertEqual(told[0], told[1])

    def test_no_worker_and_no_scheduler(self):
        self.parts("a.off", *(f"slow{n}.off" for n in range(40)))
        self.plan(PLAIN)
        self.batch("run", "jobs.jsonl", "--on", self.address, "--patience", "1", status=1)
        self.assertIn("has no worker; 41 drawings are left: start dask-worker, and run again", self.said)
        worker = self.worker("one")
        run = self.start("--burin", self.odd(), "run", "jobs.jsonl", "--on", self.address)
        self.wait_for(lambda: len(self.outputs()) >= 2)
        self.scheduler.send_signal(signal.SIGKILL)
        said = run.communicate(timeout=280)[1]
        self.assertEqual(run.returncode, 1, said)
        self.assertRegex(said.splitlines()[-1], "burin: error: the Dask scheduler at .* was lost; .* drawings are left")
        end(worker)
        self.batch("run", "jobs.jsonl", "--on", self.address, status=1)
        self.assertIn("no Dask scheduler answers at", self.said)
        self.assertEqual(self.said.count("burin: error"), 1)

    def test_a_full_disk_ends_it(self):
        self.parts(*(f"{n}.off" for n in range(40)))
        self.plan(PLAIN)
        out = self.folder / "out"
        out.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "none", out], capture_output=True).returncode:
            self.skipTest("no file system can be mounted here")
        self.addCleanup(subprocess.run, ["umount", "-l", out], capture_output=True)
        self.worker("one")
        self.batch("run", "jobs.jsonl", "--on", self.address, status=4)
        self.assertIn("the disk is full; free some space", self.said)


if __name__ == "__main__":
    unittest.main()
