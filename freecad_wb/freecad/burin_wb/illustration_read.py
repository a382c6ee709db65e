"""New illustrations from illustration files: the objects of the document that a file names, with its looks, light, view,
sheet and style. Works without a GUI."""

import os

import FreeCAD

from . import kernel, preferences
from .errors import Refused
from .features import details, make_illustration, section
from .features.dimension_entries import add_entries
from .features.explosion import Step
from .features.looks import with_flag, with_style
from .features.properties import CENTRE_LINES
from .features.sources import survey
from .job import shortened
from .match_parts import match
from .part_names import plain
from .tell import NOTE, tell

# Flags of looks by the keys of files: the word, and the value at which it is said.
_FLAGS = {"drawn": ("not drawn", False), "hatched": ("not hatched", False), "transparent": ("transparent", True)}
MOST_SEED = 2**31 - 1


def read(document, path):
    """A new illustration in `document` as the file says, of objects that are there. Says what the document lacks and what
    illustrations of documents have no property for. No transaction, no recompute. Throws Refused or
    errors.KernelMissing, and leaves the document as it was then."""
    burin = kernel.module()
    try:
        told = burin.illustration(path)
        matches, notes = match(burin, document, told["parts"])
        _refuse_none(path, matches)
        notes += _missing(matches)
        values = {**_view(told, notes), **_sheet(told, notes), **_style(burin, told, notes),
                  "Looks": _looks(burin, told["looks"], matches, notes), **_apart(burin, told, matches, notes)}
    except burin.Error as error:
        text = str(error)
        raise Refused(text if path in text else f"{path}: {text}") from error
    obj = make_illustration(document, _sources(matches))
    for name, value in values.items():
        setattr(obj, name, value)
    if told["title"]:
        obj.Label = told["title"]
    selectable = [pair for one in matches for pair in one.selectable()]
    add_entries(obj, told, lambda selector, what: _selected(burin, [selector], selectable, notes, what), notes)
    tell(f"{obj.Label}: made from {path}" + "".join("; " + note for note in notes), *(() if notes else (NOTE,)))
    return obj


def _called(one):
    return f"'{one.name}' ({os.path.basename(one.part['file']) or 'a function'})"


def _refuse_none(path, matches):
    if not any(one.found for one in matches):
        names = shortened([_called(one) for one in matches], ", ")
        raise Refused(f"{path}: the document has no object of the file's parts, which are {names}; import these models first "
                      "(File > Import), and label them so")


def _missing(matches):
    lacking = [_called(one) for one in matches if one.found is None]
    if not lacking:
        return []
    return [f"the document lacks {shortened(lacking, ', ')}: import and label these models so, and make the illustration anew"]


def _sources(matches):
    """What is drawn, in the order of the file; an outermost assembly where all that it shows is in the file."""
    found = [one.found for one in matches if one.found]
    paths = {piece.part.source for one in found for piece in one.pieces}
    whole, sources = {}, []
    for one in found:
        if one.top.Name not in whole:
            pieces, _ = survey([(one.top, ("",))])
            shown = [piece.part.source for piece in pieces]
            whole[one.top.Name] = bool(shown) and paths.issuperset(shown) and _all_below(one.top, found, set(shown))
        sub = "" if whole[one.top.Name] else one.sub
        if (one.top, (sub,)) not in sources:
            sources.append((one.top, (sub,)))
    return sources


def _all_below(top, found, shown):
    """Whether an assembly shows all that is drawn of it: hidden objects are drawn only where they are named."""
    return all(piece.part.source in shown for one in found if one.top is top for piece in one.pieces)


def _view(told, notes):
    view = told["view"]
    values = {"ViewDirection": FreeCAD.Vector(*view["from"]), "ViewUp": FreeCAD.Vector(*view["up"]),
              "Projection": "Orthographic" if view["perspective"] is None else "Perspective",
              "FitScale": view["scale"] in (None, "iso")}
    if view["perspective"] is not None:
        values["FieldOfView"] = view["perspective"]
    if view["scale"] == "iso":
        notes.append("view.scale: the drawing fills the sheet here, or has a number")
    elif view["scale"] is not None:
        values["Scale"] = view["scale"]
    if view["center"] is not None:
        notes.append("view.center: the drawing is in the middle of the sheet here")
    return values


