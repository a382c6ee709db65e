"""What has changed of a book, told: a page, a few lines of Markdown, data."""

import contextlib
import dataclasses
import html
import json
from pathlib import Path
from typing import Any
from urllib.parse import quote

from burin.batch.files import write_whole

from .compare import ADDED, CHANGED, FAILED, REMOVED, SAME, WHOLE, Compared, PageChange
from .markdown import plain

# What a reader looks for comes first.
_ORDER = (FAILED, CHANGED, ADDED, REMOVED, SAME)
_FILES = ("index.html", "differences.md", "differences.json")
# Lines of Markdown: a comment has room for 65,536 letters, and readers for fewer.
_ROWS, _LINES, _LETTERS = 60, 4, 160
_SIDES = {"old": "old revision", "new": "new revision", "difference": "both revisions"}
_STYLE = """
:root { color-scheme: light dark; font: 15px/1.45 system-ui, sans-serif; }
body { margin: 1.5rem auto; max-width: 78rem; padding: 0 1rem; }
h1 { font-size: 1.4rem; margin: 0 0 .3rem; } h2 { font-size: 1.15rem; margin: 0; display: inline; } h3 { font-size: 1rem; margin: 1rem 0 .3rem; }
.about { opacity: .75; } .about span { margin-right: 1.2rem; } .note { border-left: 3px solid #d90; padding-left: .6rem; }
nav { margin: .8rem 0 1.2rem; } nav a { margin-right: .8rem; white-space: nowrap; }
section { border: 1px solid #8886; border-radius: 6px; padding: .8rem 1rem; margin: 0 0 1rem; }
.kind { font-size: .8rem; font-weight: 600; color: #fff; border-radius: 3px; padding: .1rem .45rem; margin-right: .5rem; vertical-align: 2px; }
.failed .kind, .kind.failed { background: #a2211f; } .changed .kind, .kind.changed { background: #8a5a00; } .added .kind, .kind.added { background: #00702a; }
.removed .kind, .kind.removed { background: #b00000; } .same .kind, .kind.same { background: #667; }
ul { margin: .5rem 0; padding-left: 1.2rem; } li { overflow-wrap: anywhere; }
.three { display: grid; grid-template-columns: 1fr 1fr; gap: .6rem; } .three .wide { grid-column: 1 / -1; }
figure { margin: 0; border: 1px solid #8884; border-radius: 4px; overflow: hidden; background: #fff; }
figure img { display: block; width: 100%; max-height: 34rem; object-fit: contain; }
figcaption { font-size: .8rem; padding: .25rem .5rem; background: #8882; color: #333; } figcaption a { color: #0645ad; }
figure.none { display: grid; place-items: center; min-height: 6rem; background: none; opacity: .6; font-size: .85rem; }
details > summary { cursor: pointer; }
@media (max-width: 45rem) { .three { grid-template-columns: 1fr; } }
"""


@dataclasses.dataclass
class Differences:
    """All of a book, in its order, those that are gone last."""

    title: str
    # The revisions in words.
    old: str
    new: str
    program: str
    notes: list[str]
    figures: list[Compared]

    def counts(self) -> dict[str, int]:
        return {status: sum(f.status == status for f in self.figures) for status in _ORDER}

    def summary(self) -> str:
        told = [f"{count} {status}" for status, count in self.counts().items() if count]
        return f"{len(self.figures)} figure{'s' * (len(self.figures) != 1)}: {', '.join(told)}" if told else "no figures"

    def sorted(self) -> list[Compared]:
        return sorted(self.figures, key=lambda f: _ORDER.index(f.status))


def lines_of(figure: Compared) -> list[str]:
    """What there is to say of a figure, in plain words."""
    lines = _errors(figure) + figure.models + figure.words
    for shown in _steps(figure):
        rest = f": {'; '.join(shown.words)}" if shown.words else ""
        lines.append(f"{shown.heading} {shown.status}{rest}")
    return lines


def brief(figure: Compared) -> str:
    """The same in one line."""
    words = _errors(figure)
    parts = [f"{count} {kind}" for kind, count in figure.parts.items() if count and kind != SAME]
    if parts:
        words.append(f"parts: {', '.join(parts)}")
    steps = [s.status for s in _steps(figure)]
    if steps:
        words.append("steps: " + ", ".join(f"{steps.count(status)} {status}" for status in _ORDER if status in steps))
    words += figure.words[:_LINES] + ["..."] * (len(figure.words) > _LINES)
    return "; ".join(words)


def _errors(figure: Compared) -> list[str]:
    return [f"{_SIDES[side]}: {what}" for side, what in figure.errors.items()]


def _steps(figure: Compared) -> list[PageChange]:
    """Those that are not the same."""
    return [s for s in figure.shown if s.heading and s.status != SAME and s.heading != WHOLE]


def forget(folder: Path) -> None:
    """Removes what an earlier comparison told: it is not to be taken for this one, if this one fails."""
    for name in _FILES:
        with contextlib.suppress(OSError):
            (folder / name).unlink()


