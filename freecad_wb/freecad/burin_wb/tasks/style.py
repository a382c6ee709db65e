"""The panel that edits a style key by key."""

import json
import os

from PySide import QtCore, QtGui

from .. import kernel
from ..text import tr
from . import widgets
from .panel import Panel

# Pixels that a key stands behind its heading, and a key that has room before its value.
INDENT, LONG = 7, "line.intersection"


def keys(style="technical"):
    """Rows of the keys that change what is drawn, not how a format writes it; those of a style's kinds of strokes too.
    Throws burin.Error where there is no such style."""
    burin = kernel.module()
    return [row for row in burin.style_keys(style) if row["key"].partition(".")[0] not in burin.formats()]


def parted(key):
    """The heading and the name of a key: "strokes.2", "taper"."""
    head, _, name = key.partition(".")
    if head != "strokes":
        return head, name
    number, _, name = name.partition(".")
    return f"{head}.{number}", name


def text_of(value, words=("false", "true")):
    """A value as the property StyleKeys keeps it. `words`: what a flag's values are called."""
    if isinstance(value, bool):
        return words[value]
    if isinstance(value, (list, tuple)):
        return ",".join(f"{v:g}" for v in value)
    return f"{value:g}" if isinstance(value, float) else str(value)


class StylePanel(Panel):
    @property
    def title(self):
        return tr("Style")

    def fill(self):
        self.buttons = {}
        self.base = widgets.choice(widgets.styles(self.obj.Style), self.obj.Style,
                                   tr("A built-in style, or a style file"), self._use, "base")
        self.column.addWidget(self.base)
        row = QtGui.QHBoxLayout()
        for text, tip, name, slot in (
                (tr("Open…"), tr("Chooses a style file"), "open", self._open),
                (tr("Save as…"), tr("Saves the style with all changes as a file"), "save", self._save),
                (tr("Reset"), tr("Takes back all changes: the values of the style itself"), "reset", self._reset)):
            button = QtGui.QPushButton(text)
            button.setObjectName(name)
            button.setToolTip(tip)
            button.setMinimumWidth(50)
            button.clicked.connect(lambda *_, slot=slot: slot())
            row.addWidget(button)
            self.buttons[name] = button
        self.column.addLayout(row)
        self.filter = QtGui.QLineEdit()
        self.filter.setObjectName("filter")
        self.filter.setPlaceholderText(tr("Filter"))
        self.filter.setToolTip(tr("Shows keys whose name or meaning holds these words"))
        self.filter.setClearButtonEnabled(True)
        self.filter.textChanged.connect(lambda words: self._filter(words))
        self.column.addWidget(self.filter)
        kinds = {row["name"]: row["meaning"] for row in kernel.module().catalogues()["stroke_kinds"]}
        self.kinds = widgets.choice(["", *kinds], "", tr("Draws strokes of another kind over those that there are"),
                                    self._add_strokes, "add-strokes", [tr("Add strokes…"), *kinds])
        for k, meaning in enumerate(kinds.values()):
            self.kinds.setItemData(k + 1, meaning, QtCore.Qt.ToolTipRole)
        added = QtGui.QHBoxLayout()
        added.addWidget(self.kinds, 1)
        self.less = widgets.button(tr("Take back"), tr("Takes back the strokes that were added last, with all changes of them"),
                                   self._remove_strokes, "remove-strokes")
        added.addWidget(self.less)
        self.column.addLayout(added)
        self.tree = QtGui.QTreeWidget()
        self.tree.setObjectName("keys")
        self.tree.setColumnCount(2)
        self.tree.setHeaderLabels([tr("Key"), tr("Value")])
        self.tree.setMinimumHeight(260)
        self.tree.setIndentation(INDENT)
        self.tree.header().setStretchLastSection(False)
        self.tree.header().setSectionResizeMode(1, QtGui.QHeaderView.Stretch)
        self.column.addWidget(self.tree, 1)
        self._fill_keys()
        QtCore.QTimer.singleShot(0, self._make_room)  # themes have their say only when the tree is shown

    def _make_room(self):
        """The column of the keys as wide as a long one needs it."""
        if not self.over:
            item = self.items[LONG]
            self.tree.setColumnWidth(0, self.tree.visualItemRect(item).x() + self.tree.sizeHintForIndex(self.tree.indexFromItem(item, 0)).width())

    def _added(self):
        """The headings of the kinds of strokes that the style itself has not, in their order."""
        return sorted(parted(key)[0] for key in dict(self.obj.StyleKeys) if key.startswith("strokes.") and key.endswith(".kind"))

    def _remove_strokes(self):
        last = self._added()[-1]
        self.change("StyleKeys", {key: value for key, value in dict(self.obj.StyleKeys).items() if parted(key)[0] != last})
        self._fill_keys()

    def _fill_keys(self):
        """All keys with an editor each. Throws errors.KernelMissing."""
        self.less.setEnabled(bool(self._added()))
        self.tree.clear()
        self.editors, self.items, heads = {}, {}, {}
        changed = dict(self.obj.StyleKeys)
        rows = self._rows(changed)
        for row in rows:
            head, name = parted(row["key"])
            if head not in heads:
                group, _, number = head.partition(".")
                heads[head] = QtGui.QTreeWidgetItem(self.tree, [f"{tr(group)} {number}".strip()])
                heads[head].setExpanded(group in ("line", "hatch", "strokes"))
                heads[head].setFirstColumnSpanned(True)
            item = QtGui.QTreeWidgetItem(heads[head], [name.replace("_", " ")])
            tip = f"{row['key']}: {row['meaning']} ({row['takes']})"
            item.setToolTip(0, tip)
            value = changed.get(row["key"], self.values.get(row["key"], row["value"]))
            editor = self._editor(row, value, tip)
            self.tree.setItemWidget(item, 1, editor)
            self.editors[row["key"]], self.items[row["key"]] = editor, item
            self._mark(row["key"])

    def _rows(self, changed):
        """The keys of the style with its kinds of strokes and those that were added; `values` gets what they have
        without the changes."""
        burin = kernel.module()
        added = {key: value for key, value in changed.items() if key.startswith("strokes.") and key.endswith(".kind")}
        try:
            values = burin.style(self.obj.Style)
            rows = keys({**values, **added})
        except burin.Error as error:
            QtCore.QTimer.singleShot(0, lambda text=str(error): self.message.setText(text))
            self.values = {}
            return keys()
        self.values = {row["key"]: text_of(values[row["key"]], row.get("words")) if row["key"] in values else row["value"]
                       for row in rows}
        return rows

    def _add_strokes(self, kind):
        if not kind:
            return
        numbers = {parted(key)[0] for key in self.editors if key.startswith("strokes.")}
        self.change("StyleKeys", {**dict(self.obj.StyleKeys), f"strokes.{len(numbers) + 2}.kind": kind})
        self.kinds.setCurrentIndex(0)
        self._fill_keys()

    def _editor(self, row, value, tip):
        key, kind = row["key"], row["kind"]
        if kind == "flag":
            off, on = row["words"]
            return widgets.check(value == on, "", tip, lambda checked: self._set(key, on if checked else off), key)
        if kind == "number":
            return widgets.number(float(value), tip, lambda v: self._set(key, f"{v:.6g}"), key, row["low"],
                                  row["high"], 3, _step(float(value)), row["unit"])
        if kind == "whole":
            return widgets.number(int(value), tip, lambda v: self._set(key, f"{v:.0f}"), key, row["low"], row["high"], 0, 1)
        if kind == "word":
            return widgets.choice(row["words"], value, tip, lambda v: self._set(key, v), key)
        line = QtGui.QLineEdit(value)
        line.setObjectName(key)
        line.setToolTip(tip)
        line.editingFinished.connect(lambda: self._set(key, line.text().strip()))
        return line

    def _set(self, key, text):
        changed = dict(self.obj.StyleKeys)
        if _same(text, self.values.get(key)):
            changed.pop(key, None)
        else:
            changed[key] = text
        self.change("StyleKeys", changed)
        self._mark(key)

    def _mark(self, key):
        font = self.items[key].font(0)
        font.setBold(key in self.obj.StyleKeys)
        self.items[key].setFont(0, font)
        self.buttons["reset"].setEnabled(bool(dict(self.obj.StyleKeys)))

    def _use(self, name):
        if name != self.obj.Style:
            self.change("Style", name)
            self._fill_keys()

    def _reset(self):
        self.change("StyleKeys", {})
        self._fill_keys()

    def _filter(self, words):
        wanted = words.lower().split()
        for k in range(self.tree.topLevelItemCount()):
            head, shown = self.tree.topLevelItem(k), 0
            for r in range(head.childCount()):
                item = head.child(r)
                fits = all(w in item.toolTip(0).lower() for w in wanted)
                item.setHidden(not fits)
                shown += fits
            head.setHidden(shown == 0)
            if wanted:
                head.setExpanded(True)

    def _open(self):
        name, _ = QtGui.QFileDialog.getOpenFileName(self.form, tr("Style file"), "", tr("Style files") + " (*.json);;* (*)")
        if name:
            self.use(name)

    def use(self, name):
        if self.base.findData(name) < 0:
            self.base.addItem(os.path.basename(name), name)
        self.base.setCurrentIndex(self.base.findData(name))

    def _save(self):
        name, _ = QtGui.QFileDialog.getSaveFileName(self.form, tr("Save style"), "", tr("Style files") + " (*.json)")
        if name:
            self.save(name if name.endswith(".json") else name + ".json")

    def save(self, name):
        """Writes all keys to a file, and uses the file from now on."""
        try:
            write_style(name, self.obj.Style, self.obj.StyleKeys)
        except (OSError, kernel.module().Error) as error:
            self.message.setText(str(error))
            return
        self.change("StyleKeys", {})
        self.use(name)


def write_style(name, style, changes):
    """A style file with all keys. Throws OSError, burin.Error."""
    burin = kernel.module()
    values = burin.style({**burin.style(style), **dict(changes)})
    with open(name, "w", encoding="utf-8") as file:
        json.dump(values, file, indent=2)
        file.write("\n")


def _step(value):
    """A twentieth or so of a value, one digit."""
    return float(f"{max(abs(value), 0.02) / 20:.0e}")


def _same(a, b):
    try:
        return abs(float(a) - float(b)) < 1e-9
    except (TypeError, ValueError):
        return a == b
