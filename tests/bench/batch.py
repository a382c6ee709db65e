#!/usr/bin/python3
"""What `burin batch run` costs beside the drawings, and how much faster two at once are than one.

usage: batch.py BURIN [--rounds 3] [--only costs|speed] [FILE|FOLDER ...]

First 50 and 250 boxes in `outline`: what a job more takes by the clock, drawn by `burin batch job` alone (a process each, nothing
beside it), by `run --jobs 1`, and by one worker of Dask. What lies between is the cost of the batch; starting is not in it.
Then the files (samples, where none are given) in three views of `technical`: one process, two, a worker of Dask, two of them; seconds
and ratios. Medians of all rounds, which go through all ways in turn. Needs python3-distributed, and a machine that does nothing else.
"""
import argparse
import contextlib
import json
import pathlib
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .implicit".split()
ROOT = pathlib.Path(__file__).resolve().parents[2]
FEW, MANY = 50, 250


def box(k):
    corners = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
    lines = [f"{(10 + k) * a} {20 * b} {30 * c}" for a, b, c in corners]
    faces = ["0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5"]
    return "OFF\n8 6 0\n" + "\n".join(lines + [f"4 {face}" for face in faces]) + "\n"


@contextlib.contextmanager
def dask(workers, folder):
    """A scheduler with so many workers of one thread; its address."""
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        port = s.getsockname()[1]
    started = []

    def start(name, *words):
        words = [sys.executable, shutil.which(name), *map(str, words)]
        started.append(subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))

    try:
        start("dask-scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard")
        for k in range(workers):
            start("dask-worker", f"tcp://127.0.0.1:{port}", "--nthreads", 1, "--no-nanny", "--no-dashboard", "--memory-limit", 0,
                  "--local-directory", folder / "dask", "--name", k)
        from distributed import Client
        client = Client(f"tcp://127.0.0.1:{port}", timeout=60, set_as_default=False)
        client.wait_for_workers(workers)
        client.close()
        yield f"dask://127.0.0.1:{port}"
    finally:
        for process in reversed(started):
            process.terminate()
            process.wait()


class Catalogue:
    def __init__(self, burin, folder, text):
        self.burin, self.folder = burin, folder
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "catalogue.toml").write_text(text)
        self.batch("plan", "catalogue.toml", "-o", "jobs.jsonl")

    def batch(self, *words):
        return subprocess.run([self.burin, "batch", *words], cwd=self.folder, capture_output=True, text=True)

    def timed(self, *words):
        """Seconds of a run of all of it."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        begin = time.monotonic()
        run = self.batch("run", "jobs.jsonl", "--quiet", *words)
        seconds = time.monotonic() - begin
        if run.returncode not in (0, 1):
            raise SystemExit(f"batch: {run.stderr}")
        return seconds

    def alone(self):
        """Seconds of its drawings by the command alone, a process a part."""
        out = self.folder / "alone"
        out.mkdir(exist_ok=True)
        jobs = [json.loads(line) for line in (self.folder / "jobs.jsonl").read_text().splitlines()[1:]]
        requests = []
        for job in jobs:
            drawings = [{"options": d["options"], "outputs": [str(out / f"{k}.svg")], "lists": []} for k, d in enumerate(job["drawings"])]
            requests.append(json.dumps({"inputs": job["inputs"], "threads": 1, "drawings": drawings}).encode())
        begin = time.monotonic()
        for request in requests:
            subprocess.run([self.burin, "batch", "job"], cwd=self.folder, input=request, stdout=subprocess.DEVNULL, check=True)
        return time.monotonic() - begin


def costs(burin, folder, rounds):
    both = []
    for count in (FEW, MANY):
        where = folder / str(count)
        (where / "parts").mkdir(parents=True)
        for k in range(count):
            (where / f"parts/{k}.off").write_text(box(k))
        both.append(Catalogue(burin, where, '[[parts]]\nfiles = ["parts/*"]\nstyles = ["outline"]\n'))
    found = {"burin batch job": [], "run --jobs 1": [], "Dask, 1 worker": []}
    for _ in range(rounds):
        with dask(1, folder) as address:
            for name, way in zip(found, (Catalogue.alone, lambda c: c.timed("--jobs", "1"), lambda c: c.timed("--on", address))):
                few, many = (way(c) for c in both)
                found[name].append(1000 * (many - few) / (MANY - FEW))
    base = None
    print("a job more by the clock, ms")
    for name, values in found.items():
        value = statistics.median(values)
        base = value if base is None else base
        print(f"  {name:18} {value:7.2f}   beyond the drawing {value - base:6.2f}   ({' '.join(f'{v:.1f}' for v in values)})")


def speed(burin, folder, files, rounds):
    names = ", ".join(json.dumps(str(f)) for f in files)
    catalogue = Catalogue(burin, folder / "real", f'views = ["front", "right", "iso"]\noutputs = ["{{name}}-{{suffix}}-{{view}}.svg"]\n[[parts]]\nfiles = [{names}]\n')
    found = {"--jobs 1": [], "--jobs 2": [], "Dask, 1 worker": [], "Dask, 2 workers": []}
    for _ in range(rounds):
        for count in (1, 2):
            found[f"--jobs {count}"].append(catalogue.timed("--jobs", str(count)))
        for count, name in ((1, "Dask, 1 worker"), (2, "Dask, 2 workers")):
            with dask(count, folder) as address:
                found[name].append(catalogue.timed("--on", address))
    print(f"{len(files)} parts in three views, s")
    one = statistics.median(found["--jobs 1"])
    for name, values in found.items():
        value = statistics.median(values)
        print(f"  {name:18} {value:7.2f}   {one / value:5.2f} times --jobs 1   ({' '.join(f'{v:.1f}' for v in values)})")


def main():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False)
    parser.add_argument("burin")
    parser.add_argument("files", nargs="*")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", choices=("costs", "speed"))
    given = parser.parse_intermixed_args()
    burin = str(pathlib.Path(given.burin).resolve())
    paths = [pathlib.Path(f).resolve() for f in given.files] or [ROOT / "samples"]
    files = sorted(f for p in paths for f in (p.rglob("*") if p.is_dir() else [p]) if f.suffix.lower() in SUFFIXES)
    with tempfile.TemporaryDirectory() as scratch:
        if given.only != "speed":
            costs(burin, pathlib.Path(scratch), given.rounds)
        if given.only != "costs":
            speed(burin, pathlib.Path(scratch), files, given.rounds)


main()
