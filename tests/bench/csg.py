#!/usr/bin/env python3
"""OpenSCAD's programs by OpenSCAD and by the own evaluator, side by side.

usage: csg.py [--build DIR] [--only REGEX] [--keep FILE.json] [--over SECONDS] [FILE|DIR ...]

Each .scad or .csg is rendered by `openscad -o .off`, and evaluated by `openscad -o .csg` and the program burin-csg.
Prints a table of those that took OpenSCAD over SECONDS (2), what differs by more than 1e-5 in volume, what is lost or
slower, and medians and sums. CPU seconds of whole processes, one at a time. --keep goes on where it was stopped.
Without paths: the examples of the package openscad, those of openscad-testing-data, ../shared/data/scad.
"""
import argparse
import json
import math
import os
import pathlib
import re
import statistics
import struct
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEFAULTS = ["/usr/share/openscad/examples", "/usr/share/openscad/testdata/scad/3D", "/usr/share/openscad/testdata/scad/bugs",
            "/usr/share/openscad/testdata/scad/issues", ROOT.parent / "shared/data/scad"]
LIMIT = 300  # seconds a program


def run(words, folder, file=None):
    """CPU seconds, MB and exit status of a program; None where the limit ends it."""
    inherit = {} if file is None else {"pass_fds": [3], "preexec_fn": None}
    log = tempfile.TemporaryFile()
    saved = None
    if file is not None and file != 3:
        saved = os.dup(3) if os.path.exists("/proc/self/fd/3") else -1
        os.dup2(file, 3)
    try:
        child = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log, **inherit)
    finally:
        if saved is not None:
            os.dup2(saved, 3) if saved >= 0 else os.close(3)
    end = time.monotonic() + LIMIT
    while True:
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() > end:
            child.kill()
            os.wait4(child.pid, 0)
            return None
        time.sleep(0.005)
    child.returncode = os.waitstatus_to_exitcode(status)
    log.seek(0)
    return {"cpu": usage.ru_utime + usage.ru_stime, "mb": usage.ru_maxrss / 1024, "status": child.returncode,
            "log": log.read().decode(errors="replace")}


def volume_of(points, triangles):
    total = 0
    for a, b, c in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
        total += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)
    return total / 6


def openscad_volume(path):
    words = iter(path.read_text().split())
    head = next(words)
    count = int(next(words) if head == "OFF" else head[3:])
    faces = int(next(words))
    next(words)
    points = [tuple(float(next(words)) for _ in range(3)) for _ in range(count)]
    triangles = []
    for _ in range(faces):
        c = [int(next(words)) for _ in range(int(next(words)))]
        triangles += [(c[0], c[k], c[k + 1]) for k in range(1, len(c) - 1)]
    return volume_of(points, triangles)


def own_result(data):
    """Volume of what burin-csg writes, its corners rounded to the six digits that OpenSCAD writes; triangles, open edges."""
    at = 16
    solids = struct.unpack_from("<Q", data, 8)[0]
    total, count, balance = 0, 0, {}
    for _ in range(solids):
        parts = []
        for size in (24, 12, 4, 128):  # positions, triangles, their surfaces, surfaces
            n = struct.unpack_from("<Q", data, at)[0]
            parts.append(data[at + 8:at + 8 + n * size])
            at += 8 + n * size
        points = [tuple(float("%.6g" % v) for v in p) for p in struct.iter_unpack("<3d", parts[0])]
        triangles = list(struct.iter_unpack("<3I", parts[1]))
        count += len(triangles)
        total += volume_of(points, triangles)
        for t in triangles:
            for k in range(3):
                a, b = t[k], t[(k + 1) % 3]
                balance[min(a, b), max(a, b)] = balance.get((min(a, b), max(a, b)), 0) + (1 if a < b else -1)
    return total, count, sum(1 for v in balance.values() if v)


