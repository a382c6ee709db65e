"""The panel that draws places of an illustration again, larger."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from ..errors import Refused
from ..features import details, section
from ..features.chosen import numbers_of
from ..features.extent import Extent
from ..features.sources import from_the_top
from ..text import tr
from . import widgets
from .lights import Lights, label_of, selected_paths
from .panel import Panel

# Of the diagonal of all that is drawn: the radius about a point.
NEAR = 0.05


class DetailPanel(Panel):
    @property
    def title(self):
        return tr("Detail")

    def fill(self):
        self.extent = Extent(self.obj)
        self.entries = self._kept()
        self.table = widgets.table([tr("Place"), tr("Letter"), tr("Scale"), tr("Radius")], (
            tr("What is drawn again; a row lights up its objects in the 3-D view"), tr("A letter of its own; empty: the next one"),
            tr("Paper to model, such as 5:1; empty: as large as fits on the sheet"),
            tr("Of the circle, in mm of the model; empty: all of the objects")), "details")
        self.table.itemChanged.connect(lambda cell: self._edited(cell))
        self.column.addWidget(self.table, 1)
        self.lights = Lights(self.document, self.table, lambda row: details.words_of(self.entries[row]))
        widgets.row(self.column, widgets.button(tr("Objects"), tr("Another detail: the objects that are selected"), self._add_objects, "objects"),
                    widgets.button(tr("Point"), tr("Another detail: about the face, edge or vertex that is selected, or where an object was clicked"),
                                   self._add_point, "point"),
                    widgets.button(tr("Delete"), tr("Deletes the details that are selected above"), self._delete, "delete"))
        self._list()

    def begin(self):
        """What is selected as the panel is opened is the first detail of an illustration that has none."""
        if not self.entries and self._paths():
            self._add_objects()

    def _kept(self):
        try:
            return details.entries_of(self.obj)
        except Refused as why:
            QtCore.QTimer.singleShot(0, lambda text=str(why): self.message.setText(text))
            return []

    def refresh(self):
        self.extent = Extent(self.obj)
        self._list()

    def closing(self):
        self.lights.stop()

    # --- entries ---

    def _use(self, entries):
        self.entries = entries
        self.change("Details", [details.text_of(entry) for entry in entries])
        self._list()

    def _list(self):
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.entries))
        for row, (entry, letter) in enumerate(zip(self.entries, self._letters())):
            words = details.words_of(entry)
            self.table.setItem(row, 0, widgets.cell(self._place(entry), tip="\n".join(words[:20])))
            self.table.setItem(row, 1, widgets.cell(letter, edited=True))
            self.table.setItem(row, 2, widgets.cell(details.scale_text(entry), edited=True))
            self.table.setItem(row, 3, widgets.cell(f"{entry['radius']:.4g}" if "radius" in entry else "", edited=True))
        self.table.blockSignals(False)
        self.lights.mark()

    def _letters(self):
        """As the drawing gives them: to sections with views of their own first."""
        try:
            others = section.own_views(section.entries_of(self.obj))
        except Refused:  # which the drawing tells
            others = []
        return details.letters_of(others + self.entries)[len(others):]

    def _place(self, entry):
        words = details.words_of(entry)
        if words:
            return ", ".join(label_of(self.document, word) for word in words)
        return ", ".join(f"{a:.4g}" for a in entry.get("at", ()))

    def _edited(self, cell):
        key, text = ("letter", "scale", "radius")[cell.column() - 1], cell.text().strip()
        entry = dict(self.entries[cell.row()])
        entry.pop(key, None)
        try:
            value = self._value(key, text, entry)
        except ValueError as why:
            self.message.setText(str(why))
        else:
            entries = list(self.entries)
            entries[cell.row()] = {**entry, **({key: value} if value else {})}
            self.entries = entries
            self.change("Details", [details.text_of(one) for one in entries])
        QtCore.QTimer.singleShot(0, lambda: self.over or self._list())  # not while the cell tells

    def _value(self, key, text, entry):
        """Nothing where the cell is empty. Throws ValueError."""
        if key == "letter":
            if text and text in [other.get("letter") for other in self.entries]:
                raise ValueError(tr("another detail has this letter"))
            return text
        if key == "scale":
            if text and not details.scale_of(text) > 0:
                raise ValueError(tr("a scale is such as 5:1 or 1:2"))
            return text
        try:
            radius = FreeCAD.Units.Quantity(text).Value if text else 0.0
        except (ValueError, OSError, TypeError):
            radius = -1.0
        if radius < 0 or not radius <= 1e12 or not radius and "at" in entry:
            raise ValueError(tr("a radius is more than 0 mm"))
        return radius

    # --- what is selected ---

    def _paths(self):
        """Of the objects of the illustration that are selected."""
        return [path for path in selected_paths(self.document) if numbers_of(path, self.extent.sources)]

    def _add_objects(self):
        paths = self._paths()
        if not paths:
            self.message.setText(tr("select objects of the illustration in the 3-D view or the tree"))
            return
        self._use([*self.entries, details.of_objects(paths)])

    def _add_point(self):
        entry = selected_place(self.document, float(f"{NEAR * self.extent.whole().DiagonalLength:.3g}"))
        if entry is None:
            self.message.setText(tr("select a face, an edge or a vertex, or click an object in the 3-D view"))
            return
        self._use([*self.entries, entry])

    def _delete(self):
        rows = self.lights.rows()
        self._use([entry for row, entry in enumerate(self.entries) if row not in rows])


def selected_place(document, radius):
    """A detail about the face, edge or vertex that is selected, else where an object was clicked; nothing where neither is. `radius`: of
    what has no size."""
    for chosen in Gui.Selection.getSelectionEx(document.Name, 0):
        for sub in chosen.SubElementNames:
            if sub.rpartition(".")[2]:
                top, sub = from_the_top(chosen.Object, sub)
                return details.of_shape(details.shape_at(top, sub), radius)
        for point in chosen.PickedPoints:
            return details.of_point([round(a, 6) + 0.0 for a in point], radius)
    return None
