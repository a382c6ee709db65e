"""What becomes of runs, panels and kept shapes where documents are undone, saved and closed."""

from ..features import illustration, is_illustration, kept
from ..features.shapes import shapes


class Documents:
    """Undo and redo bring back properties, not drawings: those are looked up, or drawn again."""

    def __init__(self, scheduler):
        self._runs = scheduler
        self._touched = []

    def slotUndoDocument(self, document):
        self._renew(document)

    slotRedoDocument = slotUndoDocument

    def slotDeletedObject(self, obj):
        if is_illustration(obj):
            self._runs.left.emit(obj.Document.Name, obj.Name)
            self._runs.cancel(obj, tell=False)

    def slotStartSaveDocument(self, document, name):
        """What is not drawn yet has the drawing before in the file: once opened it is to be drawn."""
        self._touched = [o for o in document.Objects if is_illustration(o) and "Touched" not in o.State
                         and (self._runs.running(o) or o.Message.endswith(illustration.KEPT))]
        for obj in self._touched:
            obj.touch()

    def slotFinishSaveDocument(self, document, name):
        for obj in self._touched:
            obj.purgeTouched()
        self._touched = []

    def slotDeletedDocument(self, document):
        self._runs.left.emit(document.Name, "")
        self._runs.drop_document(document.Name)
        shapes.forget(document.Name)
        kept.forget(document.Name)

    def _renew(self, document):
        self._runs.undone.emit(document.Name)
        for obj in document.Objects:
            if is_illustration(obj) and "Touched" in obj.State:
                obj.recompute()
