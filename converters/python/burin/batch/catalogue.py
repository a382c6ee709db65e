"""Catalogues: a TOML file that says which parts are drawn, how, and what the drawings are called.

    out = "out"                              # folder of the drawings, beside the file of jobs
    views = ["iso"]                          # these four hold for all groups of files that do not say otherwise
    styles = ["technical", "company.json"]
    outputs = ["{folder}/{name}-{view}-{style}.svg"]
    options = {paper = "A5", set = {"line.outer" = 0.5}}
    limits = {timeout = 120, memory = "4G"}  # of each drawing

    [[parts]]
    files = ["parts/**/*.step"]              # or illustrations = ["*.burin.json"]
    exclude = ["parts/old/*"]
    views = ["front", "iso"]
"""

import fnmatch
import glob
import itertools
import json
import os
import string
from pathlib import Path
from typing import Any

from .child import check_drawings
from .errors import USAGE, BatchError
from .jobs import Batch, Drawing, Job, drawing_id, stays_inside
from .limits import memory_bytes, seconds
from .state import Hashes
from .toml_reader import TomlReader, nearest

SHARED = {"views", "styles", "outputs", "options"}
TOP = SHARED | {"out", "limits", "parts"}
GROUP = SHARED | {"files", "illustrations", "exclude"}
PLACES = ("folder", "name", "suffix", "view", "style")


def read_catalogue(path: Path, folder: Path, command: str, program: str) -> Batch:
    """All jobs of a catalogue, for a file of jobs in `folder`. Hashes each input once. Throws BatchError."""
    reader = TomlReader(path)
    table = reader.load()
    reader.table(table, "the catalogue", TOP)
    base = path.resolve().parent
    out = reader.texts(table.get("out", "out"), "out")[0]
    if os.path.isabs(out) or ".." in Path(out).parts:
        raise reader.fail(f"out = {out!r} is not below the folder of the jobs; write them elsewhere, or let out be a link")
    limits = _limits(reader, table.get("limits", {}))
    groups = table.get("parts")
    if not isinstance(groups, list) or not groups:
        raise reader.fail('names no parts; add [[parts]] with files = ["*.step"]')
    jobs: list[Job] = []
    hashes = Hashes(base)
    for number, group in enumerate(groups, 1):
        where = f"parts {number}"
        reader.table(group, where, GROUP)
        # An illustration says itself from where, how and on what it is drawn.
        shared = {"outputs"} if "illustrations" in group else SHARED
        own = {**{k: v for k, v in table.items() if k in shared}, **group}
        if "options" in group and "options" in shared:
            own["options"] = {**_mapping(reader, table.get("options", {}), "options"), **_mapping(reader, group["options"], where)}
        jobs += _Group(reader, where, own, base, program, hashes).jobs()
    batch = Batch(base, folder.resolve() / out, program, limits, jobs)
    _refuse_clashes(reader, batch)
    _check(reader, batch, command)
    return batch


