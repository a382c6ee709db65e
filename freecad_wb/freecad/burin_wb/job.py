"""One run of the kernel as plain data: taken from the document, run anywhere, brought back.

A Job holds no document objects, so it may go to a thread or another process."""

import concurrent.futures
import hashlib
import re
import time
import traceback
from dataclasses import dataclass, field, fields, replace
from typing import Any, Dict, List, Optional, Tuple

from . import item_numbers
from .kept_scene import KeptScene

# What there is to say of parts and notes may be long; this many are shown.
SHOWN = 6


def shortened(texts, between="; "):
    shown = between.join(texts[:SHOWN])
    return shown if len(texts) <= SHOWN else f"{shown}{between}and {len(texts) - SHOWN} more"


# BREP text: storing a shape changes flags and digits past the fifteenth, showing it in 3-D adds curves in the
# parameter planes of flat faces; neither changes what is drawn.
_FLAGS = re.compile(rb"(?m)^[01]{7}$\n?")
_ON_SURFACES = re.compile(rb"(?m)^[23](?: +\S+){5,} *\n")
_NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
_DECIMALS = 9  # of a mm below a metre, and as many digits more or less elsewhere: far below what is drawn


def essence(brep):
    """BREP text without what comes and goes with the shape unchanged. Quick: 2 to 6 ms a megabyte."""
    head, _, tail = brep.partition(b"\nTShapes ")
    first, last = head.find(b"\nCurve2ds "), head.find(b"\nCurves ")
    if 0 <= first < last:
        head = head[:first] + head[last:]
    return head + _ON_SURFACES.sub(b"", _FLAGS.sub(b"", tail))


def _rounded(numbers):
    import numpy

    size = numpy.maximum(numpy.abs(numbers), 1.0)
    step = 10.0 ** (numpy.maximum(numpy.floor(numpy.log10(size)) - 2, 0) - _DECIMALS)
    return (numpy.round(numbers / step) + 0.0).tobytes()


def canonical(brep):
    """BREP text as blocks that are equal also for a shape that was stored and read again."""
    import numpy

    text = essence(brep)
    numbers = numpy.array(_NUMBER.findall(text), dtype="S32").astype(float)
    return _NUMBER.sub(b"", text), _rounded(numbers)


def _digits(value):
    """Options as text, without the digits that storing may change."""
    if isinstance(value, float):
        return "%.12g" % (value + 0.0)
    if isinstance(value, (tuple, list)):
        return "(" + ",".join(_digits(v) for v in value) + ")"
    if isinstance(value, dict):
        return "{" + ",".join(f"{k!r}:{_digits(v)}" for k, v in sorted(value.items())) + "}"
    return repr(value)


class Brep(bytes):
    """BREP text that parts share, in as many places as there are instances: pickled once, read once, hashed once."""

    digest = None

    def exact(self):
        if self.digest is None:
            self.digest = hashlib.sha256(essence(self)).digest()
        return self.digest


@dataclass
class PartJob:
    """One part. Either `brep` (text, exact) or `vertices` and `triangles` (numpy arrays)."""

    name: str
    source: str  # path of the object: "Assembly.Body" with the internal names
    brep: Optional[bytes] = None
    vertices: Any = None
    triangles: Any = None
    placement: Optional[Tuple[float, ...]] = None  # where `brep` is: 16 numbers of a rigid motion, row by row
    color: str = ""
    opacity: float = 1.0  # below 1 what is behind shows through
    face_colors: Tuple[str, ...] = ()  # of each face of `brep`, where they differ, of glass with its opacity
    threads: Tuple[Dict[str, Any], ...] = ()  # as burin.Part has them
    assembly: List[str] = field(default_factory=list)
    definition: str = ""  # the name of what it is an instance of
    drawn: bool = True
    hatched: bool = True
    transparent: bool = False
    style: Optional[Any] = None

    def matrix(self):
        """The placement as the kernel takes it: four rows, or nothing."""
        return None if self.placement is None else [self.placement[4 * row : 4 * row + 4] for row in range(4)]


_SHAPE = {"brep", "vertices", "triangles", "placement"}
# Fields of later versions: drawings that are stored stay up to date where these say nothing.
_LATER = {"face_colors", "opacity", "threads"}

# Seconds after which no further shape is looked at for faults.
LOOK = 10.0


@dataclass
class Result:
    """What a run brings back."""

    drawing: Optional[bytes]  # a drawing file (JSON); nothing where the kept one is the same (Job.unless)
    picture: Optional[bytes]  # SVG, few elements
    scale: float
    messages: List[str]  # of the kernel
    fingerprint: str
    numbers: Dict[str, str] = field(default_factory=dict)  # of all items, kept ones among them; nothing where none were asked for
    left: Dict[str, str] = field(default_factory=dict)  # names of dimensions and notes that the kernel does not draw, and why


UNCHANGED = Result(None, None, 0.0, [], "")


def _place(placement):
    import numpy

    return b"" if placement is None else _rounded(numpy.array(placement))


