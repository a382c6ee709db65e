"""What two drawings, parts lists and step books have in common, as far as `burin diff` does not tell it."""

import difflib
import itertools
import json
import re
from pathlib import Path
from typing import Any

from .figures import Page

# Paper mm. Widths of strokes swell by a law of tone: they are looked at as a whole, the least and the largest of a layer.
_WIDTH = 0.01
# Steps move when others come or go.
_NUMBER = re.compile(r"^Step \d+(: )?")


def looks(path: Path) -> dict[str, dict[str, Any]]:
    """By layer of a drawing file, what its lines look like; by "" what the sheet does."""
    drawing = json.loads(path.read_text(encoding="utf-8"))
    sheet = drawing["paper"]
    size = f"{sheet['width']:g} x {sheet['height']:g} mm"
    found: dict[str, dict[str, Any]] = {"": {"ink": sheet.get("ink_color"), "color": sheet.get("sheet_color"), "size": size}}
    for layer in drawing["layers"]:
        widths = [w for line in layer.get("paths", []) for w in line.get("width", [])]
        found[layer["name"]] = {
            "color": layer.get("color"),
            "dashes": layer.get("dashes"),
            "width": [min(widths), max(widths)] if widths else None,
        }
    return found


def look_words(old: Path, new: Path) -> list[str]:
    """What differs of lines that are the same: widths, colours and dashes of layers, and the sheet."""
    before, after = looks(old), looks(new)
    words = []
    for layer in sorted(before.keys() & after.keys()):
        for key, was in before[layer].items():
            now = after[layer][key]
            if not _equal(was, now):
                words.append(f"{layer or 'sheet'}: {key} {_text(was)} to {_text(now)}")
    return words


def _equal(was: Any, now: Any) -> bool:
    if isinstance(was, list) and isinstance(now, list):
        return len(was) == len(now) and all(abs(a - b) <= _WIDTH for a, b in zip(was, now))
    return bool(was == now)


def _text(value: Any) -> str:
    if isinstance(value, list) and len(value) == 2 and value[0] == value[1]:
        return f"{value[0]:g} mm"
    if isinstance(value, list):
        return "..".join(f"{v:g}" for v in value) + " mm"
    return "none" if value is None else str(value)


def list_words(old: list[dict[str, Any]], new: list[dict[str, Any]]) -> list[str]:
    """What differs of two parts lists, by names."""

    def rows(items: list[dict[str, Any]]) -> dict[str, tuple[Any, Any]]:
        return {str(item["name"]): (item["number"], item["quantity"]) for item in items}

    before, after = rows(old), rows(new)
    words = [f"parts list: {name} is new, {after[name][1]} x" for name in after if name not in before]
    words += [f"parts list: {name} is gone" for name in before if name not in after]
    for name in (n for n in after if n in before):
        for what, was, now in zip(("number", "quantity"), before[name], after[name]):
            if was != now:
                words.append(f"parts list: {name}: {what} {was} to {now}")
    return words


def _key(page: Page) -> tuple[str, ...]:
    """What a step says but for its number."""
    return (_NUMBER.sub("", page.heading), *(f"{part['quantity']} x {part['name']}" for part in page.added))


def paired(old: list[Page], new: list[Page]) -> list[tuple[Page | None, Page | None]]:
    """Steps of two step books that mean each other; None for one that is new, or gone."""
    matcher = difflib.SequenceMatcher(None, [_key(p) for p in old], [_key(p) for p in new], autojunk=False)
    pairs: list[tuple[Page | None, Page | None]] = []
    for _, i, j, k, m in matcher.get_opcodes():
        pairs += itertools.zip_longest(old[i:j], new[k:m])
    return pairs


def step_words(old: Page, new: Page) -> list[str]:
    """What differs of what two steps say."""
    before, after = _key(old), _key(new)
    words = []
    if old.heading != new.heading:
        words.append(f"was '{old.heading}'" if before[0] != after[0] else f"was {old.heading.partition(':')[0]}")
    words += [f"adds {part}" for part in after[1:] if part not in before[1:]]
    return words + [f"no longer adds {part}" for part in before[1:] if part not in after[1:]]
