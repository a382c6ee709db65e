"""`draw` with its keywords spelled out, so that `help`, `inspect` and editors show them: they are made from what the
kernel says of its options."""

import inspect

from ._burin import catalogues
from ._burin import draw as _draw

_TYPES = {"number": "float", "whole": "int", "flag": "bool", "word": "str", "direction": "Sequence[float]", "text": "str"}
# What is no option of the command: functions of the program that calls.
_CALLS = {
    "field": ("Callable[[_Array, _Array], _Array]", "gives the directions that strokes follow"),
    "tone": ("Callable[[_Array, _Array], _Array]", "gives the wanted darkness"),
    "progress": ("Progress", "is called with the stage and the share of it that is done"),
    "cancel": ("Cancel", "ends the run when it is set"),
    "session": ("Session", "keeps what the next drawing of the same scene may use again"),
    "illustration": ("Mapping[str, Any]", "the keys of an illustration file except parts: section, explode, items, looks ..."),
}
_ABOUT = """Draws a scene, a file, several files, or an illustration: a file NAME.burin.json or a mapping as it holds.
Keywords are the long options of `burin draw`, and six more.

`style` as a mapping is that of a style file ({"base": "engraving", "line.outer": 0.5}); `set` overrides single keys,
or groups of them ({"hatch": {"taper": 1}}). `paper` is a name, (width, height) in mm or "fit"; `margin` one number or
(top, right, bottom, left). `field` and `tone` are called with positions (n, 3) in mm and unit normals (n, 3), from the
thread that called: `field` gives directions (n, 3), whose tangent parts strokes follow (NaN = none here), `tone` the
wanted darkness (n,) in [0, 1]. `illustration` takes what options have no room for; options hold over it. Keywords about reading are for files; for a scene they go to `Scene.read`. The GIL is
released while the kernel works. Throws Error.

"""


def _default(option):
    text = option["default"]
    if not text:
        return None
    if option["kind"] == "flag":
        return text == "true"
    try:
        return float(text) if "." in text else int(text)
    except ValueError:
        return text


def _keywords():
    for option in catalogues()["options"]:
        default = _default(option)
        kind = option["python"] or _TYPES[option["kind"]]
        yield option["name"], kind if default is not None else kind + " | None", default, option["meaning"]
    for name, (kind, meaning) in _CALLS.items():
        yield name, kind + " | None", None, meaning


# Each keyword of `draw`: (name, type as text, default, meaning).
KEYWORDS = tuple(_keywords())


def draw(source, **keywords):
    return _draw(source, **keywords)


draw.__module__ = "burin"
draw.__doc__ = _ABOUT + "\n".join(f"{name}: {meaning}" for name, _, _, meaning in KEYWORDS) + "\n"
draw.__signature__ = inspect.Signature(
    [inspect.Parameter("source", inspect.Parameter.POSITIONAL_OR_KEYWORD)]
    + [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default)
        for name, _, default, _ in KEYWORDS
    ]
)
