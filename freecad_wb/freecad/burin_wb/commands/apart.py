"""Assemblies explained: cut open, taken apart, numbered."""

from PySide import QtCore

from ..tasks import show
from ..tasks.detail import DetailPanel
from ..tasks.explode import ExplodePanel
from ..tasks.items import ItemsPanel
from ..tasks.section import SectionPanel, SectionViewPanel, chosen_plane
from .base import Command, one_illustration, selected_illustrations


class _Panel(Command):
    """Opens a panel, which has a transaction of its own."""

    transaction = False
    needs_kernel = True
    panel = None

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        document.openTransaction(QtCore.QCoreApplication.translate(self.name, self.text))
        show(self.panel(illustration))


class Section(_Panel):
    name = "Burin_Section"
    text = "Section"
    tip = "Cuts the parts open by planes in the drawing; the model stays as it is"
    icon = "burin_section.svg"
    panel = SectionPanel


class SectionView(_Panel):
    name = "Burin_SectionView"
    text = "Section view"
    tip = ("Adds a section A-A as a view of its own to the sheet: through the selected flat face or datum plane, else across y through the "
           "middle; the other views stay whole")
    icon = "burin_section_view.svg"

    def run(self, document):
        illustration, plane = one_illustration(), chosen_plane(document)
        document.openTransaction(QtCore.QCoreApplication.translate(self.name, self.text))
        show(SectionViewPanel(illustration, plane))


class Explode(_Panel):
    name = "Burin_Explode"
    text = "Explode"
    tip = "Takes the assembly apart in the drawing by steps that are found and can be edited; the model stays as it is"
    icon = "burin_explode.svg"
    panel = ExplodePanel

    def run(self, document):
        illustration = one_illustration()
        found = bool(illustration.ExplodeSteps)
        document.openTransaction(QtCore.QCoreApplication.translate(self.name, self.text))
        illustration.Explode = True
        panel = show(ExplodePanel(illustration))
        if found:
            panel.changed()
        else:
            panel.find()


class NumberParts(_Panel):
    name = "Burin_NumberParts"
    text = "Number parts"
    tip = "Numbers the items of an assembly with leaders in the drawing, lists them on the sheet and as a spreadsheet"
    icon = "burin_items.svg"
    panel = ItemsPanel


class Detail(_Panel):
    name = "Burin_Detail"
    text = "Detail"
    tip = "Draws a place again beside the view, larger, in a circle: of the selected objects, or about a selected face, edge or point"
    icon = "burin_detail.svg"
    panel = DetailPanel

    def run(self, document):
        illustration = one_illustration()
        document.openTransaction(QtCore.QCoreApplication.translate(self.name, self.text))
        show(DetailPanel(illustration)).begin()


COMMANDS = [Section(), SectionView(), Explode(), Detail(), NumberParts()]
