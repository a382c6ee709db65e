"""What tests of dimensions, sections and notes share: the pump on a sheet that has room for what is written."""

import json
import unittest.mock

import FreeCAD
import FreeCADGui as Gui
import support
from assembly_case import Case


def facing(obj, normal):
    """The name of the flat face that looks that way and lies farthest there."""
    return max((face.CenterOfMass.dot(normal), f"Face{k}") for k, face in enumerate(obj.Shape.Faces, 1)
               if face.findPlane() is not None and face.normalAt(0, 0).dot(normal) > 0.999)[1]


class Annotations(Case):
    """The pump on a sheet that has room for what is written."""

    def setUp(self):
        super().setUp()
        self.obj.Width, self.obj.Height, self.obj.Margin, self.obj.Views = 297, 210, 10, ["front", "top"]
        self.obj.HiddenLines = "Dashed"  # a bolt is in the hole that is measured
        self.document.recompute()
        support.drawn()
        self.undos = self.document.UndoCount
        self.told = []
        patch = unittest.mock.patch("freecad.burin_wb.commands.base.tell", lambda text, *_: self.told.append(text))
        patch.start()
        self.addCleanup(patch.stop)

    def sub(self, name, element):
        return self.pump, f"{name}.{element}"

    def run_on(self, command, *selection):
        self.select(*selection)
        Gui.runCommand(command)
        self.wait()

    def texts(self, role=None):
        with open(self.obj.Drawing, encoding="utf-8") as file:
            return [text["text"] for layer in json.load(file)["layers"] for text in layer.get("texts", ()) if role in (None, text["role"])]

    def redraw(self):
        self.obj.touch()
        self.document.recompute()
        self.wait()

    def save_and_open(self):
        path = str(support.OUT / "kept.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.obj, self.pump = self.document.Illustration, self.document.Pump
        self.wait()
