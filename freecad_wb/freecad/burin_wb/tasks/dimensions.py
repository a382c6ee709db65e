"""The panel of an illustration's dimensions, and what is selected to be measured."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..errors import Refused
from ..features.dimension import MOST_DECIMALS, dimensions_of, kinds, make_dimension
from ..features.stands_for import illustrations_by
from ..text import tr
from ..view.dimension import light_features
from . import widgets
from .panel import Panel

class DimensionsPanel(Panel):
    def __init__(self, obj, chosen=None):
        """`chosen`: the dimension that is selected at first."""
        self._at_first, self._quiet, self.rows = chosen, False, []
        super().__init__(obj)

    @property
    def title(self):
        return tr("Dimensions")

    def fill(self):
        self.list = QtGui.QListWidget()
        self.list.setObjectName("dimensions")
        self.list.setToolTip(tr("What is measured; a row lights it up in the 3-D view"))
        self.list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.list.setMaximumHeight(110)
        self.list.itemSelectionChanged.connect(lambda: self._chosen())
        self.column.addWidget(self.list)
        widgets.row(self.column, widgets.button(tr("Add"), tr("Another dimension: of the faces, edges or vertices that are selected; without any: width, "
                                                              "depth and height"), self._add, "add"),
                    widgets.button(tr("Delete"), tr("Deletes the dimensions that are selected above"), self._delete, "delete"))
        form = widgets.group(tr("Selected dimension"), self.column)
        self.kind = widgets.choice(list(kinds()), "", tr("What is measured"), lambda kind: self._set("Kind", kind), "kind", list(kinds().values()))
        form.addRow(tr("Kind"), self.kind)
        self.texts = {name: self._text(name, tip) for name, tip in (
            ("Text", tr("Instead of the number with its sign, such as 4x ⌀{value}")), ("Tolerance", tr("Behind the number: H7, 0.1 (±0.1), +0.1/-0.2")),
            ("View", tr("The view of the sheet that has it, such as top or A-A; empty: the first that shows it best")))}
        form.addRow(tr("Text"), self.texts["Text"])
        form.addRow(tr("Tolerance"), self.texts["Tolerance"])
        self.decimals = widgets.whole(-1, tr("Places after the point; -1: those of the style"), lambda places: self._set("Decimals", places), "decimals", -1, MOST_DECIMALS)
        form.addRow(tr("Decimals"), self.decimals)
        form.addRow(tr("View"), self.texts["View"])
        self._list(self._at_first)

    def _text(self, name, tip):
        field = QtGui.QLineEdit()
        field.setObjectName(name.lower())
        field.setToolTip(tip)
        field.editingFinished.connect(lambda: self._set(name, field.text().strip()))
        return field

    def refresh(self):
        if self._shown() != self._told:
            self._list(self._one())

    # --- rows ---

    def _shown(self):
        """What the list has to say: a dimension, its row, and what is wrong with it."""
        return [(one, " ".join(filter(None, (one.Label, one.Text or one.Tolerance))), one.Message) for one in dimensions_of(self.obj)]

    def _list(self, chosen=None):
        self._told = self._shown()
        self.rows = [one for one, _, _ in self._told]
        self._quiet = True
        self.list.clear()
        for _, text, message in self._told:
            QtGui.QListWidgetItem(text, self.list).setToolTip(message)
        self._quiet = False
        if chosen in self.rows:
            self.list.setCurrentRow(self.rows.index(chosen))
        self._chosen()

    def _selected(self):
        return [self.rows[row] for row in sorted(index.row() for index in self.list.selectionModel().selectedRows())]

    def _one(self):
        """The first that is selected."""
        return next(iter(self._selected()), None)

    def _chosen(self):
        if self._quiet:
            return
        one = self._one()
        self._quiet = True
        for field in (self.kind, self.decimals, *self.texts.values()):
            field.setEnabled(one is not None)
        if one is not None:
            self.kind.setCurrentIndex(self.kind.findData(one.Kind))
            self.decimals.setValue(one.Decimals)
            light_features(self._selected())
        for name, field in self.texts.items():
            field.setText(getattr(one, name) if one is not None else "")
        self._quiet = False

    # --- what widgets do ---

    def _set(self, name, value):
        if not self._quiet and self._one() is not None:
            self._put(self._one(), name, value)

    def _put(self, one, name, value):
        if not self.over and getattr(one, name) != value:
            setattr(one, name, value)
            one.recompute()  # says what is wrong with it
            self.changed()

    def _add(self):
        try:
            made = make_dimension(self.obj, selected_features(self.document))
        except Refused as why:
            self.message.setText(str(why))
            return
        made.recompute()
        self._list(made)
        self.changed()

    def _delete(self):
        for one in self._selected():
            self.document.removeObject(one.Name)
        self._list()
        QtCore.QTimer.singleShot(0, self.changed)


def selected_features(document):
    """The selected faces, edges and vertices, (object, sub-name) each. Throws Refused where an object is selected as a whole."""
    found, whole = [], []
    for chosen in Gui.Selection.getSelectionEx(document.Name, 0):
        if illustrations_by(chosen.Object) or chosen.Object.isDerivedFrom("TechDraw::DrawPage"):
            continue
        for sub in chosen.SubElementNames or ("",):
            (found if sub.rpartition(".")[2] else whole).append((chosen.Object, sub))
    if whole:
        raise Refused(tr("{0} is selected as a whole; select faces, edges or vertices in the 3-D view").format(whole[0][0].Label))
    return found
