"""Arrows to drag in the 3-D view: one a step of an exploded view, along its way."""

import FreeCAD
import FreeCADGui as Gui
from pivy import coin

COLOR, ACTIVE = (0.95, 0.35, 0.05), (1.0, 0.75, 0.1)


class Arrows:
    """Until `remove`. `dragged(number, mm, ended)` is called while an arrow is dragged and once it is let go."""

    def __init__(self, document, dragged):
        self._dragged = dragged
        self._root = coin.SoSeparator()
        self._view = next(iter(Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")), None)
        if self._view is not None:
            self._view.getSceneGraph().addChild(self._root)
        self.arrows = []

    def show(self, places, size):
        """Places: (foot, way, mm) of each step, all in mm of the model; `size`: length of an arrow's head."""
        if len(places) != len(self.arrows):
            self._root.removeAllChildren()
            self.arrows = [Arrow(self._root, number, self._dragged) for number in range(len(places))]
        for arrow, (foot, way, by) in zip(self.arrows, places):
            arrow.place(foot, way, by, size)

    def remove(self):
        self.arrows = []
        self._root.removeAllChildren()
        try:
            if self._view is not None:
                self._view.getSceneGraph().removeChild(self._root)
        except (ReferenceError, RuntimeError):  # the view is closed
            pass
        self._view = None


class Arrow:
    def __init__(self, root, number, dragged):
        self._number, self._dragged = number, dragged
        self._quiet = False
        self._size = 1.0
        separator, self._pose = coin.SoSeparator(), coin.SoTransform()
        self.dragger = coin.SoTranslate1Dragger()
        for name, color in (("translator", COLOR), ("translatorActive", ACTIVE)):
            self.dragger.setPart(name, _shape(color))
        self.dragger.addValueChangedCallback(self._changed, None)
        self.dragger.addFinishCallback(self._finished, None)
        separator.addChild(self._pose)
        separator.addChild(self.dragger)
        root.addChild(separator)

    def place(self, foot, way, by, size):
        self._quiet = True  # it is not the user who drags
        turn = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), way)
        self._pose.translation = tuple(foot)
        self._pose.rotation = turn.Q
        self._pose.scaleFactor = (size, size, size)
        self._size = size
        self.dragger.translation = (by / size, 0.0, 0.0)
        self._quiet = False

    def distance(self):
        """mm along the way."""
        return self.dragger.translation.getValue()[0] * self._size

    def _changed(self, *_):
        if not self._quiet:
            self._dragged(self._number, self.distance(), False)

    def _finished(self, *_):
        self._dragged(self._number, self.distance(), True)


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
