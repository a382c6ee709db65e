"""File > Export, and the same headless: `from freecad.burin_wb import export; export.export([obj], "a.pdf")`."""

import os

from . import kernel
from .errors import Refused
from .features import illustration, is_illustration
from .features.stale import is_stale
from .tell import NOTE, tell


def export(objects, filename):
    """Writes the kept drawing of one illustration; the suffix names the format. FreeCAD calls this too. Throws Refused,
    which is a ValueError, with what to do."""
    chosen = [o for o in objects if is_illustration(o)]
    if len(chosen) != 1:
        raise Refused("choose one illustration to export (a Burin object in the tree)")
    obj = chosen[0]
    if not kernel.found():
        raise Refused(f"{obj.Label}: nothing was written. {kernel.why_missing()}")
    if not illustration.settle(obj):
        raise Refused(f"{obj.Label}: {obj.Message}; nothing was written")
    if not obj.Drawing or not os.path.exists(obj.Drawing):
        raise Refused(f"{obj.Label} has no drawing yet; recompute it first")
    kernel.module().Drawing.load(obj.Drawing).save(filename)
    if obj.Message.endswith(illustration.KEPT):
        tell(f"{obj.Label}: {obj.Message}, and the one written to {filename}")
    elif is_stale(obj):
        tell(f"{obj.Label}: is not up to date (it or its model was changed and not recomputed); the drawing before was written to {filename}")
    else:
        tell(f"{obj.Label}: written to {filename}", NOTE)
