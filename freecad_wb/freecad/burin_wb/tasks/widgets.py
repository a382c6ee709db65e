"""Small pieces of panels."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import kernel


# Pixels beside each other in a panel that is as narrow as FreeCAD 1.0 makes it, and between two widgets there.
NARROW, GAP = 225, 6


class _StillWheel(QtCore.QObject):
    """The wheel scrolls the panel; it changes a field only where one has clicked into it."""

    def eventFilter(self, widget, event):
        if event.type() == QtCore.QEvent.Wheel and not widget.hasFocus():
            event.ignore()
            return True
        return False


def still(box):
    """A field that the wheel does not change in passing."""
    box.setFocusPolicy(QtCore.Qt.StrongFocus)
    box.still_wheel = _StillWheel(box)
    box.installEventFilter(box.still_wheel)
    return box


def warm():
    """Loads what the first field with a unit takes 40 ms for."""
    Gui.UiLoader().createWidget("Gui::QuantitySpinBox")


def quantity(value, unit, tip, changed, name, least=0.0, most=1e6):
    """A field with a unit, such as '180 mm'; `changed` gets the number in that unit."""
    box = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setObjectName(name)
    box.setProperty("unit", unit)
    box.setProperty("minimum", least)
    box.setProperty("maximum", most)
    box.setProperty("rawValue", float(value))
    box.setToolTip(tip)
    box.setMinimumWidth(60)
    box.valueChanged.connect(lambda *_: changed(float(box.property("rawValue"))))
    return still(box)


class _Number(QtGui.QDoubleSpinBox):
    """Without zeros at the end, for which a narrow panel has no room."""

    def textFromValue(self, value):
        text, point = super().textFromValue(value), self.locale().decimalPoint()
        return text.rstrip("0").rstrip(point) if point in text else text


def number(value, tip, changed, name, least, most, decimals=3, step=0.1, unit=""):
    box = _Number()
    if unit:
        box.setSuffix("°" if unit == "degrees" else " " + unit)
    box.setObjectName(name)
    box.setDecimals(decimals)
    box.setRange(least, most)
    box.setSingleStep(step)
    box.setValue(value)
    box.setToolTip(tip)
    box.setMinimumWidth(50)
    box.valueChanged.connect(lambda value: changed(value))
    return still(box)


def whole(value, tip, changed, name, least, most):
    box = QtGui.QSpinBox()
    box.setObjectName(name)
    box.setRange(least, most)
    box.setValue(value)
    box.setToolTip(tip)
    box.valueChanged.connect(lambda value: changed(value))
    return still(box)


def choice(values, chosen, tip, changed, name, texts=None):
    """A list of words; `texts` are what is shown of them."""
    box = QtGui.QComboBox()
    box.setObjectName(name)
    for k, value in enumerate(values):
        box.addItem((texts or values)[k], value)
    box.setCurrentIndex(max(0, list(values).index(chosen) if chosen in values else 0))
    box.setToolTip(tip)
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(6)
    box.currentIndexChanged.connect(lambda k: changed(box.itemData(k)))
    return still(box)


def check(value, text, tip, changed, name):
    box = QtGui.QCheckBox(text)
    box.setObjectName(name)
    box.setChecked(value)
    box.setToolTip(tip)
    box.toggled.connect(lambda on: changed(on))
    return box


def styles(chosen):
    """Names of styles to choose from: the built-in ones, and a file where one is chosen."""
    names = list(kernel.offered()["styles"])
    if chosen and chosen not in names:
        names.append(chosen)
    return names


def group(title, column):
    """A titled box; returns its form layout."""
    box = QtGui.QGroupBox(title)
    form = QtGui.QFormLayout(box)
    form.setContentsMargins(6, 4, 6, 4)
    form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    column.addWidget(box)
    return form


def button(text, tip, clicked, name):
    made = QtGui.QPushButton(text)
    made.setObjectName(name)
    made.setToolTip(tip)
    made.setMinimumWidth(max(28, made.fontMetrics().boundingRect(text).width() + 12))  # its own hint is wider than a panel has room for
    made.clicked.connect(lambda *_: clicked())
    return made


def row(column, *items):
    """Widgets side by side; the first takes what is left. Where that is a button, those that a narrow panel has no room for come into
    lines of their own."""
    buttons, line, left = isinstance(items[0], QtGui.QPushButton), None, 0
    for k, item in enumerate(items):
        left -= item.minimumWidth() + GAP if buttons else 0
        if line is None or left < 0:
            line = QtGui.QHBoxLayout()
            column.addLayout(line)
            left = NARROW - item.minimumWidth()
        line.addWidget(item, 0 if k and not buttons else 1)


def slim(header):
    """The heads of a table without the margins that dark themes give them: a narrow panel would cut their words off."""
    if QtGui.QApplication.instance().styleSheet():
        header.setStyleSheet("QHeaderView::section { padding: 2px; margin: 0px; }")


def table(heads, tips, name):
    """An empty table whose first column takes what the others leave."""
    made = QtGui.QTableWidget(0, len(heads))
    made.setObjectName(name)
    made.setHorizontalHeaderLabels(heads)
    for k, tip in enumerate(tips):
        made.horizontalHeaderItem(k).setToolTip(tip)
    made.verticalHeader().hide()
    made.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
    header = made.horizontalHeader()
    slim(header)
    header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
    header.setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
    made.setMinimumHeight(140)
    return made


def cell(text, edited=False, tip=""):
    """An item of a table."""
    made = QtGui.QTableWidgetItem(text)
    flags = QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable
    made.setFlags(flags | QtCore.Qt.ItemIsEditable if edited else flags)
    if tip:
        made.setToolTip(tip)
    return made
