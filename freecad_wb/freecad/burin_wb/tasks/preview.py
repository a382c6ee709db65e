"""The drawing as it is now, small, in a panel."""

import os
import threading

from PySide import QtCore, QtGui, QtSvg

from .. import kernel
from ..errors import KernelMissing

HEIGHT = 190
WIDTH = 220


class Preview(QtGui.QWidget):
    """Shows the kept drawing of an illustration on white paper. The kernel paints it, in a thread: Qt takes half a second
    for 7000 strokes, and only in the GUI's thread. Without the kernel Qt paints."""

    def __init__(self, obj):
        super().__init__()
        self.setObjectName("preview")
        self.setMinimumHeight(HEIGHT)
        self.setMaximumHeight(HEIGHT)
        self._obj = obj
        self._image = QtGui.QImage()
        self._painting = None  # what a thread works at: a list that gets the picture
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(30)
        self._timer.timeout.connect(lambda: self._look())
        self.renew()

    def renew(self):
        """Reads the drawing again: painted once, shown many times."""
        self._painting = None
        if not self._obj.Drawing or not os.path.exists(self._obj.Drawing):
            self._show(QtGui.QImage())
        elif kernel.found():
            self._painting = painting = []
            sheet = self._sheet()
            dpi = max(10.0, 25.4 * 2 * sheet.width() / max(self._obj.Width.Value, 1.0))
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
        sheet.scale(QtCore.QSizeF(max(self.width(), WIDTH), HEIGHT), QtCore.Qt.KeepAspectRatio)
        return sheet

    def _by_qt(self):
        renderer = QtSvg.QSvgRenderer()
        if not self._obj.Picture or not os.path.exists(self._obj.Picture) or not renderer.load(self._obj.Picture):
            return QtGui.QImage()
        image = QtGui.QImage(2 * self._sheet().toSize(), QtGui.QImage.Format_RGB32)
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
