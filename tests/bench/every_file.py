#!/usr/bin/env python3
"""Draws every file of a folder from three views in three styles, and writes what each of them cost and said as one table.

usage: every_file.py BURIN FOLDER TABLE.md [NAME_PART...]

A row a file: the most processor seconds and the most memory (MB) of its three views, a style each; then the codes of all
diagnostics with the number of drawings that carry them, or the error. Processor time is user and system time of the whole
command, so that other work on the machine counts little. What is over the limits (outline 3 s of two cores and 500 MB,
engraving 10 s and 1000 MB) stands in bold. Volumes are drawn at the level that `burin info` suggests; raw bytes, which do
not tell their shape, are left out. A drawing of status 0 without any line counts as an error, unless the file is in the
folder of broken ones.
"""
import collections
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

VIEWS = ("iso", "-0.4,-1,0.55", "0.3,-1,0.45")
STYLES = ("outline", "technical", "engraving")
CORES = 2
LIMITS = {"outline": (3.0, 500.0), "technical": (10.0, 1000.0), "engraving": (10.0, 1000.0)}
PATIENCE = 120.0
SUFFIXES = (".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .irt .scad .csg .fcstd .nrrd .mha .mhd "
            ".nii .nii.gz .inr .vti .implicit").split()


def known(name):
    return any(name.lower().endswith(suffix) for suffix in SUFFIXES)


def run(command):
    """Ends with (status, processor seconds, wall seconds, peak MB, standard error)."""
    with tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=errors,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (12 << 30, 12 << 30)))
        status = usage = None
        while status is None:
            pid, code, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                status = os.waitstatus_to_exitcode(code)
            elif time.monotonic() - start > PATIENCE:
                child.kill()
                _, _, usage = os.wait4(child.pid, 0)
                status = "over %d s" % PATIENCE
            else:
                time.sleep(0.005)
        child.returncode = 0
        errors.seek(0)
        text = errors.read().decode(errors="replace")
    return status, usage.ru_utime + usage.ru_stime, time.monotonic() - start, usage.ru_maxrss / 1024, text


def options(burin, path):
    """What a file needs beside its name: the level of a volume."""
    if path.endswith((".scad", ".csg")):
        return []  # asking takes as long as drawing
    told = subprocess.run([burin, "info", path, "--json"], capture_output=True, text=True, timeout=PATIENCE)
    try:
        volume = json.loads(told.stdout)["files"][0].get("volume")  # of a mesh, its mm^3
    except (json.JSONDecodeError, LookupError):
        volume = None
    level = volume.get("level") if isinstance(volume, dict) else None
    return ["--iso", str(level)] if level is not None else []


def lines_of(drawing):
    return sum(len(layer["paths"]) for layer in drawing["layers"])


def row(burin, folder, path, scratch):
    name = os.path.relpath(path, folder)
    broken = name.startswith("broken")
    out = os.path.join(scratch, "out.json")
    costs, said, failed = {}, collections.Counter(), collections.Counter()
    extra = options(burin, path)
    for style in STYLES:
        worst = (0.0, 0.0)
        for view in VIEWS:
            command = [burin, "draw", path, "-o", out, "--style", style, "--view=" + view, "--threads", str(CORES), "--quiet",
                       "--set", "json.points3=false"] + extra
            status, cpu, _, peak, errors = run(command)
            worst = (max(worst[0], cpu), max(worst[1], peak))
            if status != 0:
                last = errors.strip().splitlines()[-1] if errors.strip() else "no word"
                failed["status %s: %s" % (status, last.replace(path, "FILE"))] += 1
                continue
            with open(out, encoding="utf-8") as file:
                drawing = json.load(file)
            os.remove(out)
            for code in {entry["code"] for entry in drawing["diagnostics"]}:
                said[code] += 1
            if not lines_of(drawing):
                failed["empty drawing"] += 1
        costs[style] = worst
    over = any(cost[0] > LIMITS[style][0] * CORES or cost[1] > LIMITS[style][1] for style, cost in costs.items())
    cells = [name.replace("|", "\\|")]
    for style in STYLES:
        seconds, memory = costs[style]
        limit = LIMITS[style]
        cells.append(("**%.2f**" if seconds > limit[0] * CORES else "%.2f") % seconds)
        cells.append(("**%.0f**" if memory > limit[1] else "%.0f") % memory)
    words = ["%s (%d)" % pair for pair in sorted(failed.items())] + ["%s (%d)" % pair for pair in sorted(said.items())]
    cells.append("; ".join(words).replace("|", "\\|"))
    return "| " + " | ".join(cells) + " |", bool(failed) and not broken, over


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    burin, folder, table, wanted = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3], sys.argv[4:]
    paths = sorted(os.path.join(base, name) for base, _, names in os.walk(folder) for name in names if known(name))
    paths = [path for path in paths if not wanted or any(part in path for part in wanted)]
    failed, over = [], []
    with tempfile.TemporaryDirectory() as scratch, open(table, "w", encoding="utf-8") as out:
        heads = ["file"] + [head for style in STYLES for head in (style + " s", "MB")] + ["said (drawings of 9)"]
        out.write("| " + " | ".join(heads) + " |\n|" + "---|" * len(heads) + "\n")
        for path in paths:
            text, bad, heavy = row(burin, folder, path, scratch)
            out.write(text + "\n")
            out.flush()
            if bad:
                failed.append(os.path.relpath(path, folder))
            if heavy:
                over.append(os.path.relpath(path, folder))
    print("%d files, %d with an error or an empty drawing, %d over a limit" % (len(paths), len(failed), len(over)))
    for title, names in (("failed", failed), ("over a limit", over)):
        for name in names:
            print("%s: %s" % (title, name))
    sys.exit(bool(failed or over))


main()
