"""What is drawn: one page of thumbnails, failures first, and one hash of the whole catalogue."""

import dataclasses
import hashlib
import html
import json
import os
import urllib.parse
from pathlib import Path
from typing import Any

from .files import write_whole
from .jobs import Batch, Drawing, Job
from .progress import duration
from .runner import clashing
from .state import State

# What browsers show as a picture, the best first.
_PICTURES = (".svg", ".png")
_STYLE = """
:root { color-scheme: light dark; font: 15px/1.4 system-ui, sans-serif; }
body { margin: 1.5rem; }
h1 { font-size: 1.4rem; margin: 0 0 .3rem; } h2 { font-size: 1.1rem; margin: 1.6rem 0 .5rem; }
code { font-size: .85rem; overflow-wrap: anywhere; }
input { font: inherit; padding: .3rem .5rem; width: 20rem; max-width: 100%; margin-top: .8rem; }
.all { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: .8rem; }
figure { margin: 0; border: 1px solid #8886; border-radius: 4px; overflow: hidden; content-visibility: auto; contain-intrinsic-size: 13rem 12rem; }
figure img { display: block; width: 100%; height: 9.5rem; object-fit: contain; background: #fff; }
figure .none { display: grid; place-items: center; height: 9.5rem; opacity: .6; }
figcaption { padding: .35rem .5rem; font-size: .8rem; overflow-wrap: anywhere; border-top: 1px solid #8886; }
figcaption small { opacity: .7; }
.failed { border-collapse: collapse; width: 100%; } .failed td { padding: .3rem .6rem; border-top: 1px solid #8886; vertical-align: top; overflow-wrap: anywhere; }
.failed tr > :first-child { border-left: 3px solid #c33; } .failed td:first-child { width: 28%; } .kind { color: #c33; font-weight: 600; white-space: nowrap; }
[hidden] { display: none !important; }
"""
_SCRIPT = """
const all = [...document.querySelectorAll("[data-name]")];
document.querySelector("input").addEventListener("input", e => {
  const words = e.target.value.toLowerCase().split(/\\s+/).filter(Boolean);
  for (const one of all) one.hidden = !words.every(w => one.dataset.name.includes(w));
  for (const part of document.querySelectorAll("section"))
    part.hidden = !part.querySelector("[data-name]:not([hidden])");
});
"""


@dataclasses.dataclass
class Summary:
    """What became of all drawings of a catalogue."""

    drawn: list[tuple[Job, Drawing, dict[str, Any]]]
    failed: list[tuple[Job, Drawing, dict[str, Any]]]
    left: list[tuple[Job, Drawing]]
    hash: str = ""

    def line(self) -> str:
        words = f"{len(self.drawn)} drawn, {len(self.failed)} failed"
        return words + (f", {len(self.left)} not drawn yet" if self.left else "")


def summary_of(batch: Batch) -> Summary:
    """Looks at each record and at the bytes of each output; what does not agree counts as not drawn. Cost: reading all outputs."""
    state = State(batch.out, batch.base)
    clashes = clashing(batch)
    summary = Summary([], [], [])
    for job, drawing in batch.drawings():
        record = state.record(drawing.id)
        if drawing.name in clashes:
            summary.failed.append((job, drawing, {"error": {"kind": "clash", "message": clashes[drawing.name]}}))
        elif record and "error" in record:
            summary.failed.append((job, drawing, record))
        elif record and sorted(record["outputs"]) == sorted(drawing.files()) and _all_there(state, record):
            summary.drawn.append((job, drawing, record))
        else:
            summary.left.append((job, drawing))
    summary.hash = hash_of(summary)
    return summary


def _all_there(state: State, record: dict[str, Any]) -> bool:
    return all(state.holds(name, *known) for name, known in record["outputs"].items())


