"""The view provider of illustrations. Documents name it as freecad.burin_wb.view.provider.IllustrationView."""

import os

import FreeCADGui as Gui
from pivy import coin
from PySide import QtCore, QtGui

from .. import hooks
from ..features.dimension import dimensions_of, illustrations_of, is_dimension
from ..proxy import Stateless
from ..tell import ERROR, tell
from ..text import tr
from . import ink, reading
from .follow import follow

_ICONS = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "icons")
_ICON, _STALE = os.path.join(_ICONS, "burin_illustration.svg"), os.path.join(_ICONS, "burin_stale.svg")


class IllustrationView(Stateless):
    is_stale = False  # as the tree shows it

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        self.Object = view.Object
        self.View = view
        self._shown, self._stand = "", None  # the file of the drawing that is shown, and where its sheet stands in the model
        self._painted = None  # the same on paper
        self._aside = False
        self._reading = None  # what is to be shown next
        _ensure(view)
        self._root, sheet, self._paper, self._ink, self._lit = (coin.SoSeparator() for _ in range(5))
        self._pose, self._lines = coin.SoGroup(), coin.SoSwitch()
        self._lines.addChild(self._ink)
        self._lines.addChild(ink.when_large(self._ink))
        for parent, node in ((self._root, sheet), (sheet, self._pose), (sheet, self._paper), (sheet, self._lines),
                             (self._root, self._lit)):
            parent.addChild(node)
        view.addDisplayMode(self._root, "Ink")
        self._watch = None
        self._renew()
        follow(view.Object, view.Follow)

    def getDisplayModes(self, view):
        return ["Ink"]

    def getDefaultDisplayMode(self):
        return "Ink"

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        return _STALE if self.is_stale else _ICON

    def mark(self, stale):
        """Shows in the tree whether the drawing is not up to date."""
        if stale != self.is_stale and hasattr(self, "View"):
            self.is_stale = stale
            self.View.signalChangeIcon()

    def updateData(self, obj, name):
        if name == "Drawing" and hasattr(self, "_root"):
            self._renew()

    def onChanged(self, view, name):
        if name in ("Plane", "InkColor", "Paper") and hasattr(self, "_root"):
            self._place()
        if name == "Follow" and hasattr(self, "_root"):
            follow(self.Object, view.Follow)

    def lift(self, sheet):
        """Model mm from the view's centre to the plane of the ink, to the viewer."""
        return plane(self.Object, sheet, not self._aside and getattr(self.View, "Plane", BEHIND) != BEHIND)

    def lay_before(self):
        """Shows the drawing on paper before the model, as a new one is shown: behind the model nobody sees it."""
        self.View.Plane, self.View.Paper = BEFORE, True

    def step_aside(self, on):
        """Leaves the sight to the model while a panel works at it."""
        self._aside = on
        self._place()

    def _renew(self):
        """Reads the kept drawing beside the GUI; what is shown stays until then."""
        path = getattr(self.Object, "Drawing", "")
        if path and not os.path.exists(path):
            path = ""
        # Opening a document and undo tell each property once more, and every drawing has a file name of its own.
        if path == (self._reading.path if self._reading is not None else self._shown):
            return
        if self._reading is not None:
            reading.drop(self._reading)
        self._reading = reading.start(self.Object, path, self._read) if path else None
        if not path:
            self._show("", None, [], None)

    def _read(self, which, stand, nodes, painted, error):
        if which is not self._reading:
            return
        self._reading = None
        try:
            if error is None:
                self._show(which.path, stand, nodes, painted)
                return
            self._show("", None, [], None)
            if self.Object.Drawing == which.path and os.path.exists(which.path):
                tell(f"{self.Object.Label}: the kept drawing cannot be read ({error}); recompute the illustration", ERROR)
        except (NameError, ReferenceError, RuntimeError):  # the document was closed meanwhile
            pass

    def _show(self, path, stand, nodes, painted):
        self._shown, self._stand, self._painted = path, stand, painted
        self._ink.removeAllChildren()
        for node in nodes:
            self._ink.addChild(node)
        self._place()

    def _place(self):
        """Puts the drawing behind the model, where it hides nothing, or before it."""
        self._dim()
        self._pose.removeAllChildren()
        self._paper.removeAllChildren()
        if self._stand is None:
            return
        self._pose.addChild(ink.lifted(self._stand, self.lift(self._stand)))
        self._pose.addChild(ink.colored(tuple(getattr(self.View, "InkColor", DARK))[:3]))
        paper = getattr(self.View, "Paper", False) and not self._aside
        if paper:
            self._paper.addChild(ink.paper_node(self._stand, (self.Object.Width.Value, self.Object.Height.Value), self._painted))
        self._lines.whichChild = 1 if paper and self._painted is not None else 0

    def light(self, sheet, paths):
        """Shows some lines in colour, until the selection changes."""
        self._dim()
        paths = list(paths)
        if not paths:
            return
        # Before the model, which would hide them, and on the ink itself, a hair before it.
        pens = ink.pens(sheet, paths)
        for lift in (plane(self.Object, sheet, True), self.lift(sheet) + 0.05 / sheet.scale):
            lit = coin.SoSeparator()
            lit.addChild(ink.lifted(sheet, lift))
            lit.addChild(ink.colored(ink.LIT))
            for pen in pens:
                lit.addChild(ink.lines_node(pen, extra=2))
            self._lit.addChild(lit)
        self._watch = _Watch(self)
        Gui.Selection.addObserver(self._watch)

    def lit(self):
        """Whether lines are shown in colour."""
        return self._lit.getNumChildren() > 0

    def _dim(self):
        if self._watch is not None:
            Gui.Selection.removeObserver(self._watch)
            self._watch = None
        self._lit.removeAllChildren()

    def doubleClicked(self, view):
        hooks.edit(view.Object)
        return True

    def setEdit(self, view, mode=0):
        """The panel has its own transaction; FreeCAD's edit mode would end it."""
        hooks.edit(view.Object)
        return False

    def setupContextMenu(self, view, menu):
        action = menu.addAction(QtGui.QIcon(_ICON), tr("Edit illustration"))
        action.triggered.connect(lambda: self.doubleClicked(view))
        action = menu.addAction(tr("Before the model"))
        action.setCheckable(True)
        action.setChecked(view.Plane == BEFORE)
        action.toggled.connect(lambda on: setattr(view, "Plane", BEFORE if on else BEHIND))
        action = menu.addAction(tr("Follow the 3-D view"))
        action.setCheckable(True)
        action.setChecked(view.Follow)
        action.toggled.connect(lambda on: setattr(view, "Follow", on))

    def claimChildren(self):
        return dimensions_of(self.Object) if hasattr(self, "Object") else []

    def canDelete(self, obj):
        """Whether something that it refers to may go without a question."""
        return is_dimension(obj)

    def onDelete(self, view, names):
        """Its dimensions and notes go with it, in the same undo."""
        for one in dimensions_of(view.Object):
            if illustrations_of(one) == [view.Object]:
                view.Object.Document.removeObject(one.Name)
        return True