@dataclass
class Job:
    parts: List[PartJob]
    options: Dict[str, Any]  # keywords of burin.draw
    notes: List[str] = field(default_factory=list)  # what was left out, and why
    files: Dict[str, str] = field(default_factory=dict)  # style files with the hashes of what they hold
    unless: str = ""  # nothing is drawn where this is the fingerprint
    # Names of dimensions of features and of notes, in order: their key in illustrations, and their label.
    measured: Dict[str, Tuple[str, str]] = field(default_factory=dict)
    left: Dict[str, str] = field(default_factory=dict)  # names of others that are left out, and why
    book: Tuple[List[str], int] = ([], 0)  # of a step book: files that are written, new items of a step at the most

    def exact_fingerprint(self):
        """The same for the same shapes, camera and style while a document is open. Quick."""
        return self._hash(lambda brep: (brep.exact() if isinstance(brep, Brep) else essence(brep),),
                          lambda vertices: vertices.tobytes(), repr, lambda place: repr(place).encode())

    def fingerprint(self, kept=None):
        """The same also for documents that were stored and read again. Cost: 0.1 s a megabyte of BREP text that the last
        job (`kept`) did not have."""
        if kept is None:
            return self._hash(canonical, _rounded, _digits, _place)
        kept.forget_others(self)
        return self._hash(lambda brep: kept.canonical(brep, canonical), _rounded, _digits, _place)

    def _hash(self, of_brep, of_vertices, of_option, of_place):
        said = [(name, of_option(value)) for name, value in sorted(self.options.items())]
        digest = hashlib.sha256(repr((said, sorted(self.files.items()))).encode())
        blocks_of = {}
        for part in self.parts:
            said = [getattr(part, f.name) for f in fields(part) if f.name not in _SHAPE | _LATER]
            said += [part.face_colors] if part.face_colors else []
            said += [part.opacity] if part.opacity < 1 else []
            said += [part.threads] if part.threads else []
            digest.update(repr(said).encode())
            if part.brep is not None:
                if id(part.brep) not in blocks_of:
                    blocks_of[id(part.brep)] = of_brep(part.brep)
                blocks = (of_place(part.placement), *blocks_of[id(part.brep)])
            else:
                blocks = of_vertices(part.vertices), part.triangles.tobytes()
            for block in blocks:
                digest.update(len(block).to_bytes(8, "little"))
                digest.update(block)
        return digest.hexdigest()

    def draw(self, burin, progress=None, cancel=None, kept=None):
        """Runs the kernel here. Returns a burin.Drawing; throws burin.Error. `kept`: what the last job left (KeptScene)."""
        kept = kept or KeptScene(burin)
        scene = kept.scene(self, cancel)
        return burin.draw(scene, session=kept.session, progress=progress, cancel=cancel, **self.options)

    def with_numbers(self, numbers):
        """The same job where items have these numbers."""
        said = {**self.options.get("illustration", {}), "items": item_numbers.for_kernel(numbers)}
        return replace(self, options={**self.options, "illustration": said})

    def _numbers(self, found):
        """All that are kept, and those of items."""
        return item_numbers.kept(item_numbers.names_of(self.options.get("illustration", {}).get("items", {})), found)

    def steps(self, burin, progress=None, cancel=None, kept=None):
        """The steps of an exploded view, as burin.explode_steps gives them, and messages."""
        kept = kept or KeptScene(burin)
        found = burin.explode_steps(kept.scene(self, cancel), progress=progress, cancel=cancel, **self.options)
        return found["steps"], [plainly(d.message) for d in found["diagnostics"]]

    def items(self, burin, progress=None, cancel=None, kept=None):
        """The items, as burin.items gives them."""
        kept = kept or KeptScene(burin)
        return burin.items(kept.scene(self, cancel), progress=progress, cancel=cancel, **self.options)

    def write_book(self, burin, progress=None, cancel=None, kept=None):
        """Draws a step book and writes its files, all or none: how many steps it has, and messages."""
        files, new_items = self.book
        kept = kept or KeptScene(burin)
        book = burin.steps(kept.scene(self, cancel), new_items=new_items, progress=progress, cancel=cancel, **self.options)
        if cancel is not None and cancel.cancelled:
            raise burin.Cancelled("cancelled")
        book.save(*files)
        return len(book.pages), [*self.notes, *(plainly(d.message) for d in book.diagnostics)]

    def is_drawn(self):
        """Whether the kept drawing is the one of this job."""
        return bool(self.unless) and self.unless == self.fingerprint()

    def faults(self, burin, progress=None, cancel=None):
        """Words for a message: which parts have shapes that OCCT itself finds faulty; empty where none. Slow."""
        found, looked, begin = [], {}, time.monotonic()
        for k, part in enumerate(self.parts):
            if cancel is not None and cancel.cancelled:
                raise burin.Cancelled("cancelled")
            if part.brep is None or not part.drawn:
                continue
            if progress is not None:
                progress("check", k / len(self.parts))
            if id(part.brep) not in looked:
                if time.monotonic() - begin > LOOK:
                    found.append("(not all were looked at)")
                    break
                try:
                    looked[id(part.brep)] = burin.Brep(part.brep).is_valid()
                except burin.Error:
                    looked[id(part.brep)] = False
            if not looked[id(part.brep)]:
                found.append(part.name)
        return "; faulty shapes (see Part > Check geometry): " + shortened(found, ", ") if found else ""

    def told(self, text):
        """What the kernel says, `plainly`, with the labels of dimensions and notes for their numbers."""
        return _NUMBERED.sub(lambda said: self.measured.get(self._name(said), ("", said.group(0)))[1], plainly(text))

    def _name(self, said):
        """Of a dimension or a note by its number; empty where there is none."""
        names = [name for name, (key, _) in self.measured.items() if key == said.group(1) + "s"]
        return names[int(said.group(2)) - 1] if 0 < int(said.group(2)) <= len(names) else ""

    def _rows(self):
        """(name, key, row) of each dimension and each note; those without a name measure no features."""
        for key in ("dimensions", "notes"):
            names = iter([name for name, (of, _) in self.measured.items() if of == key])
            for row in self.options.get("illustration", {}).get(key, ()):
                yield "" if isinstance(row, str) else next(names), key, row

    def without(self, names):
        """The same job without some of its dimensions of features and notes."""
        if not names:
            return self
        said = {key: value for key, value in self.options.get("illustration", {}).items() if key not in ("dimensions", "notes")}
        for name, key, row in self._rows():
            if name not in names:
                said.setdefault(key, []).append(row)
        options = {**self.options, "illustration": said}
        if not said:
            del options["illustration"]
        return replace(self, options=options, measured={name: of for name, of in self.measured.items() if name not in names})

    def refusals(self, left):
        """What there is to say of dimensions and notes that the kernel does not draw."""
        return [f"{self.measured[name][1]} is not drawn: {why}" for name, why in left.items()]

    def draw_rest(self, burin, progress=None, cancel=None, kept=None):
        """As `draw`, without the dimensions and notes that the kernel refuses: the drawing, the job that has it, and why others are left out,
        by their names. One more run for each of those; they are few."""
        job, left = self, {}
        while True:
            try:
                return job.draw(burin, progress, cancel, kept), job, left
            except burin.Error as error:
                name, why = job._refused(burin, plainly(error))
                if not name:
                    raise
                left[name] = why
                job = job.without({name})

    def _refused(self, burin, text):
        """The name of the dimension or the note for whose sake nothing is drawn, and why; empty where it is for another reason."""
        said = _REFUSED.match(text)
        if said:
            return self._name(said), said.group(3)
        # Of what no row may say the kernel tells a line of a file; a row alone is refused by its own fault.
        for name, key, row in self._rows():
            try:
                burin.illustration({"burin": "illustration", "parts": [{"file": "any.step"}], key: [row]})
            except burin.UsageError as error:
                return name, plainly(error)
        return "", ""

    def run(self, burin, progress=None, cancel=None, kept=None):
        """As `draw`, for the document."""
        if self.is_drawn():
            return UNCHANGED
        with concurrent.futures.ThreadPoolExecutor(1) as beside:  # the kernel works without the interpreter
            fingerprint = beside.submit(self.fingerprint, kept)
            drawing, drawn, left = self.draw_rest(burin, progress, cancel, kept)
            messages = [*self.refusals(left), *(drawn.told(d.message) for d in drawing.diagnostics)]
            numbers = self._numbers(drawing.items)
            if numbers != self._numbers(()):
                fingerprint.result()
                fingerprint = beside.submit(self.with_numbers(numbers).fingerprint, kept)
            return Result(drawing.to_bytes("json", json_points3=False), drawing.to_bytes("svg", svg_merge=True),
                          drawing.view.scale, messages, fingerprint.result(), numbers, left)


