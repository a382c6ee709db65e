"""What the GUI shows of illustrations."""

from .provider import IllustrationView
from .scheduler import install


def dress(obj):
    """Gives an illustration its view provider, also where a script made it or the document lost it, and takes its runs
    out of the GUI's way."""
    install()
    view = obj.ViewObject
    if view is not None and not isinstance(view.Proxy, IllustrationView):
        IllustrationView(view)
