#!/usr/bin/env python3
"""watch.py BURIN MODEL.scad [COUNT]: how long after a save `burin watch` has the new drawing, beside how long the same command
takes to draw the file: medians of COUNT saves (7). What is left is the time that a save waits to be noticed."""

import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time


def stamp(path):
    try:
        s = os.stat(path)
    except FileNotFoundError:
        return None
    return s.st_ino, s.st_mtime_ns


def wait_for_another(path, before, seconds=120):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        now = stamp(path)
        if now is not None and now != before:
            return
        time.sleep(0.002)
    sys.exit(f"watch.py: {path} did not change within {seconds} s")


def main():
    burin, model, count = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 7
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(model.parent, folder / "model", ignore=lambda _, names: [n for n in names if not n.endswith((".scad", ".stl", ".dxf"))])
        file, out = folder / "model" / model.name, folder / "out.html"
        draw, watch = [], []
        for _ in range(count):
            begin = time.monotonic()
            subprocess.run([burin, "draw", file, "-o", folder / "alone.html", "--quiet"], check=True)
            draw.append(time.monotonic() - begin)
        process = subprocess.Popen([burin, "watch", file, "-o", out, "--quiet"])
        try:
            wait_for_another(out, None)
            for number in range(count):
                time.sleep(1)
                before = stamp(out)
                text = file.read_text() + f"// {number}\n"
                begin = time.monotonic()
                file.write_text(text)
                wait_for_another(out, before)
                watch.append(time.monotonic() - begin)
        finally:
            process.terminate()
            process.wait()
    d, w = statistics.median(draw), statistics.median(watch)
    print(f"{model.name}: drawn in {d:.3f} s; after a save {w:.3f} s; beyond the drawing {w - d:+.3f} s (medians of {count})")


main()
