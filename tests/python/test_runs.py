"""Runs: progress, cancel, Ctrl-C, the GIL, several at once."""

import signal
import subprocess
import sys
import threading
import time
import unittest

import burin
import numpy as np
from support import cube, sphere

# Seconds from a cancel to its end. Promised are 0.1; a loaded machine is slow to wake threads.
SOON = 0.5


def heavy():
    """A scene that takes seconds."""
    scene = burin.Scene()
    vertices, triangles = sphere(150)
    for k in range(4):
        scene.add_mesh(vertices + [25 * k, 0, 0], triangles, f"ball {k}")
    return scene


HEAVY = {"style": "engraving", "paper": "A2", "set": {"hatch.spacing_min": 0.2, "hatch.spacing_max": 0.4}}


class Progress(unittest.TestCase):
    def test_stages_and_shares(self):
        told = []
        scene = burin.Scene()
        scene.add_mesh(*sphere(120))
        thread = threading.get_ident()

        def progress(stage, share):
            self.assertEqual(threading.get_ident(), thread)
            told.append((stage, share))

        burin.draw(scene, style="engraving", paper="A6", progress=progress)
        self.assertTrue(told)
        self.assertTrue(all(isinstance(stage, str) and 0 <= share <= 1 for stage, share in told))
        order = "read build curvature field cover trace features visibility compose".split()
        self.assertTrue({stage for stage, _ in told} <= set(order))
        traced = [share for stage, share in told if stage == "trace"]
        self.assertEqual(traced, sorted(traced))

    def test_exception_ends_the_run(self):
        class Mine(Exception):
            pass

        def progress(stage, share):
            raise Mine(stage)

        start = time.monotonic()
        with self.assertRaises(Mine):
            burin.draw(heavy(), progress=progress, **HEAVY)
        self.assertLess(time.monotonic() - start, 5)

    def test_reading_reports_too(self):
        flag = burin.Cancel()
        flag.cancel()
        with self.assertRaises(burin.Cancelled):
            burin.Scene.read("/nowhere.stl", cancel=flag)


class Cancel(unittest.TestCase):
    def test_from_another_thread(self):
        scene = heavy()
        flag = burin.Cancel()
        self.assertFalse(flag.cancelled)
        when = []

        def later():
            time.sleep(0.3)
            when.append(time.monotonic())
            flag.cancel()

        thread = threading.Thread(target=later)
        thread.start()
        with self.assertRaises(burin.Cancelled):
            burin.draw(scene, cancel=flag, **HEAVY)
        self.assertLess(time.monotonic() - when[0], SOON)
        thread.join()
        self.assertTrue(flag.cancelled)

    def test_for_good(self):
        flag = burin.Cancel()
        flag.cancel()
        for _ in range(2):
            with self.assertRaises(burin.Cancelled):
                burin.draw(heavy(), cancel=flag)

    def test_one_flag_ends_two_runs(self):
        flag, ended = burin.Cancel(), []
        scene = heavy()

        def work():
            try:
                burin.draw(scene, cancel=flag, **HEAVY)
            except burin.Cancelled:
                ended.append(1)

        threads = [threading.Thread(target=work) for _ in range(2)]
        for thread in threads:
            thread.start()
        time.sleep(0.2)
        flag.cancel()
        for thread in threads:
            thread.join()
        self.assertEqual(len(ended), 2)

    def test_during_exact_calls_of_a_function(self):
        flag = burin.Cancel()
        threading.Timer(0.3, flag.cancel).start()
        scene = burin.Scene()
        scene.add_function(lambda p: np.linalg.norm(p, axis=1) - 5, (-6, -6, -6, 6, 6, 6), samples=24)
        calls = []

        def tone(positions, normals):
            calls.append(1)
            time.sleep(0.01)
            return np.zeros(len(positions))

        with self.assertRaises(burin.Cancelled):
            for _ in range(1000):
                burin.draw(scene, style="engraving", tone=tone, cancel=flag)


class Interrupt(unittest.TestCase):
    def test_ctrl_c(self):
        code = """
import sys, time
sys.path[:0] = %r
from test_runs import HEAVY, heavy, burin
scene = heavy()
print("go", flush=True)
try:
    burin.draw(scene, **HEAVY)
except KeyboardInterrupt:
    print("stopped", flush=True)
"""
        path = [p for p in sys.path if p]
        child = subprocess.Popen([sys.executable, "-c", code % path], stdout=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "go\n")
        time.sleep(0.4)
        child.send_signal(signal.SIGINT)
        start = time.monotonic()
        self.assertEqual(child.stdout.readline(), "stopped\n")
        self.assertLess(time.monotonic() - start, SOON)
        child.stdout.close()
        self.assertEqual(child.wait(20), 0)


class Gil(unittest.TestCase):
    def test_another_thread_goes_on(self):
        scene = heavy()
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.wait(0.005):
                ticks.append(time.monotonic())

        thread = threading.Thread(target=tick)
        thread.start()
        start = time.monotonic()
        burin.draw(scene, style="engraving", paper="A5")
        seconds = time.monotonic() - start
        stop.set()
        thread.join()
        self.assertGreater(len(ticks), 20 * seconds)

    def test_two_draws_at_once_are_as_one_after_the_other(self):
        scene = burin.Scene()
        scene.add_mesh(*sphere())
        asked = []

        def tone(positions, normals):
            asked.append(threading.get_ident())
            return np.clip(positions[:, 2] / 20 + 0.5, 0, 1)

        def work(view):
            return burin.draw(scene, view=view, style="engraving", paper="A6", tone=tone).to_bytes("json")

        views = ["front", "top", "iso"]
        alone = [work(view) for view in views]
        together, owners = [None] * 3, [None] * 3

        def run(k):
            owners[k] = threading.get_ident()
            together[k] = work(views[k])

        asked.clear()
        threads = [threading.Thread(target=run, args=(k,)) for k in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(together, alone)
        self.assertEqual(set(asked), set(owners))

    def test_drawing_inside_a_callable(self):
        inner = burin.Scene()
        inner.add_mesh(*cube())
        drawn = []

        def tone(positions, normals):
            if not drawn:
                drawn.append(burin.draw(inner, style="engraving", paper="A6"))
            return np.full(len(positions), 0.3)

        burin.draw(inner, paper="A6", tone=tone)
        self.assertEqual(len(drawn), 1)


if __name__ == "__main__":
    unittest.main()
