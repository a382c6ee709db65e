"""What has changed of the figures of a book from one revision to another: the models, the drawings, captions and lists."""

import dataclasses
import json
import os
from pathlib import Path
from typing import Any

from burin.batch.jobs import digest, file_hash, named_files
from burin.batch.prune import prune
from burin.batch.state import State

from .figures import Figure, FigureError, Made, Page, Studio, reading, words_of
from .pairs import list_words, look_words, paired, step_words
from .toml_book import Entry

SAME, CHANGED, ADDED, REMOVED, FAILED = "same", "changed", "added", "removed", "failed"
# The folders of drawings of both revisions, and of what is between them, below that of the differences.
OLD, NEW, BETWEEN = "old", "new", "diff"
_FORMATS = ["svg", "json"]
# Stands before the steps of a step book: what its models say.
WHOLE = "The whole"
# Where drawings that were compared line by line lie, beside models.
_LINES = "lines"
# Options that shape a drawing and that `burin diff` does not take: it draws both revisions as they stand, without lists.
_NOT_OF_DIFF = {"explode", "explode_factor", "callouts", "parts_list", "legend", "verify", "id_prefix"}
# Options that name parts.
_SELECTING = {"part", "hide", "ghost", "look", "detail", "section_exclude"}


@dataclasses.dataclass
class PageChange:
    """A picture in both revisions; names of files as seen from the folder of differences, empty where there is none."""

    # That of a step.
    heading: str
    status: str
    words: list[str]
    old: str = ""
    new: str = ""
    # Both in one drawing, and the page of it.
    difference: str = ""
    page: str = ""


@dataclasses.dataclass
class Compared:
    """What became of a figure."""

    name: str
    caption: str
    status: str
    # What `burin diff` says of the models, a line a part, and how many parts there are of each kind; empty where the files are
    # the same.
    models: list[str] = dataclasses.field(default_factory=list)
    parts: dict[str, int] = dataclasses.field(default_factory=dict)
    # All else.
    words: list[str] = dataclasses.field(default_factory=list)
    shown: list[PageChange] = dataclasses.field(default_factory=list)
    # "old", "new" or "difference" -> what failed.
    errors: dict[str, str] = dataclasses.field(default_factory=dict)


@dataclasses.dataclass
class _Between:
    """What `burin diff` says."""

    same: bool
    # A line a part, or a line a kind of line, and one that counts.
    words: list[str]
    sum: str
    counts: dict[str, int]
    picture: str = ""
    page: str = ""


_SAME_FILES = _Between(True, [], "", {})


