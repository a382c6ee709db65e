"""Marks in the tree: illustrations that are not up to date have another icon."""

import FreeCAD
from PySide import QtCore

from ..features import is_illustration
from ..features.stale import is_stale
from .provider import IllustrationView

# Milliseconds after the last change of a document until its illustrations are looked at.
PAUSE = 250


class Marks:
    """Observes documents."""

    def __init__(self, scheduler):
        self._changed = set()  # names of documents
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE)
        self._timer.timeout.connect(lambda: self._look())
        scheduler.ended.connect(self._ended)
        FreeCAD.addDocumentObserver(self)

    def slotChangedObject(self, obj, name):
        if name != "Visibility":
            self._note(obj.Document.Name)

    def slotRecomputedObject(self, obj):
        self._note(obj.Document.Name)

    def slotDeletedObject(self, obj):
        self._note(obj.Document.Name)

    def slotRecomputedDocument(self, document):
        self._note(document.Name)

    slotFinishRestoreDocument = slotRecomputedDocument

    def slotDeletedDocument(self, document):
        self._changed.discard(document.Name)

    def _ended(self, key, error):
        self._note(key[0])

    def _note(self, name):
        self._changed.add(name)
        self._timer.start()

    def _look(self):
        names, self._changed = self._changed, set()
        for name in names & set(FreeCAD.listDocuments()):
            for obj in FreeCAD.getDocument(name).Objects:
                provider = getattr(obj.ViewObject, "Proxy", None)
                if is_illustration(obj) and isinstance(provider, IllustrationView):
                    provider.mark(is_stale(obj))


_marks = None


def install(scheduler):
    global _marks
    if _marks is None:
        _marks = Marks(scheduler)
