"""The view provider of dimensions and notes. Documents name it as freecad.burin_wb.view.dimension.DimensionView."""

import os

import FreeCADGui as Gui
from pivy import coin

from .. import hooks
from ..features.dimension import features_of, is_note
from ..proxy import Stateless

_ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")
_ICON, _NOTE, _STALE = (os.path.join(_ICONS, f"burin_{name}.svg") for name in ("dimension", "note", "stale"))


def light_features(dimensions):
    """Selects what dimensions measure, and notes point at."""
    Gui.Selection.clearSelection()
    for top, sub in (feature for one in dimensions for feature in features_of(one)):
        Gui.Selection.addSelection(top.Document.Name, top.Name, sub)


class DimensionView(Stateless):
    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object, self.View = view.Object, view
        view.addDisplayMode(coin.SoGroup(), "Tree")  # with none the tree shows it as hidden

    def getDisplayModes(self, view):
        return ["Tree"]

    def getDefaultDisplayMode(self):
        return "Tree"

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        """Another one where it cannot be drawn."""
        if getattr(self.Object, "Message", ""):
            return _STALE
        return _NOTE if is_note(self.Object) else _ICON

    def updateData(self, obj, name):
        if name in ("Message", "Kind") and hasattr(self, "View"):
            self.View.signalChangeIcon()

    def doubleClicked(self, view):
        hooks.edit(view.Object)
        return True

    def setEdit(self, view, mode=0):
        """The panel has its own transaction; FreeCAD's edit mode would end it."""
        hooks.edit(view.Object)
        return False
