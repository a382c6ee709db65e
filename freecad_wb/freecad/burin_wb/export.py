"""File > Export, and the same headless: `from freecad.burin_wb import export; export.export([obj], "a.pdf")`."""

import os

import FreeCAD

from . import kernel
from .features import illustration, is_illustration


def export(objects, filename):
    """Writes the kept drawing of one illustration; the suffix names the format. FreeCAD calls this too. Throws ValueError
    with what to do."""
    chosen = [o for o in objects if is_illustration(o)]
    if len(chosen) != 1:
        raise ValueError("choose one illustration to export (a Burin object in the tree)")
    obj = chosen[0]
    if not illustration.settle(obj):
        raise ValueError(f"{obj.Label}: {obj.Message}; nothing was written")
    if not obj.Drawing or not os.path.exists(obj.Drawing):
        raise ValueError(f"{obj.Label} has no drawing yet; recompute it first")
    kernel.module().Drawing.load(obj.Drawing).save(filename)
    if obj.Message.endswith(illustration.KEPT):
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {obj.Message}, and the one written to {filename}\n")
    else:
        FreeCAD.Console.PrintMessage(f"{obj.Label}: written to {filename}\n")
