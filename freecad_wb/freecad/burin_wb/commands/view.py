"""From where an illustration is seen."""

import collections

import FreeCAD
import FreeCADGui as Gui

from ..features.sources import from_the_top
from ..view.text import tr
from .base import Command, Group, Refused, selected_illustrations

# direction: from the model to the viewer; angle: vertical field of view in degrees, 0 = parallel.
Eye = collections.namedtuple("Eye", "direction up angle")


def camera_of(view):
    """The 3-D view's camera; nothing where the view has none."""
    if view is None or not hasattr(view, "getCameraNode"):
        return None
    import math

    node = view.getCameraNode()
    rotation = view.getCameraOrientation()
    direction = rotation.multVec(FreeCAD.Vector(0, 0, 1))
    up = rotation.multVec(FreeCAD.Vector(0, 1, 0))
    angle = 0.0
    if view.getCameraType() == "Perspective":
        angle = math.degrees(node.heightAngle.getValue())
    return Eye(direction, up, angle)


def set_view(obj, eye):
    obj.ViewDirection, obj.ViewUp = eye.direction, eye.up
    obj.Projection = "Perspective" if eye.angle else "Orthographic"
    if eye.angle:
        obj.FieldOfView = eye.angle


STANDARD = {
    "Front": ((0, -1, 0), (0, 0, 1)), "Back": ((0, 1, 0), (0, 0, 1)),
    "Left": ((-1, 0, 0), (0, 0, 1)), "Right": ((1, 0, 0), (0, 0, 1)),
    "Top": ((0, 0, 1), (0, 1, 0)), "Bottom": ((0, 0, -1), (0, 1, 0)),
    "Isometric": ((1, -1, 1), (0, 0, 1)),
}


def standard(name):
    direction, up = STANDARD[name]
    return Eye(FreeCAD.Vector(*direction), FreeCAD.Vector(*up), 0.0)


def of_face(face):
    """Square onto a flat or curved face, at its middle; up stays up where that can be."""
    u0, u1, v0, v1 = face.ParameterRange
    normal = face.normalAt((u0 + u1) / 2, (v0 + v1) / 2)
    up = FreeCAD.Vector(0, 0, 1)
    if abs(normal.dot(up)) > 0.999:  # seen from above or below: as in the standard views
        up = FreeCAD.Vector(0, 1, 0)
    return Eye(normal, up, 0.0)


class ViewFromCamera(Command):
    name = "Burin_ViewFromCamera"
    text = "As in the 3-D view"
    tip = "Draws the illustration as the 3-D view shows the model now, in perspective too"
    icon = "burin_view_camera.svg"

    def possible(self):
        return bool(selected_illustrations()) and camera_of(Gui.ActiveDocument.ActiveView) is not None

    def run(self, document):
        eye = camera_of(Gui.ActiveDocument.ActiveView)
        if eye is None:
            raise Refused(tr("show a 3-D view of the model first"))
        for obj in selected_illustrations():
            set_view(obj, eye)
        document.recompute()


class ViewFromFace(Command):
    name = "Burin_ViewFromFace"
    text = "Square onto a face"
    tip = "Select an illustration and a face: the illustration looks square onto the face"
    icon = "burin_view_face.svg"

    def possible(self):
        return bool(selected_illustrations()) and any(_selected_faces())

    def run(self, document):
        chosen = next(_selected_faces(), None)
        if chosen is None:
            raise Refused(tr("select a face too"))
        face = face_of(*chosen)
        for obj in selected_illustrations():
            set_view(obj, of_face(face))
        document.recompute()


def _selected_faces():
    """Selected faces by their ways from the outermost assembly or link, each of which may move and turn them."""
    for chosen in Gui.Selection.getSelectionEx("", 0):
        for sub in chosen.SubElementNames:
            if sub.rpartition(".")[2].startswith("Face"):
                yield chosen.Object, sub


def face_of(obj, sub):
    """A face by its way ('Inner.Box.Face3') from `obj`, in global coordinates."""
    import Part

    return Part.getShape(*from_the_top(obj, sub), needSubElement=True, transform=True)


class Standard(Command):
    """Subclasses are named after their views."""

    def possible(self):
        return bool(selected_illustrations())

    def run(self, document):
        chosen = selected_illustrations()
        if not chosen:
            raise Refused(tr("select an illustration"))
        for obj in chosen:
            set_view(obj, standard(self.text))
        document.recompute()


class Front(Standard):
    name, text, icon = "Burin_ViewFront", "Front", "burin_view_front.svg"
    tip = "The illustration looks from the front (along y)"


class Back(Standard):
    name, text, icon = "Burin_ViewBack", "Back", "burin_view_back.svg"
    tip = "The illustration looks from the back"


class Left(Standard):
    name, text, icon = "Burin_ViewLeft", "Left", "burin_view_left.svg"
    tip = "The illustration looks from the left"


class Right(Standard):
    name, text, icon = "Burin_ViewRight", "Right", "burin_view_right.svg"
    tip = "The illustration looks from the right"


class Top(Standard):
    name, text, icon = "Burin_ViewTop", "Top", "burin_view_top.svg"
    tip = "The illustration looks from above"


class Bottom(Standard):
    name, text, icon = "Burin_ViewBottom", "Bottom", "burin_view_bottom.svg"
    tip = "The illustration looks from below"


class Isometric(Standard):
    name, text, icon = "Burin_ViewIsometric", "Isometric", "burin_view_isometric.svg"
    tip = "The illustration looks from the front, the right and above at once"


MEMBERS = [ViewFromCamera(), ViewFromFace(), Isometric(), Front(), Back(), Left(), Right(), Top(), Bottom()]


class ViewGroup(Group):
    name = "Burin_View"
    text = "View"
    tip = "From where the illustration is seen"
    members = [m.name for m in MEMBERS]


COMMANDS = [*MEMBERS, ViewGroup()]