def write_all(differences: Differences, folder: Path) -> None:
    """index.html, differences.md and differences.json. Throws BatchError."""
    texts = (page_of(differences), markdown_of(differences), json.dumps(data_of(differences), indent=1, ensure_ascii=False) + "\n")
    for name, text in zip(_FILES, texts):
        write_whole(folder / name, text)


def data_of(d: Differences) -> dict[str, Any]:
    head = {"format": "burin-book-differences", "version": 1, "generator": f"burin {d.program}", "title": d.title, "old": d.old, "new": d.new}
    return {**head, "notes": d.notes, "counts": d.counts(), "figures": [dataclasses.asdict(f) for f in d.figures]}


def markdown_of(d: Differences) -> str:
    """Short: for a comment in a merge request, or the summary of a job."""
    title = f"Drawings of {d.title}" if d.title else "Drawings"
    out = f"### {plain(title)}: {d.summary().partition(': ')[2] or d.summary()}\n\n{plain(d.old)} → {plain(d.new)}\n"
    out += "".join(f"\n> {plain(note)}\n" for note in d.notes)
    told = [f for f in d.sorted() if f.status != SAME]
    if told:
        out += "\n| figure | | what |\n| --- | --- | --- |\n"
        out += "".join(f"| {plain(f.name)} | {f.status} | {_cell(lines_of(f))} |\n" for f in told[:_ROWS])
    if len(told) > _ROWS:
        out += f"\n... and {len(told) - _ROWS} more: see the page\n"
    same = [plain(f.name) for f in d.figures if f.status == SAME]
    if same:
        out += f"\nSame: {', '.join(same[:_ROWS])}{', ...' if len(same) > _ROWS else ''}\n"
    return out


def _cell(lines: list[str]) -> str:
    short = [line if len(line) <= _LETTERS else line[: _LETTERS - 3] + "..." for line in lines[:_LINES]]
    return "<br>".join([plain(line) for line in short] + [f"and {len(lines) - _LINES} more"] * (len(lines) > _LINES))


def page_of(d: Differences) -> str:
    """A page that needs nothing but the pictures beside it."""
    title = html.escape(f"Drawings of {d.title}" if d.title else "Drawings")
    out = [
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">',
        f"<title>{title}: {html.escape(d.summary())}</title><style>{_STYLE}</style></head><body>",
        f"<h1>{title}</h1>",
        f'<div class="about"><span>{html.escape(d.old)} → {html.escape(d.new)}</span><span>burin {html.escape(d.program)}</span></div>',
        *(f'<p class="note">{html.escape(note)}</p>' for note in d.notes),
        f"<p>{html.escape(d.summary())}</p><nav>",
        *(f'<a href="#{_anchor(f)}">{html.escape(f.name)}</a>' for f in d.sorted() if f.status != SAME),
        "</nav>",
        *(_section(f) for f in d.sorted()),
        "</body></html>\n",
    ]
    return "\n".join(out)


def _anchor(figure: Compared) -> str:
    return "figure-" + quote(figure.name, safe="").replace("%", "_")


def _section(figure: Compared) -> str:
    head = f'<span class="kind">{figure.status}</span><h2>{html.escape(figure.name)}</h2> {html.escape(figure.caption)}'
    words = _errors(figure) + figure.models + figure.words
    body = _list(words) + "".join(_shown(s, figure.status) for s in figure.shown)
    if figure.status == SAME:
        inside = f"<details><summary>{head}</summary>{body}</details>"
    else:
        inside = head + body
    return f'<section class="{figure.status}" id="{_anchor(figure)}">{inside}</section>'


def _list(words: list[str]) -> str:
    return "<ul>" + "".join(f"<li>{html.escape(line)}</li>" for line in words) + "</ul>" if words else ""


def _shown(shown: PageChange, status: str) -> str:
    """Pictures; of what is the same one, of a step its heading, too."""
    kind = f'<span class="kind {shown.status}">{shown.status}</span>' if shown.heading != WHOLE else ""
    out = f"<h3>{kind}{html.escape(shown.heading)}</h3>{_list(shown.words)}" if shown.heading else _list(shown.words)
    if shown.status == SAME:
        return f"<details><summary>{out}</summary>{_pictures([('', shown.new, '')])}</details>" if shown.heading and status != SAME else out + _pictures([("", shown.new, "")])
    pictures = [("what has changed", shown.difference, shown.page)] if shown.difference else []
    if shown.old or shown.new:
        pictures += [("old", shown.old, ""), ("new", shown.new, "")]
    return out + _pictures(pictures)


def _pictures(pictures: list[tuple[str, str, str]]) -> str:
    out = ""
    for words, picture, page in pictures:
        wide = " class='wide'" if words in ("", "what has changed") else ""
        if not picture:
            out += f'<figure class="none">no picture of the {words} revision</figure>'
            continue
        more = f' · <a href="{quote(page)}">parts, old and new to switch</a>' if page else ""
        caption = f"<figcaption>{words}{more}</figcaption>" if words else ""
        out += f'<figure{wide}><a href="{quote(picture)}"><img loading="lazy" alt="{words}" src="{quote(picture)}"></a>{caption}</figure>'
    return f'<div class="three">{out}</div>'
