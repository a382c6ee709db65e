"""Illustrations that follow the 3-D view: drawn anew as soon as its camera rests."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from ..features.eye import set_view
from ..tell import tell
from ..text import tr
from .camera import camera_of

# Milliseconds between two looks at the camera; it rests when two of them see the same.
OFTEN = 120


class Followers(QtCore.QObject):
    def __init__(self):
        super().__init__()
        self._seen = {}  # (document, object) names: what the last look saw
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(OFTEN)
        self._timer.timeout.connect(lambda: self._look())

    def follow(self, obj, on):
        key = obj.Document.Name, obj.Name
        if not on:
            self._seen.pop(key, None)
        else:
            self._seen.setdefault(key, None)
            self._timer.start()

    def _look(self):
        for key, before in list(self._seen.items()):
            obj = _living(key)
            if obj is None:
                del self._seen[key]
                continue
            eye = _eye(key[0])
            self._seen[key] = eye
            if eye is not None and eye == before and not _sees(obj, eye):
                set_view(obj, eye)
                obj.recompute()
        if not self._seen:
            self._timer.stop()


def _living(key):
    try:
        return FreeCAD.getDocument(key[0]).getObject(key[1])
    except NameError:  # the document is closed
        return None


def _eye(document):
    """Of the document's view, if it is the one that is looked at."""
    gui = Gui.ActiveDocument
    return camera_of(gui.ActiveView) if gui is not None and gui.Document.Name == document else None


def _sees(obj, eye):
    """Whether an illustration is drawn from there already; several views follow nothing."""
    if obj.Views:
        return True
    near = 1e-7
    angle = obj.FieldOfView.Value if obj.Projection == "Perspective" else 0.0
    return ((obj.ViewDirection - eye.direction).Length < near and (obj.ViewUp - eye.up).Length < near
            and abs(angle - eye.angle) < near)


_followers = None


def follow(obj, on):
    """From now on an illustration is drawn as the 3-D view shows the model, whenever its camera rests; or no more."""
    global _followers
    if on and getattr(obj, "Views", None):
        tell(tr("{0} has several views; it follows the 3-D view as soon as it has one").format(obj.Label))
    if _followers is None:
        if not on:
            return
        _followers = Followers()
    _followers.follow(obj, on)
