"""The drawing as it is now, small, in a panel."""

import os

from PySide import QtCore, QtGui, QtSvg

HEIGHT = 190


class Preview(QtGui.QWidget):
    """Shows the kept picture of an illustration on white paper."""

    def __init__(self, obj):
        super().__init__()
        self.setObjectName("preview")
        self.setMinimumHeight(HEIGHT)
        self.setMaximumHeight(HEIGHT)
        self._obj = obj
        self._renderer = QtSvg.QSvgRenderer(self)
        self._image = QtGui.QImage()
        self.renew()

    def renew(self):
        """Reads the picture again: painted once, shown many times."""
        path = self._obj.Picture
        self._image = QtGui.QImage()
        if path and os.path.exists(path) and self._renderer.load(path):
            self._paint()
        self.update()

    def _paint(self):
        sheet = QtCore.QSizeF(self._obj.Width.Value, self._obj.Height.Value)
        sheet.scale(QtCore.QSizeF(max(self.width(), 220), HEIGHT), QtCore.Qt.KeepAspectRatio)
        image = QtGui.QImage(2 * sheet.toSize(), QtGui.QImage.Format_RGB32)
        image.fill(QtCore.Qt.white)
        painter = QtGui.QPainter(image)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        self._renderer.render(painter)
        painter.end()
        self._image = image

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
