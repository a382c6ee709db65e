"""What all commands share: one undoable transaction, errors told in one line, honest IsActive."""

import os

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from ..features import is_illustration

_ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")


class Refused(Exception):
    """The command cannot be done; the text says why and what to do."""


class Command:
    """Subclasses set name, text, tip, icon, accel and write `run` (inside a transaction) and `possible`."""

    name = text = tip = icon = accel = ""
    transaction = True

    def GetResources(self):
        return {
            "Pixmap": os.path.join(_ICONS, self.icon),
            "MenuText": QtCore.QT_TRANSLATE_NOOP(self.name, self.text),
            "ToolTip": QtCore.QT_TRANSLATE_NOOP(self.name, self.tip),
            "Accel": self.accel,
        }

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None and self.possible()

    def possible(self):
        return True

    def run(self, document):
        raise NotImplementedError

    def Activated(self, index=0):
        document = FreeCAD.ActiveDocument
        if self.transaction:
            document.openTransaction(self.text)
        try:
            self.run(document)
        except Refused as why:
            if self.transaction:
                document.abortTransaction()
            tell(str(why))
        except Exception:
            if self.transaction:
                document.abortTransaction()
            raise
        else:
            if self.transaction:
                document.commitTransaction()


def tell(text):
    """A message box, or the report view where there is no one to answer it."""
    FreeCAD.Console.PrintWarning(text + "\n")
    window = Gui.getMainWindow()
    if window is not None:
        window.statusBar().showMessage(text, 10000)


def selected_illustrations():
    """Illustrations that are selected, or the only one of the document."""
    chosen = [o for o in Gui.Selection.getSelection() if is_illustration(o)]
    if chosen or FreeCAD.ActiveDocument is None:
        return chosen
    all_of_them = [o for o in FreeCAD.ActiveDocument.Objects if is_illustration(o)]
    return all_of_them if len(all_of_them) == 1 else []
