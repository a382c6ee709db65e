#!/usr/bin/python3
"""Labels of many views that meet: a row a view, then sums.

usage: labels.py BURIN BIN/burin_labels FOLDER FILE... [--jobs 1] [--views 200] [--all]

Draws views of the files in turn (VIEWS below: one part alone has no exploded views), the first `--views` of them, as drawing files in
FOLDER, and counts what meets. Columns: view, texts, leaders of callouts; pairs of texts or circles that overlap, circles over texts,
texts and circles off the sheet; texts under leaders, texts under other lines of annotations; leaders of callouts that cross each
other, and other lines of annotations. --all: a line for each, else for the first three columns of them alone.
"""
import concurrent.futures
import json
import pathlib
import subprocess
import sys

NAMES = "texts leaders overlaps circles off under_leaders under_lines crossings over_lines".split()
SHEET = ["--title-block", "iso", "--parts-list", "sheet"]
# name, assemblies alone, options; BOX stands for a corner of the model's box and a radius about it, PART and LAST for the names of its
# first part and of its last
VIEWS = [
    ("sheet", False, ["--views", "front,top,left,iso", "--callouts", "--dimensions", "overall", "--centre-lines", "auto",
                      "--section-view", "y", *SHEET]),
    ("notes", False, ["--callouts", "--dimensions", "overall", "--note", "PART=Check {part.name}", "--note", "LAST=Break edges",
                      "--paper", "A3", "--title-block", "iso"]),
    ("exploded", True, ["--explode", "auto", "--callouts", "--dimensions", "overall", *SHEET]),
    ("details", False, ["--views", "front,top,left", "--detail", "BOX", "--section-view", "x", "--section-view", "y", "--dimensions",
                        "overall", "--callouts", "--note", "PART=Item {item}\\n{part.name}", "--centre-lines", "auto", "--paper", "A3"]),
    ("front", True, ["--view", "front", "--callouts", "--dimensions", "overall", "--note", "LAST=R 1 to R 3", *SHEET]),
    ("small", False, ["--paper", "A5", "--callouts", "--dimensions", "overall", "--detail", "BOX", "--note", "LAST=Remove burrs"]),
    ("steps", True, ["--explode", "auto", "--views", "iso,front", "--callouts", "--arrows", "steps", "--note", "PART=First", *SHEET]),
    ("back", False, ["--view", "back", "--paper", "A4p", "--callouts", "--dimensions", "overall", "--note", "PART=Paint", *SHEET]),
]


def views_of(burin, file):
    told = subprocess.run([burin, "info", str(file), "--json"], capture_output=True, text=True, timeout=300)
    if told.returncode:
        return []
    one = json.loads(told.stdout)["files"][0]
    low, high = one["bounds"]["min"], one["bounds"]["max"]
    radius = 0.12 * max(b - a for a, b in zip(low, high))
    corner = ",".join(f"{v:.6g}" for v in (low[0], low[1], high[2]))
    parts = [p["name"] for p in one.get("parts", [])]
    names = {"BOX": f"{corner},{radius:.6g}", "PART": "*", "LAST": "*"}
    for word, name in (("PART", parts[0]), ("LAST", parts[-1])) if parts else ():
        if all(c.isalnum() or c in " _-" for c in name):  # others may mean something in a selector
            names[word] = name
    several = len(parts) > 1
    out = []
    for name, assembly, options in VIEWS:
        words = list(options)
        for word, stands_for in names.items():
            words = [w.replace(word, stands_for) for w in words]
        if several or not assembly:
            out.append((file, name, words))
    return out


def draw(job):
    burin, judge, folder, number, (file, name, words) = job
    drawing = folder / f"{number:03}-{file.stem}-{name}.json"
    try:
        done = subprocess.run([burin, "draw", str(file), *words, "-o", str(drawing), "--style", "outline"], capture_output=True,
                              text=True, timeout=300)
        if done.returncode:
            return f"# {drawing.stem}: status {done.returncode} " + "".join(done.stderr.strip().splitlines()[-1:])
        return subprocess.run([judge, str(drawing)], capture_output=True, text=True, check=True).stdout.strip()
    except subprocess.TimeoutExpired:
        return f"# {drawing.stem}: more than 300 s"


def main(words):
    files, jobs, most, all_told = [], 1, 200, False
    words = iter(words)
    burin, judge, folder = next(words), next(words), pathlib.Path(next(words))
    for word in words:
        if word == "--jobs":
            jobs = int(next(words))
        elif word == "--views":
            most = int(next(words))
        elif word == "--all":
            all_told = True
        else:
            files.append(pathlib.Path(word))
    folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        each = list(pool.map(lambda f: views_of(burin, f), files))
        # The first view of all files, then the second ...
        views = [v[k] for k in range(len(VIEWS)) for v in each if k < len(v)][:most]
        sums, count = dict.fromkeys(NAMES, 0), 0
        with_labels = with_any = 0
        for told in pool.map(draw, [(burin, judge, folder, i, v) for i, v in enumerate(views)]):
            row, *lines = told.split("\n")
            if row.startswith("#"):
                print(row, flush=True)
                continue
            name, rest = row.split("\t", 1)
            print(pathlib.Path(name).stem, rest, sep="\t", flush=True)
            numbers = [int(n) for n in row.split("\t")[1:]]
            count += 1
            with_labels += any(numbers[2:5])
            with_any += any(numbers[2:])
            for name, number in zip(NAMES, numbers):
                sums[name] += number
            for line in lines:
                if all_told or any(w in line for w in ("overlaps", " lies on ", "off the sheet")):
                    print("   ", line)
    print(f"# {count} views: " + ", ".join(f"{name} {number}" for name, number in sums.items()) +
          f"; views with labels that meet {with_labels}, with anything {with_any}")


if __name__ == "__main__":
    main(sys.argv[1:])
