"""One run of the kernel as plain data: taken from the document, run anywhere, brought back.

A Job holds no document objects, so it may go to a thread or another process."""

import hashlib
import pickle
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional


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


@dataclass
class Result:
    """What a run brings back."""

    drawing: bytes  # a drawing file (JSON)
    picture: bytes  # SVG, few elements
    scale: float
    messages: List[str]


@dataclass
class Job:
    parts: List[PartJob]
    options: Dict[str, Any]  # keywords of burin.draw
    notes: List[str] = field(default_factory=list)  # what was left out, and why

    def fingerprint(self):
        """The same for the same shapes, camera and style."""
        return hashlib.sha256(pickle.dumps((self.parts, self.options), protocol=4)).hexdigest()

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
                      drawing.view.scale, messages)
