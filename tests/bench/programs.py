#!/usr/bin/env python3
"""What drawing OpenSCAD programs takes, and which part of it: a row a program, the longest first.

usage: programs.py [--burin FILE] [--only REGEX] [--limit SECONDS] [--over SECONDS] [--keep FILE.json] [FILE|DIR ...]

Each .scad and .csg is drawn by `burin draw --style outline` from its default view, one at a time. Processor seconds (user and
system, of the command and of the programs that it starts): of OpenSCAD up to the tree, of the rest of reading (which is the
cutting), of building, and of all that follows. Since other work on the machine stretches clocks but not these, they can be
compared; --limit (40) ends a program, --over (1) is what the table shows. --keep goes on where it was stopped.
Without paths: all programs of Debian's packages openscad, openscad-mcad and openscad-testing-data, and ../shared/data/scad.
"""
import argparse
import json
import os
import pathlib
import re
import selectors
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEFAULTS = ["/usr/share/openscad", ROOT.parent / "shared/data/scad", ROOT.parents[1] / "shared/data/scad"]
TICKS = os.sysconf("SC_CLK_TCK")
STAGES = ("read", "build")


def processor(pid):
    """Seconds of a process and of all below it: what has ended and was waited for, and what runs."""
    try:
        words = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        below = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        others = [t.name for t in pathlib.Path(f"/proc/{pid}/task").iterdir() if t.name != str(pid)]
        for thread in others:
            below += pathlib.Path(f"/proc/{pid}/task/{thread}/children").read_text().split()
    except OSError:
        return 0.0
    return sum(map(int, words[11:15])) / TICKS + sum(processor(child) for child in below)


class Watch:
    """Deals the processor seconds of a command to the stages that its progress names."""

    def __init__(self, pid):
        self.pid, self.stage, self.seconds, self.seen, self.said = pid, "read", {}, 0.0, []

    def look(self):
        now = processor(self.pid)
        self.seconds[self.stage] = self.seconds.get(self.stage, 0.0) + max(0.0, now - self.seen)
        self.seen = max(self.seen, now)

    def take(self, line):
        words = line.split()
        if words[:2] != ["burin:", "progress"]:
            self.said.append(line)
        elif words[2] != self.stage:
            self.look()
            self.stage = words[2]


def follow(child, limit):
    watch, rest, end = Watch(child.pid), b"", False
    with selectors.DefaultSelector() as ready:
        ready.register(child.stderr, selectors.EVENT_READ)
        while not end:
            if not ready.select(0.2):
                watch.look()
                if watch.seen > limit:
                    child.terminate()
                    child.wait()
                    return watch, None
                continue
            data = os.read(child.stderr.fileno(), 65536)
            end = not data
            *lines, rest = (rest + data).split(b"\n")
            for line in lines:
                watch.take(line.decode(errors="replace"))
    watch.look()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    total = usage.ru_utime + usage.ru_stime
    watch.seconds[watch.stage] = watch.seconds.get(watch.stage, 0.0) + max(0.0, total - watch.seen)
    return watch, usage


def tree_seconds(path, scratch, limit):
    before = os.times()
    try:
        subprocess.run(["openscad", "-o", str(scratch / "tree.csg"), str(path)], cwd=path.parent, stdin=subprocess.DEVNULL,
                       capture_output=True, timeout=10 * limit)
    except subprocess.TimeoutExpired:
        pass
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def measure(path, burin, scratch, limit):
    words = [burin, "draw", str(path), "-o", str(scratch / "a.svg"), "--style", "outline", "--progress"]
    with subprocess.Popen(words, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE) as child:
        watch, usage = follow(child, limit)
    tree = tree_seconds(path, scratch, limit) if path.suffix == ".scad" else 0.0
    read, build = (watch.seconds.get(stage, 0.0) for stage in STAGES)
    rest = sum(s for stage, s in watch.seconds.items() if stage not in STAGES)
    errors = [line for line in watch.said if line.startswith("burin: error")]
    return {"tree": tree, "read": max(0.0, read - tree), "build": build, "draw": rest, "total": read + build + rest,
            "mb": usage.ru_maxrss / 1024 if usage else 0, "ended": usage is None, "status": child.returncode,
            "said": errors[0] if errors else ""}


def report(rows, over):
    print("| program | OpenSCAD s | rest of reading s | building s | drawing s | all s | MB |\n|---|---|---|---|---|---|---|")
    for name, r in sorted(rows.items(), key=lambda row: -row[1]["total"]):
        if r["total"] >= over or r["ended"]:
            total = ("over " if r["ended"] else "") + f"{r['total']:.1f}"
            print(f"| {name} | {r['tree']:.2f} | {r['read']:.1f} | {r['build']:.1f} | {r['draw']:.1f} | {total} | {r['mb']:.0f} |")
    drawn = [r for r in rows.values() if r["status"] == 0 and not r["ended"]]
    print(f"\n{len(rows)} programs, {len(drawn)} drawn, {sum(r['ended'] for r in rows.values())} ended by the limit, "
          f"{sum(r['total'] > 10 for r in rows.values())} over 10 s, {sum(r['total'] for r in rows.values()):.0f} s in all")


def programs(paths):
    for path in map(pathlib.Path, paths):
        if path.is_dir():
            yield from sorted(q for q in path.rglob("*") if q.suffix in (".scad", ".csg") and q.is_file())
        else:
            yield path


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--burin", default=str(ROOT / "build/release/bin/burin"))
    parser.add_argument("--only", default="")
    parser.add_argument("--limit", type=float, default=40)
    parser.add_argument("--over", type=float, default=1)
    parser.add_argument("--keep")
    parser.add_argument("paths", nargs="*", default=[p for p in DEFAULTS if os.path.exists(p)])
    words = parser.parse_args()
    keep = pathlib.Path(words.keep) if words.keep else None
    rows = json.loads(keep.read_text()) if keep and keep.exists() else {}
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        for path in programs(words.paths):
            if not re.search(words.only, str(path)) or str(path) in rows:
                continue
            rows[str(path)] = measure(path.resolve(), words.burin, pathlib.Path(scratch), words.limit)
            if keep:
                keep.write_text(json.dumps(rows, indent=1))
    report(rows, words.over)
    print(f"{time.monotonic() - start:.0f} s by the clock")


if __name__ == "__main__":
    main()