def measure(path, program, scratch):
    out = {"name": path.stem}
    tree, off = scratch / "tree.csg", scratch / "solid.off"
    for f in (tree, off):
        f.unlink(missing_ok=True)
    folder = path.parent
    theirs = run(["openscad", "-o", str(off), str(path)], folder)
    if theirs and theirs["status"] == 0 and off.exists():
        out["theirs"] = {"cpu": theirs["cpu"], "mb": theirs["mb"], "volume": openscad_volume(off)}
    elif not theirs:
        out["theirs"] = {"cpu": LIMIT, "mb": 0, "volume": None}
    first = run(["openscad", "-o", str(tree), str(path)], folder)
    if not first or not tree.exists():
        return out
    memory = os.memfd_create("tree")
    os.write(memory, tree.read_bytes()) if tree.stat().st_size < 1 << 30 else None
    ours = run([str(program), "0"], folder, memory)
    if ours and ours["status"] == 0:
        os.lseek(memory, 0, os.SEEK_SET)
        with os.fdopen(memory, "rb") as f:
            volume, triangles, opened = own_result(f.read())
        out["ours"] = {"cpu": ours["cpu"], "tree": first["cpu"], "mb": max(ours["mb"], 0), "volume": volume,
                       "triangles": triangles, "open": opened}
    else:
        os.close(memory)
        out["error"] = ours["log"].strip().splitlines()[-1] if ours and ours["log"].strip() else "stopped"
    return out


def report(rows, over):
    slow = []
    print("| program | OpenSCAD s | MB | tree s | own s | MB | gain | volume differs |\n|---|---|---|---|---|---|---|---|")
    for r in sorted(rows, key=lambda r: -r.get("theirs", {}).get("cpu", 0)):
        t, o = r.get("theirs"), r.get("ours")
        if not t or not o or t["cpu"] < over:
            continue
        gain = t["cpu"] / (o["cpu"] + o["tree"])
        slow.append((gain, t["cpu"], o["cpu"] + o["tree"]))
        apart = "" if t["volume"] is None else "%.0e" % (abs(o["volume"] - t["volume"]) / max(abs(t["volume"]), 1e-9))
        print(f"| {r['name']} | {t['cpu']:.1f} | {t['mb']:.0f} | {o['tree']:.2f} | {o['cpu']:.2f} | {o['mb']:.0f} | {gain:.0f} | {apart} |")
    if slow:
        print(f"\n{len(slow)} over {over} s: gain {statistics.median(g for g, _, _ in slow):.1f} in the median, "
              f"{sum(t for _, t, _ in slow) / sum(o for _, _, o in slow):.1f} in sum, {min(slow)[0]:.1f} at least")
    both = [r for r in rows if r.get("theirs") and r.get("ours")]
    print(f"{len(rows)} programs, {sum(1 for r in rows if r.get('theirs'))} rendered by OpenSCAD as solids, {len(both)} by both")
    print(f"sum of all that both render: {sum(r['theirs']['cpu'] for r in both):.0f} s and "
          f"{sum(r['ours']['cpu'] + r['ours']['tree'] for r in both):.0f} s; most memory "
          f"{max((r['ours']['mb'] for r in both), default=0):.0f} MB")
    for r in rows:
        t, o = r.get("theirs"), r.get("ours")
        if t and not o:
            print("lost:", r["name"], r.get("error", ""))
        elif o and o["open"]:
            print("open:", r["name"], o["open"])
        elif t and o and t["volume"] is not None and not math.isclose(t["volume"], o["volume"], rel_tol=1e-5, abs_tol=1e-12):
            print("volume:", r["name"], t["volume"], o["volume"])
        if t and o and o["cpu"] + o["tree"] > t["cpu"] + 0.05:
            print("slower:", r["name"], t["cpu"], o["cpu"] + o["tree"])
        if not t and r.get("error"):
            print("refused by both:", r["name"], r["error"])


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--build", default=ROOT / "build/release")
    parser.add_argument("--only", default="")
    parser.add_argument("--keep")
    parser.add_argument("--over", type=float, default=2)
    parser.add_argument("paths", nargs="*", default=[p for p in DEFAULTS if os.path.exists(p)])
    words = parser.parse_args()
    files = []
    for p in map(pathlib.Path, words.paths):
        files += sorted(q for q in p.rglob("*") if q.suffix in (".scad", ".csg")) if p.is_dir() else [p]
    keep = pathlib.Path(words.keep) if words.keep else None
    known = json.loads(keep.read_text()) if keep and keep.exists() else {}
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for f in files:
            if not re.search(words.only, str(f)):
                continue
            if str(f) not in known:
                known[str(f)] = measure(f, pathlib.Path(words.build) / "lib/burin/burin-csg", pathlib.Path(scratch))
                if keep:
                    keep.write_text(json.dumps(known, indent=1))
            rows.append(known[str(f)])
    report(rows, words.over)


if __name__ == "__main__":
    main()
