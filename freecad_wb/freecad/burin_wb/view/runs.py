"""What the scheduler has to do: runs of the kernel, and the shapes that are written before them."""

import collections
import time

from ..features.properties import ILLUSTRATION, READ_ONLY
from ..features.sources import filled, is_ready, survey

# Seconds of the GUI's thread that writing shapes may take at a time.
SLICE = 0.03


class Run:
    def __init__(self, obj, job, inputs, finish, what="draw"):
        self.what = what  # as job.answer knows it; anything else is asked beside the drawings
        self.obj, self.key = obj, (obj.Document.Name, obj.Name)
        self.job, self.inputs, self.finish = job, inputs, finish
        self.stage, self.share = "", 0.0
        self.cancelled = False
        self.replaced = False  # by a newer one: nothing to tell
        self.asked = asked_of(obj)


class Writing:
    """The shapes of an illustration that are still to be written before its run can begin."""

    def __init__(self, obj):
        self.obj, self.key = obj, key_of(obj)
        pieces, _ = survey(obj.Sources)
        self.count = len(pieces)
        self.pieces = collections.deque(p for p in pieces if p.shape is not None and not is_ready(p))

    def go_on(self):
        """Writes for a while, one shape at least; whether all are written."""
        end = time.monotonic() + SLICE
        while self.pieces:
            part = filled(self.pieces.popleft())
            part.brep.exact()  # here too, else those of all parts come in one go
            if time.monotonic() > end:
                break
        return not self.pieces

    def share(self):
        return 1 - len(self.pieces) / max(self.count, 1)


def key_of(obj):
    return obj.Document.Name, obj.Name


def asked_of(obj):
    """What the properties ask for, to see whether they still do."""
    return repr([(row.name, getattr(obj, row.name, None)) for row in ILLUSTRATION if row.name not in READ_ONLY])
