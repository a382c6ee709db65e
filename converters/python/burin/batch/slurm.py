"""Jobs as a job array of Slurm: each task is a shard, which goes on where it stopped when it is started anew."""

import re
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Any

from .errors import FAILED, NO_OUTPUT, USAGE, BatchError
from .jobs import Batch
from .limits import seconds
from .settings import command_of, settings_of
from .state import FOLDER, State

# Seconds that a task takes at the least: scheduling it costs one.
_LEAST = 60.0
# What Slurm allows where nothing else is set.
_LARGEST_ARRAY = 1001


def submit(arguments: Any, batch: Batch) -> int:
    """Writes the script, and submits it. Throws BatchError where Slurm refuses it."""
    settings = settings_of(arguments, batch)
    if not batch.jobs:
        raise BatchError(f"{arguments.jobs_file}: has no jobs")
    tasks = arguments.tasks if arguments.tasks is not None else tasks_for(batch, seconds(arguments.each, "option --each"))
    if tasks < 1:
        raise BatchError(f"option --tasks takes a number from 1, not {tasks}", USAGE)
    words = [command_of(None), "batch", *(["--burin", settings.command] if arguments.burin else [])]
    words += ["run", str(arguments.jobs_file.resolve()), "--quiet", "--timeout", f"{settings.timeout:g}"]
    words += ["--threads", str(settings.threads)]
    if settings.memory:
        words += ["--memory", str(settings.memory)]
    if settings.again:
        words.append("--again")
    script = arguments.script or batch.out / FOLDER / "slurm.sh"
    _write(script, script_of(words, tasks))
    folder = script.resolve().parent
    order = ["sbatch", "--parsable", "--job-name=burin-batch", f"--array=1-{tasks}", "--requeue", "--open-mode=append"]
    order += [f"--chdir={folder}", "--output=slurm-%A_%a.log", *arguments.sbatch]
    if arguments.wait:
        order.append("--wait")
    if arguments.script:
        print(shlex.join([*order, str(script)]))
        return 0
    if not shutil.which("sbatch"):
        raise BatchError("burin batch slurm needs sbatch; install the package slurm-client, or run it on a machine of the cluster", FAILED)
    with subprocess.Popen([*order, str(script)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
        assert run.stdout and run.stderr
        job = run.stdout.readline().strip().partition(";")[0]
        if job:
            print(f"job {job}: {tasks} tasks, {len(batch.drawings())} drawings; logs in {folder}", flush=True)
        said = run.stderr.read().strip()
    if not job:
        raise BatchError(f"sbatch refused the jobs: {said or 'it gave no reason'}", FAILED)
    return FAILED if run.returncode != 0 else 0


def tasks_for(batch: Batch, each: float) -> int:
    """As many tasks as take a minute or more, by what drawings that are done took, else by a guess."""
    state = State(batch.out, batch.base)
    drawings = batch.drawings()
    records = [state.record(drawing.id) for _, drawing in drawings]
    took = [float(r["seconds"]) for r in records if r and "error" not in r]
    mean = sum(took) / len(took) if took else each
    left = sum(1 for r in records if r is None) or len(drawings)
    return max(1, min(int(left * mean / _LEAST), len(batch.jobs), _largest_array() - 1))


def _largest_array() -> int:
    try:
        said = subprocess.run(["scontrol", "show", "config"], capture_output=True, text=True, timeout=20).stdout
    except (OSError, subprocess.TimeoutExpired):
        said = ""
    match = re.search(r"MaxArraySize\s*=\s*(\d+)", said)
    return int(match[1]) if match else _LARGEST_ARRAY


def script_of(words: list[str], tasks: int) -> str:
    """A task of the array. It becomes the run, so that signals reach it."""
    return f'#!/bin/sh\nexec {shlex.join(words)} --shard "$SLURM_ARRAY_TASK_ID/{tasks}" --jobs "${{SLURM_CPUS_PER_TASK:-1}}"\n'


def _write(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)
    except OSError as e:
        raise BatchError(f"{path}: cannot be written: {e.strerror}", NO_OUTPUT) from e
