#!/usr/bin/env python3
"""Draws damaged copies of good files with the release binary and tells which of them the command did not meet well.

    tests/fuzz/mutate.py --seconds 600 --seed 7 samples/*.stl samples/*.step
    tests/fuzz/mutate.py --again 7:1234 FILES...      writes that mutant again (the same list of files) and its command

A mutant is met well when the command ends by itself within 10 s of processor time and 1 GB, with status 0 and a drawing
or with status 3 and one line that says why. Everything else is an offence, and the file is kept (--keep). Mutant N of a
seed depends on the seed, N and the list of files alone."""
import argparse
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CPU_SECONDS, MEGABYTES = 10, 1024
WORDS = (b"0", b"-1", b"-0.0", b"1e308", b"1e30", b"-1e12", b"1e-300", b"nan", b"inf", b"999999999", b"4294967295",
         b"2147483647", b"0.1", b"1e5")
SPANS = (b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f", b"\0\0\xc0\x7f", b"\0\0\x80\x7f", b"\xff\xff\x7f\x7f",
         b"\x01\0\0\0", b"\0\0\0\x80")
NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][+-]?\d+)?")


def number_near(data, at, dice):
    begin = max(0, at - 200)
    found = list(NUMBER.finditer(bytes(data[begin:at + 200])))
    if not found:
        return None
    match = dice.choice(found)
    return begin + match.start(), begin + match.end()


def mutate(data, dice):
    data = bytearray(data)
    for _ in range(dice.choice((1, 1, 2, 4, 16))):
        if not data:
            break
        at = dice.randrange(len(data))
        kind = dice.randrange(9)
        if kind == 0:
            data[at] = dice.randrange(256)
        elif kind == 1:
            data[at] ^= 1 << dice.randrange(8)
        elif kind == 2:
            del data[at:at + dice.choice((1, 4, 64, 1024))]
        elif kind == 3:
            data[at:at] = data[at:at + dice.choice((1, 4, 64, 512))]
        elif kind == 4:
            if dice.randrange(4) == 0:
                del data[at:]
        elif kind == 5:
            data[at:at + 4] = dice.choice(SPANS)
        elif kind == 6:  # a line, or a chunk where there are no lines, elsewhere
            end = data.find(b"\n", at)
            chunk = data[at:end if 0 <= end < at + 400 else at + 100]
            to = dice.randrange(len(data))
            data[to:to] = chunk
        else:
            span = number_near(data, at, dice)
            if span and kind == 7:
                data[span[0]:span[1]] = dice.choice(WORDS)
            elif span:  # another number of the file in its place
                other = number_near(data, dice.randrange(len(data)), dice)
                if other:
                    data[span[0]:span[1]] = data[other[0]:other[1]]
    return bytes(data)


def mutant(files, seed, number):
    dice = random.Random(f"{seed}:{number}")
    file = dice.choice(files)
    return file, mutate(pathlib.Path(file).read_bytes(), dice)


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (2 * CPU_SECONDS, 2 * CPU_SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def draw(command, folder):
    """status (a signal is negative), processor seconds, megabytes, standard error"""
    errors = folder / "errors"
    with open(errors, "wb") as stream:
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=stream, preexec_fn=limits)
        deadline = time.monotonic() + 900  # a child that waits for ever uses no processor time
        while True:
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > deadline:
                child.kill()
            time.sleep(0.005)
    child.returncode = os.waitstatus_to_exitcode(status)
    return (child.returncode, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024,
            errors.read_text(errors="replace").strip())


def offence(status, seconds, megabytes, errors, out):
    if status < 0:
        return "signal " + signal.Signals(-status).name + f" after {seconds:.1f} s, {megabytes:.0f} MB"
    if seconds > CPU_SECONDS:
        return f"{seconds:.1f} s"
    if megabytes > MEGABYTES:
        return f"{megabytes:.0f} MB"
    if status == 0:
        return "" if out.exists() and out.stat().st_size > 0 else "status 0 without a drawing"
    if status != 3:
        return f"status {status}: {errors[-200:]}"
    return "" if errors and "\n" not in errors else f"status 3 with {len(errors.splitlines())} lines: {errors[:200]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--count", type=int, default=10**9)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first mutant")
    parser.add_argument("--style", default="technical")
    parser.add_argument("--again", metavar="SEED:N")
    parser.add_argument("--keep", default="build/mutants", help="folder for offenders")
    parser.add_argument("--burin", default=os.environ.get("BURIN", "build/release/bin/burin"))
    options = parser.parse_args()
    keep = pathlib.Path(options.keep)
    keep.mkdir(parents=True, exist_ok=True)
    files = sorted(options.files)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="burin-mutants-"))
    out = folder / "out.svg"

    def command(path):
        return [options.burin, "draw", str(path), "-o", str(out), "--style", options.style, "--quiet", "--threads", "1"]

    if options.again:
        seed, number = options.again.split(":")
        file, data = mutant(files, int(seed), int(number))
        path = keep / f"{seed}_{number}_{os.path.basename(file)}"
        path.write_bytes(data)
        print(" ".join(command(path)))
        return
    end = time.monotonic() + options.seconds
    statuses, bad, done, cpu, worst = {}, [], 0, 0.0, (0.0, 0.0)
    for number in range(options.first, options.first + options.count):
        if time.monotonic() > end:
            break
        file, data = mutant(files, options.seed, number)
        suffix = re.sub(r"^[^.]*", "", os.path.basename(file))
        path = folder / ("m" + suffix)
        path.write_bytes(data)
        status, seconds, megabytes, errors = draw(command(path), folder)
        why = offence(status, seconds, megabytes, errors, out)
        done += 1
        cpu += seconds
        worst = max(worst[0], seconds), max(worst[1], megabytes)
        statuses[status] = statuses.get(status, 0) + 1
        if why:
            name = f"{options.seed}_{number}_{os.path.basename(file)}"
            shutil.copy(path, keep / name)
            bad.append(name)
            print(f"  {name}: {why}", flush=True)
        out.unlink(missing_ok=True)
    shutil.rmtree(folder)
    table = ", ".join(f"{count} of status {status}" for status, count in sorted(statuses.items()))
    print(f"seed {options.seed}: {done} mutants ({table}), {len(bad)} offenders; {cpu:.0f} s of processor time, at most "
          f"{worst[0]:.1f} s and {worst[1]:.0f} MB")
    sys.exit(1 if bad else 0)


main()
