"""Commands of menus and toolbars."""

import FreeCADGui as Gui

from ..features.stands_for import illustrations_by
from ..view import scheduler
from . import apart, book, dimension, export, help, look, new, page, redraw, select, style, view

_registered = []

# Rows of the menu and the toolbar; None is a line between them.
LAYOUT = ("Burin_NewIllustration", "Burin_View", "Burin_Style", "Burin_Look", None, "Burin_Section", "Burin_SectionView", "Burin_Detail",
          "Burin_CentreLines", "Burin_Dimension", "Burin_Note", None, "Burin_Explode", "Burin_NumberParts", "Burin_StepBook", None, "Burin_RedrawAll", None,
          "Burin_PlaceOnPage", "Burin_LinesForDimensions", "Burin_Export", None, "Burin_SelectSource", "Burin_ShowLines")


def register():
    """Registers all commands once."""
    if _registered:
        return
    scheduler.install()
    for module in (new, view, style, look, apart, dimension, book, redraw, page, export, select, help):
        for command in module.COMMANDS:
            Gui.addCommand(command.name, command)
            _registered.append(command.name)


def toolbar():
    return [name or "Separator" for name in LAYOUT]


def menu():
    """As the toolbar, with what is asked for seldom."""
    rows = toolbar()
    rows.insert(rows.index("Burin_NewIllustration") + 1, "Burin_NewFromFile")
    rows.insert(rows.index("Burin_Export") + 1, "Burin_ExportFile")
    return [*rows, "Separator", "Burin_Help"]


def context():
    """Names for the context menu: what can be done with the selection."""
    chosen = Gui.Selection.getSelection()
    if not chosen:
        return []
    if not any(illustrations_by(o) for o in chosen):
        return ["Burin_NewIllustration", "Burin_Look", "Burin_SectionView", "Burin_Dimension", "Burin_Note"]
    return ["Burin_Edit", "Burin_View", "Burin_Style", "Burin_Section", "Burin_SectionView", "Burin_Detail", "Burin_CentreLines",
            "Burin_Dimension", "Burin_Note", "Burin_Explode", "Burin_NumberParts", "Burin_StepBook", "Burin_PlaceOnPage",
            "Burin_LinesForDimensions", "Burin_Export", "Burin_ExportFile", "Burin_SelectSource", "Burin_ShowLines"]
