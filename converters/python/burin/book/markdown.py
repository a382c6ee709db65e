"""Figures as fragments of Markdown: what MkDocs, GitBuilding and plain Markdown include."""

import re
from urllib.parse import quote

from .figures import Made
from .toml_book import Entry


def plain(text: str) -> str:
    """A name as text, also in a table."""
    return re.sub(r"([\\`*_{}\[\]<>#|])", r"\\\1", " ".join(text.split()))


def picture(link: str, name: str, words: str) -> str:
    return f"![{plain(words)}]({link}{quote(name)})\n"


def parts_list(items: list[dict[str, object]]) -> str:
    lines = ["| No. | Qty | Name |", "| ---: | ---: | --- |"]
    lines += [f"| {item['number']} | {item['quantity']} | {plain(str(item['name']))} |" for item in items]
    return "\n".join(lines) + "\n"


def fragment(entry: Entry, made: Made, link: str) -> str:
    """A figure with its caption and parts list, or the steps of a step book."""
    caption = entry.caption
    if entry.figure.steps is None:
        out = picture(link, made.pictures[0], caption or entry.figure.name)
        if caption:
            out += f"\n*{plain(caption)}*\n"
        return out + ("\n" + parts_list(made.items) if made.items else "")
    out = f"*{plain(caption)}*\n\n" if caption else ""
    for page in made.pages:
        out += f"### {plain(page.heading)}\n\n"
        for part in page.added:
            number = f" ({part['item']})" if part["item"] else ""
            out += f"- {part['quantity']} x {plain(str(part['name']))}{number}\n"
        out += "\n" + picture(link, page.pictures[0], page.heading) + "\n"
    return out + (parts_list(made.items) if made.items and entry.figure.parts_list else "")


def whole(title: str, fragments: list[str]) -> str:
    return (f"# {plain(title)}\n\n" if title else "") + "\n".join(fragments)
