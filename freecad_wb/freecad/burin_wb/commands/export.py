"""Illustrations as files."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import export as exporter
from .. import kernel
from ..errors import Refused
from ..text import tr
from .base import Command, selected_illustrations


class Export(Command):
    name = "Burin_Export"
    text = "Export illustration..."
    tip = "Writes the illustration as a file: for print, for the web, for drawing programs"
    icon = "burin_export.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        chosen = selected_illustrations()
        if len(chosen) != 1:
            raise Refused(tr("select one illustration"))
        filters = ";;".join(f"{suffix.upper()} (*.{suffix})" for suffix in kernel.offered()["formats"])
        name, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "", filters)
        if not name:
            return
        try:
            exporter.export(chosen, name)
        except Exception as error:  # errors of the kernel and of files, each in one line
            raise Refused(str(error))


COMMANDS = [Export()]
