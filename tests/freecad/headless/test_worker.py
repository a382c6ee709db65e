"""The kernel in a process of its own: crashes, cancelled runs, none to be had."""

import json
import os
import signal
import subprocess
import threading
import time

import Part

from support import V, Case, content

from freecad.burin_wb import worker
from freecad.burin_wb.features import illustration as module
from freecad.burin_wb.job import Job, PartJob


def long_job():
    """Some seconds of work."""
    block = Part.makeBox(60, 60, 10)
    for i in range(5):
        for k in range(5):
            block = block.cut(Part.makeCylinder(4, 20, V(6 + 12 * i, 6 + 12 * k, -5)))
    options = {"style": "engraving", "paper": (1500, 1500), "margin": 5, "tolerance": 0.002}
    return Job([PartJob("Block", "Block", block.exportBrepToString().encode())], options)


# Writes to a pipe that nobody reads, where Python was started without its signal handlers, as FreeCAD 1.0 and 1.1 do.
BROKEN_PIPE = """
import os, signal, sys
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
sys.path.insert(0, sys.argv[1])
import messages
messages.ignore_broken_pipes()
reads, writes = os.pipe()
os.close(reads)
try:
    messages.send(os.fdopen(writes, "wb", 0), "job")
except BrokenPipeError:
    print("alive")
"""


class Killed(threading.Thread):
    """Sends a signal to the process of a worker once its run is under way."""

    def __init__(self, of, number):
        super().__init__(daemon=True)
        self.of, self.number, self.hit = of, number, threading.Event()

    def progress(self, stage, share):
        if not self.hit.is_set():
            self.hit.set()
            os.kill(self.of._process.pid, self.number)


