"""One run of the kernel as plain data: taken from the document, run anywhere, brought back.

A Job holds no document objects, so it may go to a thread or another process."""

import hashlib
import re
from dataclasses import dataclass, field, fields
from typing import Any, Dict, List, Optional


# BREP text: a shape that was stored and read again differs in flags and in digits past the fifteenth.
_FLAGS = re.compile(rb"(?m)^[01]{7}$")
_NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:e[-+]?\d+)?")
_DECIMALS = 9  # of a mm: far below what is drawn, far above what storing changes


def canonical(brep):
    """BREP text without what does not belong to the shape: equal for shapes that draw the same."""
    import numpy

    text = _FLAGS.sub(b"", brep)
    numbers = numpy.array(_NUMBER.findall(text), dtype="S32").astype(float)
    return _NUMBER.sub(b"", text), (numpy.round(numbers, _DECIMALS) + 0.0).tobytes()


@dataclass
class PartJob:
    """One part. Either `brep` (text, exact) or `vertices` and `triangles` (numpy arrays)."""

    name: str
    source: str  # path of the object: "Assembly.Body" with the internal names
    brep: Optional[bytes] = None
    vertices: Any = None
    triangles: Any = None
    color: str = ""
    assembly: List[str] = field(default_factory=list)
    drawn: bool = True
    hatched: bool = True
    transparent: bool = False
    style: Optional[Any] = None


_SHAPE = {"brep", "vertices", "triangles"}


@dataclass
class Result:
    """What a run brings back."""

    drawing: bytes  # a drawing file (JSON)
    picture: bytes  # SVG, few elements
    scale: float
    messages: List[str]
    fingerprint: str


@dataclass
class Job:
    parts: List[PartJob]
    options: Dict[str, Any]  # keywords of burin.draw
    notes: List[str] = field(default_factory=list)  # what was left out, and why

    def exact_fingerprint(self):
        """The same for the same bytes of shapes, camera and style. Quick."""
        return self._hash(lambda brep: (brep,))

    def fingerprint(self):
        """The same also for shapes that were stored and read again. Cost: 0.1 s a megabyte of BREP text."""
        return self._hash(canonical)

    def _hash(self, of_brep):
        digest = hashlib.sha256(repr(sorted(self.options.items())).encode())
        for part in self.parts:
            said = [getattr(part, f.name) for f in fields(part) if f.name not in _SHAPE]
            digest.update(repr(said).encode())
            blocks = of_brep(part.brep) if part.brep is not None else (
                part.vertices.tobytes(), part.triangles.tobytes())
            for block in blocks:
                digest.update(len(block).to_bytes(8, "little"))
                digest.update(block)
        return digest.hexdigest()

    def draw(self, burin, progress=None, cancel=None):
        """Runs the kernel here. Returns a burin.Drawing; throws burin.Error."""
        scene = burin.Scene()
        for part in self.parts:
            common = dict(color=part.color, assembly=part.assembly, source=part.source)
            if part.brep is not None:
                made = scene.add_brep(part.brep, part.name, **common)
            else:
                made = scene.add_mesh(part.vertices, part.triangles, part.name, **common)
            for look in ("drawn", "hatched", "transparent", "style"):
                wanted = getattr(part, look)
                if wanted != getattr(PartJob, look):
                    setattr(made, look, wanted)
        return burin.draw(scene, progress=progress, cancel=cancel, **self.options)

    def run(self, burin, progress=None, cancel=None):
        """As `draw`, for the document."""
        drawing = self.draw(burin, progress, cancel)
        messages = [*self.notes, *(d.message for d in drawing.diagnostics)]
        return Result(drawing.to_bytes("json", json_points3=False), drawing.to_bytes("svg", svg_merge=True),
                      drawing.view.scale, messages, self.fingerprint())
