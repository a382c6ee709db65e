#!/usr/bin/env python3
"""Lets libFuzzer look for bytes that break what reads them: build/asan/bin/burin_fuzz, a target after the other.

    ./dev fuzz [SECONDS] [TARGET...]     60 seconds each; all targets
    ./dev fuzz --short [TARGET...]       as CI does: a fixed number of inputs, so that the same sources end the same

A target begins with its seeds (seeds.py) and what it came upon before (build/asan/fuzz/corpus). A finding is what is
neither read nor refused in one line of ours: a crash, a sanitizer's word, 25 seconds or 2 GB. It is left in
build/asan/fuzz/findings, and makes the status 1."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import seeds

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/asan/bin/burin_fuzz"
PLACE = ROOT / "build/asan/fuzz"
SHORT_RUNS, SHORT_SECONDS = 1500, 6
# By the clock and with the sanitizers; mutate.py, which draws with the release build, bounds the processor time.
ONE_INPUT_SECONDS, ONE_INPUT_MEGABYTES = 25, 2048


def environment(target):
    """That of tests/sanitizers/environment.sh, which ./dev fuzz has read; freed memory is kept back for less long."""
    asan = os.environ["ASAN_OPTIONS"] + ":quarantine_size_mb=64"
    return dict(os.environ, BURIN_FUZZ=target, ASAN_OPTIONS=asan)


def run(target, limits, keep, data):
    """Whether nothing was found."""
    initial, corpus = PLACE / "seeds" / target, PLACE / "corpus" / target
    shutil.rmtree(initial, ignore_errors=True)
    for folder in (initial, corpus, PLACE / "findings", PLACE / "log"):
        folder.mkdir(parents=True, exist_ok=True)
    count = seeds.fill(target, initial, data)
    folders = [str(corpus), str(initial)] if keep else [str(initial)]
    log = PLACE / "log" / target
    words = [str(PROGRAM), *limits, f"-timeout={ONE_INPUT_SECONDS}", f"-rss_limit_mb={ONE_INPUT_MEGABYTES}",
             f"-max_len={seeds.LARGEST}", "-seed=1", "-print_final_stats=1",
             f"-artifact_prefix={PLACE}/findings/{target}-", *folders]
    with open(log, "wb") as stream:
        status = subprocess.run(words, stdout=stream, stderr=subprocess.STDOUT, env=environment(target)).returncode
    text = log.read_text(errors="replace")
    runs = re.findall(r"number_of_executed_units: *(\d+)", text)
    covered = re.findall(r"cov: (\d+)", text)
    print(f"{target:15} {count:3} seeds {runs[-1] if runs else '?':>8} inputs {covered[-1] if covered else '?':>6} "
          f"branches{'' if status == 0 else '  FOUND'}", flush=True)
    if status != 0:
        print(*text.splitlines()[-45:], sep="\n    ", flush=True)
        again = re.findall(r"Test unit written to (\S+)", text)
        if again:
            print(f"again: BURIN_FUZZ={target} build/asan/bin/burin_fuzz {again[-1]}", flush=True)
    return status == 0


def main():
    words = sys.argv[1:]
    short = "--short" in words
    words = [word for word in words if word != "--short"]
    seconds = int(words.pop(0)) if words and words[0].isdigit() else 60
    limits = ([f"-runs={SHORT_RUNS}", f"-max_total_time={SHORT_SECONDS}"] if short else [f"-max_total_time={seconds}"])
    listed = subprocess.run([PROGRAM], env=environment("list"), capture_output=True, text=True, check=True)
    known = listed.stdout.split()
    for word in words:
        if word not in known:
            sys.exit(f"fuzz: error: no target is called {word}; there are {', '.join(known)}")
    cache = (ROOT / "build/asan/CMakeCache.txt").read_text()
    data = pathlib.Path(re.search(r"^BURIN_TEST_DATA:PATH=(.*)$", cache, re.M).group(1))
    failed = [target for target in words or known if not run(target, limits, not short, data)]
    if failed:
        sys.exit(f"fuzz: found something: {', '.join(failed)}; see build/asan/fuzz/log")


main()
