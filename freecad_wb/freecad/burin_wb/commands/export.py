"""Illustrations as files."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import export as exporter
from .. import illustration_file, kernel
from ..errors import Refused
from ..text import tr
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
        filters = ";;".join(f"{suffix.upper()} (*.{suffix})" for suffix in kernel.offered()["formats"])
        name, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "", filters)
        if not name:
            return
        try:
            exporter.export([illustration], name)
        except Exception as error:  # errors of the kernel and of files, each in one line
            raise Refused(str(error))


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
