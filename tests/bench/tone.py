#!/usr/bin/python3
"""How far the ink of a style is from the tone that was asked for: a row a file and style, then the median and the worst.

usage: PYTHONPATH=build/release/python tone.py FILE|FOLDER... [--styles plotter,engraving]

Each file is drawn on A5 from the usual view with a tone of this program: darkness by the cosine to a light, from 0.1 to 0.65. The ink of
a picture at 508 dpi, averaged over discs of 2 mm, is compared with that tone averaged in the same way: where it is 0.05 to 0.70, 2 mm and more from
every feature line. `error` is the mean of |ink - tone|, `bias` that of ink - tone. The unit test Tone.OfEachStyleIsWhatTheLightAsks measures so on a torus.
Needs numpy and ImageMagick.
"""
import pathlib
import statistics
import subprocess
import sys
import tempfile

import burin
import numpy as np

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .implicit".split()
CELL = 0.5  # mm
LIGHT = np.array([-0.4, -0.5, 0.77])


def disc_mean(plane, mask):
    """Means over discs of 2 mm, of the cells of the mask."""
    total, count = np.zeros_like(plane), np.zeros_like(plane)
    padded, known = np.pad(np.where(mask, plane, 0), 2), np.pad(mask.astype(float), 2)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            if dx * dx + dy * dy <= 4:
                window = np.s_[2 + dy:2 + dy + plane.shape[0], 2 + dx:2 + dx + plane.shape[1]]
                total += padded[window]
                count += known[window]
    return total / np.maximum(count, 1)


def near(lines, shape):
    """Cells nearer than 2 mm to a line."""
    here = np.zeros(shape, dtype=bool)
    for line in lines:
        for a, b in zip(line[:-1], line[1:]):
            n = int(np.abs(b - a).max() / CELL * 2) + 2
            at = ((a + np.linspace(0, 1, n)[:, None] * (b - a)) / CELL).astype(int)
            x, y = np.clip(at, 0, [shape[1] - 1, shape[0] - 1]).T
            here[y, x] = True
    reach = round(2 / CELL)
    padded, out = np.pad(here, reach), np.zeros_like(here)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dx * dx + dy * dy <= reach * reach:
                out |= padded[reach + dy:reach + dy + shape[0], reach + dx:reach + dx + shape[1]]
    return out


def measure(file, style):
    asked = []
    light = LIGHT / np.linalg.norm(LIGHT)

    def tone(positions, normals):
        darkness = 0.65 - 0.55 * np.clip(normals @ light, 0, 1)
        asked.append((np.array(positions), darkness))
        return darkness

    drawing = burin.draw(str(file), style=style, paper="A5", tone=tone)
    view = drawing.view
    positions, darkness = (np.concatenate([one[k] for one in asked]) for k in (0, 1))
    width, height = drawing.paper
    shape = (int(height / CELL), int(width / CELL))
    off = positions - np.array(view["center"])
    x = view["scale"] * off @ np.array(view["right"]) + view["offset"][0]
    y = view["scale"] * off @ np.array(view["up"]) + view["offset"][1]
    cell = (np.floor(np.stack([y, x], 1) / CELL)).astype(int)
    inside = (cell >= 0).all(1) & (cell < shape).all(1)
    total, count = np.zeros(shape), np.zeros(shape)
    np.add.at(total, tuple(cell[inside].T), darkness[inside])
    np.add.at(count, tuple(cell[inside].T), 1)
    mask = count > 0
    want = disc_mean(total / np.maximum(count, 1), mask)
    pixels = 10  # a cell
    with tempfile.TemporaryDirectory() as folder:
        png = pathlib.Path(folder) / "a.png"
        drawing.save(png, png_dpi=25.4 / CELL * pixels)
        size = subprocess.run(["identify", "-format", "%w %h", png], capture_output=True, text=True, check=True).stdout.split()
        raw = subprocess.run(["convert", png, "-alpha", "remove", "-depth", "8", "gray:-"], capture_output=True, check=True).stdout
    ink = 1 - np.frombuffer(raw, dtype=np.uint8).reshape(int(size[1]), int(size[0])) / 255.0
    ink = ink[:shape[0] * pixels, :shape[1] * pixels]
    ink = np.pad(ink, ((0, shape[0] * pixels - ink.shape[0]), (0, shape[1] * pixels - ink.shape[1])))
    have = disc_mean(ink.reshape(shape[0], pixels, shape[1], pixels).mean((1, 3))[::-1], mask)
    features = [np.asarray(path.points) for layer in drawing.layers for path in layer.paths if path.kind != "stroke"]
    features = [np.vstack([line, line[:1]]) if closed else line for line, closed in
                zip(features, (path.closed for layer in drawing.layers for path in layer.paths if path.kind != "stroke"))]
    counted = mask & ~near(features, shape) & (want >= 0.05) & (want <= 0.70)
    if counted.sum() < 500:
        return None
    return float(np.abs(have - want)[counted].mean()), float((have - want)[counted].mean()), int(counted.sum())


def main():
    words, styles = sys.argv[1:], ["plotter", "engraving"]
    if "--styles" in words:
        at = words.index("--styles")
        styles = words[at + 1].split(",")
        del words[at:at + 2]
    if not words:
        sys.exit(__doc__)
    files = []
    for name in map(pathlib.Path, words):
        files += sorted(f for f in name.rglob("*") if f.suffix.lower() in SUFFIXES) if name.is_dir() else [name]
    print("| file | cells |" + "".join(f" {style}: error | bias |" for style in styles))
    print("|---|---|" + "---|---|" * len(styles))
    errors = {style: [] for style in styles}
    for file in files:
        cells, count = "", 0
        for style in styles:
            try:
                found = measure(file, style)
            except burin.Error as error:
                print(f"{file}: {error}", file=sys.stderr)
                found = None
            if found is None:
                break
            errors[style].append(found[0])
            count = found[2]
            cells += f" {found[0]:.3f} | {found[1]:+.3f} |"
        else:
            print(f"| {file.name} | {count} |{cells}", flush=True)
    if all(errors.values()):
        print("| **median, worst** | |" + "".join(f" {statistics.median(e):.3f}, {max(e):.3f} | |" for e in errors.values()))


if __name__ == "__main__":
    main()
