"""The words of `burin batch`."""

import argparse
import os
from pathlib import Path
from typing import Any

from . import report
from .catalogue import read_catalogue
from .child import program_version
from .errors import FAILED, USAGE, BatchError
from .jobs import read, write
from .limits import TIMEOUT, seconds
from .progress import Progress, printable
from .prune import prune
from .runner import chosen, large_first, run_here, without_clashes
from .settings import command_of, settings_of
from .state import State
from .words import Parser, exit_status


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="burin batch", allow_abbrev=False, description="Draw a catalogue of parts, each once. The page catalogues.md of the manual explains it.")
    parser.add_argument("--burin", metavar="FILE", help="the command that draws (default: this one)")
    commands = parser.add_subparsers(dest="verb", metavar="COMMAND", required=True, parser_class=Parser)

    plan = commands.add_parser("plan", help="make jobs of a catalogue")
    plan.add_argument("catalogue", metavar="CATALOGUE.toml", type=Path)
    plan.add_argument("-o", "--output", metavar="JOBS.jsonl", type=Path, required=True)

    run = commands.add_parser("run", help="draw what is not done yet")
    _add_jobs(run)
    _add_limits(run)
    run.add_argument("--shard", metavar="I/N", default="1/1", help="only the I-th of N parts of the jobs")
    run.add_argument("--jobs", metavar="N", type=int, help="parts drawn at the same time (default: one for each core)")
    run.add_argument("--on", metavar="dask://HOST:PORT", help="draw with the workers of a Dask scheduler")
    run.add_argument("--patience", metavar="S", default="60", help="end the run after so many seconds without a Dask worker (default 60)")
    run.add_argument("--quiet", "-q", action="store_true", help="print failures only")

    shows = commands.add_parser("report", help="one page of all drawings, failures first, and one hash of them")
    _add_jobs(shows)
    shows.add_argument("-o", "--output", metavar="FILE.html", type=Path, help="the page (default: index.html beside the drawings)")

    prunes = commands.add_parser("prune", help="remove drawings that the catalogue no longer has, and their records")
    prunes.add_argument("jobs_files", metavar="JOBS.jsonl", type=Path, nargs="+", help="all files of jobs that draw into this folder")
    prunes.add_argument("--dry-run", "-n", action="store_true", help="list what would be removed; remove nothing")
    prunes.add_argument("--quiet", "-q", action="store_true", help="print nothing")

    slurm = commands.add_parser("slurm", help="draw by a job array of Slurm")
    _add_jobs(slurm)
    _add_limits(slurm)
    slurm.add_argument("--tasks", metavar="N", type=int, help="tasks of the array (default: each takes a minute or more)")
    slurm.add_argument("--each", metavar="S", default="1", help="estimated seconds for a drawing, if none is done yet (default 1)")
    slurm.add_argument(
        "--sbatch", metavar="OPTION", action="append", default=[], help="an option of sbatch, e.g. --sbatch=--partition=long; repeatable"
    )
    slurm.add_argument("--script", metavar="FILE", type=Path, help="write the script there, and submit nothing")
    slurm.add_argument("--wait", action="store_true", help="wait until all tasks have ended")
    return parser


def _add_jobs(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("jobs_file", metavar="JOBS.jsonl", type=Path)


def _add_limits(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--timeout", metavar="S", help=f"seconds that a drawing may take (default {TIMEOUT:g})")
    parser.add_argument("--memory", metavar="4G", help="memory that the process of a part may take (default: any)")
    parser.add_argument("--threads", metavar="N", type=int, default=1, help="threads of each drawing (default 1)")
    parser.add_argument("--again", action="store_true", help="also draw again what failed")


def _shard(text: str) -> tuple[int, int]:
    number, slash, count = text.partition("/")
    if not (slash and number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
        raise BatchError(f"option --shard takes I/N, such as 3/8, with I from 1 to N, not '{text}'", USAGE)
    return int(number), int(count)


def _plan(arguments: Any) -> int:
    command = command_of(arguments.burin)
    batch = read_catalogue(arguments.catalogue, arguments.output.parent, command, program_version(command))
    write(batch, arguments.output)
    print(f"{arguments.output}: {len(batch.jobs)} parts, {len(batch.drawings())} drawings")
    return 0


def _run(arguments: Any) -> int:
    batch = read(arguments.jobs_file)
    settings = settings_of(arguments, batch)
    jobs, clashes = without_clashes(batch, chosen(batch.jobs, _shard(arguments.shard)))
    progress = Progress(sum(len(job.drawings) for job in jobs) + len(clashes), arguments.quiet)
    progress.add(clashes)
    jobs = large_first(jobs, batch.base)
    count = arguments.jobs if arguments.jobs is not None else len(os.sched_getaffinity(0))
    if count < 1:
        raise BatchError(f"option --jobs takes a number from 1, not {count}", USAGE)
    try:
        if arguments.on:
            from .on_dask import run_on_dask

            run_on_dask(arguments.on, settings, jobs, progress, seconds(arguments.patience, "option --patience"))
        else:
            run_here(settings, jobs, count, progress)
    finally:
        progress.end()
    return FAILED if progress.failed else 0


def _report(arguments: Any) -> int:
    batch = read(arguments.jobs_file)
    summary = report.summary_of(batch)
    page = arguments.output or batch.out / "index.html"
    report.write_page(summary, batch, page)
    print(f"{page}: {summary.line()}")
    print(f"hash {summary.hash}")
    return 0


def _prune(arguments: Any) -> int:
    batches = [read(path) for path in arguments.jobs_files]
    outs = {batch.out.resolve() for batch in batches}
    if len(outs) > 1:
        raise BatchError(f"these files of jobs draw into several folders, {' and '.join(sorted(map(str, outs)))}; prune one after the other", USAGE)
    drawings = [drawing for batch in batches for _, drawing in batch.drawings()]
    wanted = {name for drawing in drawings for name in drawing.files()}
    pruned = prune(State(batches[0].out, batches[0].base), {d.id for d in drawings}, wanted, arguments.dry_run)
    if not arguments.quiet:
        for words, names in (("would remove" if arguments.dry_run else "removed", pruned.files), ("left", pruned.left)):
            for name in names:
                print(f"{words:7}  {printable(name)}")
        print(f"{batches[0].out}: {pruned.words(arguments.dry_run)}")
    return 0


def _slurm(arguments: Any) -> int:
    from .slurm import submit

    return submit(arguments, read(arguments.jobs_file))


def _main(words: list[str]) -> int:
    arguments = _parser().parse_args(words)
    verbs = {"plan": _plan, "run": _run, "report": _report, "prune": _prune, "slurm": _slurm}
    return verbs[arguments.verb](arguments)


def main(words: list[str]) -> int:
    """Runs the command; its exit status. What goes wrong is one line."""
    return exit_status(lambda: _main(words))
