"""From a line to the edge or face that made it, and back."""

import FreeCAD
import FreeCADGui as Gui
import Part
from PySide import QtCore, QtGui

from ..errors import Refused
from ..features.sheet import Sheet
from ..tell import tell
from ..text import tr
from ..view import scheduler
from ..view.provider import BEFORE
from .base import Command, selected_illustrations

# Pixels around the pointer within which a line is meant.
REACH = 8

# Pixels that the pointer may move in a click; more turn the view.
STILL = 3


def sheet_of(obj):
    """The kept drawing. Throws Refused."""
    try:
        return Sheet(obj.Drawing)
    except (OSError, ValueError, KeyError) as error:
        raise Refused(tr("{0} has no drawing that can be read ({1}); recompute it").format(obj.Label, error)) from error


class SelectSource(Command):
    name = "Burin_SelectSource"
    text = "Select source of a line"
    tip = "Click a line of the illustration in the 3-D view: the edge or face that made it is selected. Esc ends."
    icon = "burin_source.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1 and hasattr(Gui.ActiveDocument.ActiveView, "addEventCallback")

    def run(self, document):
        chosen = selected_illustrations()
        if len(chosen) != 1 or not chosen[0].Drawing:
            raise Refused(tr("select one illustration that is drawn"))
        global picker
        if picker is not None:
            picker.stop()
        sheet_of(chosen[0])
        picker = Picker(chosen[0], Gui.ActiveDocument.ActiveView)
        tell(tr("Click a line of the illustration; Esc ends"))


# What waits for clicks; one at a time.
picker = None


class Picker:
    """Waits for clicks in a 3-D view."""

    def __init__(self, obj, view):
        self.obj, self.view = obj, view
        self._names = obj.Document.Name, obj.Name
        # Lines are clicked where they are seen, before the model as long as this lasts; paper would hide what is selected.
        self._shown = {name: getattr(obj.ViewObject, name) for name in ("Plane", "Paper")}
        obj.ViewObject.Plane, obj.ViewObject.Paper = BEFORE, False
        self.sheet = Sheet(obj.Drawing)
        self._callback = view.addEventCallback("SoEvent", self._event)
        self._runs = scheduler.install()
        self._runs.left.connect(self._left)

    def stop(self):
        global picker
        if picker is self:
            picker = None
        if self._callback is None:
            return
        callback, self._callback = self._callback, None
        for leave in (lambda: self._runs.left.disconnect(self._left),
                      lambda: self.view.removeEventCallback("SoEvent", callback),
                      *(lambda name=name, value=value: setattr(self.obj.ViewObject, name, value)
                        for name, value in self._shown.items())):
            try:
                leave()
            except (AttributeError, NameError, ReferenceError, RuntimeError):  # the view or the document is gone
                pass

    def _left(self, document, name):
        """The illustration is deleted, or its document is closed."""
        if document == self._names[0] and name in ("", self._names[1]):
            self.stop()

    def _event(self, event):
        if event.get("Type") == "SoKeyboardEvent" and event.get("Key") == "ESCAPE":
            QtCore.QTimer.singleShot(0, lambda: self.stop())  # not while the view calls
        elif (event.get("Type") == "SoMouseButtonEvent" and event.get("Button") == "BUTTON1"
              and event.get("State") == "DOWN"):
            self._after_click(tuple(event["Position"]), QtGui.QCursor.pos())

    def _after_click(self, at, pressed):
        """The view keeps the release for itself and selects then; this comes after it. Drags turn the view."""
        if self._callback is None:
            return
        if QtGui.QApplication.mouseButtons() & QtCore.Qt.LeftButton:
            QtCore.QTimer.singleShot(30, lambda: self._after_click(at, pressed))
        elif (QtGui.QCursor.pos() - pressed).manhattanLength() <= STILL:
            QtCore.QTimer.singleShot(50, lambda: self._callback is not None and self.pick(at))

    def pick(self, position):
        """Selects what made the line under a place of the view, in pixels."""
        here = self.sheet.on_paper(self._on_plane(position))
        beside = self.sheet.on_paper(self._on_plane((position[0] + REACH, position[1])))
        reach = ((here[0] - beside[0]) ** 2 + (here[1] - beside[1]) ** 2) ** 0.5
        path = self.sheet.nearest(here, reach)
        if path is None:
            tell(tr("there is no line of the illustration here"))
            return None
        return select(self.obj.Document, *self.sheet.element(path, here))

    def _on_plane(self, position):
        """Where the line of sight through a pixel meets the plane of the ink."""
        through = self.view.getPoint(*position)
        sight = self.view.getViewDirection()
        if self.view.getCameraType() == "Perspective":
            eye = FreeCAD.Vector(*self.view.getCameraNode().position.getValue().getValue())
            sight = through - eye
        normal = self.sheet.direction
        origin = self.sheet.center + normal * self.obj.ViewObject.Proxy.lift(self.sheet)
        slope = sight.dot(normal)
        if abs(slope) < 1e-9 * sight.Length:  # the plane is seen edge-on
            return through
        return through + sight * ((origin - through).dot(normal) / slope)


def select(document, source, element):
    """Selects an element of an object of an assembly; returns what was selected."""
    top, _, rest = source.partition(".")
    sub = (rest + "." if rest else "") + element
    if document.getObject(top) is None:
        tell(tr("{0} is no longer in the document").format(source))
        return None
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, top, sub)
    return top, sub


def edges_of(top, sub):
    """Names of the edges around a face; of what is no face none."""
    names, _, element = sub.rpartition(".")
    if not element.startswith("Face"):
        return []
    shape = Part.getShape(top, names + "." if names else "", needSubElement=False)
    around = shape.getElement(element).Edges
    return [f"Edge{k + 1}" for k, edge in enumerate(shape.Edges) if any(edge.isSame(e) for e in around)]


class ShowLines(Command):
    name = "Burin_ShowLines"
    text = "Show lines of a face or edge"
    tip = "Select an illustration and faces, edges or objects: the lines that they made light up"
    icon = "burin_lines.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1 and len(Gui.Selection.getSelectionEx("", 0)) > 1

    def run(self, document):
        obj = selected_illustrations()[0]
        sheet = sheet_of(obj)
        lit = []
        for chosen in Gui.Selection.getSelectionEx("", 0):
            if chosen.Object is obj:
                continue
            for sub in chosen.SubElementNames or [""]:
                names, _, element = sub.rpartition(".")
                source = chosen.ObjectName + ("." + names if names else "")
                for one in [element, *edges_of(chosen.Object, sub)]:
                    lit.extend(p for p in sheet.paths_of(source, one) if p not in lit)
        obj.ViewObject.Proxy.light(sheet, lit)
        tell(tr("{0} lines").format(len(lit)))


COMMANDS = [SelectSource(), ShowLines()]
