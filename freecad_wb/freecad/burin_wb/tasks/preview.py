"""The drawing as it is now: small in a panel, and as large as one likes in a window of its own."""

import os
import threading

from PySide import QtCore, QtGui, QtSvg

from .. import kernel
from ..errors import KernelMissing
from ..text import tr

# Pixels of a panel, in which a low screen leaves room for more than the preview: a quarter of its height at the most.
HEIGHT, LEAST, SHARE = 190, 110, 4
WIDTH = 220

# Milliseconds after which a window that was made larger or smaller is painted anew.
RESIZED = 150


class Picture(QtGui.QWidget):
    """Shows the kept drawing of an illustration on white paper. The kernel paints it, in a thread: Qt takes half a second
    for 7000 strokes, and only in the GUI's thread. Without the kernel Qt paints."""

    def __init__(self, obj):
        super().__init__()
        self._obj = obj
        self._image = QtGui.QImage()
        self._painting = None  # what a thread works at: a list that gets the picture
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(30)
        self._timer.timeout.connect(lambda: self._look())

    def renew(self):
        """Reads the drawing again: painted once, shown many times."""
        self._painting = None
        if not self._obj.Drawing or not os.path.exists(self._obj.Drawing):
            self._show(QtGui.QImage())
        elif kernel.found():
            self._painting = painting = []
            sheet = self._sheet()
            dpi = max(10.0, 25.4 * self._dots() * sheet.width() / max(self._obj.Width.Value, 1.0))
            threading.Thread(target=_paint, args=(self._obj.Drawing, dpi, painting), daemon=True).start()
            self._timer.start()
        else:
            self._show(self._by_qt())

    def busy(self):
        """Whether the picture is still being painted."""
        return self._painting is not None

    def _look(self):
        if self._painting:
            painted, self._painting = self._painting[0], None
            try:
                self._show(QtGui.QImage.fromData(painted) if painted else self._by_qt())
            except ReferenceError:  # the document was closed meanwhile, and the drawing went with it
                pass
        if self._painting is None:
            self._timer.stop()

    def _show(self, image):
        self._image = image
        self.update()

    def _sheet(self):
        """The size of the picture."""
        sheet = QtCore.QSizeF(self._obj.Width.Value, self._obj.Height.Value)
        sheet.scale(QtCore.QSizeF(self._room()), QtCore.Qt.KeepAspectRatio)
        return sheet

    def _room(self):
        """What there is for the picture, in pixels."""
        return self.size()

    def _dots(self):
        """A side, for each pixel of the widget."""
        return 1 if self._room().width() > 4 * WIDTH else 2

    def _by_qt(self):
        renderer = QtSvg.QSvgRenderer()
        if not self._obj.Picture or not os.path.exists(self._obj.Picture) or not renderer.load(self._obj.Picture):
            return QtGui.QImage()
        image = QtGui.QImage(self._dots() * self._sheet().toSize(), QtGui.QImage.Format_RGB32)
        image.fill(QtCore.Qt.white)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        renderer.render(painter)
        painter.end()
        return image

    def paintEvent(self, event):
        if self._image.isNull():
            return
        size = self._image.size().scaled(self.size(), QtCore.Qt.KeepAspectRatio)
        place = QtCore.QRect(QtCore.QPoint((self.width() - size.width()) // 2, (self.height() - size.height()) // 2),
                             size)
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform)
        painter.drawImage(place, self._image)
        painter.end()

    def shown(self):
        """The picture that is shown."""
        return self._image


class Preview(Picture):
    """Small, in a panel; a click opens the large one."""

    def __init__(self, obj):
        super().__init__(obj)
        self.setObjectName("preview")
        screen = QtGui.QGuiApplication.primaryScreen().availableGeometry().height()
        self._height = max(LEAST, min(HEIGHT, screen // SHARE))
        self.setFixedHeight(self._height)
        self.setCursor(QtCore.Qt.PointingHandCursor)
        self.setToolTip(tr("The drawing as it is now; a click shows it large"))
        self.large = None
        self.renew()

    def _room(self):
        return QtCore.QSize(max(self.width(), WIDTH), self._height)

    def mousePressEvent(self, event):
        self.enlarge()

    def enlarge(self):
        """Opens the large preview, or brings it to the front."""
        if self.large is None:
            self.large = LargePreview(self._obj, self.window())
            self.large.move(self.mapToGlobal(QtCore.QPoint(self.width() + 60, 0)))
        self.large.show()
        self.large.raise_()
        self.large.renew()

    def renew(self):
        super().renew()
        if self.large is not None and self.large.isVisible():
            self.large.renew()

    def close_large(self):
        if self.large is not None:
            self.large.close()
            self.large = None


class LargePreview(QtGui.QDialog):
    """A window beside FreeCAD's: every change of a panel shows in it as soon as it is drawn."""

    def __init__(self, obj, parent):
        super().__init__(parent)
        self.setObjectName("large-preview")
        self.setWindowTitle(obj.Label)
        self.setWindowFlags(QtCore.Qt.Window)
        box = QtGui.QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        self.picture = Picture(obj)
        self.picture.setMinimumSize(WIDTH, HEIGHT)
        box.addWidget(self.picture)
        shown = QtCore.QSizeF(obj.Width.Value, obj.Height.Value)
        shown.scale(900, 700, QtCore.Qt.KeepAspectRatio)
        self.resize(shown.toSize())
        self._resized = QtCore.QTimer(self)
        self._resized.setSingleShot(True)
        self._resized.setInterval(RESIZED)
        self._resized.timeout.connect(lambda: self.renew())

    def renew(self):
        self.picture.renew()

    def resizeEvent(self, event):
        self._resized.start()

    def hideEvent(self, event):
        self._resized.stop()  # the illustration may be gone when it ends


def _paint(path, dpi, into):
    """In a thread: appends the PNG of a drawing file; nothing where it cannot be read."""
    try:
        burin = kernel.module()
    except KernelMissing:
        into.append(None)
        return
    try:
        into.append(burin.Drawing.load(path).to_bytes("png", png_dpi=dpi))
    except burin.Error:  # replaced meanwhile, or spoilt
        into.append(None)
