"""Planes that cut parts open, as the property Sections keeps them: an entry of an illustration file each, as JSON, or the text
of the option --section ("y", "-z=12")."""

import json

from ..errors import Refused
from .chosen import selectors


def entry_of(text, number=1):
    """What an illustration file would say: text, or a mapping. Throws Refused."""
    text = text.strip()
    if not text.startswith("{"):
        return text
    try:
        return json.loads(text)
    except ValueError as error:
        raise Refused(f"section {number} of the property Sections is no JSON ({error}); choose the plane again") from error


def text_of(entry):
    return entry if isinstance(entry, str) else json.dumps(entry, ensure_ascii=False)


def entries_of(obj):
    """All sections of an illustration. Throws Refused."""
    return [entry_of(text, number) for number, text in enumerate(obj.Sections, 1) if text.strip()]


def plane(normal, offset, exclude=()):
    """An entry of one plane: `normal` points to what is taken away, `offset` mm from the origin along it; `exclude`:
    paths or names of objects that stay whole."""
    entry = {"plane": {"normal": [float(n) for n in normal], "offset": float(offset)}}
    return {**entry, "exclude": list(exclude)} if exclude else entry


def excluded(entry):
    """Words for what stays whole."""
    words = entry.get("exclude", []) if isinstance(entry, dict) else []
    return [words] if isinstance(words, str) else list(words)


def for_kernel(obj, sources, notes):
    """Entries as the kernel takes them: objects by the numbers of their parts."""
    found = []
    for number, entry in enumerate(entries_of(obj), 1):
        words = excluded(entry)
        if words:
            chosen, lost = selectors(words, sources)
            if lost:
                notes.append(f"section {number} leaves {', '.join(lost)} whole, which is not drawn here; choose again what it leaves whole")
            entry = {key: value for key, value in entry.items() if key != "exclude"}
            if chosen:
                entry["exclude"] = chosen
        found.append(entry)
    return found
