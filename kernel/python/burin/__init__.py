"""Line art from CAD parts, meshes, functions and volumes: see kernel/docs/python.md.

Lengths of models are millimetres; lengths on the sheet are millimetres of paper, origin bottom left,
y up; angles are degrees. Arrays are numpy arrays, float64 unless said.
"""

from collections.abc import Callable as _Callable
from typing import Any as _Any

from ._burin import (
    Cancel,
    Cancelled,
    Diagnostic,
    Drawing,
    Error,
    GeometryError,
    InputError,
    Layer,
    OutputError,
    Part,
    Path,
    Scene,
    UsageError,
    View,
    __version__,
    draw,
    formats,
    info,
    style,
    style_keys,
    styles,
)

Progress = _Callable[[str, float], _Any]

__all__ = [
    "Cancel",
    "Cancelled",
    "Diagnostic",
    "Drawing",
    "Error",
    "GeometryError",
    "InputError",
    "Layer",
    "OutputError",
    "Part",
    "Path",
    "Progress",
    "Scene",
    "UsageError",
    "View",
    "draw",
    "formats",
    "info",
    "style",
    "style_keys",
    "styles",
]
