"""From where an illustration is seen."""

import FreeCADGui as Gui

from ..errors import Refused
from ..features.eye import face_of, of_face, set_view, standard
from ..text import tr
from ..view.camera import camera_of
from .base import Command, Group, selected_illustrations, some_illustrations


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
        eye = of_face(*face_of(*chosen))
        for obj in selected_illustrations():
            set_view(obj, eye)
        document.recompute()


def _selected_faces():
    """Selected faces by their ways from the outermost assembly or link, each of which may move and turn them."""
    for chosen in Gui.Selection.getSelectionEx("", 0):
        for sub in chosen.SubElementNames:
            if sub.rpartition(".")[2].startswith("Face"):
                yield chosen.Object, sub


class Standard(Command):
    """Subclasses set `view`, its name."""

    view = ""

    def possible(self):
        return bool(selected_illustrations())

    def run(self, document):
        for obj in some_illustrations():
            set_view(obj, standard(self.view))
        document.recompute()


class Front(Standard):
    view, name, text, icon = "front", "Burin_ViewFront", "Front", "burin_view_front.svg"
    tip = "The illustration looks from the front (along y)"


class Back(Standard):
    view, name, text, icon = "back", "Burin_ViewBack", "Back", "burin_view_back.svg"
    tip = "The illustration looks from the back"


class Left(Standard):
    view, name, text, icon = "left", "Burin_ViewLeft", "Left", "burin_view_left.svg"
    tip = "The illustration looks from the left"


class Right(Standard):
    view, name, text, icon = "right", "Burin_ViewRight", "Right", "burin_view_right.svg"
    tip = "The illustration looks from the right"


class Top(Standard):
    view, name, text, icon = "top", "Burin_ViewTop", "Top", "burin_view_top.svg"
    tip = "The illustration looks from above"


class Bottom(Standard):
    view, name, text, icon = "bottom", "Burin_ViewBottom", "Bottom", "burin_view_bottom.svg"
    tip = "The illustration looks from below"


class Isometric(Standard):
    view, name, text, icon = "iso", "Burin_ViewIsometric", "Isometric", "burin_view_isometric.svg"
    tip = "The illustration looks from the front, the right and above at once"


class Dimetric(Standard):
    view, name, text, icon = "dimetric", "Burin_ViewDimetric", "Dimetric", "burin_view_dimetric.svg"
    tip = "The illustration looks almost from the front: depths are halved, as ISO 5456-3 has it"


class Trimetric(Standard):
    view, name, text, icon = "trimetric", "Burin_ViewTrimetric", "Trimetric", "burin_view_trimetric.svg"
    tip = "The illustration looks from the front, the right and above, at each by another angle"


MEMBERS = [ViewFromCamera(), ViewFromFace(), Isometric(), Dimetric(), Trimetric(), Front(), Back(), Left(), Right(),
           Top(), Bottom()]


class ViewGroup(Group):
    name = "Burin_View"
    text = "View"
    tip = "From where the illustration is seen"
    members = [m.name for m in MEMBERS]


COMMANDS = [*MEMBERS, ViewGroup()]
