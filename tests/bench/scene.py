#!/usr/bin/env python3
"""Writes an illustration of 112 parts in mixed styles: a chess board with 32 pieces, and 16 CAD parts beside it.

    tests/bench/scene.py > scene.burin.json
    tests/bench/scene.py --glass > glass.burin.json        four of the CAD parts are transparent
    burin draw scene.burin.json -o scene.svg -v"""
import json
import pathlib
import sys

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
PIECE = "union(union(cylinder(3.2, 3), translate(cone(2.4, 0.8, 9), 0, 0, 4)), translate(sphere(2.2), 0, 0, 11))"


def main():
    parts = []
    for i in range(8):
        for j in range(8):
            place = {"translate": [10 * i, 10 * j, -1]}
            parts.append({"function": "box(10, 10, 2)", "name": f"field {i}{j}", "place": place})
    for i in range(8):
        for j in (0, 1, 6, 7):
            place = {"translate": [10 * i, 10 * j, 1.5]}
            parts.append({"function": PIECE, "name": f"{'white' if j < 2 else 'black'} {i}{j}", "place": place})
    for i in range(4):
        for j in range(4):
            place = {"scale": 0.08, "translate": [22 * i, -30 - 22 * j, 0]}
            parts.append({"file": str(SAMPLES / "pedestal.step"), "name": f"stand {i}{j}", "place": place})
    looks = [
        {"select": "black *", "style": {"tone.ambient": 0.05}},
        {"select": "white *", "style": "technical"},
        {"select": "field *", "style": "outline"},
        {"select": "field *1", "style": "pencil"},
    ]
    if "--glass" in sys.argv[1:]:
        looks.append({"select": "stand 1*", "transparent": True})
    print(json.dumps({"burin": "illustration", "parts": parts, "paper": "A4", "style": "engraving", "looks": looks}, indent=1))


main()
