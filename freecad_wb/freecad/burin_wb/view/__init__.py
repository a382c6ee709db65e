"""What the GUI shows of illustrations."""

from ..features import is_dimension
from .dimension import DimensionView
from .provider import IllustrationView
from .scheduler import install


def dress(obj):
    """Gives an illustration, or a dimension or note of one, its view provider, also where a script made it or the document lost it, and takes
    the runs of illustrations out of the GUI's way."""
    install()
    kind, view = DimensionView if is_dimension(obj) else IllustrationView, obj.ViewObject
    if view is not None and not isinstance(view.Proxy, kind):
        kind(view)
