"""Panels and icons where they are hardest to read: on a small screen that is scaled, and in a dark theme. run.py has the settings."""

import os
import pathlib
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore, QtGui, QtSvg  # noqa: E402

ICONS = pathlib.Path(__file__).resolve().parents[3] / "freecad_wb/freecad/burin_wb/resources/icons"
PANELS = ("Burin_Edit", "Burin_Style", "Burin_Section", "Burin_Explode", "Burin_NumberParts", "Burin_Detail", "Burin_SectionView", "Burin_Dimension", "Burin_Note")
# Of black and white.
READABLE = 0.25
# What toolbars of FreeCAD's themes are painted with.
LIGHT, DARK = "#f0f0f0", "#23282f"


def lightness(color):
    return 0.299 * color.redF() + 0.587 * color.greenF() + 0.114 * color.blueF()


def colors(image):
    return [image.pixelColor(x, y) for y in range(image.height()) for x in range(image.width())]


class Panels(support.Case):
    def setUp(self):
        super().setUp()
        for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
            if dock.objectName() in ("Python console", "Report view"):
                dock.hide()
        self.obj = self.illustrate(*self.box_and_ball())

    def shown(self, name):
        self.select(self.obj, *([self.obj.Sources[0][0]] if name == "Burin_Note" else []))
        if name == "Burin_Edit":
            self.obj.ViewObject.Proxy.doubleClicked(self.obj.ViewObject)
        else:
            Gui.runCommand(name)
        if name == "Burin_Dimension":  # its panel is that of what it made
            self.obj.Dimensions[0].ViewObject.Proxy.doubleClicked(self.obj.Dimensions[0].ViewObject)
        support.settle(300)
        support.drawn()
        return support.panel()

    def area(self, form):
        """What scrolls a panel."""
        while not isinstance(form, QtGui.QScrollArea):
            form = form.parentWidget()
        return form

    def test_nothing_is_cut_off(self):
        for name in PANELS:
            form = self.shown(name).form
            support.screenshot(f"{name}-{os.environ.get('BURIN_TEST_STYLESHEET') or 'light'}")
            with self.subTest(name):
                area = self.area(form)
                self.assertEqual(area.horizontalScrollBar().maximum(), 0, "wider than the panel's room")
                for head in form.findChildren(QtGui.QHeaderView):
                    if head.orientation() == QtCore.Qt.Horizontal and head.isVisible():
                        for k in range(head.count()):
                            text = head.model().headerData(k, QtCore.Qt.Horizontal)
                            room = head.fontMetrics().boundingRect(text).width() + 4
                            self.assertGreaterEqual(head.sectionSize(k), room, text)
                for button in form.findChildren(QtGui.QPushButton):
                    room = button.fontMetrics().boundingRect(button.text()).width() + 4
                    self.assertGreaterEqual(button.width(), room, button.text())
                for box in form.findChildren(QtGui.QAbstractSpinBox):
                    # Where a number has many digits it is scrolled in its field.
                    line = box.findChild(QtGui.QLineEdit)
                    room = line.fontMetrics().boundingRect(line.text()).width() + 1
                    if line.isVisible() and len(line.text()) <= 8 and not line.text()[:4].isdigit():
                        self.assertGreaterEqual(line.width(), room, (box.objectName(), line.text()))
                for tree in form.findChildren(QtGui.QTreeWidget):
                    item = support.panel().items["line.intersection"]
                    room = tree.visualItemRect(item).x() + tree.sizeHintForIndex(tree.indexFromItem(item, 0)).width()
                    self.assertGreaterEqual(tree.columnWidth(0), room)
            support.panel().reject()
            support.settle(100)

    def test_words_are_lighter_or_darker_than_what_they_stand_on(self):
        for name in PANELS:
            form = self.shown(name).form
            for kind in (QtGui.QLabel, QtGui.QCheckBox, QtGui.QPushButton, QtGui.QComboBox):
                for widget in form.findChildren(kind):
                    text = widget.currentText() if kind is QtGui.QComboBox else widget.text()
                    if text and widget.isVisible() and widget.isEnabled():
                        seen = [lightness(c) for c in colors(widget.grab().toImage())]
                        self.assertGreater(max(seen) - min(seen), READABLE, (name, text))
            support.panel().reject()
            support.settle(100)

    def test_the_preview_leaves_room_on_a_low_screen(self):
        panel = self.shown("Burin_Edit")
        screen = QtGui.QGuiApplication.primaryScreen().availableGeometry().height()
        self.assertLessEqual(panel.preview.height(), max(110, screen // 4))
        self.assertLess(panel.preview.shown().height() / panel.preview.shown().width(), 1.0)
        panel.reject()

    def test_icons_are_seen_on_light_and_on_dark(self):
        """Lines are dark, so on dark it is the surfaces that stand out: at least two fifths of what is painted."""
        for icon in sorted(ICONS.glob("*.svg")):
            for ground in (LIGHT, DARK):
                image = QtGui.QImage(48, 48, QtGui.QImage.Format_ARGB32)
                image.fill(QtCore.Qt.transparent)
                painter = QtGui.QPainter(image)
                QtSvg.QSvgRenderer(str(icon)).render(painter)
                painter.end()
                painted = [c for c in colors(image) if c.alphaF() > 0.5]
                out = [c for c in painted if abs(lightness(c) - lightness(QtGui.QColor(ground))) > READABLE]
                self.assertGreater(len(out), 0.4 * len(painted) if ground == DARK else 0.25 * len(painted), (icon.name, ground))


support.run(__name__)