def _sheet(told, notes):
    size, margins = told["paper"]["size"], told["paper"]["margin"]
    values = {"Margin": max(margins), "HiddenLines": told["hidden"].capitalize(), "Tolerance": told["tolerance"] or 0.0,
              "Seed": min(told["seed"], MOST_SEED)}
    if min(margins) != max(margins):
        notes.append(f"paper.margin: one for all sides here, {max(margins):g} mm is taken")
    if told["seed"] > MOST_SEED:
        notes.append(f"seed: {MOST_SEED} at most here, which is taken")
    if told["title_block"] is not None:
        notes.append("title_block: the template of a page has it here")
    if told["breaks"]:
        notes.append("breaks: no property here leaves stretches of long parts out; views show them whole")
    if size == "fit":
        size = preferences.sheet()
        notes.append("paper.size: no sheet fits itself to the drawing here, {:g} x {:g} mm of new illustrations are taken"
                     .format(*size))
    values["Width"], values["Height"] = size
    return values


def _style(burin, told, notes):
    """The style by name, by its file or as the built-in one that it differs least from; the light; keys that differ."""
    style = told["style"]
    if isinstance(style, str):
        name = style if style in burin.styles() else os.path.abspath(style)
        keys = {}
    else:
        name, keys = _nearest(burin, style)
    keys.update(_lights(burin, told, notes))
    drawn = keys.get(CENTRE_LINES) in ("true", True)
    if drawn:
        del keys[CENTRE_LINES]  # it has a property
    return {"Style": name, "StyleKeys": keys, "CentreLines": drawn, "Light": FreeCAD.Vector(*told["light"])}


def _keys(burin, style):
    return {key["key"]: key["value"] for key in burin.style_keys(style)}


def _nearest(burin, style):
    """A built-in style and the keys, as text, by which `style` differs from it, but for the light."""
    wanted = _keys(burin, style)
    start, keys = _closest(burin, wanted, [{"base": name, "tone.light": wanted["tone.light"]} for name in burin.styles()])
    kinds = [row["name"] for row in burin.catalogues()["stroke_kinds"]]
    for head in sorted({".".join(key.split(".")[:2]) for key in keys if key.startswith("strokes.")}):
        if head + ".enabled" not in _keys(burin, start):
            start, keys = _closest(burin, wanted, [{**start, head + ".kind": kind} for kind in kinds])
    keys.update({key: value for key, value in start.items() if key.endswith(".kind")})
    return start["base"], keys


def _closest(burin, wanted, starts):
    """Of mappings as style files have them the one that needs the fewest further keys, and these."""
    found = []
    for start in starts:
        known = _keys(burin, start)
        if known.keys() <= wanted.keys():  # strokes that the style has not cannot be taken away
            found.append((start, {key: value for key, value in wanted.items() if known.get(key) != value}))
    return min(found, key=lambda one: len(one[1]))


def _lights(burin, told, notes):
    """Keys of the style that are the same as a light from a direction and an ambient one; others are left out."""
    lights = told["lights"]
    if not lights:
        return {}
    ways = [light for light in lights if "from" in light]
    left = len(lights) - len(ways[:1]) - sum("ambient" in light for light in lights)
    if left:
        notes.append(f"lights: one from a direction and the ambient ones are taken here, {left} left out")
    if any(look["style"] is not None for look in told["looks"]):
        notes.append("lights: they do not reach parts with a style of their own here")
    keys = {"tone.ambient": sum(light.get("ambient", 0.0) for light in lights), "tone.diffuse": ways[0]["strength"] if ways else 0.0}
    for key in (key for key in burin.style_keys() if key["key"] in keys):
        name, most = key["key"], key["high"]
        if keys[name] > most:
            notes.append(f"lights: {name} is {most:g} at most here, which is taken for {keys[name]:g}")
        keys[name] = min(keys[name], most)
    return {name: repr(value) for name, value in keys.items()}


