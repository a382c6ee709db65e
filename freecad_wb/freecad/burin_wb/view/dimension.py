"""The view provider of dimensions. Documents name it as freecad.burin_wb.view.dimension.DimensionView."""

import os

import FreeCADGui as Gui
from pivy import coin

from ..features.dimension import features_of

_ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")
_ICON, _STALE = os.path.join(_ICONS, "burin_dimension.svg"), os.path.join(_ICONS, "burin_stale.svg")


class DimensionView:
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
        return _STALE if getattr(self.Object, "Message", "") else _ICON

    def updateData(self, obj, name):
        if name == "Message" and hasattr(self, "View"):
            self.View.signalChangeIcon()

    def doubleClicked(self, view):
        """Lights up what it measures."""
        Gui.Selection.clearSelection()
        for top, sub in features_of(view.Object):
            Gui.Selection.addSelection(top.Document.Name, top.Name, sub)
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
