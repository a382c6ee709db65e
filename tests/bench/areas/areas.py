#!/usr/bin/python3
"""Areas of many models beside random rays: a row a drawing, then sums.

usage: areas.py BIN/burin_areas FILE|FOLDER... [--views iso,front] [--jobs 1] [KEY=VALUE]...

Columns: model, view, parts, mm2 of paper that parts cover, areas, rings, corners; mm2 that random rays contradict, of these over 0.12 mm
from a border, of these with a wrong part; processor seconds of the lines, of the areas, and in a session of another colour and of
another light; the first wrong places (seen!drawn).
"""
import concurrent.futures
import pathlib
import subprocess
import sys

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .glb .implicit .nrrd .scad".split()
NAMES = "shape areas rings corners wrong open part lines time color light".split()


def row(job):
    program, file, view, keys = job
    done = subprocess.run([program, str(file), view, *keys], capture_output=True, text=True, timeout=600)
    return done.stdout.strip() or "# " + done.stderr.strip().replace("\n", " ")


def main(words):
    views, jobs, keys, places = ["iso", "front"], 1, [], []
    words = iter(words)
    program = next(words)
    for word in words:
        if word == "--views":
            views = next(words).split(",")
        elif word == "--jobs":
            jobs = int(next(words))
        elif "=" in word:
            keys.append(word)
        else:
            places.append(pathlib.Path(word))
    files = []
    for place in places:
        found = sorted(place.rglob("*")) if place.is_dir() else [place]
        files += [f for f in found if f.suffix.lower() in SUFFIXES and f.is_file()]
    sums, count = dict.fromkeys(NAMES, 0.0), 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for line in pool.map(row, [(program, f, v, keys) for f in files for v in views]):
            print(line, flush=True)
            if line.startswith("#"):
                continue
            count += 1
            for name, value in zip(NAMES, line.split("\t")[3:]):
                sums[name] += float(value)
    shape = max(sums["shape"], 1)
    print(f"# {count} drawings, {shape:.0f} mm2: wrong {1e6 * sums['wrong'] / shape:.1f} in a million, over 0.12 mm from a border "
          f"{1e6 * sums['open'] / shape:.1f} (part {1e6 * sums['part'] / shape:.1f}); areas {sums['areas']:.0f}, corners "
          f"{sums['corners']:.0f}; lines {sums['lines']:.1f} s, areas {sums['time']:.1f} s, "
          f"another colour {sums['color']:.1f} s, another light {sums['light']:.1f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
