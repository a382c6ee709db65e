"""Rows of a table and the objects that they stand for: each lights up the other."""

import FreeCADGui as Gui
from PySide import QtCore

from .watch import Selected


class Lights:
    """Until `stop`. `paths_of(row)`: paths of the objects of a row."""

    def __init__(self, document, table, paths_of):
        self._document, self._table, self._paths_of = document, table, paths_of
        self._busy = False
        self._watch = Selected(lambda: self.mark())
        table.itemSelectionChanged.connect(lambda: self._light())

    def stop(self):
        self._watch.stop()
        self._busy = True

    def rows(self):
        """Numbers of the rows that are selected, ascending."""
        return sorted({index.row() for index in self._table.selectionModel().selectedRows()})

    def mark(self):
        """Selects the rows of the objects that are selected."""
        if self._busy:
            return
        chosen = selected_paths(self._document)
        model = self._table.selectionModel()
        self._busy = True
        self._table.clearSelection()
        for row in range(self._table.rowCount()):
            if any(_meet(path, one) for path in self._paths_of(row) for one in chosen):
                model.select(self._table.model().index(row, 0), QtCore.QItemSelectionModel.Select | QtCore.QItemSelectionModel.Rows)
        self._busy = False

    def _light(self):
        """Selects the objects of the rows that are selected."""
        if self._busy:
            return
        self._busy = True
        Gui.Selection.clearSelection()
        for row in self.rows():
            for path in self._paths_of(row):
                top, _, sub = path.partition(".")
                if self._document.getObject(top) is not None:
                    Gui.Selection.addSelection(self._document.Name, top, sub + "." if sub else "")
        QtCore.QTimer.singleShot(0, self._lit)  # the selection tells of itself before

    def _lit(self):
        self._busy = False


def _meet(one, other):
    """Whether a path is that of the other, or of an assembly that it is in, or the other way round."""
    return f"{one}.".startswith(f"{other}.") or f"{other}.".startswith(f"{one}.")


def selected_paths(document):
    """Paths of the objects of a document that are selected: 'Assembly.Body' with the internal names."""
    paths = []
    for chosen in Gui.Selection.getSelectionEx(document.Name, 0):
        for sub in chosen.SubElementNames or ("",):
            names = sub[: sub.rfind(".") + 1].rstrip(".")
            paths.append(chosen.ObjectName + ("." + names if names else ""))
    return list(dict.fromkeys(paths))


def label_of(document, path):
    """What the tree calls an object by its path; the path itself where it is gone."""
    top, _, sub = path.partition(".")
    obj = document.getObject(top)
    inner = obj.getSubObject(sub + ".", retType=1) if obj is not None and sub else obj
    return inner.Label if inner is not None else path
