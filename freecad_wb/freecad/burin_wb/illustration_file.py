"""Illustrations of documents as illustration files, which the command `burin draw` and the Python module draw:
`from freecad.burin_wb import illustration_file; illustration_file.write(obj, "pump.burin.json")`;
`illustration_file.read(document, path)` is the way back. Works without a GUI."""

import json
import os
import re
import tempfile
from dataclasses import replace

import FreeCAD

from . import item_numbers, kernel
from .errors import Refused
from .features.dimension import refused_of
from .features.illustration import make_job
from .features.styles import is_file
from .illustration_read import read  # noqa: F401  the way back
from .job import plainly, shortened
from .part_names import distinct
from .tell import NOTE, tell

SUFFIX = ".burin.json"


def write(obj, path):
    """Writes the illustration, and its parts as models into a folder beside: NAME.burin.json, NAME.models. Says what was left
    out. Throws Refused, OSError or errors.KernelMissing."""
    if not path.endswith(SUFFIX):
        raise Refused(f"{path}: illustration files end with {SUFFIX}; give it such a name")
    job = make_job(obj)
    refused = refused_of(obj, job)
    job.notes.extend(job.refusals(refused))
    job = job.without(refused)  # with them it would not be drawn
    burin = kernel.module()
    folder = os.path.basename(path)[: -len(SUFFIX)] + ".models"
    models = _Models(os.path.join(os.path.dirname(path), folder))
    names = distinct(part.name for part in job.parts)
    parts = []
    for part, name in zip(job.parts, names):
        file, place = models.of(part, name)
        parts.append({"file": f"{folder}/{file}", "name": name, **({"place": place} if place else {})})
    try:
        style = _style(burin, job.options["style"], job.options["set"])
        looks = [look for look in (_look(burin, part, name) for part, name in zip(job.parts, names)) if look]
    except burin.Error as error:  # a word that no style has
        raise Refused(str(error)) from error
    style["tone.light"] = list(job.options["light"])
    data = {"burin": "illustration", "version": 1, "title": obj.Label, "parts": parts, "view": _view(job.options),
            "paper": {"size": list(job.options["paper"]), "margin": job.options["margin"]}, "style": style}
    if looks:
        data["looks"] = looks
    try:
        data.update(_apart(burin, job, names))
    except burin.Error as error:  # a word that names nothing, a plane that is none
        raise Refused(plainly(error)) from error
    data["hidden"], data["seed"] = job.options["hidden"], job.options["seed"]
    if job.options["tolerance"]:
        data["tolerance"] = job.options["tolerance"]
    models.write()
    _write(path, (_text(data) + "\n").encode())
    tell(f"{obj.Label}: written to {path}" + ("; " + shortened(job.notes) if job.notes else ""), NOTE)


def _text(data):
    """JSON to be read and edited: lists without lists in one line."""
    return re.sub(r"\[\n([^][{}]*)\]", lambda match: "[" + " ".join(match.group(1).split()) + "]",
                  json.dumps(data, indent=2, ensure_ascii=False))


def _view(options):
    view = {"from": list(options["view"]), "up": list(options["up"])}
    if options["perspective"]:
        view["perspective"] = options["perspective"]
    if options["scale"]:
        view["scale"] = options["scale"]
    return view


def _style(burin, name, keys):
    """A built-in style with the keys that differ; of a style file all keys, so that the file need not be there. Keys of
    added strokes stay text."""
    values = burin.style({**burin.style(name), **keys})
    return values if is_file(name) else {"base": name, **{key: values.get(key, text) for key, text in keys.items()}}


def _look(burin, part, name):
    look = {key: getattr(part, key) for key, usual in (("drawn", True), ("hatched", True), ("transparent", False))
            if getattr(part, key) != usual}
    if part.style:
        look["style"] = _style_of_part(burin, part.style) if is_file(part.style) else part.style
    return {"select": "/" + name, **look} if look else None


def _style_of_part(burin, file):
    """All keys of a style file but those that hold for a whole drawing."""
    whole = {row["key"] for row in burin.style_keys(file) if row["scope"] == "drawing"}
    return {key: value for key, value in burin.style(file).items() if key not in whole}


