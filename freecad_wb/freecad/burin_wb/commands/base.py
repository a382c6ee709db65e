"""What all commands share: one undoable transaction, errors in one line, honest IsActive."""

import os

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import kernel
from ..errors import Failed, Refused
from ..features import is_illustration
from ..features.stands_for import illustrations_by
from ..tell import tell
from ..text import tr

_ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")


class Command:
    """Subclasses set name, text, tip, icon, accel and write `run` (inside a transaction) and `possible`."""

    name = text = tip = icon = accel = ""
    transaction = True
    needs_kernel = False

    def GetResources(self):
        return {
            "Pixmap": os.path.join(_ICONS, self.icon),
            "MenuText": QtCore.QT_TRANSLATE_NOOP(self.name, self.text),
            "ToolTip": QtCore.QT_TRANSLATE_NOOP(self.name, self.tip),
            "Accel": self.accel,
        }

    def IsActive(self):
        # While a panel is open its transaction is: a command would end it.
        return FreeCAD.ActiveDocument is not None and Gui.Control.activeDialog() is False and self.possible()

    def possible(self):
        return True

    def run(self, document):
        raise NotImplementedError

    def Activated(self, index=0):
        document = FreeCAD.ActiveDocument
        if self.needs_kernel and not kernel.found():
            ask_for_kernel()
            return
        if self.transaction:
            document.openTransaction(QtCore.QCoreApplication.translate(self.name, self.text))
        try:
            self.run(document)
        except (Refused, Failed) as why:
            if self.transaction:
                document.abortTransaction()
            tell(str(why))
        except Exception:
            if self.transaction:
                document.abortTransaction()
            raise
        else:
            if self.transaction and Gui.Control.activeDialog() is False:
                document.commitTransaction()


def ask_for_kernel():
    """Says what to install. Does not stop what runs: the box waits beside it."""
    why = kernel.why_missing()
    tell(why)
    box = QtGui.QMessageBox(QtGui.QMessageBox.Information, "Burin", tr("The drawing kernel is not installed."),
                            QtGui.QMessageBox.Ok, Gui.getMainWindow())
    box.setInformativeText(why)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.open()


def selected_illustrations():
    """Illustrations that are selected, also by what stands for them, or the only one of the document."""
    chosen = list({o.Name: o for chosen in Gui.Selection.getSelection() for o in illustrations_by(chosen)}.values())
    if chosen or FreeCAD.ActiveDocument is None:
        return chosen
    all_of_them = [o for o in FreeCAD.ActiveDocument.Objects if is_illustration(o)]
    return all_of_them if len(all_of_them) == 1 else []


def some_illustrations():
    """The illustrations that a command is for; refuses none."""
    chosen = selected_illustrations()
    if not chosen:
        raise Refused(tr("select an illustration"))
    return chosen


def one_illustration():
    """The one illustration that a command is for; refuses any other number."""
    chosen = selected_illustrations()
    if len(chosen) != 1:
        raise Refused(tr("select one illustration"))
    return chosen[0]


class Group:
    """Several commands behind one button with an arrow."""

    name = text = tip = ""
    members = ()

    def GetResources(self):
        return {
            "MenuText": QtCore.QT_TRANSLATE_NOOP(self.name, self.text),
            "ToolTip": QtCore.QT_TRANSLATE_NOOP(self.name, self.tip),
        }

    def GetCommands(self):
        return tuple(self.members)

    def GetDefaultCommand(self):
        return 0

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None
