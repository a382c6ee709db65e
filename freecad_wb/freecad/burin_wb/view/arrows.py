"""Arrows to drag in the 3-D view: one a step of an exploded view, along its way."""

import FreeCAD
from pivy import coin
from PySide import QtCore

from .overlay import Overlay

# Milliseconds between two looks at what is dragged. Coin's own callbacks reach Python without the interpreter's lock, which
# FreeCAD's event loop does not hold: they would end FreeCAD.
OFTEN = 40

COLOR, ACTIVE = (0.95, 0.35, 0.05), (1.0, 0.75, 0.1)


class Arrows:
    """Until `remove`. `dragged(number, mm, ended)` is called while an arrow is dragged and once it is let go."""

    def __init__(self, document, dragged):
        self._dragged = dragged
        self._overlay = Overlay(document)
        self.arrows = []
        self._timer = QtCore.QTimer()
        self._timer.setInterval(OFTEN)
        self._timer.timeout.connect(lambda: self._look())

    def show(self, places, size):
        """Places: (foot, way, mm) of each step, all in mm of the model; `size`: length of an arrow's head."""
        if len(places) != len(self.arrows):
            self._overlay.root.removeAllChildren()
            self.arrows = [Arrow(self._overlay.root) for _ in places]
        for arrow, (foot, way, by) in zip(self.arrows, places):
            arrow.place(foot, way, by, size)
        if self.arrows:
            self._timer.start()
        else:
            self._timer.stop()

    def _look(self):
        for number, arrow in enumerate(list(self.arrows)):
            moved = arrow.moved()
            if moved is not None:
                self._dragged(number, *moved)

    def remove(self):
        self._timer.stop()
        self.arrows = []
        self._overlay.remove()


class Arrow:
    def __init__(self, root):
        self._size, self._seen, self._held = 1.0, 0.0, False
        separator, self._pose = coin.SoSeparator(), coin.SoTransform()
        self.dragger = coin.SoTranslate1Dragger()
        for name, color in (("translator", COLOR), ("translatorActive", ACTIVE)):
            self.dragger.setPart(name, _shape(color))
        separator.addChild(self._pose)
        separator.addChild(self.dragger)
        root.addChild(separator)

    def place(self, foot, way, by, size):
        """Not while the user holds it."""
        if self.dragger.isActive.getValue():
            return
        turn = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), way)
        self._pose.translation = tuple(foot)
        self._pose.rotation = turn.Q
        self._pose.scaleFactor = (size, size, size)
        self._size = size
        self.dragger.translation = (by / size, 0.0, 0.0)
        self._seen = self.distance()

    def distance(self):
        """mm along the way."""
        return self.dragger.translation.getValue()[0] * self._size

    def moved(self):
        """Where it was dragged to since the last look, and whether it was let go; nothing where neither."""
        held, before, mm = self.dragger.isActive.getValue(), self._held, self.distance()
        if mm == self._seen and held == before:
            return None
        self._seen, self._held = mm, held
        return mm, not held


def _shape(color):
    """An arrow along x, 2 long, its middle at the origin."""
    root, material = coin.SoSeparator(), coin.SoMaterial()
    material.diffuseColor = color
    material.emissiveColor = tuple(0.4 * c for c in color)
    turn = coin.SoRotationXYZ()
    turn.axis, turn.angle = coin.SoRotationXYZ.Z, -1.5707963
    shaft, up, head = coin.SoCylinder(), coin.SoTranslation(), coin.SoCone()
    shaft.radius, shaft.height = 0.12, 1.2
    up.translation = (0, 0.9, 0)
    head.bottomRadius, head.height = 0.35, 0.8
    for node in (material, turn, shaft, up, head):
        root.addChild(node)
    return root
