"""Illustrations whose drawing is not, or may not be, that of what they ask for now."""

from .illustration import KEPT, is_illustration
from .properties import is_newer


def is_stale(obj):
    """Whether a recompute is outstanding, of the illustration or of what it draws, or the last run gave no drawing. Quick: nothing
    is computed; what nobody has told FreeCAD of, such as a changed style file, only `redraw_all` sees."""
    if is_newer(obj):
        return False
    if "Touched" in obj.State or not obj.Drawing or obj.Message.endswith(KEPT):
        return True
    return any("Touched" in source.State for source in obj.OutListRecursive)


def stale_in(document):
    return [obj for obj in document.Objects if is_illustration(obj) and is_stale(obj)]


def redraw_all(document):
    """Recomputes a document, and looks at each of its illustrations: what differs from its kept drawing is drawn. Without a window
    that is done when this returns. Returns the illustrations."""
    found = [obj for obj in document.Objects if is_illustration(obj) and not is_newer(obj)]
    for obj in found:
        obj.touch()
    document.recompute()
    return found
