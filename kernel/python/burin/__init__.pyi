"""Line art from CAD parts, meshes, functions and volumes.

Lengths of models are millimetres; lengths on the sheet are millimetres of paper, origin bottom left,
y up; angles are degrees. Arrays are numpy arrays, float64 unless said.
"""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any

from numpy.typing import NDArray

_Array = NDArray[Any]

__version__: str

class Error(Exception):
    """What all errors of this module are."""

class UsageError(Error, ValueError):
    """An argument or option that makes no sense."""

class InputError(Error):
    """A file that is missing, broken or empty. Attributes: file (str), line (int, 0 = unknown)."""

    file: str
    line: int

class MissingFile(InputError, FileNotFoundError):
    """An input that is not there, also a FileNotFoundError."""

class GeometryError(Error):
    """A shape that cannot be drawn."""

class OutputError(Error, OSError):
    """A file that cannot be written. Attribute: file (str)."""

    file: str

class Cancelled(Error):
    """The run was cancelled."""

class Cancel:
    """A flag that ends runs; may be set from any thread."""

    def cancel(self) -> None: ...
    @property
    def cancelled(self) -> bool: ...

Progress = Callable[[str, float], Any]
"""Called with the stage's name and the share done in [0, 1], at most every 20 ms, with the GIL held,
from the thread that called. An exception in it ends the run and is passed on."""

class Part:
    name: str
    source: str
    color: str
    assembly: list[str]
    drawn: bool
    hatched: bool
    transparent: bool
    style: dict[str, Any] | None
    """Part's own style, as `style` of `draw` takes it; None = that of the drawing."""

class Brep:
    """A shape as OCCT writes it in text or binary, read once: the parts that are made of it share it."""

    def __init__(self, brep: str | bytes) -> None: ...
    def is_valid(self) -> bool:
        """Whether OCCT finds nothing wrong with it. Slow: for messages about what cannot be drawn."""

class Scene:
    """What is drawn: parts in order."""

    def __init__(self) -> None: ...
    def __len__(self) -> int: ...
    @staticmethod
    def read(
        *paths: str | PathLike[str],
        bounds: Sequence[float] | None = None,
        progress: Progress | None = None,
        cancel: Cancel | None = None,
        **options: Any,
    ) -> Scene:
        """Files, by their formats. `options` are the long options of the command line that concern
        reading, with underscores."""
    def add_brep(
        self,
        brep: str | bytes | Brep,
        name: str = "",
        *,
        placement: _Array | Sequence[Sequence[float]] | None = None,
        color: str = "",
        assembly: Sequence[str] = (),
        source: str = "",
    ) -> Part:
        """A shape as OCCT writes it in text (FreeCAD: `shape.exportBrepToString()`), or a `Brep`, which
        all parts made of it share. `placement` is a 4 x 4 matrix of a rigid motion (row major, acts on columns). One part, whatever its solids; faces
        and edges are numbered as in the shape (TopExp order), from 0."""
    def add_mesh(
        self,
        vertices: _Array,
        triangles: _Array,
        name: str = "",
        *,
        color: str = "",
        assembly: Sequence[str] = (),
        source: str = "",
    ) -> Part:
        """`vertices` (n, 3), `triangles` (m, 3) of any integer type; repaired as files are."""
    def add_function(
        self,
        values: Callable[[_Array], _Array],
        bounds: Sequence[float],
        name: str = "",
        *,
        gradients: Callable[[_Array], _Array] | None = None,
        hessians: Callable[[_Array], _Array] | None = None,
        samples: int = 192,
    ) -> Part:
        """The zero set of a function, negative inside, clipped by `bounds`: `values` takes points (n, 3)
        and gives (n,). What is drawn is the cubic spline through `samples` points along the longest side
        of the bounds and as many to the mm along the others, so that the function is called once a plane
        of them; kernel/docs/python.md says how near that is. samples=0 asks the function itself, and
        `gradients` (n, 3) and `hessians` (n, 3, 3) where given (else central differences), for every
        point: slow."""
    def add_implicit(
        self, text: str, name: str = "", *, bounds: Sequence[float] | None = None
    ) -> Part:
        """A function as text, as in `.implicit` files."""
    @property
    def parts(self) -> list[Part]: ...
    def bounds(self) -> _Array:
        """(2, 3): least and greatest coordinates."""
    @property
    def diagnostics(self) -> list[Diagnostic]: ...

