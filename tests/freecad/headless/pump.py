"""A small assembly that tests take apart."""

import FreeCAD
import Part

V = FreeCAD.Vector


def pump(document):
    """A plate with a lid on it and two bolts through both, in an App::Part."""
    part = document.addObject("App::Part", "Pump")
    shapes = {"Plate": Part.makeBox(60, 40, 10), "Lid": Part.makeBox(60, 40, 6, V(0, 0, 10))}
    for x in (12, 48):
        hole = Part.makeCylinder(3.1, 40, V(x, 20, -5))
        shapes = {name: shape.cut(hole) for name, shape in shapes.items()}
    bolt = Part.makeCylinder(3, 20, V(0, 0, -4)).fuse(Part.makeCylinder(6, 4, V(0, 0, 16)))
    for name, shape, place in (*((name, shape, V()) for name, shape in shapes.items()), ("Bolt", bolt, V(12, 20, 0)), ("Bolt", bolt, V(48, 20, 0))):
        solid = document.addObject("Part::Feature", name)
        solid.Shape = shape
        solid.Placement.Base = place
        part.addObject(solid)
    document.recompute()
    return part