def _mapping(reader: TomlReader, value: Any, where: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise reader.fail(f"{where}: options is no table")
    return value


def _limits(reader: TomlReader, value: Any) -> dict[str, Any]:
    limits = dict(reader.table(value, "limits", {"timeout", "memory"}))
    if "timeout" in limits:
        seconds(limits["timeout"], f"{reader.path}: limits: timeout")
    if "memory" in limits:
        memory_bytes(str(limits["memory"]), f"{reader.path}: limits: memory")
    return limits


class _Group:
    """One table of [[parts]]."""

    def __init__(self, reader: TomlReader, where: str, own: dict[str, Any], base: Path, program: str, hashes: Hashes) -> None:
        self.reader, self.where, self.base, self.program, self.hashes = reader, where, base, program, hashes
        if ("files" in own) == ("illustrations" in own):
            raise reader.fail(f"{where} takes either files or illustrations")
        self.illustrated = "illustrations" in own
        self.patterns = reader.texts(own["illustrations" if self.illustrated else "files"], f"{where}: files")
        self.exclude = reader.texts(own["exclude"], f"{where}: exclude") if "exclude" in own else []
        nothing = [""] if self.illustrated else None
        self.views = reader.texts(own["views"], f"{where}: views") if "views" in own else nothing or ["iso"]
        self.styles = reader.texts(own["styles"], f"{where}: styles") if "styles" in own else nothing or ["technical"]
        names = "{folder}/{name}" + ("-{view}" if self.views != [""] else "") + ("-{style}" if len(self.styles) > 1 else "")
        self.outputs = reader.texts(own.get("outputs", names + ".svg"), f"{where}: outputs")
        options = _mapping(reader, own.get("options", {}), where)
        for name in ("threads", "view", "style", "output", "format"):
            if name in options:
                instead = {"threads": "burin batch run --threads", "view": "views", "style": "styles"}.get(name, "outputs")
                raise reader.fail(f"{where}: options: {name} is set by {instead}")
        self.options = {str(k): reader.option(v, f"{where}: options: {k}") for k, v in options.items()}

    def files(self) -> list[str]:
        found: dict[str, None] = {}
        for pattern in self.patterns:
            if os.path.lexists(self.base / pattern):
                found[pattern] = None
                continue
            if not glob.has_magic(pattern):
                found[pattern] = None  # told by the job that misses it
                continue
            names = sorted(n for n in glob.glob(pattern, root_dir=self.base, recursive=True) if not (self.base / n).is_dir())
            if not names:
                raise self.reader.fail(f"{self.where}: '{pattern}' matches no file below {self.base}")
            found.update(dict.fromkeys(names))
        kept = [f for f in found if not any(fnmatch.fnmatch(f, e) for e in self.exclude)]
        if not kept:
            raise self.reader.fail(f"{self.where}: exclude leaves no file")
        for name in kept:
            try:
                name.encode()
            except UnicodeEncodeError:
                raise self.reader.fail(f"{self.where}: {os.fsencode(name)!r} is a name that is no UTF-8; rename the file") from None
        return kept

    def jobs(self) -> list[Job]:
        return [Job(f, [f], [self.drawing(f, v, s) for v, s in itertools.product(self.views, self.styles)]) for f in self.files()]

    def drawing(self, file: str, view: str, style: str) -> Drawing:
        path = Path(file)
        suffix = ".burin.json" if file.endswith(".burin.json") else path.suffix
        folder = "/".join(p for p in path.parent.parts if p not in ("/", ".."))
        places = {
            "folder": folder or ".",
            "name": path.name.removesuffix(suffix),
            "suffix": suffix.lstrip("."),
            "view": view or "drawing",
            "style": Path(style).stem or "drawing",
        }
        options = dict(self.options)
        if view:
            options["view"] = [view]
        if style:
            options["style"] = [style]
        lists = [t for t in options.get("parts_list", []) if t.endswith((".csv", ".json"))]
        if lists:
            options["parts_list"] = [t for t in options["parts_list"] if t not in lists]
            options = {k: v for k, v in options.items() if v}
        outputs = [self.filled(t, places) for t in self.outputs]
        drawing = Drawing(outputs[0], options, outputs, [self.filled(t, places) for t in lists])
        drawing.id = drawing_id(self.program, self.base, [file], options, drawing.files(), self.hashes.of)
        return drawing

    def filled(self, template: str, places: dict[str, str]) -> str:
        try:
            for _, place, form, _ in string.Formatter().parse(template):
                if place is not None and (place not in places or form):
                    raise self.reader.fail(
                        f"{self.where}: outputs: '{{{place}}}' is no placeholder; the nearest is '{{{nearest(place, PLACES)}}}'"
                    )
            name = os.path.normpath(template.format(**places))
        except ValueError as e:
            raise self.reader.fail(f"{self.where}: outputs: '{template}': {e}; a brace is written twice") from e
        if not stays_inside(name):
            raise self.reader.fail(f"{self.where}: outputs: {name!r} is not below the folder of outputs")
        return name


def _refuse_clashes(reader: TomlReader, batch: Batch) -> None:
    inputs = {os.path.normpath(batch.base / i) for job in batch.jobs for i in job.inputs}
    owner: dict[str, str] = {}
    for job, drawing in batch.drawings():
        what = f"{job.part} ({' '.join(v for o in ('view', 'style') for v in drawing.options.get(o, []))})"
        for name in drawing.files():
            if os.path.normpath(batch.out / name) in inputs:
                raise reader.fail(f"the output {name!r} of {what} is also an input; name another folder by out")
            if name in owner:
                raise reader.fail(
                    f"the output {name!r} of {what} is also one of {owner[name]}; add {{folder}}, {{suffix}}, {{view}} or {{style}}"
                )
            owner[name] = what


def _check(reader: TomlReader, batch: Batch, command: str) -> None:
    """Options and formats are looked at once for all drawings that have the same, by the command itself."""
    different: dict[str, Drawing] = {}
    for _, drawing in batch.drawings():
        suffixes = [Path(o).suffix for o in drawing.files()]
        different.setdefault(json.dumps([drawing.options, suffixes], sort_keys=True), drawing)
    drawings = list(different.values())
    for drawing, error in zip(drawings, check_drawings(command, batch.base, drawings)):
        if error:
            raise BatchError(f"{reader.path}: {drawing.name}: {error}", USAGE)
