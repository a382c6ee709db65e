"""The panel of an illustration: made with it, and opened again by a double-click."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..features.eye import set_view, standard, standards
from ..features.looks import FLAGS, flags_of, style_of, with_flag, with_style
from ..features.sources import survey
from ..offers import kept, title
from ..text import tr
from ..view.camera import camera_of
from . import widgets
from .lights import Lights
from .panel import Panel
from .views import Views


class IllustrationPanel(Panel):
    def fill(self):
        self._fill_view()
        self._fill_sheet()
        self._fill_style()
        self._fill_objects()

    def _fill_view(self):
        form = widgets.group(tr("View"), self.column)
        row = QtGui.QHBoxLayout()
        names = ["", *standards()]
        self.view = widgets.choice(names, "", tr("Standard views"), self._standard, "view",
                                   [tr("as it is"), *(tr(title(n)) for n in standards())])
        camera = QtGui.QPushButton(tr("3-D view"))
        camera.setObjectName("camera")
        camera.setToolTip(tr("Draws the illustration as the 3-D view shows the model now, in perspective too"))
        camera.clicked.connect(lambda: self._camera())
        row.addWidget(self.view)
        row.addWidget(camera)
        form.addRow(row)
        self.projection = widgets.choice(
            ["Orthographic", "Perspective"], self.obj.Projection, tr("Parallel, or with vanishing points"),
            self._project, "projection", [tr("Parallel"), tr("Perspective")])
        low, high = (kept()["options"]["perspective"][end] for end in ("low", "high"))
        self.angle = widgets.quantity(self.obj.FieldOfView.Value, "deg",
                                      tr("Vertical field of view, {0:g} to {1:g} degrees").format(low, high),
                                      lambda v: self.change("FieldOfView", v), "angle", low, high)
        self.angle.setEnabled(self.obj.Projection == "Perspective")
        row = QtGui.QHBoxLayout()
        row.addWidget(self.projection)
        row.addWidget(self.angle)
        form.addRow(row)
        self.views = Views(self)
        form.addRow(self.views.row)

    def _fill_sheet(self):
        form = widgets.group(tr("Sheet"), self.column)
        self.width = widgets.quantity(self.obj.Width.Value, "mm", tr("Width of the drawing on paper"),
                                      lambda v: self.change("Width", v), "width", 10.0, 2000.0)
        self.height = widgets.quantity(self.obj.Height.Value, "mm", tr("Height of the drawing on paper"),
                                       lambda v: self.change("Height", v), "height", 10.0, 2000.0)
        form.addRow(tr("Width"), self.width)
        form.addRow(tr("Height"), self.height)
        row = QtGui.QHBoxLayout()
        self.fit = widgets.check(self.obj.FitScale, tr("Fit"), tr("Scale so that the drawing fills the sheet"),
                                 self._fit, "fit")
        self.scale = widgets.number(self.obj.Scale, tr("Millimetres of paper for a millimetre of the model"),
                                    lambda v: self.change("Scale", v), "scale", 1e-4, 1e4, 4)
        self.scale.setEnabled(not self.obj.FitScale)
        row.addWidget(self.fit)
        row.addWidget(self.scale)
        form.addRow(tr("Scale"), row)

    def _fill_style(self):
        form = widgets.group(tr("Style"), self.column)
        row = QtGui.QHBoxLayout()
        names = widgets.styles(self.obj.Style)
        self.style = widgets.choice(names, self.obj.Style, tr("A built-in style, or a style file"),
                                    lambda v: self.change("Style", v), "style")
        file = QtGui.QToolButton()
        file.setText("…")
        file.setToolTip(tr("Chooses a style file"))
        file.clicked.connect(lambda: self._style_file())
        row.addWidget(self.style)
        row.addWidget(file)
        form.addRow(row)
        words = self.obj.getEnumerationsOfProperty("HiddenLines")
        self.hidden = widgets.choice(words, self.obj.HiddenLines, tr("How hidden lines are drawn"),
                                     lambda v: self.change("HiddenLines", v), "hidden", [tr(w.lower()) for w in words])
        form.addRow(tr("Hidden lines"), self.hidden)
        self.centres = widgets.check(self.obj.CentreLines, tr("Centre lines"), tr("Axes of round faces, and marks where they are seen along their axis"),
                                     lambda on: self.change("CentreLines", on), "centre-lines")
        form.addRow(self.centres)
        self.seed = widgets.whole(self.obj.Seed, tr("Seed of all that is left to chance: another one gives other strokes"),
                                  lambda v: self.change("Seed", v), "seed", 0, 2**31 - 1)
        form.addRow(tr("Seed"), self.seed)

    def _fill_objects(self):
        form = widgets.group(tr("Objects"), self.column)
        self.rows = []
        self.table = QtGui.QTableWidget(0, 1 + len(FLAGS))
        self.table.setObjectName("objects")
        self.table.setHorizontalHeaderLabels([tr("Object"), tr("off"), tr("plain"), tr("glass")])
        for k, tip in enumerate((tr("Object of the model; a row lights it up in the 3-D view, and is marked where it is selected there"), tr("Not drawn: as if the object were not there"),
                                 tr("Not hatched: lines alone"),
                                 tr("Transparent: what lies behind is drawn too"))):
            self.table.horizontalHeaderItem(k).setToolTip(tip)
        self.table.verticalHeader().hide()
        header = self.table.horizontalHeader()
        widgets.slim(header)
        header.setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
        self.table.setMinimumHeight(110)
        self.table.itemChanged.connect(lambda item: self._look(item))
        form.addRow(self.table)
        names = ["", *widgets.styles("")]
        self.own = widgets.choice(names, "", tr("Style of the object that is chosen above"), self._own_style, "own",
                                  [tr("as the others"), *names[1:]])
        self.own.setEnabled(False)
        self.table.currentCellChanged.connect(lambda *_: self._chosen())
        self.lights = Lights(self.document, self.table, lambda row: [self._path(row)])
        form.addRow(tr("Own style"), self.own)
        self.refresh()

    def refresh(self):
        """The objects that the sources have now."""
        rows = leaves(self.obj)
        if rows == self.rows:
            return
        chosen = self._path(self.table.currentRow()) if self.table.currentRow() >= 0 else None
        self.rows = rows
        self.table.blockSignals(True)
        self.table.setRowCount(len(rows))
        for r, (path, label) in enumerate(rows):
            self._fill_row(r, path, label)
        self.table.setCurrentCell(next((r for r, (path, _) in enumerate(rows) if path == chosen), -1), 0)
        self.table.blockSignals(False)
        self._chosen()

    def _fill_row(self, r, path, label):
        name = QtGui.QTableWidgetItem(label)
        name.setData(QtCore.Qt.UserRole, path)
        name.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsSelectable)
        name.setToolTip(path)
        self.table.setItem(r, 0, name)
        flags = flags_of(self.obj.Looks.get(path, ""))
        for k, flag in enumerate(FLAGS):
            item = QtGui.QTableWidgetItem()
            item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if flag in flags else QtCore.Qt.Unchecked)
            self.table.setItem(r, 1 + k, item)

    def closing(self):
        self.lights.stop()

    # --- what widgets do ---

    def _standard(self, name):
        if name:
            set_view(self.obj, standard(name))
            self.projection.setCurrentIndex(0)
            self.views.renew()
            self.changed()

    def _camera(self):
        eye = camera_of(Gui.ActiveDocument.ActiveView)
        if eye is None:
            self.message.setText(tr("show a 3-D view of the model first"))
            return
        set_view(self.obj, eye)
        self.views.renew()
        self.view.setCurrentIndex(0)
        self.projection.setCurrentIndex(1 if eye.angle else 0)
        self.angle.setProperty("rawValue", self.obj.FieldOfView.Value)
        self.changed()

    def _project(self, name):
        self.angle.setEnabled(name == "Perspective")
        self.change("Projection", name)

    def _fit(self, on):
        self.scale.setEnabled(not on)
        if not on and self.obj.DrawnScale:
            self.scale.setValue(self.obj.DrawnScale)
        self.change("FitScale", on)

    def _style_file(self):
        name, _ = QtGui.QFileDialog.getOpenFileName(self.form, tr("Style file"), "", tr("Style files") + " (*.json *.style);;* (*)")
        if name:
            self.use_style(name)

    def use_style(self, name):
        if self.style.findData(name) < 0:
            self.style.addItem(name, name)
        self.style.setCurrentIndex(self.style.findData(name))

    def _path(self, row):
        return self.table.item(row, 0).data(QtCore.Qt.UserRole)

    def _chosen(self):
        """Another row of the table."""
        row = self.table.currentRow()
        self.own.setEnabled(row >= 0)
        if row >= 0:
            style = style_of(self.obj.Looks.get(self._path(row), ""))
            if self.own.findData(style) < 0:
                self.own.addItem(style, style)
            self.own.setCurrentIndex(self.own.findData(style))

    def _own_style(self, style):
        row = self.table.currentRow()
        if row >= 0:
            looks = dict(self.obj.Looks)
            looks[self._path(row)] = with_style(looks.get(self._path(row), ""), style)
            self.change("Looks", {p: words for p, words in looks.items() if words})

    def _look(self, item):
        if item.column() == 0:
            return
        path = self._path(item.row())
        looks = dict(self.obj.Looks)
        on = item.checkState() == QtCore.Qt.Checked
        looks[path] = with_flag(looks.get(path, ""), FLAGS[item.column() - 1], on)
        self.change("Looks", {p: words for p, words in looks.items() if words})


def leaves(obj):
    """Paths and labels of what an illustration is made of."""
    pieces, _ = survey(obj.Sources)
    return [(piece.part.source, piece.part.name) for piece in pieces]
