"""The view provider of illustrations. Documents name it as freecad.burin_wb.view.provider.IllustrationView."""

import os

import FreeCAD

_ICON = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons", "burin_illustration.svg")


class IllustrationView:
    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        from pivy import coin

        self.Object = view.Object
        self._root = coin.SoSeparator()
        view.addDisplayMode(self._root, "Ink")
        self._show()

    def getDisplayModes(self, view):
        return ["Ink"]

    def getDefaultDisplayMode(self):
        return "Ink"

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        return _ICON

    def updateData(self, obj, name):
        if name == "Drawing" and hasattr(self, "_root"):
            self._show()

    def _show(self):
        """Puts the kept drawing behind the model, where it hides nothing."""
        from ..features.sheet import Sheet
        from . import ink

        self._root.removeAllChildren()
        path = getattr(self.Object, "Drawing", "")
        if not path or not os.path.exists(path):
            return
        try:
            sheet = Sheet(path)
        except (OSError, ValueError, KeyError) as error:
            FreeCAD.Console.PrintError(f"{self.Object.Label}: the kept drawing cannot be read ({error})\n")
            return
        self._root.addChild(ink.ink_node(sheet, -behind(self.Object, sheet)))

    def doubleClicked(self, view):
        import FreeCADGui as Gui

        Gui.ActiveDocument.setEdit(view.Object.Name)
        return True

    def setEdit(self, view, mode=0):
        if mode != 0:
            return None
        import FreeCADGui as Gui

        from ..tasks.illustration import IllustrationPanel

        Gui.Control.showDialog(IllustrationPanel(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        import FreeCADGui as Gui

        Gui.Control.closeDialog()
        return False

    def claimChildren(self):
        return []

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads


def behind(obj, sheet):
    """Model mm from the view's centre back to a plane behind all sources."""
    farthest = 0.0
    for source, _ in obj.Sources:
        box = getattr(getattr(source, "Shape", None), "BoundBox", None)
        if box is None or not box.isValid():
            continue
        for k in range(8):
            depth = (sheet.center - box.getPoint(k)).dot(sheet.direction)
            farthest = max(farthest, depth)
    return farthest
