"""What TechDraw pages show while a panel takes width from their windows. TechDraw's views are anchored under the mouse: as the
mouse is elsewhere, a page would jump out of its window."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

# Milliseconds in which windows have their size again once a panel is gone.
LATER = 1000


def _areas():
    """The views of pages that are seen now."""
    for window in Gui.getMainWindow().centralWidget().subWindowList():
        shown = window.widget()
        if shown is not None and shown.metaObject().className().endswith("::MDIViewPage"):
            yield from (area for area in shown.findChildren(QtGui.QGraphicsView) if area.isVisible())


class _Area(QtCore.QObject):
    """Keeps what one view shows while its size changes. Where the user zoomed or moved it meanwhile, it is left as it is."""

    def __init__(self, area):
        super().__init__(area)
        self._area, self._closing = area, False
        self._later = self._timer(0, self._follow)
        self._last = self._timer(LATER, self.deleteLater)
        self._rectangle = self._seen()
        self._first = self._left = self._state()
        self._size = area.viewport().size()
        area.viewport().installEventFilter(self)

    def _timer(self, milliseconds, slot):
        """Goes with the view, which may be gone by then."""
        timer = QtCore.QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(milliseconds)
        timer.timeout.connect(slot)
        return timer

    def eventFilter(self, _, event):
        # Here the view still has its place on the page; it moves when it gets the event.
        if event.type() == QtCore.QEvent.Resize and not self._later.isActive() and self._state() == self._left:
            self._later.start()
        return False

    def _follow(self):
        if self._closing and self._area.viewport().size() == self._size:
            scale, _ = self._first
            self._area.setTransform(QtGui.QTransform.fromScale(scale, scale))
            self._area.centerOn(self._rectangle.center())
        else:
            self._area.fitInView(self._rectangle, QtCore.Qt.KeepAspectRatio)
        self._left = self._state()

    def _seen(self):
        return self._area.mapToScene(self._area.viewport().rect()).boundingRect()

    def _state(self):
        corner = self._area.mapToScene(QtCore.QPoint(0, 0))
        return self._area.transform().m11(), (corner.x(), corner.y())

    def close(self):
        self._closing = True
        self._last.start()


class Kept:
    """The views of all pages that are seen, from now until `close`."""

    def __init__(self):
        self._kept = [_Area(area) for area in _areas()]

    def close(self):
        kept, self._kept = self._kept, []
        for one in kept:
            try:
                one.close()
            except RuntimeError:  # the page's window is gone, and this with it
                pass
