"""What an illustration asks of its parts as an assembly: sections, an exploded view, numbers and a list; and of its sheet: several
views, details, dimensions, notes."""

from .. import item_numbers
from . import details, explosion, section


def options_of(obj, sources, rows, notes):
    """Keywords of burin.draw; only those that are asked for, so that drawings without them stay what they are. `sources`:
    paths of the parts; `rows`: what is measured and noted (dimension.rows_of). Throws Refused."""
    said = {}
    sections = section.for_kernel(obj, sources, notes)
    if sections:
        said["section"] = sections
    explode = explosion.for_kernel(obj, sources, notes)
    if explode is not None:
        said["explode"] = explode
    options = {}
    if obj.Callouts:
        options["callouts"] = True
    if obj.PartsList:
        options["parts_list"] = "sheet"
    if obj.Legend:
        options["legend"] = True
    if options and dict(obj.ItemNumbers):
        said["items"] = item_numbers.for_kernel(dict(obj.ItemNumbers))
    said.update(details.sheet_of(obj, sources, notes))
    if obj.Projection == "Perspective" and "views" not in said and any(map(section.view_of, sections)):
        notes.append(details.PARALLEL)
    said.update({key: [row for _, row in of] for key, of in rows.items() if of})
    if "views" in said or any(map(section.view_of, sections)):
        options["perspective"] = None
    if said:
        options["illustration"] = said
    return options
