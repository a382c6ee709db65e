"""How far what an illustration draws reaches."""

import FreeCAD

from .sources import survey


class Extent:
    """The boxes of the parts that are drawn, in global coordinates, by their paths. Quick: no shape is looked into."""

    def __init__(self, obj):
        pieces, _ = survey(obj.Sources, obj.Looks)
        self.boxes = {piece.part.source: _box(piece) for piece in pieces if piece.part.drawn}
        self.sources = [piece.part.source for piece in pieces]

    def along(self, normal):
        """Least and greatest coordinate along a unit vector, in mm."""
        reach = [box.getPoint(k).dot(normal) for box in self.boxes.values() for k in range(8)]
        return (min(reach), max(reach)) if reach else (0.0, 0.0)

    def whole(self, paths=None):
        """The box of some parts, or of all."""
        box = FreeCAD.BoundBox()
        for path, one in self.boxes.items():
            if paths is None or path in paths:
                box.add(one)
        return box


def _box(piece):
    if piece.shape is not None:
        return piece.shape.BoundBox
    return piece.leaf.Mesh.BoundBox.transformed(FreeCAD.Matrix(*_placed(piece)))


def _placed(piece):
    """Where a mesh is, without its own placement, which its box has."""
    whole, own = piece.top.getSubObject(piece.sub, retType=4), piece.leaf.Placement.toMatrix()
    return (whole * own.inverse()).A
