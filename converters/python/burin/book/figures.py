"""Figures: drawings of models, and step books, as files that are made once and made anew where what was read has changed.

What is done stands in records as those of `burin batch`: see burin.batch.state."""

import contextlib
import dataclasses
import json
import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from burin.batch.child import Ended, program_version, run_to_end
from burin.batch.files import write_whole
from burin.batch.jobs import Drawing, Job, digest, drawing_id, file_hash, named_files
from burin.batch.prune import Pruned, prune
from burin.batch.settings import command_of
from burin.batch.state import Hashes, State
from burin.batch.work import Settings, run_job

# What a file begins with that Git LFS has not fetched.
_POINTER = b"version https://git-lfs.github.com/spec/"
# The rows of converters/read/read_options.cpp.
_READING = set(
    "input_format define openscad_timeout csg as_ object recompute freecad_timeout encoding heal bounds mesher iso inside smooth specks volume_degree "
    "interpolate raw raw_skip pmi".split()
)


class FigureError(Exception):
    """One line: what is wrong with a figure, where, and what to do."""


@dataclasses.dataclass
class Figure:
    """What is drawn. Options are those of `burin draw` with underscores, each a list of texts."""

    name: str  # of the files, without a suffix
    inputs: list[str]
    options: dict[str, list[str]]
    formats: list[str]
    # Asks for the parts list as data.
    parts_list: bool = False
    # A step book with so many new items a step at the most; None: one drawing.
    steps: int | None = None


@dataclasses.dataclass
class Page:
    """A step of a step book."""

    heading: str
    added: list[dict[str, Any]]
    pictures: list[str]


@dataclasses.dataclass
class Made:
    """What came of a figure. Names are seen from the folder of outputs."""

    pictures: list[str]
    # A dict an item of the parts list: "number", "name", "quantity".
    items: list[dict[str, Any]]
    pages: list[Page]
    diagnostics: list[str]
    # All files that were read, as seen from the base.
    read: list[str]
    # Whether it was done before.
    kept: bool


