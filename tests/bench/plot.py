#!/usr/bin/python3
"""How far a pen travels: a row a drawing, before (the order of the drawing file) and after (the HPGL that burin writes).

usage: plot.py BURIN FILE|FOLDER... [--styles technical,engraving,plotter] [--svg] [-- draw options]
       plot.py --show OUT.png FILE.hpgl|FILE.gcode

Lengths are in metres: drawn, travelled before, travelled after, and their ratio; `lifts` is how often the pen comes down.
Hidden lines are left out. --svg measures the SVG of svg.order=travel and the DXF of dxf.order=travel, too. --show draws what the machine does: lines of each
pen in its own grey, travel in red (rsvg-convert or ImageMagick makes the picture).
"""
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .scad .csg .implicit .fcstd".split()


class Machine:
    """Lines with the pen down, and the ways between them."""

    def __init__(self):
        self.at, self.down, self.pen, self.lines, self.ways, self.way = (0.0, 0.0), False, 1, [], [], [(0.0, 0.0)]

    def put(self, down):
        if down and not self.down:
            self.ways.append(self.way)
            self.lines.append((self.pen, [self.at]))
        if self.down and not down:
            self.way = [self.at]
        self.down = down

    def go(self, x, y):
        self.at = (x, y)
        (self.lines[-1][1] if self.down else self.way).append(self.at)

    def arc(self, centre, turn):
        x, y = self.at[0] - centre[0], self.at[1] - centre[1]
        n = max(1, math.ceil(abs(turn) / 0.02))
        for k in range(1, n + 1):
            c, s = math.cos(turn * k / n), math.sin(turn * k / n)
            self.go(centre[0] + c * x - s * y, centre[1] + s * x + c * y)


def read_hpgl(text):
    machine = Machine()
    for one in text.replace("\n", "").split(";"):
        word, rest = one[:2], one[2:]
        numbers = [float(n) for n in rest.split(",") if n]
        if word == "AA":
            machine.arc((numbers[0] / 40, numbers[1] / 40), math.radians(numbers[2]))
        if word == "SP":
            machine.pen = int(numbers[0]) if numbers else 0
        if word in ("PU", "PD"):
            machine.put(word == "PD")
        if word in ("PU", "PD", "PA"):
            for x, y in zip(numbers[::2], numbers[1::2]):
                machine.go(x / 40, y / 40)
    return machine


def read_gcode(text):
    """The pen is down after M3, or at a Z of no more than 0."""
    machine = Machine()
    for line in text.splitlines():
        words = dict((w[0], float(w[1:])) for w in line.partition(";")[0].split())
        if words.get("M") in (3, 5):
            machine.put(words["M"] == 3)
        if words.get("G") in (2, 3):
            (x, y), to = machine.at, (words["X"], words["Y"])
            centre = x + words["I"], y + words["J"]
            a, b = (math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in ((x, y), to))
            turn = (b - a) % math.tau if words["G"] == 3 else -((a - b) % math.tau)
            machine.arc(centre, turn)
            machine.go(*to)
        if "M" in words or words.get("G", 2) > 1:
            continue
        if "Z" in words:
            machine.put(words["Z"] <= 0)
        if "X" in words:
            machine.go(words["X"], words["Y"])
    return machine


