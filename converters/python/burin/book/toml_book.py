"""BOOK.toml: the figures of a manual.

    title = "Gear pump"
    out = "figures"                       # folder of all that is made, beside this file
    formats = ["svg", "pdf"]              # each figure in each of them; the first is the one that Markdown shows
    options = {style = "technical", paper = "A5"}

    [[figures]]
    name = "apart"                        # figures/apart.svg, figures/apart.pdf, figures/apart.md
    model = "pump.burin.json"             # or a list of files
    caption = "The pump, taken apart"
    options = {explode = "auto", callouts = true}
    parts_list = true

    [[figures]]
    name = "assembly"
    model = "pump.step"
    steps = true                          # or 4: new items a step at the most
"""

import dataclasses
import os
from pathlib import Path
from typing import Any

from burin.batch.toml_reader import TomlReader

from .figures import Figure

_TOP = {"title", "out", "formats", "options", "link", "figures"}
_FIGURE = {"name", "model", "caption", "options", "formats", "parts_list", "steps"}
_STEP_ITEMS = 6


@dataclasses.dataclass
class Entry:
    figure: Figure
    caption: str


@dataclasses.dataclass
class Book:
    title: str
    # Where models are looked for, and where all that is made goes.
    base: Path
    out: Path
    # What addresses of pictures begin with in fragments; pages that include them may lie elsewhere.
    link: str
    entries: list[Entry]


def read_book(path: Path) -> Book:
    """Throws BatchError, naming the file and the key."""
    reader = TomlReader(path)
    table = reader.load()
    reader.table(table, "the book", _TOP)
    base = path.resolve().parent
    out = reader.text(table.get("out", "figures"), "out")
    if os.path.isabs(out) or ".." in Path(out).parts or not out:
        raise reader.fail(f"out = {out!r} is not below the folder of the book")
    figures = table.get("figures")
    if not isinstance(figures, list) or not figures:
        raise reader.fail("names no figures; add [[figures]] with name and model")
    entries: list[Entry] = []
    for number, value in enumerate(figures, 1):
        entries.append(_entry(reader, f"figures {number}", reader.table(value, f"figures {number}", _FIGURE), table))
        names = [e.figure.name for e in entries]
        if len(set(names)) < len(names):
            raise reader.fail(f"figures {number}: there is another figure of the name '{names[-1]}'")
    link = reader.text(table.get("link", ""), "link")
    return Book(reader.text(table.get("title", ""), "title"), base, base / out, link, entries)


def _entry(reader: TomlReader, where: str, own: dict[str, Any], table: dict[str, Any]) -> Entry:
    for key in ("name", "model"):
        if key not in own:
            raise reader.fail(f"{where} has no {key}")
    name = reader.text(own["name"], f"{where}: name")
    if not name or name != os.path.basename(name) or name.startswith(".") or any(c in name for c in "\n\r\\#%?"):
        raise reader.fail(f"{where}: name = {name!r} is no name of a file")
    options: dict[str, list[str]] = {}
    for source in (table.get("options", {}), own.get("options", {})):
        if not isinstance(source, dict):
            raise reader.fail(f"{where}: options is no table")
        for key, value in source.items():
            if key in ("output", "format", "threads", "parts_list"):
                raise reader.fail(f"{where}: options: {key} is set by {'parts_list of the figure' if key == 'parts_list' else 'formats'}")
            options[key] = reader.option(value, f"{where}: options: {key}")
    formats = reader.texts(own.get("formats", table.get("formats", ["svg"])), f"{where}: formats")
    if len(set(formats)) < len(formats) or any("/" in f or f == "md" for f in formats):
        raise reader.fail(f"{where}: formats takes each format once, svg, pdf, png ...")
    steps = own.get("steps", False)
    if isinstance(steps, bool):
        steps = _STEP_ITEMS if steps else None
    elif not isinstance(steps, int) or not 1 <= steps <= 1000:
        raise reader.fail(f"{where}: steps takes true or a whole number from 1 to 1000")
    parts_list = own.get("parts_list", False)
    if not isinstance(parts_list, bool):
        raise reader.fail(f"{where}: parts_list takes true or false")
    figure = Figure(name, reader.texts(own["model"], f"{where}: model"), options, formats, parts_list, steps)
    return Entry(figure, reader.text(own.get("caption", ""), f"{where}: caption"))
