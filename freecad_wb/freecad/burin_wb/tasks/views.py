"""Several views on a sheet: which, and by which method of projection."""

from PySide import QtGui

from ..features.details import METHODS, views_of
from ..features.eye import standards
from ..offers import title
from ..text import tr
from . import widgets


class Views:
    """A row of a panel."""

    def __init__(self, panel):
        self._panel = panel
        self.button = QtGui.QToolButton()
        self.button.setObjectName("views")
        self.button.setPopupMode(QtGui.QToolButton.InstantPopup)
        self.button.setToolTip(tr("Several views on the sheet at one scale, front, top ... about the front view, others in the corner; "
                                  "none: the view above"))
        self.menu = QtGui.QMenu(self.button)
        self.actions = {}
        for name in standards():
            action = self.menu.addAction(tr(title(name)))
            action.setCheckable(True)
            action.triggered.connect(lambda *_: self._chosen())
            self.actions[name] = action
        self.button.setMenu(self.menu)
        words = list(METHODS)
        self.method = widgets.choice(words, panel.obj.ProjectionMethod, tr("Where the view from the left goes: to the right of the front view "
                                                                          "(first angle), or to its left (third angle)"),
                                     lambda word: panel.change("ProjectionMethod", word), "method", [tr("First angle"), tr("Third angle")])
        self.method.setMinimumContentsLength(5)  # the row is as narrow as the others
        self.row = QtGui.QHBoxLayout()
        self.row.addWidget(self.button)
        self.row.addWidget(self.method, 1)
        self.renew()

    def renew(self):
        """Shows what the illustration has."""
        names = views_of(self._panel.obj)
        for name, action in self.actions.items():
            action.setChecked(name in names)
        self.button.setText(tr("{0} views").format(len(names)) if names else tr("One view"))
        self.method.setEnabled(bool(names))

    def _chosen(self):
        """In the order of the menu; what it does not know, such as directions, stays behind."""
        others = [name for name in views_of(self._panel.obj) if name not in self.actions]
        self._panel.change("Views", [name for name, action in self.actions.items() if action.isChecked()] + others)
        self.renew()
