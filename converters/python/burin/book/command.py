"""The words of `burin book`."""

import argparse
import concurrent.futures
import contextlib
import json
import os
import sys
import threading
from pathlib import Path
from typing import Any

from burin.batch.errors import FAILED, NO_OUTPUT, USAGE, BatchError
from burin.batch.limits import seconds
from burin.batch.words import Parser, exit_status

from .figures import FigureError, Made, Studio
from .markdown import fragment, whole
from .toml_book import Book, Entry, read_book

DIFFERENT = 6


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="burin book",
        allow_abbrev=False,
        description="Make the figures of a manual, those that are not made yet or show something that has changed. kernel/docs/book.md explains it.",
        epilog="Exit status: 0 all are made; 1 a figure failed; 6 with --check: something was made or would change; else that of burin draw.",
    )
    parser.add_argument("book", metavar="BOOK.toml", type=Path)
    parser.add_argument("-o", "--output", metavar="FOLDER", type=Path, help="where all that is made goes (default: what the book says)")
    parser.add_argument("--only", metavar="NAME", action="append", default=[], help="only this figure; repeatable")
    parser.add_argument("--jobs", metavar="N", type=int, help="figures made at once (default: as many as cores)")
    parser.add_argument("--timeout", metavar="S", default="300", help="seconds that a figure may take (default 300)")
    parser.add_argument("--check", action="store_true", help="exit status 6 where files that are there were not what the book says")
    parser.add_argument("--quiet", "-q", action="store_true", help="say nothing but what failed")
    parser.add_argument("--burin", metavar="FILE", help="the command that draws (default: this one)")
    return parser


def _write(path: Path, text: str) -> bool:
    """Whether the file was another before. Throws BatchError."""
    data = text.encode()
    with contextlib.suppress(OSError):
        if path.read_bytes() == data:
            return False
    aside = path.with_name(f".{path.name}.part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        aside.write_bytes(data)
        aside.replace(path)
    except OSError as e:
        raise BatchError(f"{path}: cannot be written: {e.strerror}", NO_OUTPUT) from e
    return True


def _chosen(book: Book, only: list[str]) -> list[Entry]:
    names = [e.figure.name for e in book.entries]
    for name in only:
        if name not in names:
            raise BatchError(f"option --only: there is no figure '{name}'; there are {', '.join(names)}", USAGE)
    return [e for e in book.entries if not only or e.figure.name in only]


def _make_all(studio: Studio, entries: list[Entry], count: int, stop: threading.Event, quiet: bool) -> dict[str, Made | FigureError]:
    made: dict[str, Made | FigureError] = {}
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        futures = {pool.submit(studio.make, e.figure): e for e in entries}
        try:
            for future in concurrent.futures.as_completed(futures):
                name = futures[future].figure.name
                try:
                    made[name] = one = future.result()
                except FigureError as e:
                    made[name] = e
                    print(f"burin: error: figure {name}: {e}", file=sys.stderr)
                    continue
                for words in one.diagnostics:
                    print(f"burin: figure {name}: {words}", file=sys.stderr)
                if not quiet:
                    print(f"{'kept' if one.kept else 'made'}  {name}", flush=True)
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    return made


def _run(arguments: Any) -> int:
    book = read_book(arguments.book)
    if arguments.output is not None:
        book.out = arguments.output.resolve()
    entries = _chosen(book, arguments.only)
    count = arguments.jobs if arguments.jobs is not None else len(os.sched_getaffinity(0))
    if count < 1:
        raise BatchError(f"option --jobs takes a number from 1, not {count}", USAGE)
    stop = threading.Event()
    studio = Studio(book.base, book.out, arguments.burin, seconds(arguments.timeout, "option --timeout"), stop.is_set)
    made = _make_all(studio, entries, count, stop, arguments.quiet)
    changed = any(isinstance(one, Made) and not one.kept for one in made.values())
    fragments = []
    index = []
    for entry in entries:
        one = made[entry.figure.name]
        if isinstance(one, FigureError):
            continue
        text = fragment(entry, one, book.link)
        changed |= _write(book.out / f"{entry.figure.name}.md", text)
        fragments.append(fragment(entry, one, ""))
        index.append({"name": entry.figure.name, "caption": entry.caption, "pictures": one.pictures, "items": one.items})
    if not arguments.only and len(fragments) == len(entries):
        changed |= _write(book.out / "book.md", whole(book.title, fragments))
        changed |= _write(book.out / "book.json", json.dumps({"format": "burin-book", "version": 1, "title": book.title, "figures": index}, indent=1) + "\n")
    if len(fragments) < len(entries):
        return FAILED
    return DIFFERENT if arguments.check and changed else 0


def main(words: list[str]) -> int:
    """Runs the command; its exit status. What goes wrong is one line."""
    return exit_status(lambda: _run(_parser().parse_args(words)))
