"""Illustrations as files."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import export as exporter
from ..errors import Refused
from ..text import tr
from .base import Command, selected_illustrations

FILTERS = "SVG (*.svg);;PDF (*.pdf);;PNG (*.png);;EPS (*.eps);;DXF (*.dxf);;Drawing (*.json)"


class Export(Command):
    name = "Burin_Export"
    text = "Export illustration..."
    tip = "Writes the illustration as SVG, PDF, PNG, EPS, DXF or as a drawing file"
    icon = "burin_export.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        chosen = selected_illustrations()
        if len(chosen) != 1:
            raise Refused(tr("select one illustration"))
        name, _ = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "", FILTERS)
        if not name:
            return
        try:
            exporter.export(chosen, name)
        except Exception as error:  # errors of the kernel and of files, each in one line
            raise Refused(str(error))


COMMANDS = [Export()]
