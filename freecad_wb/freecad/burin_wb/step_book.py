"""How an assembly is put together, a page a step, as a file: `from freecad.burin_wb import step_book;
step_book.write(obj, "pump.pdf", "pump.html")`. Works without a GUI."""

import os
from dataclasses import replace

from . import item_numbers
from .errors import Failed, Refused
from .features import section
from .features.asking import SHEET
from .features.details import PARALLEL
from .features.explosion import steps_for_kernel
from .features.illustration import ask_to_end, make_job
from .job import shortened
from .tell import NOTE, WARNING, tell

# What they are, by their endings.
KINDS = {".pdf": "PDF", ".html": "HTML", ".md": "Markdown"}

NEW_ITEMS = 6  # that a step adds at the most, where nothing is said


def check(files, new_items):
    """Throws Refused."""
    for file in files:
        if os.path.splitext(file)[1] not in KINDS:
            raise Refused(f"{file}: a step book is a file that ends with {', '.join(KINDS)}; give it such a name")
    if not files:
        raise Refused("a step book needs a file to be written to")
    if new_items < 1:
        raise Refused("a step of a step book adds one item at the least")


def job_of(obj, files, new_items=NEW_ITEMS):
    """What the kernel is to do ("book"), by the illustration's own steps where it has some, whether they are drawn or not, else by
    steps that are found; with its view, sheet, style, looks and numbers. Throws Refused."""
    check(files, new_items)
    job = make_job(obj)
    said = {key: value for key, value in job.options.get("illustration", {}).items() if key not in SHEET}
    if "section" in said:
        said["section"] = [one for one in said["section"] if not section.view_of(one)]
    said["title"] = obj.Label
    said["explode"] = steps_for_kernel(obj, [part.source for part in job.parts], job.notes)
    if dict(obj.ItemNumbers):
        said["items"] = item_numbers.for_kernel(dict(obj.ItemNumbers))
    perspective = obj.FieldOfView.Value if obj.Projection == "Perspective" else None
    options = {**job.options, "illustration": said, "scale": None, "perspective": perspective}
    options.pop("parts_list", None)  # it is the last page
    notes = [note for note in job.notes if note != PARALLEL]
    return replace(job, options=options, notes=notes, book=([os.path.abspath(file) for file in files], new_items))


def write(obj, *files, new_items=NEW_ITEMS):
    """Writes NAME.pdf, NAME.html or NAME.md, all of them or none; of Markdown the pictures beside it. Waits; changes nothing. Returns
    how many steps there are. Throws Refused."""
    job = job_of(obj, files, new_items)
    try:
        answer = ask_to_end("book", job)
    except Failed as error:
        raise Refused(f"{obj.Label}: {error}") from error
    written(obj.Label, files, answer)
    return answer[0]


def written(label, files, answer):
    """Tells of the end."""
    steps, messages = answer
    text = f"{label}: step book written to {', '.join(files)}; steps: {steps}"
    tell("; ".join([text, *([shortened(messages)] if messages else [])]), WARNING if messages else NOTE)
