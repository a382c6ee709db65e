"""The page of Edit > Preferences: resources/preferences.ui, its lists filled with what the kernel offers."""

import os

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import kernel, preferences
from ..features.properties import default_of, words_of
from ..text import tr

_FORM = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "preferences.ui")


class Page:
    """The widgets of `form` that have a property "preference" hold what it names. FreeCAD calls `load` when the
    page is made, `save` with OK."""

    def __init__(self):
        self.form = Gui.PySideUic.loadUi(_FORM)
        styles = kernel.offered()["styles"]
        self._fill("style", {name: name for name in styles}, {name: tr(meaning) for name, meaning in styles.items()})
        self._fill("sheet", {name: _title(name, *size) for name, size in preferences.sheets().items()})
        self._fill("hidden", {word: tr(word.lower()) for word in words_of("HiddenLines")})
        self._defaults = {"StyleName": default_of("Style"), "Hidden": words_of("HiddenLines")[0]}

    def load(self):
        for widget, name in self._fields():
            text = preferences.group().GetString(name, "") or self._defaults.get(name, "")
            if isinstance(widget, QtGui.QComboBox):
                widget.setCurrentIndex(max(widget.findData(text), 0))
            else:
                widget.setProperty(_content(widget), text)

    def save(self):
        for widget, name in self._fields():
            text = widget.currentData() if isinstance(widget, QtGui.QComboBox) else widget.property(_content(widget))
            if text == self._defaults.get(name, ""):
                preferences.group().RemString(name)
            else:
                preferences.group().SetString(name, text)

    def _fill(self, name, texts, tips=None):
        box = self.form.findChild(QtGui.QComboBox, name)
        for k, (value, text) in enumerate(texts.items()):
            box.addItem(text, value)
            if tips:
                box.setItemData(k, tips[value], QtCore.Qt.ToolTipRole)

    def _fields(self):
        """Widgets with the names of their preferences."""
        for widget in self.form.findChildren(QtGui.QWidget):
            if widget.property("preference"):
                yield widget, widget.property("preference")


def _content(widget):
    """The property of a field that holds its text: lines, and fields for files."""
    return "text" if isinstance(widget, QtGui.QLineEdit) else "fileName"


def _title(name, width, height):
    size = f"{width:g} x {height:g} mm"
    if not name:
        return size
    paper = name[:-1] if name.endswith("p") else name
    return f"{paper} {tr('portrait') if name.endswith('p') else tr('landscape')} ({size})"
