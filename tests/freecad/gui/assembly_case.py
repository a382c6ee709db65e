"""What tests of panels of assemblies share: a small pump with its illustration."""

import pathlib
import sys

import FreeCADGui as Gui
import support
from PySide import QtGui

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "headless"))
from pump import pump  # noqa: E402


class Case(support.Case):
    def setUp(self):
        super().setUp()
        self.pump = pump(self.document)
        Gui.ActiveDocument.ActiveView.viewIsometric()
        Gui.ActiveDocument.ActiveView.fitAll()
        self.obj = self.illustrate(self.pump)
        self.obj.Style = "outline"
        self.document.recompute()
        support.drawn()
        self.undos = self.document.UndoCount

    def open(self, command, *selection):
        self.select(*(selection or (self.obj,)))
        Gui.runCommand(command)
        support.drawn()
        self.assertTrue(Gui.Control.activeDialog())
        return support.panel()

    def wait(self):
        support.drawn()

    def close(self, panel):
        panel.accept()
        self.wait()
        self.assertFalse(Gui.Control.activeDialog())

    def chosen(self):
        return sorted(s.ObjectName + "." + n for s in Gui.Selection.getSelectionEx("", 0) for n in s.SubElementNames or ("",))

    def is_narrow_and_told(self, panel):
        self.assertLessEqual(panel.form.minimumSizeHint().width(), 330)
        for button in panel.form.findChildren(QtGui.QPushButton):
            needed = button.fontMetrics().boundingRect(button.text()).width()
            self.assertGreater(button.minimumWidth() or button.width(), needed, f"the text of {button.objectName()} is cut off")
        for kind in (QtGui.QComboBox, QtGui.QAbstractSpinBox, QtGui.QPushButton, QtGui.QCheckBox, QtGui.QSlider):
            for widget in panel.form.findChildren(kind):
                self.assertTrue(widget.toolTip(), widget.objectName())
