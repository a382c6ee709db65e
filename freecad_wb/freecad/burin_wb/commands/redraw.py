"""All illustrations of the document anew."""

import FreeCAD

from ..features import is_illustration
from ..view.redraw import redraw
from .base import Command


class RedrawAll(Command):
    name = "Burin_RedrawAll"
    text = "Redraw all"
    tip = ("Looks at all illustrations of the document, style files and models too, and draws those that are not up to date; the status bar "
           "shows progress and can end it")
    icon = "burin_redraw.svg"
    transaction = False  # a recompute, which FreeCAD does not undo

    def possible(self):
        return any(is_illustration(obj) for obj in FreeCAD.ActiveDocument.Objects)

    def run(self, document):
        redraw(document)


COMMANDS = [RedrawAll()]