class _Watch:
    """Puts the light out when the selection changes."""

    def __init__(self, provider):
        self._provider = provider

    def _changed(self, *_):
        provider = self._provider  # not from within the call: it removes this observer
        QtCore.QTimer.singleShot(0, lambda: provider._dim() if provider._watch is self else None)

    addSelection = removeSelection = setSelection = clearSelection = _changed


DARK = (0.06, 0.06, 0.08)

BEHIND, BEFORE = "Behind the model", "Before the model"


def _ensure(view):
    """Adds the properties that a view provider lacks."""
    have = set(view.PropertiesList)
    for kind, name, text, value in (
            ("App::PropertyEnumeration", "Plane", "Where the drawing lies in the 3-D view", [BEHIND, BEFORE]),
            ("App::PropertyColor", "InkColor", "Colour of the lines in the 3-D view, without paper", DARK),
            ("App::PropertyBool", "Paper", "Shows the drawing on its paper, with its colours", False),
            ("App::PropertyBool", "Follow", "Draws as the 3-D view shows the model, whenever its camera stops moving", False)):
        if name not in have:
            view.addProperty(kind, name, "Ink", text)
            setattr(view, name, value)


def plane(obj, sheet, before=False):
    """Model mm along the view's direction from its centre to a plane behind or before all sources."""
    farthest = 0.0
    sign = 1.0 if before else -1.0
    for source, subs in obj.Sources:
        for box in _boxes(source, subs):
            for k in range(8):
                farthest = max(farthest, sign * (box.getPoint(k) - sheet.center).dot(sheet.direction))
    return sign * farthest


def _boxes(source, subs):
    """Boxes in global coordinates, without making shapes: assemblies by what is shown of them."""
    for sub in subs or ("",):
        for kind in ("Shape", "Mesh"):
            box = getattr(getattr(source, kind, None), "BoundBox", None)
            if box is not None and box.isValid():
                yield box
                break
        else:
            view = getattr(source, "ViewObject", None)
            try:
                box = view.getBoundingBox(sub) if view is not None else None
            except Exception:  # not shown yet
                box = None
            if box is not None and box.isValid():
                yield box
