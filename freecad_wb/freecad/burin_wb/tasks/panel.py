"""What the panels share: one transaction, changes drawn a moment later, progress with Cancel."""

import time

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..qt import number
from ..text import tr
from ..view import page_view, scheduler
from .preview import Preview
from .watch import Changes, Escape

# Milliseconds after the last change until it is drawn: as long as one types or turns a wheel.
PAUSE = 200

# Where the last drawing took no more seconds than this it is drawn while one turns the wheel, as often as it can be.
LIVE = 0.5
OFTEN = 40
WIDTH = 340


class Panel:
    """A task panel of one illustration. Subclasses fill `self.column`."""

    title = ""

    def __init__(self, obj):
        self.obj = obj
        self.document = obj.Document
        self.key = obj.Document.Name, obj.Name
        self.over = False
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(self.title or obj.Label)
        self.form.setWindowIcon(QtGui.QIcon(obj.ViewObject.Proxy.getIcon()))
        self.form.setMaximumWidth(WIDTH)
        # FreeCAD may close a panel by itself.
        self.form.destroyed.connect(lambda *_: self._close())
        self.column = QtGui.QVBoxLayout(self.form)
        self.column.setContentsMargins(2, 4, 2, 4)
        self._pause = QtCore.QTimer(self.form)
        self._pause.setSingleShot(True)
        self._pause.timeout.connect(lambda: self._paused())
        self._began, self._took = 0.0, float("inf")  # when the last run began, and seconds that it took
        obj.ViewObject.Proxy.step_aside(True)
        self._pages = page_view.Kept()
        self.preview = Preview(obj)
        self.column.addWidget(self.preview)
        self._add_progress()
        self.fill()
        self.column.addStretch()
        self.runs = scheduler.install()
        self.runs.progressed.connect(self._progressed)
        self.runs.ended.connect(self._ended)
        self.runs.left.connect(self._left)
        self.runs.undone.connect(self._undone)
        self._escape = Escape(self.document, lambda: self.over or self.reject())
        self._watch = Changes(self.document, lambda: self.over or not self.alive() or self.refresh(), obj)
        self._report_state()

    def fill(self):
        raise NotImplementedError

    def refresh(self):
        """The document changed: shows what it holds now."""

    def closing(self):
        """The panel is about to go: takes back what it shows elsewhere."""

    # --- changes ---

    def change(self, name, value):
        """Sets a property; drawn after a pause."""
        if self.over:  # a late word of a field
            return
        if getattr(self.obj, name) != value:
            setattr(self.obj, name, value)
            self.changed()

    def changed(self):
        live = self._took < LIVE
        if not live or not self._pause.isActive():
            self._pause.start(OFTEN if live else PAUSE)

    def _paused(self):
        if self._took < LIVE and self.alive() and self.runs.running(self.obj) and time.monotonic() - self._began < 2 * LIVE:
            self._pause.start(OFTEN)  # it would never be seen
        else:
            self.draw()

    def draw(self):
        """Starts a run where something has changed; a run under way is ended."""
        self._pause.stop()
        self._began = time.monotonic()
        if self.alive():
            self.obj.touch()
            self.obj.recompute()
            self._report_state()

    def waits(self):
        """Whether a change is still to be drawn, or to be shown here."""
        return self._pause.isActive() or self._watch.waits()

    def alive(self):
        """Whether the illustration is still in its document."""
        try:
            return self.document.getObject(self.key[1]) is self.obj and self.obj.Name == self.key[1]
        except (ReferenceError, RuntimeError, NameError):
            return False

    # --- progress ---

    def _add_progress(self):
        row = QtGui.QHBoxLayout()
        self.bar = QtGui.QProgressBar()
        self.bar.setObjectName("progress")
        self.bar.setRange(0, 100)
        self.bar.setFormat("%p %")
        self.stop = QtGui.QPushButton(tr("Stop"))
        self.stop.setObjectName("stop")
        self.stop.setToolTip(tr("Ends the run; the drawing before is kept"))
        self.stop.clicked.connect(lambda: self._stop())
        row.addWidget(self.bar)
        row.addWidget(self.stop)
        self.message = QtGui.QLabel()
        self.message.setObjectName("message")
        self.message.setWordWrap(True)
        self.message.setMinimumHeight(self.message.fontMetrics().height())
        self.message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.column.addLayout(row)
        self.column.addWidget(self.message)

    def _progressed(self, key, stage, share):
        if self._concerns(key):
            self.bar.setValue(round(100 * share))
            self.message.setText(tr(stage) if stage else tr("drawing"))

    def _ended(self, key, error):
        if self._concerns(key):
            self._report_state(error)
            self._took = time.monotonic() - self._began if error is None else float("inf")
            if error is None:
                self.preview.renew()

    def _report_state(self, error=None):
        running = self.runs.running(self.obj)
        self.stop.setEnabled(running)
        if running:
            self.bar.setValue(0)
            self.message.setText(tr("drawing"))
        else:
            self.bar.setValue(0 if error else 100 if self.obj.Drawing else 0)
            self.message.setText(str(error) if error else self.obj.Message or tr("drawn"))

    def _stop(self):
        self.stop.setEnabled(False)
        self.message.setText(tr("stopping"))
        self.runs.cancel(self.obj)

    def _concerns(self, key):
        return not self.over and key == self.key and self.alive()

    # --- the end ---

    def accept(self):
        if self._pause.isActive():
            self.draw()
        self._close()
        self.document.commitTransaction()
        Gui.Control.closeDialog()
        return True

    def reject(self):
        self._pause.stop()
        self.runs.cancel(self.obj)
        self._close()
        self.document.abortTransaction()
        Gui.Control.closeDialog()
        if self.alive():
            self.obj.touch()
            self.obj.recompute()
        return True

    def abandon(self):
        """The document is closed, or the changes were undone: there is nothing to keep or to take back."""
        self._pause.stop()
        self._close()
        QtCore.QTimer.singleShot(0, Gui.Control.closeDialog)  # not while the document or a menu is at work

    def _left(self, document, name):
        if document == self.key[0] and not name:  # the document is closed
            self.abandon()

    def _undone(self, document):
        if document == self.key[0]:  # the panel's transaction was the one that is undone
            self.abandon()

    def _close(self):
        if self.over:
            return
        self.over = True
        self.closing()
        self.preview.close_large()
        self._escape.stop()
        self._watch.stop()
        self._pages.close()
        for signal, slot in ((self.runs.progressed, self._progressed), (self.runs.ended, self._ended),
                             (self.runs.left, self._left), (self.runs.undone, self._undone)):
            try:
                signal.disconnect(slot)
            except RuntimeError:
                pass
        try:
            self.obj.ViewObject.Proxy.step_aside(False)
        except (AttributeError, NameError, ReferenceError, RuntimeError):  # the illustration or its document is gone
            pass

    def getStandardButtons(self):
        return number(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return False
