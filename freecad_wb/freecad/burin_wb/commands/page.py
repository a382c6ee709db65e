"""Illustrations on TechDraw pages."""

import os

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from .. import preferences
from ..errors import Refused
from ..features import place_on_page
from ..text import tr
from ..view import page_scale
from .base import Command, selected_illustrations

TEMPLATE = os.path.join("Mod", "TechDraw", "Templates", "A3_Landscape_blank.svg")


def page_of(document):
    """The selected page, else the document's only one, else a new one with an A3 template."""
    pages = [o for o in Gui.Selection.getSelection() if o.isDerivedFrom("TechDraw::DrawPage")]
    pages = pages or [o for o in document.Objects if o.isDerivedFrom("TechDraw::DrawPage")]
    if len(pages) > 1:
        raise Refused(tr("this document has several pages; select one of them too"))
    if pages:
        return pages[0]
    file = preferences.template() or os.path.join(FreeCAD.getResourceDir(), TEMPLATE)
    if not os.path.isfile(file):
        raise Refused(tr("the template {0} is not there; choose another one in the preferences of Burin").format(file))
    page = document.addObject("TechDraw::DrawPage", "Page")
    template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = file
    page.Template = template
    return page


class PlaceOnPage(Command):
    name = "Burin_PlaceOnPage"
    text = "Place on TechDraw page"
    tip = "Puts the illustration on a TechDraw page at its own scale; makes the page where there is none"
    icon = "burin_page.svg"

    def possible(self):
        return bool(selected_illustrations())

    def run(self, document):
        page = page_of(document)
        for obj in selected_illustrations():
            place_on_page(page, obj)
        document.recompute()
        if page.ViewObject is not None:
            page.ViewObject.show()
            _when_shown(page)


def _when_shown(page):
    """Fits the view, and looks whether the symbols have their true size, once the page's window stands."""
    key = page.Document.Name, page.Name

    def then():
        Gui.SendMsgToActiveView("ViewFit")
        if key[0] in FreeCAD.listDocuments():
            shown = FreeCAD.getDocument(key[0]).getObject(key[1])
            if shown is not None:
                page_scale.check(shown)

    QtCore.QTimer.singleShot(100, then)


COMMANDS = [PlaceOnPage()]
