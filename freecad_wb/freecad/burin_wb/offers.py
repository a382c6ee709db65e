"""What the kernel offers: options, names of formats, styles, views, sheets. Menus, properties and FreeCAD's start know them without
loading the kernel, from a file that its own module told (tools/offers.py; a test compares them)."""

import functools
import json
import os

PATH = os.path.join(os.path.dirname(__file__), "resources", "offers.json")


# Options of a drawing whose words, range or default the workbench takes over.
_OPTIONS = ("hidden", "perspective", "style")


def asked(burin):
    """What a kernel offers, of its module."""
    catalogues = burin.catalogues()
    options = {row["name"]: row for row in catalogues["options"]}
    return {
        "options": {name: {k: options[name][k] for k in ("words", "low", "high", "default") if k in options[name]}
                    for name in _OPTIONS},
        "formats": burin.formats(),
        "stages": catalogues["stages"],  # of a run, as progress names them
        "styles": burin.styles(),  # with what they are for
        "views": {name: [_rounded(direction), _rounded(up)] for name, (direction, up) in burin.views().items()},
        "papers": {name: list(size) for name, size in burin.papers().items()},  # width and height in mm
        "symbols": _symbols(burin),  # of notes, with the words of their options, by their keys
        "groups": list(dict.fromkeys(row["key"].partition(".")[0] for row in burin.style_keys())),  # of style keys
    }


def _symbols(burin):
    rows = json.loads(burin.illustration_schema())["properties"]["notes"]["items"]["anyOf"]
    keys = next(row["properties"] for row in rows if "properties" in row)
    return {name: {key: row["enum"] for key, row in keys.items() if key.startswith(name + "_") and "enum" in row} for name in keys["symbol"]["enum"]}


def _rounded(vector):
    """Without the last digits, which may be others on another machine."""
    return [round(x, 12) for x in vector]


@functools.lru_cache(maxsize=None)
def kept():
    """What the kernel offers that the add-on was made with."""
    with open(PATH, encoding="utf-8") as file:
        return json.load(file)


# The kernel's names are what one types.
_TITLES = {"iso": "Isometric"}


def title(view):
    """A standard view's name as menus have it, in English."""
    return _TITLES.get(view, view.capitalize())
