"""How an assembly is put together, as a file."""

import os

import FreeCADGui as Gui
from PySide import QtGui

from .. import step_book
from ..text import tr
from ..view.book import make
from .base import Command, one_illustration, selected_illustrations


class StepBook(Command):
    name = "Burin_StepBook"
    text = "Step book..."
    tip = ("Writes how the assembly is put together, a page a step, by the steps of its exploded view: PDF, a page for the web, or Markdown; the "
           "status bar shows progress and can end it")
    icon = "burin_step_book.svg"
    transaction = False  # a file
    needs_kernel = True

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        items, wanted = QtGui.QInputDialog.getInt(Gui.getMainWindow(), self.text.rstrip("."), tr("New items of a step, at the most:"),
                                                  step_book.NEW_ITEMS, 1, 999)
        if not wanted:
            return
        filters = ";;".join(f"{kind} (*{suffix})" for suffix, kind in step_book.KINDS.items())
        name, chosen = QtGui.QFileDialog.getSaveFileName(Gui.getMainWindow(), self.text, "", filters)
        if name:
            make(illustration, name if os.path.splitext(name)[1] else name + _suffix(chosen), items)


def _suffix(filter_):
    """Of the kind that was chosen in the dialog."""
    return next((suffix for suffix in step_book.KINDS if f"*{suffix}" in filter_), ".pdf")


COMMANDS = [StepBook()]
