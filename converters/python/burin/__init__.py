"""Line art from CAD parts, meshes, functions and volumes: see kernel/docs/python.md.

Lengths of models are millimetres; lengths on the sheet are millimetres of paper, origin bottom left,
y up; angles are degrees. Arrays are numpy arrays, float64 unless said.
"""

from collections.abc import Callable as _Callable
from typing import Any as _Any

from ._burin import (
    Book,
    Brep,
    Cancel,
    Cancelled,
    Diagnostic,
    Difference,
    Drawing,
    Error,
    GeometryError,
    InputError,
    Layer,
    MissingFile,
    OutputError,
    Part,
    Path,
    Scene,
    Session,
    UsageError,
    View,
    __version__,
    catalogues,
    diff,
    explode_steps,
    formats,
    illustration,
    illustration_schema,
    info,
    items,
    papers,
    plugins,
    register_direction,
    register_form,
    register_law,
    register_reader,
    register_symbol,
    register_writer,
    select,
    steps,
    style,
    style_keys,
    styles,
    views,
)
from ._draw import draw
from ._jupyter import set_up as _set_up_notebooks
from ._plugins import load as _load_plugins

Progress = _Callable[[str, float], _Any]

__all__ = [
    "Book",
    "Brep",
    "Cancel",
    "Cancelled",
    "Diagnostic",
    "Difference",
    "Drawing",
    "Error",
    "GeometryError",
    "InputError",
    "Layer",
    "MissingFile",
    "OutputError",
    "Part",
    "Path",
    "Progress",
    "Scene",
    "Session",
    "UsageError",
    "View",
    "catalogues",
    "diff",
    "draw",
    "explode_steps",
    "formats",
    "illustration",
    "illustration_schema",
    "info",
    "items",
    "papers",
    "plugins",
    "register_direction",
    "register_form",
    "register_law",
    "register_reader",
    "register_symbol",
    "register_writer",
    "select",
    "steps",
    "style",
    "style_keys",
    "styles",
    "views",
]

def _load():
    from . import _burin

    _load_plugins(_burin._refuse_plugin)
    _set_up_notebooks()


_load()
del _load
