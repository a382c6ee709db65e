#!/usr/bin/python3
"""How calm the ink of engravings is: a row a file, then the median and the worst, of one or several builds side by side.

usage: calm.py [--sheet OUT.png] [--worst OUT.png] BURIN[,BURIN...] FILE|FOLDER... [-- draw options]

Each file is drawn as an engraving on A5 from the usual view. Where strokes carry a smooth tone (mean ink over 1.8 mm between 0.08 and
0.75, 1.65 mm and more from every feature line)
  streak  is the root mean square of the ink blurred over 0.45 mm less the ink blurred over 1.8 mm (standard deviations; of that
          the part that varies over 0.9 mm, for edges of highlights are no streaks),
  ends    is the number of stroke ends a cm2 where the mean ink is over 0.2.
Even hatching of 0.55 mm has a streak of about 0.002. --sheet writes contact sheets of all drawings of the last build, 24 on each: OUT-1.png ...; --worst one of the places, 24 x 18 mm,
where each of its drawings is least calm.
Needs numpy and ImageMagick.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

import numpy as np

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .scad .implicit".split()
DPI = 254
PER_SHEET = 24
PIXEL = 25.4 / DPI


def box(plane, radius, axis):
    """A moving mean over 2 radius + 1 pixels; beyond the border there is nothing."""
    sums = np.cumsum(plane, axis=axis)
    width = 2 * radius + 1
    pad = [(0, 0), (0, 0)]
    pad[axis] = (radius + 1, radius)
    sums = np.pad(sums, pad, mode="edge")
    first = [slice(None), slice(None)]
    first[axis] = slice(0, radius + 1)
    sums[tuple(first)] = 0
    after, before = [slice(None), slice(None)], [slice(None), slice(None)]
    after[axis], before[axis] = slice(width, None), slice(0, -width)
    return (sums[tuple(after)] - sums[tuple(before)]) / width


def blur(plane, deviation):
    """Nearly a Gaussian: three moving means each way."""
    radius = max(1, round((np.sqrt(4 * (deviation / PIXEL) ** 2 + 1) - 1) / 2))
    for axis in (0, 1):
        for _ in range(3):
            plane = box(plane, radius, axis)
    return plane


def near(lines, shape, distance):
    """Whether a pixel is nearer to a line than that, in mm."""
    here = np.zeros(shape, dtype=np.float64)
    for line in lines:
        for a, b in zip(line[:-1], line[1:]):
            n = max(2, int(np.abs(b - a).max() / PIXEL) + 2)
            at = a + np.linspace(0, 1, n)[:, None] * (b - a)
            x, y = np.clip((at / PIXEL).astype(int), 0, [shape[1] - 1, shape[0] - 1]).T
            here[y, x] = 1
    r = round(distance / PIXEL)
    for axis in (0, 1):  # a square is as good as a disc
        here = box(here, r, axis) > 1e-12
        here = here.astype(np.float64)
    return here > 0


def measure(burin, file, options):
    with tempfile.TemporaryDirectory() as folder:
        png, drawing = folder + "/a.png", folder + "/a.json"
        done = subprocess.run([burin, "draw", str(file), "--style", "engraving", "--paper", "A5", *options, "-o", png, "-o",
                               drawing, "--quiet", "--set", f"png.dpi={DPI}"], capture_output=True, text=True)
        if done.returncode:
            return None, done.stderr.strip().splitlines()[-1:]
        size = subprocess.run(["identify", "-format", "%w %h", png], capture_output=True, text=True, check=True).stdout.split()
        width, height = int(size[0]), int(size[1])
        raw = subprocess.run(["convert", png, "-alpha", "remove", "-depth", "8", "gray:-"], capture_output=True, check=True).stdout
        paths = [p for layer in json.loads(pathlib.Path(drawing).read_text())["layers"] for p in layer["paths"]]
    ink = 1 - np.frombuffer(raw, dtype=np.uint8).reshape(height, width) / 255.0
    lines, ends = [], []
    for path in paths:
        points = np.array(path["points"], dtype=float)
        points[:, 1] = height * PIXEL - points[:, 1]
        if path["kind"] == "stroke":
            ends += [points[0], points[-1]]
        else:
            lines.append(points)
    clear = (~near(lines, ink.shape, 1.2)).astype(float)

    def even(plane, weight, deviation):
        return blur(plane * weight, deviation) / np.maximum(blur(weight, deviation), 1e-3)

    fine, mean = even(ink, clear, 0.45), even(ink, clear, 1.8)
    smooth = ~near(lines, ink.shape, 1.65) & (mean > 0.08) & (mean < 0.75)
    if not smooth.any():
        return None, ["no smooth tone"]
    band = fine - mean
    band -= even(band, smooth.astype(float), 0.9)
    dark = smooth & (mean > 0.2)
    count = 0
    if ends:
        x, y = np.clip((np.array(ends) / PIXEL).astype(int), 0, [width - 1, height - 1]).T
        count = int(dark[y, x].sum())
    cm2 = dark.sum() * PIXEL * PIXEL / 100
    at = np.unravel_index(int(np.argmax(blur(np.where(smooth, band ** 2, 0.0), 1.5))), band.shape)
    return (float(np.sqrt((band[smooth] ** 2).mean())), count / cm2 if cm2 > 0 else 0.0, cut_out(ink, *at)), []


def cut_out(ink, y, x):
    """A piece of the drawing round a place, as grey bytes."""
    high, wide = round(18 / PIXEL), round(24 / PIXEL)
    y, x = max(0, min(y - high // 2, ink.shape[0] - high)), max(0, min(x - wide // 2, ink.shape[1] - wide))
    return np.round(255 * (1 - ink[y:y + high, x:x + wide])).astype(np.uint8)


def main():
    words = sys.argv[1:]
    options = []
    if "--" in words:
        at = words.index("--")
        words, options = words[:at], words[at + 1:]
    asked = {}
    while words[:1] in (["--sheet"], ["--worst"]):
        asked[words[0]] = pathlib.Path(words[1])
        words = words[2:]
    sheet = asked.get("--sheet")
    if len(words) < 2:
        sys.exit(__doc__)
    builds = words[0].split(",")
    files = []
    for name in map(pathlib.Path, words[1:]):
        files += sorted(f for f in name.rglob("*") if f.suffix.lower() in SUFFIXES) if name.is_dir() else [name]
    print("| file |" + " streak | ends a cm2 |" * len(builds))
    print("|---|" + "---|---|" * len(builds))
    rows, places = [], []
    for file in files:
        cells = []
        for build in builds:
            found, why = measure(build, file, options)
            cells.append(found)
            if found is None:
                print(f"{file}: {' '.join(why)}", file=sys.stderr)
        if any(c is None for c in cells):
            continue
        rows.append(cells)
        places.append((file.name, cells[-1][2]))
        print(f"| {file.name} |" + "".join(f" {s:.4f} | {e:.1f} |" for s, e, _ in cells), flush=True)
    for name, of in (("median", statistics.median), ("worst", max)):
        print(f"| **{name}** |" + "".join(f" {of([r[k][0] for r in rows]):.4f} | {of([r[k][1] for r in rows]):.1f} |"
                                          for k in range(len(builds))))
    if "--worst" in asked:
        with tempfile.TemporaryDirectory() as folder:
            words = []
            for i, (name, place) in enumerate(places):
                grey = f"{folder}/{i:04d}.pgm"
                pathlib.Path(grey).write_bytes(b"P5 %d %d 255\n" % (place.shape[1], place.shape[0]) + place.tobytes())
                words += ["-label", name, grey]
            subprocess.run(["montage", *words, "-tile", "5x", "-geometry", "+6+6", str(asked["--worst"])], check=True)
    if sheet:
        with tempfile.TemporaryDirectory() as folder:
            shown = []
            for i, file in enumerate(files):
                png = f"{folder}/{i:04d}.png"
                done = subprocess.run([builds[-1], "draw", str(file), "--style", "engraving", "--paper", "A5", *options, "-o", png,
                                       "--quiet", "--set", "png.dpi=130"], capture_output=True)
                if done.returncode == 0:
                    shown.append(["-label", file.name, png])
            for k in range(0, len(shown), PER_SHEET):
                words = [word for one in shown[k:k + PER_SHEET] for word in one]
                name = sheet.with_stem(f"{sheet.stem}-{k // PER_SHEET + 1}")
                subprocess.run(["montage", *words, "-tile", "6x", "-geometry", "500x+4+4", str(name)], check=True)


main()
