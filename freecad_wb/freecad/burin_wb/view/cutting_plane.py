"""The plane of a section as the 3-D view shows it while it is chosen."""

import FreeCAD
from pivy import coin

from . import ink
from .overlay import Overlay


class CuttingPlane:
    """Until `remove`."""

    def __init__(self, document):
        self._overlay = Overlay(document)
        pick = coin.SoPickStyle()  # what is behind it is chosen through it
        pick.style = coin.SoPickStyle.UNPICKABLE
        self._plane = coin.SoSeparator()
        self._overlay.root.addChild(pick)
        self._overlay.root.addChild(self._plane)

    def show(self, normal, offset, box):
        """A square across what a box holds; nothing without a normal."""
        self._plane.removeAllChildren()
        if normal is None or not box.isValid():
            return
        turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), normal)
        middle = box.Center + normal * (offset - box.Center.dot(normal))
        half = 0.55 * box.DiagonalLength
        corners = [tuple(middle + turn.multVec(FreeCAD.Vector(x * half, y * half, 0))) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        self._plane.addChild(ink.colored(ink.LIT))
        points = coin.SoCoordinate3()
        points.point.setValues(0, 4, corners)
        frame = coin.SoIndexedLineSet()
        frame.coordIndex.setValues(0, 6, [0, 1, 2, 3, 0, -1])
        self._plane.addChild(points)
        self._plane.addChild(frame)
        clear = coin.SoMaterial()
        clear.diffuseColor, clear.transparency = ink.LIT, 0.8
        sides = coin.SoShapeHints()
        sides.vertexOrdering, sides.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
        face = coin.SoFaceSet()
        face.numVertices.setValues(0, 1, [4])
        for node in (clear, sides, face):
            self._plane.addChild(node)

    def is_shown(self):
        return self._plane.getNumChildren() > 0

    def remove(self):
        self._plane.removeAllChildren()
        self._overlay.remove()
