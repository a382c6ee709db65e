"""Illustrations on TechDraw pages."""

import os

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore

from .. import preferences
from ..errors import Refused
from ..features import make_flat_edges, place_on_page
from ..features.sheet_view import add_template, blank_template, sheet_size
from ..text import tr
from ..view import page_scale
from .base import Command, one_illustration, selected_illustrations


def page_of(document, illustrations):
    """The selected page, else the document's only one, else a new one of the smallest size that holds the illustrations' sheets."""
    pages = [o for o in Gui.Selection.getSelection() if o.isDerivedFrom("TechDraw::DrawPage")]
    pages = pages or [o for o in document.Objects if o.isDerivedFrom("TechDraw::DrawPage")]
    if len(pages) > 1:
        raise Refused(tr("this document has several pages; select one of them too"))
    if pages:
        return pages[0]
    file = preferences.template() or blank_template([sheet_size(o) for o in illustrations])
    if not os.path.isfile(file):
        raise Refused(tr("the template {0} is not there; choose another one in the preferences of Burin").format(file))
    page = document.addObject("TechDraw::DrawPage", "Page")
    add_template(page, file)
    return page


class PlaceOnPage(Command):
    name = "Burin_PlaceOnPage"
    text = "Place on TechDraw page"
    tip = "Puts the illustration on a TechDraw page at its own scale; makes the page where there is none"
    icon = "burin_page.svg"

    def possible(self):
        return bool(selected_illustrations())

    def run(self, document):
        illustrations = selected_illustrations()
        page = page_of(document, illustrations)
        for obj in illustrations:
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


class LinesForDimensions(Command):
    name = "Burin_LinesForDimensions"
    text = "Lines for dimensions"
    tip = ("Puts the illustration's lines on the page as edges, over its picture where that is there: TechDraw dimensions on them measure " 
           "the model")
    icon = "burin_dimensions.svg"

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        if not illustration.Drawing:
            raise Refused(tr("{0} is not drawn yet; recompute it").format(illustration.Label))
        page = page_of(document, [illustration])
        view = make_flat_edges(page, illustration)
        document.recompute()
        if not view.Source[0].Shape.Edges:
            raise Refused(tr("{0} has no lines that could be measured").format(illustration.Label))
        if page.ViewObject is not None:
            page.ViewObject.show()
            _when_shown(page)


COMMANDS = [PlaceOnPage(), LinesForDimensions()]