class Studio:
    """Draws figures of models below `base` into the folder `out`. Safe for several threads and processes, one figure each."""

    def __init__(
        self, base: Path, out: Path, command: str | None = None, timeout: float = 300, cancelled: Callable[[], bool] = lambda: False
    ) -> None:
        self.base, self.out, self.cancelled = base, out, cancelled
        program = command_of(command)
        self.settings = Settings(str(base), str(out), program, program_version(program), timeout, None)
        self.state = State(out, base)

    def make(self, figure: Figure) -> Made:
        """Throws FigureError, burin.batch.errors.BatchError where nothing can be written, Cancelled."""
        try:
            return self._draw(figure) if figure.steps is None else self._steps(figure)
        except FigureError:
            for name in figure.inputs:
                with contextlib.suppress(OSError), open(self.base / name, "rb") as file:
                    if file.read(len(_POINTER)) == _POINTER:
                        raise FigureError(f"{name}: is a pointer of Git LFS, the file itself is not here; git lfs pull gets it") from None
            raise

    def id_of(self, figure: Figure) -> str:
        """The id of its record: of the figure's bytes, options and files, not of what its inputs include."""
        return self._id(figure, self._drawing(figure).files())

    def record_of(self, figure: Figure) -> dict[str, Any]:
        """What is known of a figure that was made: "files" that were read, "outputs"."""
        return self.state.record(self.id_of(figure)) or {}

    def write_text(self, name: str, text: str) -> bool:
        """A text beside the figures; whether it was another before. Throws BatchError."""
        changed = write_whole(self.out / name, text)
        record = self.state.record(_text_id(name))
        known = [len(text.encode()), file_hash(self.out / name)]
        if record is None or record["outputs"][name] != known:
            self.state.write_record({"id": _text_id(name), "name": name, "files": {}, "outputs": {name: known}})
        return changed

    def prune(self, figures: list[Figure], texts: list[str]) -> Pruned:
        """Removes what was made of other figures and texts than these."""
        ids = {self.id_of(f) for f in figures} | {_text_id(name) for name in texts}
        return prune(self.state, ids, {name for id in ids for name in (self.state.record(id) or {}).get("outputs", {})})

    def adopt(self, figure: Figure, other: "Studio") -> None:
        """Takes the files that another studio has made of the same figure, if what is read here has the same bytes."""
        drawing = self._drawing(figure)
        id = self._id(figure, drawing.files())
        here = Hashes(self.base)
        record = other.state.record(id)
        if record is None or "error" in record or self.settings.command != other.settings.command:
            return
        wanted = Drawing(figure.name, figure.options, sorted(record["outputs"]), [], id)
        if self.state.done(wanted, {}, here) or any(here.of(name) != known for name, known in record["files"].items()):
            return
        with self.state.aside() as aside:
            for number, (name, (size, known)) in enumerate(sorted(record["outputs"].items())):
                copy = aside / str(number)
                with contextlib.suppress(OSError):
                    shutil.copyfile(other.out / name, copy)
                if file_hash(copy) != known:
                    return
                (self.out / name).parent.mkdir(parents=True, exist_ok=True)
                os.replace(copy, self.out / name)
        self.state.write_record(record)

    def _id(self, figure: Figure, files: list[str]) -> str:
        return drawing_id(self.settings.program, self.base, figure.inputs, figure.options, files, Hashes(self.base).of, figure.steps)

    @staticmethod
    def _drawing(figure: Figure) -> Drawing:
        """The figure as a drawing; of a step book the names of pages are known when it is made."""
        stem = figure.name if figure.steps is None else f"{figure.name}-step"
        lists = [f"{figure.name}.items.json"] if figure.parts_list and figure.steps is None else []
        return Drawing(figure.name, dict(figure.options), [f"{stem}.{f}" for f in figure.formats], lists)

    def _draw(self, figure: Figure) -> Made:
        drawing = self._drawing(figure)
        pictures, lists = drawing.outputs, drawing.lists
        drawing.id = self._id(figure, drawing.files())
        result = run_job(self.settings, Job(figure.inputs[0], figure.inputs, [drawing]), self.cancelled)[0]
        if result.status == "failed":
            if result.before:
                # Whoever asks again has changed something that is no file, perhaps.
                self.state.forget(drawing.id)
            raise FigureError(result.message)
        record = self.state.record(drawing.id) or {}
        items = _items(self.out / lists[0]) if lists else []
        return Made(pictures, items, [], _words(record), sorted(record.get("files", {})), result.status == "kept")

    def _steps(self, figure: Figure) -> Made:
        marker = Drawing(figure.name, figure.options, [], [], self.id_of(figure))
        record = self.state.record(marker.id)
        if record is not None:
            marker.outputs = sorted(record.get("outputs", {}))
            done = self.state.done(marker, {}, Hashes(self.base))
            if done is not None and "error" not in done:
                return _made(done, kept=True)
        with self.state.aside() as aside:
            record = self._make_steps(figure, marker.id, aside)
        self.state.write_record(record)
        return _made(record, kept=False)

    def _make_steps(self, figure: Figure, id: str, aside: Path) -> dict[str, Any]:
        # What the model is made of: a drawing that takes little says it.
        quick = Drawing("read", {"style": ["outline"], **reading(figure.options)}, ["read.json"])
        probe = Studio(self.base, aside, self.settings.command, self.settings.timeout or 300, self.cancelled)
        quick.id = digest([id])
        result = run_job(probe.settings, Job(figure.inputs[0], figure.inputs, [quick]), self.cancelled)[0]
        if result.status == "failed":
            raise FigureError(result.message)
        files = (probe.state.record(quick.id) or {}).get("files", {})
        files.update({name: file_hash(self.base / name) for name in named_files(self.base, figure.options)})
        data = aside / "steps.json"
        self._run(["steps", *figure.inputs, "-o", str(data), "--items", str(figure.steps or 6), *words_of(figure.options)])
        book = json.loads(data.read_text(encoding="utf-8"))
        outputs: dict[str, tuple[int, str]] = {}
        pages = []
        for number, page in enumerate(book["pages"], 1):
            stem = f"{figure.name}-step-{number:02}"
            drawn = aside / "page.json"
            drawn.write_text(json.dumps(page["drawing"]), encoding="utf-8")
            pictures = [f"{stem}.{f}" for f in figure.formats]
            asides = [aside / f"page-{number}.{f}" for f in figure.formats]
            self._run(["convert", str(drawn), *(word for a in asides for word in ("-o", str(a))), "--id-prefix", f"{stem}-"])
            for written, name in zip(asides, pictures):
                hashed = file_hash(written)
                if hashed is None:
                    raise FigureError(f"{name} was not written")
                outputs[name] = (written.stat().st_size, hashed)
                target = self.out / name
                target.parent.mkdir(parents=True, exist_ok=True)
                os.replace(written, target)
            pages.append({"heading": page["heading"], "added": page["added"], "pictures": pictures})
        return {"id": id, "files": files, "outputs": outputs, "pages": pages, "items": book["items"], "diagnostics": []}

    def _run(self, words: list[str]) -> None:
        self.run([*words, "--quiet"], {0})

    def run(self, words: list[str], fine: set[int]) -> tuple[int, str]:
        """Exit status, one that is fine, and output of the command. Throws FigureError, Cancelled."""
        try:
            status, said, errors = run_to_end([self.settings.command, *words], self.base, self.settings.timeout, self.cancelled)
        except Ended as e:
            raise FigureError(e.message) from e
        except OSError as e:
            raise FigureError(f"{self.settings.command} cannot be started: {e.strerror}") from e
        if status not in fine:
            lines = [line for line in errors.splitlines() if line.strip()] or [f"ended with status {status}"]
            raise FigureError(re.sub(r"^burin: error: ", "", lines[-1]))
        return status, said


def _text_id(name: str) -> str:
    return digest(["text", name])


def reading(options: dict[str, list[str]]) -> dict[str, list[str]]:
    """Options about reading, without which files may not be read at all; illustrations have them at their parts."""
    return {k: v for k, v in options.items() if k in _READING}


def words_of(options: dict[str, list[str]]) -> list[str]:
    """Options as the command takes them."""
    words = []
    for name, values in options.items():
        word = "--" + name.strip("_").replace("_", "-")
        for value in values:
            if value == "true":
                words.append(word)
            elif value == "false":
                words.append(word.replace("--", "--no-", 1))
            else:
                words.append(f"{word}={value}")
    return words


def _items(path: Path) -> list[dict[str, Any]]:
    value = json.loads(path.read_text(encoding="utf-8"))
    return list(value["items"] if isinstance(value, dict) else value)


def _words(record: dict[str, Any]) -> list[str]:
    found = []
    for diagnostic in record.get("diagnostics", []):
        if isinstance(diagnostic, str):
            found.append(diagnostic)
        elif diagnostic.get("severity") != "info":
            found.append(str(diagnostic.get("message", "")))
    return found


def _made(record: dict[str, Any], kept: bool) -> Made:
    pages = [Page(**page) for page in record["pages"]]
    pictures = [name for page in pages for name in page.pictures]
    return Made(pictures, record["items"], pages, [], sorted(record["files"]), kept)
