"""What the tests inside freecadcmd share."""

import os
import shutil
import tempfile
import time
import unittest

import FreeCAD as App
import Part  # noqa: F401  documents with shapes need it
from PySide import QtCore

from freecad.burin_wb import features, kernel

V = App.Vector
# Real models that are no part of the project.
DATA = os.environ.get("BURIN_TEST_DATA", "")


class Case(unittest.TestCase):
    """A document and a folder for each test, closed and removed after it."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="burin-test-")
        self.doc = App.newDocument("Test")

    def tearDown(self):
        for name in list(App.listDocuments()):
            App.closeDocument(name)
        shutil.rmtree(self.folder, ignore_errors=True)

    def box(self, length=10.0, width=20.0, height=30.0, name="Box"):
        box = self.doc.addObject("Part::Box", name)
        box.Length, box.Width, box.Height = length, width, height
        return box

    def solid(self, shape, name="Solid"):
        made = self.doc.addObject("Part::Feature", name)
        made.Shape = shape
        return made

    def illustration(self, *sources, **properties):
        obj = features.make_illustration(self.doc, list(sources))
        for name, value in properties.items():
            setattr(obj, name, value)
        self.doc.recompute()
        return obj

    def reopen(self, obj):
        """Saves the document, closes it and opens it from its file; the object as it is then."""
        name = obj.Name
        path = os.path.join(self.folder, "test.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(path)
        return self.doc.getObject(name)

    def redraw(self, obj):
        obj.touch()
        self.doc.recompute()


def visible_edges(view, seconds=20.0):
    """The edges that a view of TechDraw shows. FreeCAD 1.0 finds them in a thread of its own, and has them once the event
    loop has run."""
    loop = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    end = time.monotonic() + seconds
    while not view.getVisibleEdges() and time.monotonic() < end:
        loop.processEvents()
        time.sleep(0.01)
    return view.getVisibleEdges()


def burin():
    return kernel.module()


def drawn(obj):
    """The kernel's drawing of an illustration, made here, with places in the model."""
    from freecad.burin_wb.features.illustration import make_job

    return make_job(obj).draw(burin())


def content(path):
    with open(path, "rb") as file:
        return file.read()
