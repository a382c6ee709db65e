#!/usr/bin/env python3
"""Draws files with two builds of the command and tells where the drawings differ.

usage: compare_builds.py OLD NEW [--view V]... [--style S]... [--with=OPTION]... FILE...

For each drawing: whether the bytes are the same; else for the lines of the shape how many mm of each one have no line of the
other within 0.01 mm, and for strokes how much their number, their ink (mm2) and their tone (mean difference of the ink in
squares of 3 mm, as a share of the paper) have changed. Processor time and memory of both, in turn, as ratios. One table,
the drawings that differ first told one by one, then the sums. Status 1 where a file is drawn by one build alone.
"""
import argparse
import hashlib
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

if sys.argv[1:2] == ["--told"]:
    import numpy  # in the process that compares alone: what a process weighs when it starts another counts for that one

NEAR = 0.01  # mm of paper
STEP = 0.1  # mm between the points that lines are compared at
SQUARE = 3.0


def draw(burin, path, out, style, view, extra):
    command = [burin, "draw", path, "-o", out, "--style", style, "--view=" + view, "--quiet", "--set", "json.points3=false"] + extra
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    errors = child.stderr.read()
    _, code, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(code)
    cost = usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024
    if child.returncode != 0:
        return None, cost, errors.strip().splitlines()[-1] if errors.strip() else "status %d" % child.returncode
    with open(out, "rb") as file:
        return hashlib.sha256(file.read()).digest(), cost, ""


def paths_of(text):
    """(lines of the shape, strokes): arrays of points, mm, with their widths."""
    lines, strokes = [], []
    for layer in json.loads(text)["layers"]:
        for path in layer["paths"]:
            points = numpy.array(path["points"], float)[:, :2]
            if path.get("closed"):
                points = numpy.vstack([points, points[:1]])
            width = path.get("width", layer.get("width", 0.2))
            (strokes if "stroke" in path.get("kind", layer.get("name", "")) else lines).append((points, width))
    return lines, strokes


def samples(paths):
    """Points along paths, the length and the width that each stands for."""
    points, shares, widths = [numpy.zeros((0, 2))], [numpy.zeros(0)], [numpy.zeros(0)]
    for path, width in paths:
        width = numpy.mean(width)
        a, d = path[:-1], numpy.diff(path, axis=0)
        lengths = numpy.hypot(d[:, 0], d[:, 1])
        counts = numpy.maximum(1, numpy.ceil(lengths / STEP).astype(int))
        which = numpy.repeat(numpy.arange(len(a)), counts)
        t = (numpy.arange(len(which)) - numpy.repeat(numpy.cumsum(counts) - counts, counts) + 0.5) / counts[which]
        points.append(a[which] + t[:, None] * d[which])
        shares.append(lengths[which] / counts[which])
        widths.append(numpy.full(len(which), width))
    return numpy.vstack(points), numpy.concatenate(shares), numpy.concatenate(widths)


def segments_by_cell(paths, cell):
    grid = {}
    for path, _ in paths:
        for p, q in zip(path[:-1], path[1:]):
            pieces = max(1, math.ceil(math.dist(p, q) / cell))
            for i in range(pieces):
                a, b = p + (q - p) * i / pieces, p + (q - p) * (i + 1) / pieces
                for x in range(int(min(a[0], b[0]) // cell) - 1, int(max(a[0], b[0]) // cell) + 2):
                    for y in range(int(min(a[1], b[1]) // cell) - 1, int(max(a[1], b[1]) // cell) + 2):
                        grid.setdefault((x, y), []).append((a[0], a[1], b[0], b[1]))
    return {key: numpy.array(value) for key, value in grid.items()}


def lonely(paths, others):
    """mm of `paths` that no line of `others` is near to."""
    points, shares, _ = samples(paths)
    cell = 0.5
    grid = segments_by_cell(others, cell)
    far = 0.0
    for p, share in zip(points, shares):
        near = grid.get((int(p[0] // cell), int(p[1] // cell)))
        if near is not None:
            a, d = near[:, :2], near[:, 2:] - near[:, :2]
            t = numpy.clip(((p - a) * d).sum(1) / numpy.maximum((d * d).sum(1), 1e-18), 0, 1)
            off = p - a - t[:, None] * d
            if ((off * off).sum(1)).min() <= NEAR * NEAR:
                continue
        far += share
    return far


def tone(paths):
    points, shares, widths = samples(paths)
    ink = {}
    for key, amount in zip(map(tuple, (points // SQUARE).astype(int)), shares * widths):
        ink[key] = ink.get(key, 0.0) + amount
    return ink


def compare(old, new):
    lines_a, strokes_a = paths_of(pathlib.Path(old).read_text(encoding="utf-8"))
    lines_b, strokes_b = paths_of(pathlib.Path(new).read_text(encoding="utf-8"))
    words = ["lines %.2f mm gone, %.2f mm new of %.0f" % (
        lonely(lines_a, lines_b), lonely(lines_b, lines_a), samples(lines_a)[1].sum())]
    if strokes_a or strokes_b:
        a, b = tone(strokes_a), tone(strokes_b)
        squares = set(a) | set(b)
        off = sum(abs(a.get(s, 0.0) - b.get(s, 0.0)) for s in squares) / (len(squares) * SQUARE * SQUARE)
        words.append("strokes %d to %d, ink %.1f to %.1f mm2, tone off %.4f" % (
            len(strokes_a), len(strokes_b), sum(a.values()), sum(b.values()), off))
    return ", ".join(words)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--view", action="append")
    parser.add_argument("--style", action="append")
    parser.add_argument("--with", action="append", default=[], dest="extra")
    parser.add_argument("files", nargs="+")
    asked = parser.parse_args()
    same = different = 0
    alone, seconds, peaks = [], [0.0, 0.0], []
    with tempfile.TemporaryDirectory() as scratch:
        for path in asked.files:
            for style in asked.style or ("outline", "engraving"):
                for view in asked.view or ("iso",):
                    outs = [os.path.join(scratch, name) for name in ("old.json", "new.json")]
                    made = [draw(burin, path, out, style, view, asked.extra)
                            for burin, out in zip((asked.old, asked.new), outs)]
                    name = "%s %s %s" % (path, style, view)
                    (old, cost_old, error_old), (new, cost_new, error_new) = made
                    seconds[0] += cost_old[0]
                    seconds[1] += cost_new[0]
                    peaks.append((cost_new[1] / cost_old[1], cost_new[0] / max(cost_old[0], 0.01), name))
                    if (old is None) != (new is None):
                        alone.append(name)
                        print("%s: drawn by one alone: %s" % (name, error_old or error_new), flush=True)
                    elif old == new:
                        same += 1
                    else:
                        different += 1
                        told = subprocess.run([sys.executable, __file__, "--told", *outs], capture_output=True, text=True)
                        print("%s: %s; time %.2f to %.2f s, %.0f to %.0f MB" % (
                            name, told.stdout.strip() or told.stderr, cost_old[0], cost_new[0], cost_old[1], cost_new[1]),
                            flush=True)
    print("%d drawings the same, %d different, %d by one build alone; processor time %.1f to %.1f s" % (
        same, different, len(alone), *seconds))
    print("memory: at most %.2f times (%s); time: at most %.2f times (%s)" % (
        max(peaks)[0], max(peaks)[2], *max((t, name) for _, t, name in peaks)))
    sys.exit(bool(alone))


if sys.argv[1:2] == ["--told"]:
    print(compare(*sys.argv[2:]))
else:
    main()
