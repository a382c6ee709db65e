"""The words of `burin book`."""

import argparse
import concurrent.futures
import contextlib
import json
import os
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

from burin.batch.errors import FAILED, USAGE, BatchError
from burin.batch.files import write_whole
from burin.batch.limits import seconds
from burin.batch.words import Parser, exit_status

from . import compare
from .differences import Differences, brief, forget, write_all
from .figures import FigureError, Made, Studio
from .markdown import fragment, whole
from .revision import OldBook, old_book
from .toml_book import Book, Entry, read_book

DIFFERENT = 6
_DIFFERENCES = Path("differences")
_T = TypeVar("_T")


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="burin book",
        allow_abbrev=False,
        description="Make the figures of a manual that are missing or out of date; or, with --since or --compare, "
        "list what has changed in them since another revision: a page (index.html), a few lines (differences.md) and data (differences.json). "
        "The page manuals.md of the manual explains both.",
        epilog="Exit status: 0 all are made, or nothing has changed; 1 a figure failed; 6 something has changed since another revision, or with --check: "
        "something was made or would change; else that of burin draw.",
    )
    parser.add_argument("book", metavar="BOOK.toml", type=Path)
    parser.add_argument(
        "-o",
        "--output",
        metavar="FOLDER",
        type=Path,
        help=f"folder for all output (default: as in the book; for a comparison: {_DIFFERENCES})",
    )
    parser.add_argument("--only", metavar="NAME", action="append", default=[], help="only this figure; repeatable")
    parser.add_argument("--jobs", metavar="N", type=int, help="figures made at the same time (default: one for each core)")
    parser.add_argument("--timeout", metavar="S", default="300", help="seconds that a figure may take (default 300)")
    parser.add_argument("--check", action="store_true", help="exit status 6 if files differ from what the book describes")
    parser.add_argument("--prune", action="store_true", help="remove what was made of figures that the book no longer has, if none fails")
    parser.add_argument("--quiet", "-q", action="store_true", help="print failures only")
    parser.add_argument("--burin", metavar="FILE", help="the command that draws (default: this one)")
    others = parser.add_argument_group("another revision")
    either = others.add_mutually_exclusive_group()
    either.add_argument(
        "--since",
        metavar="REV[:PATH]",
        help="compare with the book as it was in this revision of Git: a branch, tag or commit; :PATH where it had another name then, from the top",
    )
    either.add_argument("--compare", metavar="OLD.toml", type=Path, help="compare with this book")
    others.add_argument("--line-tolerance", metavar="MM", help="lines up to this many paper mm apart are the same (default 0.1)")
    others.add_argument("--old-burin", metavar="FILE", help="the command that draws the old figures, e.g. another version (default: this one)")
    return parser


def _chosen(books: list[Book], only: list[str]) -> list[str]:
    """Names of figures, those of the first book first."""
    names = list(dict.fromkeys(e.figure.name for book in books for e in book.entries))
    for name in only:
        if name not in names:
            raise BatchError(f"option --only: there is no figure '{name}'; there are {', '.join(names)}", USAGE)
    return [name for name in names if not only or name in only]


def _each(names: list[str], count: int, stop: threading.Event, work: Callable[[str], _T]) -> Iterator[tuple[str, _T | FigureError]]:
    """What comes of each figure, as they are done."""
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        futures = {pool.submit(work, name): name for name in names}
        try:
            for future in concurrent.futures.as_completed(futures):
                try:
                    yield futures[future], future.result()
                except FigureError as e:
                    yield futures[future], e
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise


def _make_all(studio: Studio, entries: dict[str, Entry], count: int, stop: threading.Event, quiet: bool) -> dict[str, Made | FigureError]:
    made: dict[str, Made | FigureError] = {}
    for name, one in _each(list(entries), count, stop, lambda name: studio.make(entries[name].figure)):
        made[name] = one
        if isinstance(one, FigureError):
            print(f"burin: error: figure {name}: {one}", file=sys.stderr)
            continue
        for words in one.diagnostics:
            print(f"burin: figure {name}: {words}", file=sys.stderr)
        if not quiet:
            print(f"{'kept' if one.kept else 'made'}  {name}", flush=True)
    return made