class Diagnostic:
    @property
    def severity(self) -> str:
        """"info", "warning" or "error"."""
    @property
    def code(self) -> str:
        """Stable, e.g. "mesh.nonmanifold_edges"."""
    @property
    def count(self) -> int:
        """How often it occurred."""
    @property
    def message(self) -> str:
        """One sentence."""

class Path:
    """One line of ink."""

    def __len__(self) -> int: ...
    @property
    def kind(self) -> str:
        """contour, boundary, crease, smooth, seam, intersection, stroke ..."""
    @property
    def visible(self) -> bool:
        """False where it is dashed."""
    @property
    def part(self) -> int:
        """Number of the part."""
    @property
    def face(self) -> int:
        """Number of the face in the part, -1 = none."""
    @property
    def edge(self) -> int:
        """Number of the edge in the part, -1 = none."""
    @property
    def closed(self) -> bool:
        """Whether the last point joins the first, which is not repeated."""
    @property
    def field(self) -> str:
        """Strokes: the direction field ("own" = that of the caller), else empty."""
    @property
    def family(self) -> int:
        """Strokes: 1 or 2, the family in the field, else 0."""
    @property
    def points(self) -> _Array:
        """(n, 2) mm of paper."""
    @property
    def points3(self) -> _Array:
        """(n, 3) mm of the model."""
    @property
    def width(self) -> _Array:
        """(1,) or (n,) mm of paper."""

class Layer:
    """Paths that are drawn together."""

    def __len__(self) -> int: ...
    @property
    def name(self) -> str:
        """Its name in files."""
    @property
    def paths(self) -> list[Path]:
        """The paths, in the order in which they are drawn."""

class View:
    """How the sheet was seen."""

    @property
    def projection(self) -> str:
        """"orthographic" or "perspective"."""
    @property
    def direction(self) -> _Array:
        """(3,) unit vector from the model to the viewer."""
    @property
    def right(self) -> _Array:
        """(3,) what points right on the sheet."""
    @property
    def up(self) -> _Array:
        """(3,) what points up on it."""
    @property
    def scale(self) -> float:
        """Paper mm a model mm (perspective: in the plane through `center`)."""
    @property
    def center(self) -> _Array:
        """(3,) the model point at `offset`, in mm."""
    @property
    def offset(self) -> _Array:
        """(2,) mm of paper."""
    @property
    def eye(self) -> _Array:
        """(3,) the viewer's place in mm; perspective only."""
    @property
    def field_of_view(self) -> float:
        """Vertical, in degrees; 0 = orthographic."""
    def project(self, points: _Array) -> _Array:
        """(n, 3) of the model to (n, 2) of the sheet."""

