"""Which illustrations an object in the tree stands for."""

from .dimension import illustrations_of, is_dimension
from .illustration import is_illustration


def illustrations_by(obj):
    """Itself, or that of a view on a page, of lines, of a parts list, of a dimension or a note; nothing for all other objects."""
    if is_illustration(obj):
        return [obj]
    if is_dimension(obj):
        return illustrations_of(obj)
    shown = getattr(obj, "Illustration", None)
    return [shown] if is_illustration(shown) else []
