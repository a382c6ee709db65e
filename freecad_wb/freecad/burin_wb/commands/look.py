"""How single objects are drawn."""

import FreeCADGui as Gui

from ..errors import Refused
from ..features.looks import FLAGS, flags_of, path_of, with_flag
from ..features.stands_for import illustrations_by
from ..text import tr
from .base import Command, Group, selected_illustrations


def chosen_objects():
    """Paths of the selected objects that are no illustrations: 'Assembly.Body' with the internal names."""
    paths = []
    for chosen in Gui.Selection.getSelectionEx("", 0):
        if not illustrations_by(chosen.Object):
            paths.extend(path_of(chosen.Object, sub) for sub in chosen.SubElementNames or ("",))
    return sorted(set(paths))


class Look(Command):
    """Gives a flag to the selected objects, or takes it away where all have it."""

    flag = ""

    def possible(self):
        return bool(chosen_objects()) and bool(selected_illustrations())

    def run(self, document):
        paths, illustrations = chosen_objects(), selected_illustrations()
        if not paths or not illustrations:
            raise Refused(tr("select an object of the illustration (and the illustration, where there are several)"))
        for obj in illustrations:
            looks = dict(obj.Looks)
            on = not all(self.flag in flags_of(looks.get(path, "")) for path in paths)
            for path in paths:
                looks[path] = with_flag(looks.get(path, ""), self.flag, on)
            obj.Looks = {path: words for path, words in looks.items() if words}
        document.recompute(illustrations)


class NotDrawn(Look):
    name = "Burin_LookNotDrawn"
    text = "Not drawn"
    tip = "Draws the illustration as if the selected objects were not there"
    icon = "burin_look.svg"
    flag = "not drawn"


class NotHatched(Look):
    name = "Burin_LookNotHatched"
    text = "Not hatched"
    tip = "Draws the selected objects with lines alone, without strokes that carry the tone"
    icon = "burin_look.svg"
    flag = "not hatched"


class Transparent(Look):
    name = "Burin_LookTransparent"
    text = "Transparent"
    tip = "Draws the selected objects with lines alone, and what lies behind them too"
    icon = "burin_look.svg"
    flag = "transparent"


MEMBERS = [NotDrawn(), NotHatched(), Transparent()]
assert [m.flag for m in MEMBERS] == list(FLAGS)


class LookGroup(Group):
    name = "Burin_Look"
    text = "Look of objects"
    tip = "How the selected objects are drawn; once more takes it back"
    members = [m.name for m in MEMBERS]


COMMANDS = [*MEMBERS, LookGroup()]
