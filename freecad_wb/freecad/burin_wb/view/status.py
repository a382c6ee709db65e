"""What runs, in the status bar: stage, share and a button that ends it."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..text import tr

# Milliseconds that a run may take before it is worth telling.
QUIET = 300

# The stages' names as the kernel gives them are words of their own; translation files know them.


class Status(QtGui.QWidget):
    def __init__(self, scheduler, parent):
        super().__init__(parent)
        self.setObjectName("BurinStatus")
        self._scheduler = scheduler
        self.text, self.bar = QtGui.QLabel(self), QtGui.QProgressBar(self)
        self.button = QtGui.QPushButton(tr("Cancel"), self)
        self.button.setToolTip(tr("Ends the run; the drawing before is kept"))
        self.button.clicked.connect(lambda: scheduler.cancel_all())
        self.bar.setRange(0, 100)
        self.bar.setMaximumWidth(120)
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.text, self.bar, self.button):
            row.addWidget(widget)
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(QUIET)
        self._timer.timeout.connect(lambda: self.setVisible(self._scheduler.running()))
        self.hide()
        scheduler.began.connect(self._began)
        scheduler.progressed.connect(self._progressed)
        scheduler.ended.connect(self._ended)

    def _began(self, key):
        if not self.isVisible():
            self._timer.start()
        self._show(key, tr("drawing"), 0.0)

    def _progressed(self, key, stage, share):
        self._show(key, tr(stage) if stage else tr("drawing"), share)

    def _show(self, key, stage, share):
        more = self._scheduler.waiting()
        self.text.setText(f"{_label(key)}: {stage}" + (" " + tr("({0} more)").format(more) if more else ""))
        self.bar.setValue(round(100 * share))

    def _ended(self, key, error):
        if not self._scheduler.running():
            self._timer.stop()
            self.hide()


def _label(key):
    try:
        obj = FreeCAD.getDocument(key[0]).getObject(key[1])
    except NameError:
        obj = None
    return obj.Label if obj is not None else key[1]


def install(scheduler):
    window = Gui.getMainWindow()
    if window is not None:
        window.statusBar().addPermanentWidget(Status(scheduler, window))
