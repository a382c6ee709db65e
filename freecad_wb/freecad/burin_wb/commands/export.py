"""Illustrations as files."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import export as exporter
from .. import illustration_file, kernel
from ..errors import Refused
from ..features.stale import is_stale
from ..text import tr
from ..view.scheduler import settle
from .base import Command, one_illustration, selected_illustrations


class Export(Command):
    name = "Burin_Export"
    text = "Export illustration..."
    tip = "Writes the illustration as a file: for print, for the web, for drawing programs"
    icon = "burin_export.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        if not is_wanted(illustration):
            return
        filters = ";;".join(f"{suffix.upper()} (*.{suffix})" for suffix in kernel.offered()["formats"])
        name, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "", filters)
        if not name:
            return
        try:
            exporter.export([illustration], name)
        except Exception as error:  # errors of the kernel and of files, each in one line
            raise Refused(str(error))


REDRAW, AS_IT_IS = QtGui.QMessageBox.Yes, QtGui.QMessageBox.No


def is_wanted(illustration):
    """Asks what to do where a drawing is not up to date; whether to go on."""
    if not is_stale(illustration):
        return True
    box = QtGui.QMessageBox(QtGui.QMessageBox.Question, "Burin", tr("{0} is not up to date.").format(illustration.Label),
                            REDRAW | AS_IT_IS | QtGui.QMessageBox.Cancel, Gui.getMainWindow())
    box.setObjectName("BurinStale")
    box.button(REDRAW).setText(tr("Redraw first"))
    box.button(AS_IT_IS).setText(tr("Export the drawing before"))
    chosen = box.exec_() if hasattr(box, "exec_") else box.exec()
    box.deleteLater()
    if chosen == REDRAW:
        illustration.touch()
        illustration.Document.recompute()
        settle(illustration)
    return chosen in (REDRAW, AS_IT_IS)


class ExportFile(Command):
    name = "Burin_ExportFile"
    text = "Export illustration file..."
    tip = "Writes an illustration file and the models of its parts: the command burin draws them without FreeCAD"
    icon = "burin_export_file.svg"
    transaction = False
    needs_kernel = True

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        suffix = illustration_file.SUFFIX
        name, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "",
                                                    tr("Illustration files") + f" (*{suffix})")
        if not name:
            return
        try:
            illustration_file.write(illustration, name if name.endswith(suffix) else name + suffix)
        except OSError as error:
            raise Refused(str(error))


COMMANDS = [Export(), ExportFile()]