class Drawing:
    @property
    def layers(self) -> list[Layer]: ...
    @property
    def diagnostics(self) -> list[Diagnostic]: ...
    @property
    def parts(self) -> list[dict[str, Any]]: ...
    @property
    def view(self) -> View: ...
    @property
    def paper(self) -> tuple[float, float]: ...
    @property
    def style(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def stats(self) -> dict[str, Any]:
        """"triangles", "strokes", "coverage_points", "coverage_delta"; where `verify` was asked for, "verify":
        {"spans", "length", "contradicted", "share", "count", "loose_ends", "contradictions": [{"what", "kind",
        "part", "face", "edge", "length", "at", "model"}, ...]}, lengths and `at` in mm of the sheet."""
    def arrays(self) -> dict[str, _Array]:
        """All paths as few arrays, for programs that show them: "points" (N, 2), "points3" (N, 3),
        "width" (N,), and a path: "first" (P + 1,) index of its first point, "layer", "kind", "part",
        "face", "edge", "family", "visible", "closed" (P,); "kinds" and "layers" are lists of names."""
    def save(self, path: str | PathLike[str], **options: Any) -> None:
        """Writes a file whole or not at all; the suffix names the format. `options`: the format's keys
        with underscores, e.g. svg_flatten=True, png_dpi=300, and id_prefix."""
    def to_bytes(self, format: str, **options: Any) -> bytes: ...
    @staticmethod
    def load(path: str | PathLike[str]) -> Drawing:
        """A drawing file (JSON)."""
    @staticmethod
    def from_json(text: str | bytes) -> Drawing: ...

def draw(
    source: str | PathLike[str] | Scene | Sequence[str | PathLike[str]],
    *,
    view: str | Sequence[float] = "iso",
    up: Sequence[float] | None = None,
    perspective: float | None = None,
    paper: str | Sequence[float] = "A4",
    scale: float | str | None = None,
    margin: float | Sequence[float] = 10,
    style: str | PathLike[str] | Mapping[str, Any] = "technical",
    set: Mapping[str, Any] | None = None,
    light: Sequence[float] | None = None,
    hidden: str = "none",
    tolerance: float | None = None,
    bounds: Sequence[float] | None = None,
    seed: int = 1,
    threads: int | None = None,
    center: Sequence[float] | None = None,
    verify: bool = False,
    id_prefix: str = "",
    field: Callable[[_Array, _Array], _Array] | None = None,
    tone: Callable[[_Array, _Array], _Array] | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    mesher: str | None = None,
    define: Mapping[str, Any] | Sequence[str] | None = None,
    openscad_timeout: float | None = None,
    object: str | Sequence[str] | None = None,
    recompute: bool | None = None,
    freecad_timeout: float | None = None,
    heal: bool | None = None,
    iso: float | None = None,
    inside: str | None = None,
    smooth: float | None = None,
    specks: float | None = None,
    volume_degree: int | None = None,
    interpolate: bool | None = None,
    raw: str | None = None,
    raw_skip: int | None = None,
    **unknown: Any,
) -> Drawing:
    """Draws a scene. Arguments are the long options of `burin draw`. `style` as a mapping is that of a style
    file ({"base": "engraving", "line.outer": 0.5}); `set` overrides single keys, or groups of them
    ({"hatch": {"taper": 1}}). `paper` is a name, (width, height) in mm or "fit"; `margin` one number or (top,
    right, bottom, left). `id_prefix`: what the ids of an SVG begin with. Arguments from `mesher` on, and
    `bounds`, are about reading files; for a scene they go to `Scene.read`. `center`: the model point in
    the middle of the sheet, with `scale`; absent = the middle of what is drawn. `verify`: every visible and hidden
    line is tested against rays, `Drawing.stats["verify"]`. `field` and `tone` are called with
    positions (n, 3) and unit normals (n, 3), from the thread that called: `field` gives directions (n, 3), whose
    tangent parts strokes follow (NaN = none here), `tone` the wanted darkness (n,) in [0, 1]. The GIL is
    released while the kernel works."""

def info(*paths: str | PathLike[str], **read_options: Any) -> list[dict[str, Any]]:
    """What `burin info --json` tells, one entry a file."""

def styles() -> dict[str, str]:
    """Names of the built-in styles with what they are for."""

def style(name: str | PathLike[str] | Mapping[str, Any]) -> dict[str, Any]:
    """All keys of a style with their values: {"name": "outline", "line.outer": 0.7, ...}; `draw` takes
    it back."""

def style_keys() -> list[dict[str, str]]:
    """Each key of a style: "key", "meaning", "takes", "value" (in technical)."""

def formats() -> list[str]:
    """Suffixes that `Drawing.save` writes."""

def views() -> dict[str, tuple[tuple[float, float, float], tuple[float, float, float]]]:
    """Names that `view` takes, each with the direction from the model to the viewer, and up."""

def papers() -> dict[str, tuple[float, float]]:
    """Names that `paper` takes, each with width and height in mm; with a trailing p it is upright."""
