"""The panel of an illustration's dimensions and notes, and what is selected for them."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import kernel
from ..errors import Refused
from ..features.dimension import MOST_DECIMALS, dimensions_of, is_note, kinds, make_dimension, make_note
from ..features.note import lines_of
from ..features.stands_for import illustrations_by
from ..text import tr
from ..view.dimension import light_features
from . import widgets
from .panel import Panel


class DimensionsPanel(Panel):
    def __init__(self, obj, chosen=None):
        """`chosen`: the dimension or note that is selected at first."""
        self._at_first, self._quiet, self.rows, self._area = chosen, False, [], None
        super().__init__(obj)

    @property
    def title(self):
        return tr("Dimensions and notes")

    def fill(self):
        self.list = QtGui.QListWidget()
        self.list.setObjectName("dimensions")
        self.list.setToolTip(tr("What is measured or noted; a row lights it up in the 3-D view"))
        self.list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.list.setMaximumHeight(110)
        self.list.itemSelectionChanged.connect(lambda: self._chosen())
        self.column.addWidget(self.list)
        widgets.row(self.column, widgets.button(tr("Add"), tr("Another dimension: of the faces, edges or vertices that are selected; without any: width, "
                                                              "depth and height"), lambda: self._add(make_dimension), "add"),
                    widgets.button(tr("Add note"), tr("Another note: with a leader to each of the faces, edges, vertices or objects that are selected"),
                                   lambda: self._add(make_note), "add-note"),
                    widgets.button(tr("Delete"), tr("Deletes the rows that are selected above"), self._delete, "delete"))
        form = widgets.group(tr("Selected row"), self.column)
        self.kind = widgets.choice(list(kinds()), "", tr("What is measured, or a note"), lambda kind: self._set_kind(kind), "kind", list(kinds().values()))
        form.addRow(tr("Kind"), self.kind)
        self.texts = {name: self._text(name, tip) for name, tip in (
            ("Text", tr("Instead of the number with its sign, such as 4x ⌀{value}")), ("Tolerance", tr("Behind the number: H7, 0.1 (±0.1), +0.1/-0.2")),
            ("View", tr("The view of the sheet that has it, such as top or A-A; empty: the first that shows it best")))}
        form.addRow(tr("Text"), self.texts["Text"])
        self._add_words(form)
        form.addRow(tr("Tolerance"), self.texts["Tolerance"])
        self.decimals = widgets.whole(-1, tr("Places after the point; -1: those of the style"), lambda places: self._set("Decimals", places), "decimals", -1, MOST_DECIMALS)
        form.addRow(tr("Decimals"), self.decimals)
        form.addRow(tr("View"), self.texts["View"])
        self._list(self._at_first)
        if self._at_first is not None and is_note(self._at_first):
            QtCore.QTimer.singleShot(0, lambda: self.over or self._begin())  # when it is in its window

    def _begin(self):
        """Has what one types go into the words, and these in sight while the panel finds its place."""
        self.words.setFocus()
        area = self.form
        while area is not None and not isinstance(area, QtGui.QScrollArea):
            area = area.parentWidget()
        self._area = area
        if area is not None:
            area.verticalScrollBar().rangeChanged.connect(self._keep_in_sight)

    def _keep_in_sight(self, *_):
        if self.words.hasFocus():
            self._area.ensureWidgetVisible(self.words)

    def closing(self):
        try:
            if self._area is not None:
                self._area.verticalScrollBar().rangeChanged.disconnect(self._keep_in_sight)
        except RuntimeError:  # the window is gone
            pass

    def _add_words(self, form):
        """What notes alone have."""
        self.words = QtGui.QPlainTextEdit()
        self.words.setObjectName("words")
        self.words.setToolTip(tr("The words of the note; {part.name}, {item}, {length}, {area}, {diameter}, {radius}, {volume} are values of what it points at"))
        self.words.setTabChangesFocus(True)
        self.words.setFixedHeight(4 * self.words.fontMetrics().lineSpacing())
        self.words.textChanged.connect(lambda: self._set("Text", self.words.toPlainText()))
        form.addRow(tr("Text"), self.words)
        symbols = kernel.offered()["symbols"]
        self.symbol = widgets.choice(["", *symbols], "", tr("The symbol around the words"), lambda name: self._set_symbol(name), "symbol",
                                     [tr("no symbol"), *map(tr, symbols)])
        self.symbol_kind = widgets.choice([], "", tr("Which of these symbols"), lambda word: self._set_symbol_kind(word), "symbol-kind")
        self.frame = widgets.check(False, tr("Frame"), tr("A frame around the words"), lambda on: self._set("Frame", on), "frame")
        form.addRow(tr("Symbol"), self.symbol)
        form.addRow(tr("Variant"), self.symbol_kind)
        form.addRow("", self.frame)
        self._of_kind = {True: (self.words, self.symbol, self.symbol_kind, self.frame), False: (self.texts["Text"], self.texts["Tolerance"])}
        self._form = form

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
        """What the list has to say: a dimension or note, its row, and what is wrong with it."""
        return [(one, " ".join(filter(None, (one.Label, *(one.Text or one.Tolerance).split()))), one.Message) for one in dimensions_of(self.obj)]

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
        for field in (self.kind, self.decimals, self.words, self.symbol, self.frame, *self.texts.values()):
            field.setEnabled(one is not None)
        if one is not None:
            self.kind.setCurrentIndex(self.kind.findData(one.Kind))
            self.decimals.setValue(one.Decimals)
            light_features(self._selected())
        for name, field in self.texts.items():
            field.setText(getattr(one, name) if one is not None else "")
        self._show_words(one)
        self._quiet = False

    def _show_words(self, one):
        """The fields of its kind, and what those of a note hold."""
        for of_note, fields in self._of_kind.items():
            for field in fields:
                is_shown = (one is not None and is_note(one)) is of_note
                field.setVisible(is_shown)
                if self._form.labelForField(field) is not None:
                    self._form.labelForField(field).setVisible(is_shown)
        if one is None or not is_note(one):
            return
        if lines_of(self.words.toPlainText()) != lines_of(one.Text):  # else the cursor stays where one types
            self.words.setPlainText(lines_of(one.Text))
        self.symbol.setCurrentIndex(self.symbol.findData(one.Symbol))
        self.frame.setChecked(one.Frame)
        key, words = self._option_of(one.Symbol)
        self.symbol_kind.clear()
        for word in words:
            self.symbol_kind.addItem(tr(word), word)
        self.symbol_kind.setEnabled(bool(words))
        self.symbol_kind.setCurrentIndex(max(0, self.symbol_kind.findData(one.SymbolKeys.get(key, ""))))

    @staticmethod
    def _option_of(symbol):
        """The option of a symbol that has words, and these."""
        return next(iter(kernel.offered()["symbols"].get(symbol, {}).items()), ("", []))

    # --- what widgets do ---

    def _set(self, name, value):
        if not self._quiet and self._one() is not None:
            self._put(self._one(), name, value)

    def _set_kind(self, kind):
        self._set("Kind", kind)
        self._chosen()

    def _set_symbol(self, name):
        self._set("Symbol", name)
        self._chosen()

    def _set_symbol_kind(self, word):
        if not self._quiet:
            self._set("SymbolKeys", {**self._one().SymbolKeys, self._option_of(self._one().Symbol)[0]: word})

    def _put(self, one, name, value):
        if not self.over and getattr(one, name) != value:
            setattr(one, name, value)
            one.recompute()  # says what is wrong with it
            self.changed()

    def _add(self, make):
        try:
            made = make(self.obj, selected_features(self.document, wholes=make is make_note))
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


def selected_features(document, wholes=False):
    """The selected faces, edges and vertices, (object, sub-name) each, with `wholes` objects too. Throws Refused where an object is selected
    as a whole else."""
    found, whole = [], []
    for chosen in Gui.Selection.getSelectionEx(document.Name, 0):
        if illustrations_by(chosen.Object) or chosen.Object.isDerivedFrom("TechDraw::DrawPage"):
            continue
        for sub in chosen.SubElementNames or ("",):
            (found if wholes or sub.rpartition(".")[2] else whole).append((chosen.Object, sub))
    if whole:
        raise Refused(tr("{0} is selected as a whole; select faces, edges or vertices in the 3-D view").format(whole[0][0].Label))
    return found