class Worker(Case):
    def setUp(self):
        super().setUp()
        self.worker = worker.Worker()

    def tearDown(self):
        self.worker.stop()
        super().tearDown()

    def test_a_crash_in_a_run_is_told_and_the_next_run_works(self):
        for number in (signal.SIGSEGV, signal.SIGKILL, signal.SIGABRT):
            killer = Killed(self.worker, number)
            with self.assertRaises(worker.Failed) as caught:
                self.worker.draw(long_job(), killer.progress)
            self.assertIn(f"ended unexpectedly (signal {int(number)})", str(caught.exception))
        job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {"style": "outline"})
        self.assertIn(b"layers", self.worker.draw(job).drawing)

    def test_glass_is_seen_through(self):
        box = Part.makeBox(10, 10, 10).exportBrepToString().encode()

        def drawn(**look):
            parts = [PartJob("Box", "Box", box, **look)]
            drawing = json.loads(self.worker.draw(Job(parts, {"style": "flat"})).drawing)
            return {area["fill"][:7]: round(area["opacity"], 2) for area in drawing["areas"]}

        self.assertEqual(drawn(color="#ff0000"), {"#ff0000": 1})
        self.assertEqual(drawn(color="#ff0000", opacity=0.4), {"#ff0000": 0.4})
        self.assertEqual(drawn(face_colors=("#ff000066",) * 6), {"#ff0000": 0.4})

    def test_a_worker_that_is_gone_does_not_end_freecad(self):
        folder = os.path.dirname(worker.__file__)
        done = subprocess.run([worker.interpreters()[0], "-c", BROKEN_PIPE, folder], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (0, "alive\n"), done.stderr)

    def test_a_crash_leaves_the_document_alive(self):
        obj = self.illustration(self.box())
        before = content(obj.Drawing)
        running, module._worker = module._worker, self.worker
        try:
            self.worker.start()
            os.kill(self.worker._process.pid, signal.SIGSTOP)  # so that the job is in it when it dies
            pid = self.worker._process.pid
            threading.Timer(0.3, os.kill, (pid, signal.SIGSEGV)).start()
            threading.Timer(0.35, os.kill, (pid, signal.SIGCONT)).start()
            self.doc.Box.Length = 12
            self.doc.recompute()
            self.assertIn("ended unexpectedly (signal 11)", obj.Message)
            self.assertEqual(content(obj.Drawing), before)
            self.redraw(obj)
            self.assertEqual(obj.Message, "")
            self.assertNotEqual(content(obj.Drawing), before)
            self.assertEqual(len(json.loads(content(self.reopen(obj).Drawing))["parts"]), 1)
        finally:
            module._worker = running

    def test_what_the_last_job_left_changes_no_drawing(self):
        def job(length=20, light=(-0.5, 0.65, 0.6), **look):
            parts = [PartJob(name, name, shape.exportBrepToString().encode())
                     for name, shape in (("Box", Part.makeBox(length, 20, 30)), ("Ball", Part.makeSphere(12, V(30, 0, 0))))]
            for name, value in look.items():
                setattr(parts[1], name, value)
            return Job(parts, {"style": "engraving", "paper": (100, 80), "light": light})

        jobs = [job(), job(light=(0.5, 0.65, 0.6)), job(transparent=True), job(drawn=False), job(style="technical"), job(25),
                job(25, hatched=False), job()]
        found = set()
        for one in jobs:
            fresh = worker.Worker()
            try:
                wanted = fresh.draw(one)
            finally:
                fresh.stop()
            got = self.worker.draw(one)
            self.assertEqual((got.drawing, got.picture, got.fingerprint), (wanted.drawing, wanted.picture, wanted.fingerprint))
            found.add(got.drawing)
        self.assertEqual(len(found), len(jobs) - 1)  # the last one is as the first

    def test_a_worker_that_died_between_runs_is_started_anew(self):
        obj = self.illustration(self.box())
        process = module._worker._process
        process.kill()
        process.wait()
        obj.Seed = 3
        self.redraw(obj)
        self.assertEqual(obj.Message, "")

    def test_cancelled(self):
        cancelled = []

        def progress(stage, share):
            if not cancelled:
                cancelled.append(stage)
                self.worker.cancel()

        with self.assertRaises(worker.Stopped):
            self.worker.draw(long_job(), progress)
        job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {"style": "outline"})
        self.assertIn(b"layers", self.worker.draw(job).drawing)
        self.worker.cancel()  # nothing is under way: of no effect
        self.assertIn(b"layers", self.worker.draw(job).drawing)

    def test_a_job_that_does_not_listen_is_ended_with_its_process(self):
        hit = []

        def progress(stage, share):
            if not hit:
                hit.append(self.worker._process)
                os.kill(hit[0].pid, signal.SIGSTOP)
                self.worker.cancel()

        with self.assertRaises(worker.Stopped):
            self.worker.draw(long_job(), progress)
        self.assertEqual(hit[0].poll(), -signal.SIGKILL)
        job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {"style": "outline"})
        self.assertIn(b"layers", self.worker.draw(job).drawing)

    def test_a_cancel_does_not_wait_for_a_worker_that_takes_nothing(self):
        self.worker.start()
        hung = self.worker._process
        os.kill(hung.pid, signal.SIGSTOP)  # before a job that is more than a pipe holds
        job = long_job()
        job.parts[0].brep += b" " * 2**20
        caught = []

        def draw():
            try:
                self.worker.draw(job)
            except worker.Stopped as stopped:
                caught.append(stopped)

        drawing = threading.Thread(target=draw, daemon=True)
        drawing.start()
        while not self.worker._sent:
            time.sleep(0.01)
        cancelling = threading.Thread(target=self.worker.cancel, daemon=True)
        cancelling.start()
        cancelling.join(20)
        drawing.join(20)
        try:
            self.assertFalse(cancelling.is_alive(), "cancel waits for the worker")
            self.assertEqual(len(caught), 1)
            self.assertEqual(hung.poll(), -signal.SIGKILL)
            self.assertIsNone(self.worker._process.poll(), "no new worker waits for the next run")
        finally:
            hung.kill()

    def test_a_job_cancelled_before_the_worker_has_it_is_not_begun(self):
        begun = []
        with self.assertRaises(worker.Stopped):
            self.worker.draw(long_job(), lambda *told: begun.append(told), lambda: False)
        self.assertEqual((begun, self.worker._sent), ([], False))
        job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {"style": "outline"})
        self.assertIn(b"layers", self.worker.draw(job).drawing)

    def test_a_cancel_ends_a_process_that_does_not_come_up(self):
        script = os.path.join(self.folder, "python3")
        with open(script, "w") as file:
            file.write("#!/bin/sh\nexec sleep 60\n")
        os.chmod(script, 0o755)
        before, worker.interpreters = worker.interpreters, lambda: [script]
        caught = []

        def draw():
            try:
                self.worker.draw(long_job())
            except worker.Stopped as stopped:
                caught.append(stopped)

        try:
            drawing = threading.Thread(target=draw, daemon=True)
            drawing.start()
            while self.worker._process is None:
                time.sleep(0.01)
            process = self.worker._process
            self.worker.cancel()
            drawing.join(20)
            self.assertEqual(len(caught), 1)
            self.assertEqual(process.poll(), -signal.SIGKILL)
            self.assertNotIn(script, worker.Worker._unfit, "it may come up another time")
        finally:
            worker.interpreters = before

    def test_a_late_cancel_does_not_end_the_next_job(self):
        job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {"style": "outline"})
        self.worker.draw(job)
        self.worker._ask_to_end(self.worker._process, self.worker._number)  # on its way while the job ended
        self.assertIn(b"layers", self.worker.draw(job).drawing)

    def test_progress_comes_with_stages(self):
        seen = []
        self.worker.draw(Job(long_job().parts, {"style": "technical"}), lambda *told: seen.append(told))
        self.assertGreater(len({stage for stage, _ in seen}), 2)
        self.assertTrue(all(0 <= share <= 1 for _, share in seen))

    def test_without_an_interpreter_it_runs_here_and_says_so_once(self):
        before, worker.interpreters = worker.interpreters, lambda: []
        worker.Worker._told = False
        try:
            obj = self.illustration(self.box())
            kept = content(obj.Drawing)
            module._worker, running = self.worker, module._worker
            try:
                obj.Seed = 2
                self.redraw(obj)
                self.assertEqual(obj.Message, "")
                self.assertEqual(json.loads(content(obj.Drawing))["seed"], 2)
                obj.Seed = 1
                self.redraw(obj)
            finally:
                module._worker = running
            self.assertEqual((obj.Message, self.worker._process), ("", None))
            self.assertTrue(worker.Worker._told)
            self.assertEqual(content(obj.Drawing), kept)  # the same wherever it runs
        finally:
            worker.interpreters = before

    def test_programs_that_cannot_be_workers_are_passed_over(self):
        good = worker.interpreters()[0]
        scripts = []
        for name, text in (("silent", "exec /bin/false"), ("talks", "echo this is no message; sleep 0.1"),
                           ("bare", f'BURIN_WORKER_NUMPY= exec {good} -S "$@"')):
            folder = os.path.join(self.folder, name)
            os.mkdir(folder)
            scripts.append(os.path.join(folder, "python3"))
            with open(scripts[-1], "w") as file:
                file.write(f"#!/bin/sh\n{text}\n")
            os.chmod(scripts[-1], 0o755)
        before, worker.interpreters = worker.interpreters, lambda: ["/nowhere/python3", *scripts, good]
        try:
            job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {})
            self.assertIn(b"layers", self.worker.draw(job).drawing)
            self.assertEqual(self.worker._process.args[0], good)
            whys = worker.Worker._unfit
            self.assertEqual({"/nowhere/python3", *scripts} - set(whys), set())
            self.assertIn("No such file", whys["/nowhere/python3"])
            self.assertIn("no numpy", whys[scripts[2]])
        finally:
            worker.interpreters = before

    def test_an_interpreter_without_numpy_gets_freecads(self):
        # As the system's in a Flatpak, whose numpy is FreeCAD's alone.
        script = os.path.join(self.folder, "python3")
        with open(script, "w") as file:
            file.write(f'#!/bin/sh\nexec {worker.interpreters()[0]} -S "$@"\n')
        os.chmod(script, 0o755)
        before, worker.interpreters = worker.interpreters, lambda: [script]
        try:
            job = Job([PartJob("Box", "Box", Part.makeBox(1, 2, 3).exportBrepToString().encode())], {})
            self.assertIn(b"layers", self.worker.draw(job).drawing)
            self.assertIsNotNone(self.worker._process, worker.Worker._unfit)
        finally:
            worker.interpreters = before

    def test_two_runs_give_the_same_bytes(self):
        obj = self.illustration(self.box())
        first = content(obj.Drawing), content(obj.Picture)
        obj.Inputs = ""
        self.redraw(obj)
        self.assertEqual((content(obj.Drawing), content(obj.Picture)), first)
