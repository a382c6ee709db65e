"""New illustration of the selection, of all that is shown, or as a file says."""

import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import illustration_file, preferences
from ..errors import Refused
from ..features import make_illustration, visible
from ..features.eye import set_view
from ..features.shown import is_shown
from ..features.sources import is_aid, survey
from ..features.stands_for import illustrations_by
from ..tasks import show
from ..tasks.illustration import IllustrationPanel
from ..text import tr
from ..view.camera import camera_of
from .base import Command


class NewIllustration(Command):
    name = "Burin_NewIllustration"
    text = "New illustration"
    tip = "Draws the selected parts, bodies, meshes or assemblies (nothing selected: all that are shown) as the 3-D view shows them"
    icon = "burin_new.svg"
    accel = "U, N"
    needs_kernel = True

    def possible(self):
        return bool(Gui.Selection.getSelection()) or any(may_be_drawn(o) for o in FreeCAD.ActiveDocument.Objects)

    def run(self, document):
        sources = selected_sources() or [(o, ("",)) for o in visible(document)]
        if not sources:
            raise Refused(tr("nothing to draw: show or select the parts, bodies, meshes or assemblies to be drawn first"))
        pieces, notes = survey(sources)
        if not pieces:
            raise Refused(tr("nothing to draw: {0}").format("; ".join(notes) or tr("the selection has no visible shape")))
        obj = make_illustration(document, sources)
        preferences.apply_to(obj)
        eye = camera_of(Gui.ActiveDocument.ActiveView)
        if eye is not None:
            set_view(obj, eye)
        document.recompute([obj])
        obj.ViewObject.Proxy.lay_before()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        show(IllustrationPanel(obj))


def may_be_drawn(obj):
    """Whether an object is shown and of a kind that has shapes. Quick: asked at every change of the selection."""
    return (obj.isDerivedFrom("App::GeoFeature") or obj.isDerivedFrom("App::Link")) and is_shown(obj) and not is_aid(obj)


def selected_sources():
    """The selection as pairs of object and sub-names, whole objects only, without illustrations."""
    sources = []
    for chosen in Gui.Selection.getSelectionEx("", 0):
        if illustrations_by(chosen.Object):
            continue
        subs = sorted({s[: s.rfind(".") + 1] for s in chosen.SubElementNames}) or [""]
        sources.append((chosen.Object, tuple(subs)))
    return sources


class NewFromFile(Command):
    name = "Burin_NewFromFile"
    text = "New illustration from file..."
    tip = "Draws the objects that an illustration file names, with its looks, view, sheet, style and light"
    icon = "burin_new_file.svg"
    needs_kernel = True

    def possible(self):
        return any(may_be_drawn(o) for o in FreeCAD.ActiveDocument.Objects)

    def run(self, document):
        name, _ = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), self.text, "",
                                                    tr("Illustration files") + f" (*{illustration_file.SUFFIX} *.json)")
        if not name:
            return
        obj = illustration_file.read(document, name)
        document.recompute([obj])
        obj.ViewObject.Proxy.lay_before()
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)


COMMANDS = [NewIllustration(), NewFromFile()]