def length(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


def travel(lines):
    """From the end of each line to the beginning of the next, and to the first."""
    at, way = (0.0, 0.0), 0.0
    for line in lines:
        way += math.dist(at, line[0])
        at = line[-1]
    return way


def drawing_lines(path):
    """The visible lines of a drawing file, layer by layer and part by part, as other formats write them."""
    lines = []
    for layer in json.loads(path.read_text())["layers"]:
        by_part = {}
        for line in layer["paths"]:
            if line.get("visible", True) and len(line["points"]) > 1:
                points = [tuple(p) for p in line["points"]]
                by_part.setdefault(line.get("part", -1), []).append(points + points[:1] if line.get("closed") else points)
        for part in sorted(by_part):
            lines += by_part[part]
    return lines


def svg_lines(path):
    """Polylines of an SVG of svg.flatten=polylines."""
    return [[tuple(map(float, p.split(","))) for p in found.split()]
            for found in re.findall(r'<polyline[^>]* points="([^"]*)"', path.read_text())]


def dxf_lines(path):
    """LINE and LWPOLYLINE of a DXF of ours that was written with dxf.arcs=false."""
    words = path.read_text().split("\n")
    lines, kind, points, closed = [], "", [], False
    for code, value in zip(words[::2], words[1::2]):
        code = code.strip()
        if code == "0":
            if kind in ("LINE", "LWPOLYLINE") and points:
                lines.append(points + points[:1] if closed else points)
            kind, points, closed = value, [], False
        elif code in ("10", "11") and kind in ("LINE", "LWPOLYLINE"):
            points.append((float(value),))
        elif code in ("20", "21") and kind in ("LINE", "LWPOLYLINE"):
            points[-1] += (float(value),)
        elif code == "70":
            closed = int(value) & 1 == 1
    return lines


def show(out, file):
    read = read_gcode if file.suffix == ".gcode" else read_hpgl
    machine = read(file.read_text())
    every = [p for _, line in machine.lines for p in line]
    width, height = (max(p[k] for p in every) + 5 for k in (0, 1))
    pens = sorted({pen for pen, _ in machine.lines})

    def polyline(points, colour, pen):
        at = " ".join(f"{x:.3f},{height - y:.3f}" for x, y in points)
        return f'<polyline points="{at}" fill="none" stroke="{colour}" stroke-width="{pen}" stroke-linecap="round" stroke-linejoin="round"/>'

    body = [polyline(line, f"hsl(220,60%,{10 + 50 * pens.index(pen) // max(1, len(pens))}%)", 0.25) for pen, line in machine.lines]
    body += [polyline(way, "red", 0.12) for way in machine.ways]
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">'
           f'<rect width="100%" height="100%" fill="white"/>{"".join(body)}</svg>')
    with tempfile.NamedTemporaryFile("w", suffix=".svg") as picture:
        picture.write(svg)
        picture.flush()
        subprocess.run(["rsvg-convert", "--dpi-x", "150", "--dpi-y", "150", picture.name, "-o", str(out)], check=True)
    print(f"{file.name}: {len(machine.lines)} lines, {sum(length(l) for _, l in machine.lines) / 1000:.2f} m drawn, "
          f"{travel([l for _, l in machine.lines]) / 1000:.2f} m of travel")


def row(burin, file, style, svg, options):
    with tempfile.TemporaryDirectory() as folder:
        a = pathlib.Path(folder) / "a"
        outputs = ["-o", f"{a}.json", "-o", f"{a}.hpgl"]
        if svg:
            outputs += ["-o", f"{a}.svg", "-o", f"{a}.dxf", "--set", "svg.flatten=polylines", "--set", "svg.order=travel",
                        "--set", "dxf.order=travel", "--set", "dxf.arcs=false"]
        done = subprocess.run([burin, "draw", str(file), "--style", style, *options, *outputs, "--quiet"], capture_output=True,
                              text=True)
        if done.returncode:
            print(f"{file}: {done.stderr.strip()}", file=sys.stderr)
            return None
        before = drawing_lines(a.with_suffix(".json"))
        after = [line for _, line in read_hpgl(a.with_suffix(".hpgl").read_text()).lines]
        if not before:
            return None
        numbers = [sum(map(length, before)) / 1000, travel(before) / 1000, travel(after) / 1000, len(before), len(after)]
        if svg:
            numbers += [travel(svg_lines(a.with_suffix(".svg"))) / 1000, travel(dxf_lines(a.with_suffix(".dxf"))) / 1000]
        return numbers


def main():
    words, options = sys.argv[1:], []
    if words[:1] == ["--show"] and len(words) == 3:
        return show(pathlib.Path(words[1]), pathlib.Path(words[2]))
    if "--" in words:
        at = words.index("--")
        words, options = words[:at], words[at + 1:]
    styles, svg = ["technical", "engraving", "plotter"], "--svg" in words
    if "--styles" in words:
        at = words.index("--styles")
        styles = words[at + 1].split(",")
        del words[at:at + 2]
    words = [w for w in words if w != "--svg"]
    if len(words) < 2:
        sys.exit(__doc__)
    files = []
    for name in map(pathlib.Path, words[1:]):
        files += sorted(f for f in name.rglob("*") if f.suffix.lower() in SUFFIXES) if name.is_dir() else [name]
    print("| file | style | lines | lifts | drawn, m | travel before, m | travel, m | ratio |" + (" SVG, m | DXF, m |" if svg else ""))
    print("|---|---|---|---|---|---|---|---|" + ("---|---|" if svg else ""))
    ratios = []
    for file in files:
        for style in styles:
            found = row(words[0], file, style, svg, options)
            if found is None:
                continue
            drawn, before, after, lines, lifts, *others = found
            ratios.append(after / before if before else 0.0)
            print(f"| {file.name} | {style} | {lines} | {lifts} | {drawn:.2f} | {before:.2f} | {after:.2f} | {ratios[-1]:.3f} |"
                  + "".join(f" {way:.2f} |" for way in others), flush=True)
    if ratios:
        print(f"| **median, worst** | | | | | | | {statistics.median(ratios):.3f}, {max(ratios):.3f} |" + (" | |" if svg else ""))


if __name__ == "__main__":
    main()
