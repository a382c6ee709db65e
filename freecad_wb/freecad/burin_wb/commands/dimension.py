"""What drawings of parts are read by: dimensions and notes of what is selected, centre lines."""

import FreeCAD
import FreeCADGui as Gui

from ..errors import Refused
from ..features import is_illustration, make_dimension, make_note
from ..features.looks import path_of
from ..features.properties import CENTRE_LINES
from ..features.sources import from_the_top, survey
from ..tasks import show
from ..tasks.dimensions import DimensionsPanel, selected_features
from ..text import tr
from .base import Command, selected_illustrations, some_illustrations


class Dimension(Command):
    name = "Burin_Dimension"
    text = "Dimension"
    tip = ("Writes a dimension of the selected faces, edges or vertices: a distance or an angle of two, the diameter or radius of a round one, the "
           "length of an edge; without any: width, depth and height")
    icon = "burin_dimension.svg"
    accel = "U, D"

    def possible(self):
        return bool(FreeCAD.ActiveDocument.Objects)

    def run(self, document):
        illustration, features = selected(document)
        made = make_dimension(illustration, features)
        document.recompute()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(made)


class Note(Command):
    name = "Burin_Note"
    text = "Note"
    tip = "Writes words beside the drawing, with a leader to each of the selected faces, edges, vertices or objects"
    icon = "burin_note.svg"
    accel = "U, T"

    def possible(self):
        return bool(FreeCAD.ActiveDocument.Objects)

    def run(self, document):
        illustration, features = selected(document, wholes=True)
        if not features:
            raise Refused(tr("select what the note is about: faces, edges, vertices or objects"))
        made = make_note(illustration, features)
        document.recompute()
        show(DimensionsPanel(illustration, made))


def selected(document, wholes=False):
    """The illustration that a dimension or a note is for, and the features that are selected for it. Throws Refused."""
    if not any(is_illustration(obj) for obj in document.Objects):
        raise Refused(tr("there is no illustration yet; make one with New illustration first"))
    features = selected_features(document, wholes)
    return illustration_for(document, features), features


def illustration_for(document, features):
    """The selected illustration, else the only one of the document, else the only one that draws these features. Throws Refused."""
    chosen = selected_illustrations()
    if not chosen:
        chosen = [obj for obj in document.Objects if is_illustration(obj) and features and draws(obj, features)]
    if len(chosen) != 1:
        raise Refused(tr("select the illustration too: this document has several"))
    return chosen[0]


def draws(obj, features):
    """Whether an illustration draws the objects of all features."""
    sources = [piece.part.source for piece in survey(obj.Sources)[0]]
    paths = [path_of(*from_the_top(*feature)) for feature in features]
    return all(any(f"{path}.".startswith(f"{source}.") for source in sources) for path in paths)


class CentreLines(Command):
    name = "Burin_CentreLines"
    text = "Centre lines"
    tip = "Draws the axes of round faces, and marks where these are seen along their axis; once more: leaves them out"
    icon = "burin_centre_lines.svg"

    def possible(self):
        return bool(selected_illustrations())

    def run(self, document):
        chosen = some_illustrations()
        on = not all(obj.CentreLines or obj.StyleKeys.get(CENTRE_LINES) == "true" for obj in chosen)
        for obj in chosen:
            obj.CentreLines = on
            obj.StyleKeys = {key: value for key, value in obj.StyleKeys.items() if key != CENTRE_LINES}
        document.recompute()


COMMANDS = [CentreLines(), Dimension(), Note()]
