"""What panels listen to outside themselves."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore


class Escape:
    """Calls a function once Esc is pressed in a 3-D view of a document."""

    def __init__(self, document, slot):
        self._slot = slot
        views = Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
        self._hooks = [(view, view.addEventCallback("SoKeyboardEvent", self._event)) for view in views]

    def _event(self, event):
        if event.get("Key") == "ESCAPE" and self._hooks:
            self.stop()
            QtCore.QTimer.singleShot(0, self._slot)  # not while the view calls

    def stop(self):
        hooks, self._hooks = self._hooks, []
        for view, hook in hooks:
            try:
                view.removeEventCallback("SoKeyboardEvent", hook)
            except (ReferenceError, RuntimeError):  # the view is gone
                pass


class Changes:
    """Calls a function a moment after objects of a document came, went or changed."""

    PAUSE = 150  # ms

    def __init__(self, document, slot, but):
        """`but`: an object whose results are no change, only its sources."""
        self._name, self._but = document.Name, but.Name
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.setInterval(self.PAUSE)
        self._timer.timeout.connect(lambda: slot())
        FreeCAD.addDocumentObserver(self)

    def slotCreatedObject(self, obj):
        self._note(obj)

    slotDeletedObject = slotCreatedObject

    def slotChangedObject(self, obj, name):
        if obj.Name != self._but or name == "Sources":
            self._note(obj)

    def _note(self, obj):
        if obj.Document.Name == self._name:
            self._timer.start()

    def waits(self):
        """Whether the function is still to be called."""
        return self._timer is not None and self._timer.isActive()

    def stop(self):
        if self._timer is not None:
            self._timer.stop()
            self._timer = None
            FreeCAD.removeDocumentObserver(self)


class Selected:
    """Calls a function once the selection has changed."""

    def __init__(self, slot):
        self._slot, self._waits = slot, False
        Gui.Selection.addObserver(self)

    def _changed(self, *_):
        if not self._waits:
            self._waits = True
            QtCore.QTimer.singleShot(0, self._tell)  # not while the selection calls

    addSelection = removeSelection = setSelection = clearSelection = _changed

    def _tell(self):
        self._waits = False
        if self._slot is not None:
            self._slot()

    def stop(self):
        if self._slot is not None:
            self._slot = None
            Gui.Selection.removeObserver(self)
