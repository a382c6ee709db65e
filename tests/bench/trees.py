#!/usr/bin/env python3
"""Large OpenSCAD programs of kinds that people write, made here: what each takes.

usage: trees.py [--build DIR] [--only REGEX] [--other DIR]

Letters cut from a ball, a tube of hulls, a pyramid of bars in pyramids, boards full of equal things. A row a program: leaves of
the tree, then processor seconds of OpenSCAD to the tree, of the evaluator burin-csg on the tree, its memory, and of the whole
`burin draw` in outline. --other: a second build, measured beside the first one, and the ratio of both evaluators.
"""
import argparse
import os
import pathlib
import re
import tempfile

import csg

LETTERS = """
difference() {
  sphere(30, $fn = 96);
  for (i = [0:5], j = [-1:1]) rotate([j * 35, 0, i * 60]) translate([0, -20, 0]) rotate([90, 0, 0])
    linear_extrude(20) text(["Ab", "&8", "Qg"][j + 1], size = 9, halign = "center", valign = "center", $fn = 24);
}
"""
TUBE = """
function k(t) = [(24 + 8 * cos(3 * t)) * cos(2 * t), (24 + 8 * cos(3 * t)) * sin(2 * t), 8 * sin(3 * t)];
module tube(r) for (i = [0:1:359]) hull() { translate(k(i)) sphere(r, $fn = 16); translate(k(i + 1)) sphere(r, $fn = 16); }
difference() { tube(4); tube(3); translate([-60, -60, 4]) cube(120); }
"""
PYRAMID = """
module bar(a, b) hull() { translate(a) cube(1, center = true); translate(b) cube(1, center = true); }
module pyramid(n, s) {
  c = [[s, s, 0], [-s, s, 0], [-s, -s, 0], [s, -s, 0]];
  for (i = [0:3]) { bar(c[i], c[(i + 1) % 4]); bar(c[i], [0, 0, s]); }
  if (n > 0) { for (p = c) translate(p / 2) pyramid(n - 1, s / 2); translate([0, 0, s / 2]) pyramid(n - 1, s / 2); }
}
pyramid(5, 100);
"""
BOARD = """
module plug() difference() {
  union() { cylinder(d = 8, h = 10, $fn = 64); translate([-3, -3, 0]) cube([6, 6, 12]); }
  for (a = [0:45:315]) rotate(a) translate([2, 0, -1]) cylinder(d = 0.8, h = 14, $fn = 24);
}
for (x = [0:29], y = [0:19]) translate([12 * x, 12 * y, 0]) rotate(7 * x) plug();
"""
PROGRAMS = {"letters cut from a ball": LETTERS, "hollow tube of 720 hulls": TUBE, "pyramid of 31,248 bars": PYRAMID,
            "600 equal plugs": BOARD}
LEAF = re.compile(r"\b(cube|sphere|cylinder|polyhedron|linear_extrude|rotate_extrude)\(")


def evaluated(build, tree):
    memory = os.memfd_create("tree")
    os.write(memory, tree.read_bytes())
    out = csg.run([str(build / "lib/burin/burin-csg"), "0"], tree.parent, memory)
    os.close(memory)
    return out


def row(name, text, build, other, scratch):
    program, tree = scratch / "program.scad", scratch / "tree.csg"
    program.write_text(text)
    made = csg.run(["openscad", "-o", str(tree), str(program)], scratch)
    own = evaluated(build, tree)
    drawn = csg.run([str(build / "bin/burin"), "draw", str(program), "-o", str(scratch / "a.svg"), "--style", "outline"], scratch)
    leaves = len(LEAF.findall(tree.read_text()))
    seconds = [f"{r['cpu']:.2f}" if r and r["status"] == 0 else "-" for r in (made, own, drawn)]
    memory = f"{own['mb']:.0f}" if own else "-"
    words = [name, f"{leaves:,}", *seconds[:2], memory, seconds[2]]
    if other:
        old = evaluated(other, tree)
        words += [f"{old['cpu']:.2f}", f"{old['cpu'] / own['cpu']:.1f}"] if old and own else ["-", "-"]
    print("| " + " | ".join(words) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--build", default=csg.ROOT / "build/release", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--other", type=pathlib.Path)
    words = parser.parse_args()
    heads = ["program", "leaves", "tree s", "own s", "MB", "draw s"] + (["other s", "gain"] if words.other else [])
    print("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    with tempfile.TemporaryDirectory() as scratch:
        for name, text in PROGRAMS.items():
            if re.search(words.only, name):
                row(name, text, words.build, words.other, pathlib.Path(scratch))


if __name__ == "__main__":
    main()
