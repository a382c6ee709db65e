"""From a line to the edge or face that made it, and back."""

import FreeCAD
import FreeCADGui as Gui

from ..features.sheet import Sheet
from .base import Command, Refused, selected_illustrations, tell

# Pixels around the pointer within which a line is meant.
REACH = 8


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
            raise Refused("select one illustration that is drawn")
        Picker(chosen[0], Gui.ActiveDocument.ActiveView)
        tell("Click a line of the illustration; Esc ends")


class Picker:
    """Waits for clicks in a 3-D view."""

    def __init__(self, obj, view):
        self.obj, self.view = obj, view
        self.sheet = Sheet(obj.Drawing)
        self._callback = view.addEventCallback("SoEvent", self._event)

    def _event(self, event):
        if event.get("Type") == "SoKeyboardEvent" and event.get("Key") == "ESCAPE":
            self.view.removeEventCallback("SoEvent", self._callback)
        elif (event.get("Type") == "SoMouseButtonEvent" and event.get("Button") == "BUTTON1"
              and event.get("State") == "DOWN"):
            self.pick(event["Position"])

    def pick(self, position):
        """Selects what made the line under a place of the view, in pixels."""
        here = self.sheet.on_paper(self._on_plane(position))
        beside = self.sheet.on_paper(self._on_plane((position[0] + REACH, position[1])))
        reach = ((here[0] - beside[0]) ** 2 + (here[1] - beside[1]) ** 2) ** 0.5
        path = self.sheet.nearest(here, reach)
        if path is None:
            return None
        return select(self.obj.Document, *self.sheet.element(path, here))

    def _on_plane(self, position):
        """Where the line of sight through a pixel meets the plane of the ink."""
        from ..view.provider import behind

        through = self.view.getPoint(*position)
        sight = self.view.getViewDirection()
        if self.view.getCameraType() == "Perspective":
            eye = FreeCAD.Vector(*self.view.getCameraNode().position.getValue().getValue())
            sight = through - eye
        normal = self.sheet.direction
        origin = self.sheet.center - normal * behind(self.obj, self.sheet)
        slope = sight.dot(normal)
        if abs(slope) < 1e-9 * sight.Length:  # the plane is seen edge-on
            return through
        return through + sight * ((origin - through).dot(normal) / slope)


def select(document, source, element):
    """Selects an element of an object of an assembly; returns what was selected."""
    top, _, rest = source.partition(".")
    sub = (rest + "." if rest else "") + element
    if document.getObject(top) is None:
        tell(f"{source} is no longer in the document")
        return None
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.Name, top, sub)
    return top, sub


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
        sheet = Sheet(obj.Drawing)
        lit = []
        for chosen in Gui.Selection.getSelectionEx("", 0):
            if chosen.Object is obj:
                continue
            for sub in chosen.SubElementNames or [""]:
                names, _, element = sub.rpartition(".")
                source = chosen.ObjectName + ("." + names if names else "")
                lit.extend(sheet.paths_of(source, element))
        obj.ViewObject.Proxy.light(sheet, lit)
        tell(f"{len(lit)} lines")


COMMANDS = [SelectSource(), ShowLines()]
