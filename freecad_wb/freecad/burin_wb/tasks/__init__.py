"""Panels beside the tree. A panel works in the transaction that is open when it is shown."""

import FreeCADGui as Gui

from ..tell import tell
from ..text import tr
from .illustration import IllustrationPanel

# The panel that is open.
shown = None


def show(panel):
    """Shows a panel; from now on its OK commits and its Cancel takes back."""
    global shown
    Gui.Control.showDialog(panel)
    shown = panel
    return panel


def edit(obj):
    """The panel of an illustration, as an undoable change of its own."""
    if Gui.Control.activeDialog() is not False:
        tell(tr("another panel is open; close it first"))
        return None
    obj.Document.openTransaction(tr("Edit illustration"))
    return show(IllustrationPanel(obj))