def _apart(burin, job, names):
    """Keys about parts as an assembly: what they name is there under other names."""
    parts = [{"name": part.name, "assembly": part.assembly, "color": part.color, "source": part.source} for part in job.parts]

    def named(selectors):
        return ["/" + names[k] for k in sorted({k for one in selectors for k in burin.select(parts, one)})]

    def one(selector):
        found = named([selector])
        if len(found) > 1:
            job.notes.append(f"the note at {selector[1:]} points at {found[0][1:]} in the file, its first part")
        return found[0]

    said = job.options.get("illustration", {})
    data = {}
    if "section" in said:
        data["section"] = [{**one, "exclude": named(one["exclude"])} if "exclude" in one and not isinstance(one, str) else one
                           for one in said["section"]]
    if "explode" in said:
        data["explode"] = dict(said["explode"])
        if "steps" in data["explode"]:
            data["explode"]["steps"] = [{**step, "move": named(step["move"])} for step in data["explode"]["steps"]]
    data.update({key: said[key] for key in ("views", "projection") if key in said})
    if "details" in said:
        data["details"] = [{**one, "select": named(one["select"])} if "select" in one else one for one in said["details"]]
    data.update({key: [_measured(row, one) for row in said[key]] for key in ("dimensions", "notes") if key in said})
    if said.get("items"):
        data["items"] = _item_names(burin, job, names)
    data.update({key: job.options[key] for key in ("callouts", "parts_list", "legend") if key in job.options})
    return data


def _measured(said, named):
    """A dimension or a note with the names that its parts have in the file: `named(selector)`."""
    if isinstance(said, list):
        return [_measured(one, named) for one in said]
    if isinstance(said, dict):
        return {key: named(value) if key == "part" else _measured(value, named) for key, value in said.items()}
    return said


def _item_names(burin, job, names):
    """The kept numbers, by the names that items have where the parts have these names."""
    there = replace(job, parts=[replace(part, name=name, assembly=[]) for part, name in zip(job.parts, names)],
                    options={"callouts": True})
    called = {tuple(item["parts"]): item["name"] for item in there.items(burin)}
    kept = item_numbers.names_of(job.options["illustration"]["items"])
    kept.update((str(item["number"]), called[tuple(item["parts"])]) for item in job.items(burin) if tuple(item["parts"]) in called)
    return kept


class _Models:
    """The models of parts: one for all parts that are alike but for their place."""

    def __init__(self, folder):
        self._folder = folder
        self._files = {}  # name of a file -> what it holds
        self._known = {}  # BREP text, by its place in memory -> name of its file

    def of(self, part, name):
        """A part's file, and where it is to be placed."""
        if part.brep is None:
            return self._add(name, ".off", _off(part.vertices, part.triangles)), None
        place = _place(part.placement) if part.placement else None
        if id(part.brep) not in self._known:
            self._known[id(part.brep)] = self._add(name, ".brep", bytes(part.brep))
        return self._known[id(part.brep)], place

    def _add(self, name, suffix, data):
        file = f"{len(self._files) + 1}-{re.sub('[^A-Za-z0-9_-]+', '_', name)}{suffix}"
        self._files[file] = data
        return file

    def write(self):
        if not os.path.isdir(self._folder):
            os.mkdir(self._folder)
        for file, data in self._files.items():
            _write(os.path.join(self._folder, file), data)


def _place(numbers):
    """A rigid motion or a mirror image, 16 numbers row by row, as illustration files have it."""
    matrix = FreeCAD.Matrix(*numbers)
    if matrix.determinant() < 0:
        return {"matrix": [list(numbers[4 * row : 4 * row + 4]) for row in range(3)]}
    placement = FreeCAD.Placement(matrix)
    about_z, about_y, about_x = placement.Rotation.toEuler()
    place = {}
    if any(abs(a) > 1e-12 for a in (about_x, about_y, about_z)):
        place["rotate"] = [about_x, about_y, about_z]
    if placement.Base.Length > 0:
        place["translate"] = list(placement.Base)
    return place


def _off(vertices, triangles):
    rows = [f"OFF\n{len(vertices)} {len(triangles)} 0"]
    rows += ["%r %r %r" % tuple(v) for v in vertices.tolist()]
    rows += ["3 %d %d %d" % tuple(t) for t in triangles.tolist()]
    return ("\n".join(rows) + "\n").encode()


def _write(path, data):
    """Aside first: what is there is whole at any time."""
    handle, aside = tempfile.mkstemp(prefix=".burin-", dir=os.path.dirname(path) or ".")
    try:
        with os.fdopen(handle, "wb") as out:
            out.write(data)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(aside, 0o666 & ~mask)
        os.replace(aside, path)
    except BaseException:
        os.unlink(aside)
        raise