def hash_of(summary: Summary) -> str:
    """SHA-256 over a line an output, sorted: its name and the SHA-256 of its bytes, or its name and the kind of the failure."""
    lines = [json.dumps([name, known]) for _, _, record in summary.drawn for name, (_, known) in record["outputs"].items()]
    lines += [json.dumps([name, "failed", record["error"]["kind"]]) for _, drawing, record in summary.failed for name in drawing.files()]
    return hashlib.sha256("".join(line + "\n" for line in sorted(lines)).encode()).hexdigest()


def write_page(summary: Summary, batch: Batch, path: Path) -> None:
    """Writes the page, whole or not at all. Throws BatchError."""
    write_whole(path, page_of(summary, batch, path.parent))


def page_of(summary: Summary, batch: Batch, folder: Path) -> str:
    """The page as it stands in a folder."""
    took = sum(record["seconds"] for _, _, record in summary.drawn)
    size = sum(n for _, _, record in summary.drawn for n, _ in record["outputs"].values())
    out = [
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">',
        f"<title>Catalogue: {html.escape(summary.line())}</title><style>{_STYLE}</style></head><body>",
        f"<h1>{html.escape(summary.line())}</h1>",
        f"<div>{len(batch.jobs)} parts, {duration(took)} of drawing, {_size(size)}, burin {html.escape(batch.program)}</div>",
        f"<div>hash <code>{summary.hash}</code></div>",
        '<input type="search" placeholder="part, view, style, kind" aria-label="Find">',
    ]
    if summary.failed:
        out.append('<section><h2>Failed</h2><table class="failed">')
        out += [_failure(job, drawing, record["error"]) for job, drawing, record in summary.failed]
        out.append("</table></section>")
    if summary.left:
        out.append('<section><h2>Not drawn yet</h2><table class="failed">')
        out += [_failure(job, drawing, {"kind": "", "message": ""}) for job, drawing in summary.left]
        out.append("</table></section>")
    if summary.drawn:
        out.append('<section><h2>Drawn</h2><div class="all">')
        out += [_figure(job, drawing, record, batch.out, folder) for job, drawing, record in summary.drawn]
        out.append("</div></section>")
    return "\n".join([*out, f"<script>{_SCRIPT}</script></body></html>\n"])


def _size(count: float) -> str:
    for unit in ("bytes", "kB", "MB"):
        if count < 1000:
            return f"{count:.3g} {unit}"
        count /= 1000
    return f"{count:.3g} GB"


def _words(job: Job, drawing: Drawing, more: str = "") -> str:
    words = [job.part, *drawing.files(), *(t for texts in drawing.options.values() for t in texts), more]
    return html.escape(" ".join(words).lower())


def _failure(job: Job, drawing: Drawing, error: dict[str, str]) -> str:
    kind, message = html.escape(error["kind"]), html.escape(error["message"])
    name = html.escape(drawing.name)
    return f'<tr data-name="{_words(job, drawing, error["kind"])}"><td>{name}</td><td class="kind">{kind}</td><td>{message}</td></tr>'


def _figure(job: Job, drawing: Drawing, record: dict[str, Any], out: Path, folder: Path) -> str:
    links = {name: urllib.parse.quote(os.path.relpath(out / name, folder)) for name in drawing.files()}
    pictures = [name for suffix in _PICTURES for name in links if name.lower().endswith(suffix)]
    first = pictures[0] if pictures else drawing.files()[0]
    shown = f'<img loading="lazy" alt="" src="{links[first]}">' if pictures else f'<span class="none">{html.escape(Path(first).suffix[1:])}</span>'
    files = " ".join(f'<a href="{link}">{html.escape(name)}</a>' for name, link in links.items())
    warned = [d["message"] for d in record["diagnostics"] if d["severity"] != "info"]
    title = f' title="{html.escape("; ".join(warned))}"' if warned else ""
    note = f"{record['seconds']:.2f} s" + (f", {len(warned)} warnings" if warned else "")
    return (
        f'<figure data-name="{_words(job, drawing)}"><a href="{links[first]}">{shown}</a>'
        f"<figcaption{title}>{files}<br><small>{html.escape(note)}</small></figcaption></figure>"
    )