class Comparer:
    """Compares figures of two revisions. Studios draw below `folder`/old and `folder`/new. Safe for several threads, a figure each."""

    def __init__(self, old: Studio, new: Studio, folder: Path, line_tolerance: float | None) -> None:
        self.studios = {OLD: old, NEW: new}
        self.folder, self.line_tolerance = folder, line_tolerance
        self.state = State(folder / BETWEEN, new.base)
        # What the records of this comparison are; all others are of what is no more.
        self.ids: dict[str, set[str]] = {OLD: set(), NEW: set(), BETWEEN: set()}

    def compare(self, old: Entry | None, new: Entry | None) -> Compared:
        """Of one figure. Throws burin.batch.errors.BatchError where nothing can be written, Cancelled."""
        entry = new or old
        assert entry is not None
        found = Compared(entry.figure.name, entry.caption, SAME)
        made = {side: self._make(side, e, found) for side, e in ((OLD, old), (NEW, new)) if e is not None}
        if found.errors:
            found.status = FAILED
            for side, what in made.items():
                if what:
                    found.shown += [_only(side, p) for p in _pages(what)]
            return found
        if old is None or new is None:
            side, found.status = (NEW, ADDED) if old is None else (OLD, REMOVED)
            found.shown = [_only(side, p) for p in _pages(made[side])]
            return found
        try:
            self._between_revisions(found, old, new, made)
        except FigureError as e:
            found.status, found.errors["difference"] = FAILED, f"cannot be compared: {e}"
            found.shown = [_both(*pair) for pair in _aligned(made[OLD], made[NEW])]
        return found

    def forget_others(self) -> None:
        """Removes records and files of what this comparison has not looked at."""
        for side in (OLD, NEW, BETWEEN):
            state = State(self.folder / side, self.folder)
            records = [state.record(id) or {} for id in self.ids[side]]
            prune(state, self.ids[side], {name for record in records for name in record.get("outputs", {})})

    def _make(self, side: str, entry: Entry, found: Compared) -> Made | None:
        studio, other = self.studios[side], self.studios[NEW if side == OLD else OLD]
        figure = _asked(entry.figure)
        self.ids[side].add(studio.id_of(figure))
        try:
            studio.adopt(figure, other)
            return studio.make(figure)
        except FigureError as e:
            found.errors[side] = str(e)
            return None

    def _between_revisions(self, found: Compared, old: Entry, new: Entry, made: dict[str, Made | None]) -> None:
        words = [f"caption '{old.caption}' to '{new.caption}'"] if old.caption != new.caption else []
        before, after = made[OLD], made[NEW]
        assert before is not None and after is not None
        if new.figure.parts_list or old.figure.parts_list:
            words += list_words(before.items, after.items)
        if (old.figure.steps is None) != (new.figure.steps is None):
            kind = ("a drawing", "a step book")
            words.append(f"was {kind[old.figure.steps is not None]}, is {kind[new.figure.steps is not None]}")
        for pair in _aligned(before, after):
            found.shown.append(self._picture(found.name, *pair))
        drawn = any(shown.status != SAME for shown in found.shown)
        found.status = CHANGED if drawn or words else SAME
        models, why = _SAME_FILES, ""
        try:
            models = self._models(found.name, old.figure, new.figure)
        except FigureError as e:
            why = f"the models cannot be compared: {e}"
        found.models, found.parts = models.words, models.counts
        if why:
            words.append(why)
        elif not models.same and not drawn:
            words.append("the models have changed, but not where this figure shows them")
        elif not models.same:
            if new.figure.steps is None and old.figure.steps is None:
                # What the models say of a part tells more than its lines.
                one = found.shown[0]
                one.words, one.difference, one.page = [], models.picture, models.page
            else:
                found.shown.insert(0, PageChange(WHOLE, CHANGED, [], "", "", models.picture, models.page))
        elif drawn:
            words.append("the models are the same, the drawing is not")
        if not found.shown[0].heading:
            words += found.shown[0].words
            found.shown[0].words = []
        found.words = words

    def _picture(self, name: str, old: Page | None, new: Page | None) -> PageChange:
        """Of a pair of pictures."""
        if old is None or new is None:
            return _both(old, new)
        shown = _both(old, new)
        shown.words = step_words(old, new)
        files = [self.folder / side / _data(page) for side, page in ((OLD, old), (NEW, new))]
        hashes = [file_hash(path) for path in files]
        if hashes[0] != hashes[1]:
            stem = Path(new.pictures[0]).stem
            lines = self._diff(f"{_LINES}/{stem}", [str(f) for f in files], self._tolerance(), ["lines", hashes])
            shown.words += [lines.sum] if not lines.same else look_words(*files)
            shown.difference, shown.page = lines.picture, lines.page
        shown.status = CHANGED if shown.words else SAME
        return shown

    def _tolerance(self) -> list[str]:
        return [] if self.line_tolerance is None else [f"--line-tolerance={self.line_tolerance:g}"]

    def _models(self, name: str, old: Figure, new: Figure) -> _Between:
        """What the models say, each read as its figure says, both drawn with the options of the new one. Throws FigureError."""
        read = {}
        for side, figure in ((OLD, old), (NEW, new)):
            studio = self.studios[side]
            styles = set(named_files(studio.base, figure.options))
            files = studio.record_of(_asked(figure)).get("files", {})
            read[side] = {file: known for file, known in files.items() if file not in styles and known}
        how = [reading(figure.options) for figure in (old, new)]
        if read[OLD] == read[NEW] and old.inputs == new.inputs and how[0] == how[1]:
            return _SAME_FILES
        options = {k: v for k, v in new.options.items() if k not in _NOT_OF_DIFF}
        base = self.studios[NEW].base
        id = [read, old.inputs, new.inputs, how, options, [file_hash(base / name) for name in named_files(base, options)]]
        with self.state.aside() as aside:
            inputs = [str(self.studios[side].base / figure.inputs[0]) for side, figure in ((OLD, old), (NEW, new))]
            if len(old.inputs) > 1 or len(new.inputs) > 1 or how[0] != how[1]:
                inputs = [self._as_one(side, figure, aside) for side, figure in ((OLD, old), (NEW, new))]
                options = {k: v for k, v in options.items() if k not in how[1]}
            try:
                return self._diff(name, inputs, words_of(options), ["models", id])
            except FigureError:
                # Parts that the new figure names need not have been there.
                fewer = {k: v for k, v in options.items() if k not in _SELECTING}
                if fewer == options:
                    raise
                return self._diff(name, inputs, words_of(fewer), ["models", id])

    def _as_one(self, side: str, figure: Figure, aside: Path) -> str:
        """The inputs of a figure as one illustration file: `burin diff` takes one file of each revision, and one way to read both."""
        path = aside / f"{side}.burin.json"
        how: dict[str, Any] = {name: values[0] if len(values) == 1 else values for name, values in reading(figure.options).items()}
        parts = [{"file": str(self.studios[side].base / name), **how} for name in figure.inputs]
        path.write_text(json.dumps({"burin": "illustration", "parts": parts}), encoding="ascii")
        return str(path)

    def _diff(self, stem: str, inputs: list[str], words: list[str], what: list[Any]) -> _Between:
        """Runs `burin diff`, once for what is the same. Throws FigureError."""
        studio = self.studios[NEW]
        id = digest([studio.settings.program, stem, words, what])
        self.ids[BETWEEN].add(id)
        record = self.state.record(id)
        if record is None or not all(self.state.holds(name, *known) for name, known in record["outputs"].items()):
            with self.state.aside() as aside:
                record = self._run_diff(id, stem, [*inputs, *words], aside)
            self.state.write_record(record)
        names = {Path(name).suffix: f"{BETWEEN}/{name}" for name in record["outputs"]}
        return _Between(record["same"], record["words"], record["sum"], record["counts"], names.get(".svg", ""), names.get(".html", ""))

    def _run_diff(self, id: str, stem: str, words: list[str], aside: Path) -> dict[str, Any]:
        files = {suffix: aside / f"both.{suffix}" for suffix in ("svg", "html", "json")}
        outputs = [f"--output={path}" for path in files.values()]
        status, said = self.studios[NEW].run(["diff", "--threads=1", *words, *outputs], {0, 6})
        report = json.loads(files.pop("json").read_text(encoding="utf-8"))
        record: dict[str, Any] = {"id": id, "name": stem, "files": {}, "outputs": {}, "same": status == 0, "counts": report["counts"]}
        *record["words"], record["sum"] = [" ".join(line.split()) for line in said.splitlines() if line.strip()]
        for suffix, path in files.items() if status else ():
            name = f"{stem}.{suffix}"
            record["outputs"][name] = [path.stat().st_size, file_hash(path)]
            (self.state.out / name).parent.mkdir(parents=True, exist_ok=True)
            os.replace(path, self.state.out / name)
        return record


def _asked(figure: Figure) -> Figure:
    """The figure as it is compared: as a picture and as data, without what makes a file that no one asks for here."""
    return dataclasses.replace(figure, formats=_FORMATS)


def _pages(made: Made | None) -> list[Page]:
    """The pictures of a figure, those of a step book by step."""
    assert made is not None
    return made.pages or [Page("", [], made.pictures)]


def _aligned(old: Made | None, new: Made | None) -> list[tuple[Page | None, Page | None]]:
    return paired(_pages(old), _pages(new))


def _data(page: Page) -> str:
    return page.pictures[_FORMATS.index("json")]


def _only(side: str, page: Page) -> PageChange:
    return _both(page if side == OLD else None, page if side == NEW else None)


def _both(old: Page | None, new: Page | None) -> PageChange:
    page = new or old
    assert page is not None
    status = ADDED if old is None else REMOVED if new is None else CHANGED
    names = [f"{side}/{p.pictures[0]}" if p else "" for side, p in ((OLD, old), (NEW, new))]
    return PageChange(page.heading, status, [], *names)