# What the kernel calls a dimension or a note.
_NUMBERED = re.compile(r"\b(dimension|note) (\d+)(?: \([a-z]+\))?")

# How it says that it draws nothing for the sake of one.
_REFUSED = re.compile(_NUMBERED.pattern + r": (.*)", re.DOTALL)


def plainly(text):
    """What the kernel says, without the place in what it was asked by, which is no file, and with the words of panels for options."""
    return str(text).replace("illustration:1: ", "").replace("section_exclude none cuts", "Cut in the panel Section cuts")


# What may be asked of a job.
_WORK = {"draw": Job.run, "steps": Job.steps, "items": Job.items, "book": Job.write_book}


def answer(what, job, burin, progress, cancel, kept=None):
    """Does a job here: ("done", result), ("cancelled", nothing) or ("failed", text). `kept`: what the last job left."""
    try:
        if what == "check":
            return "done", job.faults(burin, progress, cancel)
        try:
            return "done", _WORK[what](job, burin, progress, cancel, kept)
        except (burin.GeometryError, burin.InputError) as error:  # it may be the fault of the shapes
            return "failed", job.told(error) + job.faults(burin, progress, cancel)
    except burin.Cancelled:
        return "cancelled", None
    except burin.Error as error:
        return "failed", job.told(error)
    except Exception as error:  # a mistake of ours: told, and the worker lives on
        traceback.print_exc()
        return "failed", f"the drawing kernel failed: {error!r}"
