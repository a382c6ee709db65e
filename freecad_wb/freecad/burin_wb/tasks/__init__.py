"""Panels beside the tree. A panel works in the transaction that is open when it is shown."""

import FreeCADGui as Gui
from PySide import QtCore

from ..features.stands_for import illustrations_by
from ..tell import tell
from ..text import tr
from . import widgets
from .dimensions import DimensionsPanel
from .illustration import IllustrationPanel

# The panel that is open.
shown = None


def warm():
    """Loads a moment later what the first panel takes long for."""
    QtCore.QTimer.singleShot(200, widgets.warm)


def show(panel):
    """Shows a panel; from now on its OK commits and its Cancel takes back."""
    global shown
    Gui.Control.showDialog(panel)
    shown = panel
    return panel


def edit(obj):
    """The panel of an illustration, or that of its dimensions and notes for one of these, as an undoable change of its own."""
    if Gui.Control.activeDialog() is not False:
        tell(tr("another panel is open; close it first"))
        return None
    illustration = next(iter(illustrations_by(obj)), None)
    if illustration is None:
        tell(tr("{0} belongs to no illustration; delete it").format(obj.Label))
        return None
    obj.Document.openTransaction(tr("Edit illustration"))
    return show(IllustrationPanel(obj) if obj is illustration else DimensionsPanel(illustration, obj))