def _make_book(arguments: Any, book: Book, count: int) -> int:
    if arguments.output is not None:
        book.out = arguments.output.resolve()
    names = _chosen([book], arguments.only)
    entries = {e.figure.name: e for e in book.entries if e.figure.name in names}
    stop = threading.Event()
    studio = Studio(book.base, book.out, arguments.burin, seconds(arguments.timeout, "option --timeout"), stop.is_set)
    made = _make_all(studio, entries, count, stop, arguments.quiet)
    changed = any(isinstance(one, Made) and not one.kept for one in made.values())
    fragments = []
    index = []
    for name, entry in entries.items():
        one = made[name]
        if isinstance(one, FigureError):
            continue
        changed |= studio.write_text(f"{name}.md", fragment(entry, one, book.link))
        fragments.append(fragment(entry, one, ""))
        index.append({"name": name, "caption": entry.caption, "pictures": one.pictures, "items": one.items})
    if not arguments.only and len(fragments) == len(entries):
        changed |= write_whole(book.out / "book.md", whole(book.title, fragments))
        changed |= write_whole(book.out / "book.json", json.dumps({"format": "burin-book", "version": 1, "title": book.title, "figures": index}, indent=1) + "\n")
    if len(fragments) < len(entries):
        return FAILED
    if arguments.prune:
        all = [e.figure for e in book.entries]
        pruned = studio.prune(all, [f"{figure.name}.md" for figure in all])
        for verb, files in (("removed", pruned.files), ("left, it has changed since", pruned.left)):
            for file in files if not arguments.quiet else ():
                print(f"{verb}  {file}")
        changed |= bool(pruned.files)
    return DIFFERENT if arguments.check and changed else 0


def _compare(arguments: Any, book: Book, before: OldBook, count: int, stop: threading.Event) -> int:
    # Where there was no book, there was one without figures.
    was, broken = Book(book.title, book.base, book.out, "", []), False
    try:
        was = read_book(before.path) if before.path else was
    except BatchError as e:
        if arguments.compare is not None:
            raise
        # Whoever mends it wants to see the figures all the same.
        broken = True
        before.notes.append(f"the book of {before.words} cannot be read: {str(e).removeprefix(f'{before.path}: ')}")
    folder = _folder(arguments)
    timeout = seconds(arguments.timeout, "option --timeout")
    tolerance = None if arguments.line_tolerance is None else _tolerance(arguments.line_tolerance)
    new = Studio(book.base, folder / compare.NEW, arguments.burin, timeout, stop.is_set)
    old = Studio(was.base, folder / compare.OLD, arguments.old_burin or arguments.burin, timeout, stop.is_set)
    comparer = compare.Comparer(old, new, folder, tolerance)
    names = _chosen([book, was], arguments.only)
    olds, news = ({e.figure.name: e for e in b.entries} for b in (was, book))
    for note in before.notes:
        print(f"burin: {note}", file=sys.stderr)
    found: dict[str, compare.Compared] = {}
    for name, one in _each(names, count, stop, lambda name: comparer.compare(olds.get(name), news.get(name))):
        assert not isinstance(one, FigureError)
        found[name] = one
        if one.status == compare.FAILED:
            print(f"burin: error: figure {name}: {brief(one)}", file=sys.stderr)
        elif not arguments.quiet:
            words = brief(one)
            print(f"{one.status:7}  {name}{': ' if words else ''}{words}", flush=True)
    if not arguments.only:
        comparer.forget_others()
    differences = Differences(book.title, before.words, "now", new.settings.program, before.notes, [found[name] for name in names])
    write_all(differences, folder)
    if not arguments.quiet:
        print(f"{folder / 'index.html'}: {differences.summary()}")
    counts = differences.counts()
    if counts[compare.FAILED] or broken:
        return FAILED
    return 0 if counts[compare.SAME] == len(names) else DIFFERENT


def _folder(arguments: Any) -> Path:
    """That of the differences."""
    return Path(arguments.output or _DIFFERENCES).resolve()


def _tolerance(text: str) -> float:
    with contextlib.suppress(ValueError):
        if 0 < (value := float(text)) <= 100:
            return value
    raise BatchError(f"option --line-tolerance takes mm from 0 to 100, not '{text}'", USAGE)


def _run(arguments: Any) -> int:
    count = arguments.jobs if arguments.jobs is not None else len(os.sched_getaffinity(0))
    if count < 1:
        raise BatchError(f"option --jobs takes a number from 1, not {count}", USAGE)
    comparing = arguments.since is not None or arguments.compare is not None
    for given, option in ((arguments.line_tolerance, "--line-tolerance"), (arguments.old_burin, "--old-burin")):
        if given is not None and not comparing:
            raise BatchError(f"option {option} is for --since or --compare", USAGE)
    if comparing and (arguments.check or arguments.prune):
        word = "--check" if arguments.check else "--prune"
        raise BatchError(f"option {word} is for making a book; --since and --compare have status 6 where something has changed", USAGE)
    if comparing:
        forget(_folder(arguments))
    book = read_book(arguments.book)
    if not comparing:
        return _make_book(arguments, book, count)
    stop = threading.Event()
    if arguments.compare is not None:
        return _compare(arguments, book, OldBook(arguments.compare, str(arguments.compare), []), count, stop)
    with old_book(arguments.book, arguments.since, stop.is_set) as before:
        return _compare(arguments, book, before, count, stop)


def main(words: list[str]) -> int:
    """Runs the command; its exit status. What goes wrong is one line."""
    return exit_status(lambda: _run(_parser().parse_args(words)))