def _looks(burin, looks, matches, notes):
    """Paths of objects to words."""
    selectable = [pair for one in matches for pair in one.selectable()]
    words, said = {}, []
    for look in looks:
        style = _style_of_look(burin, look, said)
        if look["listed"] is False:
            said.append(f"look of {', '.join(look['select'])}: objects of FreeCAD are all listed; \"listed\" is left out")
        for path in _selected(burin, look["select"], selectable, said):
            text = words.get(path, "")
            for key, (flag, at) in _FLAGS.items():
                if look[key] is not None:
                    text = with_flag(text, flag, look[key] is at)
            words[path] = with_style(text, style) if style else text
    if said:
        notes.append(shortened(said))
    return {path: text for path, text in words.items() if text}


def _apart(burin, told, matches, notes):
    """Sections, the exploded view and numbers; what they select by the paths of objects."""
    selectable = [pair for one in matches for pair in one.selectable()]
    said = []

    def paths(selectors, what):
        return _selected(burin, [selectors] if isinstance(selectors, str) else selectors, selectable, said, what)

    values = {"Callouts": told["callouts"], "PartsList": told["parts_list"], "Legend": told["legend"], "Explode": told["explode"] is not None,
              "Sections": [section.text_of(_section(one, paths)) for one in told["sections"]],
              "ItemNumbers": _item_numbers(told["items"], selectable), "Views": told["views"],
              "ProjectionMethod": next(word for word, kernels in details.METHODS.items() if kernels == told["projection"]),
              "Details": _details(told["details"], paths, notes)}
    if values["Explode"]:
        values.update(_explode(told["explode"], paths, notes))
    if said:
        notes.append(shortened(said))
    return values


def _section(entry, paths):
    if isinstance(entry, str) or "exclude" not in entry:
        return entry
    return {**entry, "exclude": paths(entry["exclude"], "section")}


def _details(entries, paths, notes):
    """Texts of the property; details of which the document has nothing are told."""
    found = []
    for number, entry in enumerate(entries, 1):
        entry = details.entry_of(entry if isinstance(entry, str) else details.text_of(entry), number)
        if "select" in entry:
            entry["select"] = paths(entry["select"], "detail")
            if not entry["select"]:
                notes.append(f"detail {number}: the document has nothing that it shows, so it is left out")
                continue
        found.append(details.text_of(entry))
    return found


def _explode(entry, paths, notes):
    if not isinstance(entry, dict):
        entry = {"along": entry}
    steps = [Step.of({**step, "move": moved}) for step in entry.get("steps", ()) for moved in [paths(step["move"], "explode")] if moved]
    along = entry.get("along", "")
    along = along if isinstance(along, str) else ",".join(f"{number:g}" for number in along)
    left = [key for key in ("base", "fit") if key in entry]
    if left:
        notes.append(f"explode: {' and '.join(left)}: no property here has that; find the steps with burin illustrate and read its file")
    if "steps" in entry and not steps:
        notes.append("explode: the document has nothing that its steps move, so nothing comes apart")
    return {"Explode": bool(steps) or "steps" not in entry, "ExplodeSteps": [step.text() for step in steps], "ExplodeFactor": float(entry.get("factor", 1.0)),
            "ExplodeAlong": "" if along == "auto" else along}


def _item_numbers(items, selectable):
    """Numbers with the names that the document has."""
    labels = {plain(part["name"]): part["name"] for part, path in selectable if path}
    return {str(number): labels.get(name, name) for number, name in items.items()}


def _style_of_look(burin, look, said):
    style = look["style"]
    if style is None:
        return ""
    if isinstance(style, str):
        return style if style in burin.styles() else os.path.abspath(style)
    name, keys = _nearest(burin, style)
    if keys:
        said.append(f"look of {', '.join(look['select'])}: its own style has no name, so it is left out; save it as a style file "
                    "and name that")
    return "" if keys else name


def _selected(burin, selectors, selectable, said, what="look"):
    """Paths of the objects that any of the selectors names."""
    found = {}
    for selector in selectors:
        try:
            numbers = burin.select([part for part, _ in selectable], selector)
        except burin.UsageError as error:
            said.append(f"{what}: {error}")
            continue
        found.update({selectable[number][1]: None for number in numbers if selectable[number][1]})
    return list(found)
