"""What the kernel finds out of an illustration beside drawing it: the steps of an exploded view, its items."""

from ..errors import Failed, Refused
from .dimension import refused_of
from .explosion import taken
from .illustration import ask_to_end, make_job

# Keys about one sheet.
SHEET = "views", "projection", "details", "dimensions", "notes"


def steps_job(obj):
    """What is to be asked for ("steps"): steps that are there are left aside. Throws Refused."""
    job = make_job(obj)
    said = {key: value for key, value in job.options.get("illustration", {}).items() if key not in ("section", *SHEET)}
    said["explode"] = {"along": obj.ExplodeAlong} if obj.ExplodeAlong.strip() else "auto"
    job.options["illustration"] = said
    return job


def steps_in(job, answer):
    """Steps as the property has them, and messages, of what the kernel answered."""
    found, messages = answer
    return taken(found, [part.source for part in job.parts]), messages


def find_steps(obj):
    """The steps that take an illustration apart, and messages. Waits; changes nothing. Throws Refused, errors.Failed."""
    job = steps_job(obj)
    return steps_in(job, _asked(obj, "steps", job))


def items_job(obj):
    """What is to be asked for ("items"): items with the numbers that are kept, whether they are drawn or not. Throws Refused."""
    job = make_job(obj)
    job = job.without(refused_of(obj, job))
    return job.with_numbers(dict(obj.ItemNumbers))


def items_of(obj):
    """The items of an illustration, dicts with number, name, quantity, color and sources, the paths of their objects. Waits;
    changes nothing. Throws Refused, errors.Failed."""
    job = items_job(obj)
    return items_in(job, _asked(obj, "items", job))


def items_in(job, answer):
    """What the kernel answered, with the paths of objects."""
    return [{**item, "sources": [job.parts[k].source for k in item["parts"]]} for item in answer]


def _asked(obj, what, job):
    try:
        return ask_to_end(what, job)
    except Failed as error:
        raise Refused(f"{obj.Label}: {error}") from error
