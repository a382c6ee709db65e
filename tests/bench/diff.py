#!/usr/bin/python3
"""How long `burin diff` takes, and whether it finds what was changed: a row a pair of revisions.

usage: diff.py BURIN [PARTS ...]

The coupling of the samples against itself and against its revision; then, for each number of PARTS (2500, 10000), an OBJ file of so many
ribbed blocks against the same in another order of parts, points and triangles, and against one in which every third is shifted and one is gone.
Processor seconds and peak memory of the whole command, reading included.
"""
import json
import math
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIDES = 24  # a prism: 4 * SIDES triangles


def prism(k):
    """Points and triangles of a prism; neighbours differ in height."""
    x, y, height = 10.0 * (k % 100), 10.0 * (k // 100), 3 + 0.001 * k
    ring = [(x + 3 * math.cos(2 * math.pi * i / SIDES), y + 3 * math.sin(2 * math.pi * i / SIDES)) for i in range(SIDES)]
    points = [(px, py, z) for z in (0, height) for px, py in ring] + [(x, y, 0), (x, y, height)]
    faces = []
    for i in range(SIDES):
        j = (i + 1) % SIDES
        faces += [(i, j, SIDES + j), (i, SIDES + j, SIDES + i), (2 * SIDES, j, i), (2 * SIDES + 1, SIDES + i, SIDES + j)]
    return points, faces


def write(path, parts, shuffle=None):
    """An OBJ file of parts, (number, shift); `shuffle` changes all orders."""
    chance = random.Random(1) if shuffle else None
    parts = list(parts)
    if chance:
        chance.shuffle(parts)
    base = 1
    with open(path, "w", encoding="ascii") as file:
        for number, shift in parts:
            points, faces = prism(number)
            order = list(range(len(points)))
            if chance:
                chance.shuffle(order)
                chance.shuffle(faces)
            place = {old: new for new, old in enumerate(order)}
            file.write(f"o block_{number}\n")
            file.writelines(f"v {points[k][0] + shift} {points[k][1]} {points[k][2]}\n" for k in order)
            file.writelines("f " + " ".join(str(base + place[k]) for k in face) + "\n" for face in faces)
            base += len(points)


def row(burin, name, old, new, wanted):
    with tempfile.TemporaryDirectory() as scratch:
        report = pathlib.Path(scratch) / "report.json"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        run = subprocess.run([burin, "diff", str(old), str(new), "-o", str(report), "--quiet"], capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if run.returncode not in (0, 6):
            raise SystemExit(f"diff: {name}: {run.stderr}")
        counts = {key: n for key, n in json.loads(report.read_text())["counts"].items() if n}
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    said = "as made" if wanted is None or counts == wanted else f"WRONG, made: {wanted}"
    print(f"{name:44} {seconds:7.2f} s  peak so far {after.ru_maxrss / 1024:6.0f} MB  {counts} {said}")


def main():
    burin = sys.argv[1]
    samples = ROOT / "samples"
    row(burin, "coupling.step against itself", samples / "coupling.step", samples / "coupling.step", {"same": 30})
    row(burin, "... against coupling_revised.step", samples / "coupling.step", samples / "coupling_revised.step",
        {"same": 24, "changed": 1, "moved": 1, "added": 1, "removed": 4})
    with tempfile.TemporaryDirectory() as scratch:
        at = pathlib.Path(scratch)
        for count in [int(word) for word in sys.argv[2:]] or [2500, 10000]:
            write(at / "old.obj", ((k, 0) for k in range(count)))
            write(at / "same.obj", ((k, 0) for k in range(count)), shuffle=True)
            write(at / "other.obj", ((k, 1.5 if k % 3 == 0 else 0) for k in range(count - 1)), shuffle=True)
            moved = (count - 1 + 2) // 3
            row(burin, f"{count} parts of 96 triangles, in another order", at / "old.obj", at / "same.obj", {"same": count})
            row(burin, "... every third shifted, the last one gone", at / "old.obj", at / "other.obj",
                {"same": count - 1 - moved, "moved": moved, "removed": 1})


main()
