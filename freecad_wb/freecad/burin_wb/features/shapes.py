"""Shapes as BREP text for the kernel: each written once, however many objects, links and runs use it."""

import collections
import itertools

import FreeCAD
import Part

from ..job import Brep

# Bytes of text that are kept for the next run.
MOST = 256 * 2**20

# How far the axes of a placement may be from unit length and right angles for a rigid motion.
RIGID = 1e-9


class Shapes:
    """Text by the shape it is of. FreeCAD does not change shapes but makes new ones, so what is kept stays true. The
    shapes are held: their place in memory tells which they are."""

    def __init__(self):
        self._kept = collections.OrderedDict()  # (document, path) -> (shape without its placement, its text)
        self._alike = {}  # _key of a shape -> places in _kept of what has it: looking at all of them takes time by the square
        self.written = 0  # texts so far

    def text(self, shape, place):
        """The text of a shape without its placement, and the placement as 16 numbers (nothing where the text has it).
        `place`: names of the document and of the path in it. Cost where it is new: 40 ms a megabyte."""
        base, placement = _apart(shape)
        brep = self._find(base, place)
        if brep is None:
            brep = Brep(base.exportBrepToString().encode())
            self.written += 1
        self._drop(place)
        self._kept[place] = base, brep
        self._alike.setdefault(_key(base), {})[place] = None
        return brep, placement

    def has(self, shape, place):
        """Whether the text of a shape is there already."""
        return self._find(_apart(shape)[0], place) is not None

    def _find(self, base, place):
        here = [place] if place in self._kept else []
        for known_at in itertools.chain(here, self._alike.get(_key(base), ())):
            known, brep = self._kept[known_at]
            if known.isPartner(base) and known.Orientation == base.Orientation:
                return brep
        return None

    def _drop(self, place):
        if place not in self._kept:
            return
        key = _key(self._kept.pop(place)[0])
        places = self._alike[key]
        del places[place]
        if not places:
            del self._alike[key]

    def trim(self):
        """Forgets the oldest beyond MOST bytes. Called between jobs, so that no job writes what it has just written."""
        size = sum({id(brep): len(brep) for _, brep in self._kept.values()}.values())
        while size > MOST:
            place, (_, brep) = next(iter(self._kept.items()))
            self._drop(place)
            size -= len(brep)

    def forget(self, document):
        """Lets go of the shapes of a document that is closed, by its name."""
        for key in [k for k in self._kept if k[0] == document]:
            self._drop(key)


shapes = Shapes()


def _key(base):
    """The same for shapes that are partners. Of what the shape is made of, for its own hash depends on its location, too, which is
    another object each time that a placement is set."""
    inside = base.childShapes(False, False)
    return inside[0].hashCode() if inside else 0


def _apart(shape):
    """A shape without its placement, and that. Scaled shapes stay whole."""
    numbers = shape.Matrix.A
    if not _is_rigid(numbers):
        return shape, None
    base = Part.Shape(shape)
    base.Placement = FreeCAD.Placement()
    return base, tuple(numbers)


def _is_rigid(a):
    rows = a[0:3], a[4:7], a[8:11]
    return all(abs(sum(x * y for x, y in zip(rows[i], rows[k])) - (i == k)) <= RIGID for i in range(3) for k in range(3))
