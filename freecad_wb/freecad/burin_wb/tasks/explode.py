"""The panel that takes an assembly apart. Objects are shown on their ways as long as it is open, and stay where they are."""

import collections

import FreeCAD
from PySide import QtCore, QtGui

from ..errors import Refused
from ..features import assembly_view
from ..features.asking import steps_in, steps_job
from ..features.chosen import numbers_of
from ..features.explosion import Step, moves_of, steps_of
from ..features.extent import Extent
from ..text import tr
from ..view import scheduler
from ..view.arrows import Arrows
from ..view.displaced import Displaced
from . import widgets
from .lights import Lights, label_of, selected_paths
from .panel import Panel

AXES = {"+x": (1.0, 0.0, 0.0), "-x": (-1.0, 0.0, 0.0), "+y": (0.0, 1.0, 0.0), "-y": (0.0, -1.0, 0.0),
        "+z": (0.0, 0.0, 1.0), "-z": (0.0, 0.0, -1.0)}
LEAST = 0.01  # mm of a step
HEAD = 0.05  # half an arrow's length, as a share of the assembly's diagonal


class ExplodePanel(Panel):
    @property
    def title(self):
        return tr("Explode")

    def fill(self):
        self.extent = Extent(self.obj)
        self.steps = self._kept_steps()
        self.displaced = Displaced(self.document)
        self.arrows = Arrows(self.document, self._dragged)
        self._fill_finding()
        self._fill_table()
        self._fill_showing()
        self._list()

    def _fill_finding(self):
        self.wanted = widgets.check(self.obj.Explode, tr("Exploded"), tr("Draws the assembly taken apart; the model stays as it is"),
                                    lambda on: self._want(on), "exploded")
        self.column.addWidget(self.wanted)
        words = ["", *AXES, "x", "y", "z"]
        if self.obj.ExplodeAlong not in words:
            words.append(self.obj.ExplodeAlong)
        self.along = widgets.choice(words, self.obj.ExplodeAlong, tr("Ways that are tried where steps are found"),
                                    lambda way: setattr(self.obj, "ExplodeAlong", way), "along", [tr("all ways"), *words[1:]])
        self.find_button = widgets.button(tr("Find steps"), tr("Looks in which order and how far the parts come out; replaces the steps below. "
                                                              "Stop ends it"), self.find, "find")
        widgets.row(self.column, self.along, self.find_button)
        views = assembly_view.exploded_views(self.document)
        if views:
            self.views = widgets.choice([view.Name for view in views], "", tr("Exploded views of the workbench Assembly"), lambda _: None, "views",
                                        [view.Label for view in views])
            widgets.row(self.column, self.views, widgets.button(tr("Take over"), tr("Takes the moves of the exploded view as steps"),
                                                                self._take_over, "take-over"))

    def _fill_table(self):
        self.table = widgets.table([tr("Parts"), tr("Way"), tr("mm"), tr("line")], (
            tr("What moves together; a row lights up its objects in the 3-D view"), tr("+x, -z ..., or x, y, z of a direction of the model"),
            tr("How far; the arrows in the 3-D view can be dragged too"), tr("Whether a line shows the way")), "steps")
        self.table.itemChanged.connect(lambda cell: self._edited(cell))
        self.column.addWidget(self.table, 1)
        self.lights = Lights(self.document, self.table, lambda row: self.steps[row].move)
        widgets.row(self.column, widgets.button(tr("Add"), tr("A step of the objects that are selected"), self._add, "add"),
                    widgets.button(tr("Join"), tr("Makes one step of the rows that are selected"), self._join, "join"),
                    widgets.button(tr("Delete"), tr("Deletes the steps that are selected"), self._delete, "delete"),
                    widgets.button("↑", tr("Earlier"), lambda: self._shift(-1), "up"),
                    widgets.button("↓", tr("Later"), lambda: self._shift(1), "down"))
        self.said = QtGui.QLabel()
        self.said.setObjectName("said")
        self.said.setWordWrap(True)
        self.column.addWidget(self.said)

    def _fill_showing(self):
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("factor")
        self.slider.setRange(0, max(100, round(100 * self.obj.ExplodeFactor)))
        self.slider.setValue(round(100 * self.obj.ExplodeFactor))
        self.slider.setToolTip(tr("How far parts have come on their ways: together, apart"))
        self.slider.valueChanged.connect(lambda k: self._slide(k))
        self.share = QtGui.QLabel(f"{self.slider.value()} %")
        widgets.row(self.column, self.slider, self.share)
        self.shown = widgets.check(True, tr("In the 3-D view too"), tr("Shows the objects on their ways, with an arrow to drag for each step, as "
                                                                       "long as this panel is open"), lambda on: self._show(), "shown")
        self.column.addWidget(self.shown)

    def _kept_steps(self):
        try:
            return steps_of(self.obj)
        except Refused as why:
            QtCore.QTimer.singleShot(0, lambda text=str(why): self.message.setText(text))
            return []

    def refresh(self):
        self.extent = Extent(self.obj)
        self._show()

    def closing(self):
        self.lights.stop()
        self.arrows.remove()
        self.displaced.restore()

    # --- steps ---

    def find(self):
        """Asks for the steps beside the panel."""
        try:
            job = steps_job(self.obj)
        except Refused as why:
            QtCore.QTimer.singleShot(0, lambda text=str(why): self.message.setText(text))
            return
        self.find_button.setEnabled(False)
        scheduler.install().ask("steps", self.obj, job, lambda answer, error: self._found(job, answer, error))
        QtCore.QTimer.singleShot(0, lambda: self.over or self._report_state())  # Stop ends it

    def _found(self, job, answer, error):
        if self.over or not self.alive():
            return
        self.find_button.setEnabled(True)
        if error is not None:
            self.said.setText(str(error))
            if not self.steps:
                self.wanted.setChecked(False)
            return
        steps, messages = steps_in(job, answer)
        self.said.setText("; ".join(messages) if steps or messages else tr("nothing comes apart"))
        self._use(steps)
        if not steps:
            self.wanted.setChecked(False)

    def _use(self, steps):
        self.steps = steps
        self._keep()
        self._list()

    def _keep(self):
        """Draws the steps as they are now."""
        self.change("ExplodeSteps", [step.text() for step in self.steps])

    def _list(self):
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.steps))
        for row, step in enumerate(self.steps):
            self.table.setItem(row, 0, widgets.cell(self._parts(step), tip="\n".join(step.move[:20])))
            self.table.setItem(row, 1, widgets.cell(way_text(step.along), edited=True))
            self.table.setItem(row, 2, widgets.cell(f"{step.by:.4g}", edited=True))
            line = widgets.cell("")
            line.setFlags(line.flags() | QtCore.Qt.ItemIsUserCheckable)
            line.setCheckState(QtCore.Qt.Checked if step.trail else QtCore.Qt.Unchecked)
            self.table.setItem(row, 3, line)
        self.table.blockSignals(False)
        self.lights.mark()
        self._show()

    def _parts(self, step):
        """What moves, by its labels: "cover, 6 x nut"."""
        counts = collections.Counter(label_of(self.document, path) for path in step.move)
        return ", ".join(label if count == 1 else f"{count} x {label}" for label, count in counts.items())

    def _edited(self, cell):
        step, text = self.steps[cell.row()], cell.text().strip()
        try:
            if cell.column() == 1:
                step.along = way_of(text)
            elif cell.column() == 2:
                step.by = distance_of(text)
            else:
                step.trail = cell.checkState() == QtCore.Qt.Checked
        except ValueError as why:
            self.message.setText(str(why))
        else:
            self._keep()
        QtCore.QTimer.singleShot(0, lambda: self.over or self._list())  # not while the cell tells

    def _add(self):
        paths = [path for path in selected_paths(self.document) if numbers_of(path, self.extent.sources)]
        if not paths:
            self.message.setText(tr("select objects of the illustration in the 3-D view or the tree"))
            return
        self._use([*self.steps, Step(paths, AXES["+z"], float(f"{0.3 * self.extent.whole().DiagonalLength:.3g}"))])

    def _join(self):
        rows = self.lights.rows()
        if len(rows) < 2:
            self.message.setText(tr("select two rows or more"))
            return
        moved = list(dict.fromkeys(path for row in rows for path in self.steps[row].move))
        first = self.steps[rows[0]]
        joined = Step(moved, first.along, first.by, first.trail)
        self._use([joined if row == rows[0] else step for row, step in enumerate(self.steps) if row == rows[0] or row not in rows])

    def _delete(self):
        rows = self.lights.rows()
        self._use([step for row, step in enumerate(self.steps) if row not in rows])
        if not self.steps:
            self.wanted.setChecked(False)

    def _shift(self, by):
        rows = self.lights.rows()
        if len(rows) != 1 or not 0 <= rows[0] + by < len(self.steps):
            return
        steps, at = list(self.steps), rows[0]
        steps[at], steps[at + by] = steps[at + by], steps[at]
        self._use(steps)
        self.table.selectRow(at + by)

    def _take_over(self):
        view = self.document.getObject(self.views.currentData())
        steps, notes = assembly_view.steps_of(view)
        self.said.setText("; ".join(notes))
        if steps:
            self.wanted.setChecked(True)
            self._use(steps)

    def _want(self, on):
        self.change("Explode", on)
        self._show()

    def _slide(self, k):
        self.share.setText(f"{k} %")
        self.change("ExplodeFactor", k / 100)
        self._show()

    # --- the 3-D view ---

    def _show(self):
        """Objects on their ways, and the arrows, as the steps are now."""
        if self.over:
            return
        if not (self.shown.isChecked() and self.obj.Explode and self.extent.whole().isValid()):  # else all is hidden, as the preview says
            self.displaced.restore()
            self.arrows.show([], 1.0)
            return
        sources, factor = self.extent.sources, self.obj.ExplodeFactor
        self.displaced.show(sources, moves_of(self.steps, sources, factor))
        self.arrows.show([self._place(number, factor) for number in range(len(self.steps))], self._head())

    def _place(self, number, factor):
        """The foot, way and length of the arrow of a step: before its parts, where they would be without the step."""
        sources, step = self.extent.sources, self.steps[number]
        others = moves_of([other for k, other in enumerate(self.steps) if k != number], sources, factor)
        numbers = sorted({k for word in step.move for k in numbers_of(word, sources)})
        box = self.extent.whole({sources[k] for k in numbers})
        box = box if box.isValid() else self.extent.whole()
        way = FreeCAD.Vector(*step.along).normalize()
        front = max((box.getPoint(k) - box.Center).dot(way) for k in range(8)) + self._head()
        foot = box.Center + way * front + (others[numbers[0]] if numbers else FreeCAD.Vector())
        return foot, way, step.by * factor

    def _head(self):
        """Half the length of an arrow."""
        return max(HEAD * self.extent.whole().DiagonalLength, 1e-6)

    def _dragged(self, number, mm, ended):
        """An arrow is dragged, or was let go."""
        if self.over:
            return
        step, factor = self.steps[number], self.obj.ExplodeFactor
        if factor < 0.01:
            return
        step.by = max(LEAST, float(f"{mm / factor:.5g}"))
        self.table.blockSignals(True)
        self.table.item(number, 2).setText(f"{step.by:.4g}")
        self.table.blockSignals(False)
        sources = self.extent.sources
        self.displaced.show(sources, moves_of(self.steps, sources, factor))
        self._keep()
        if ended:
            self._show()


def way_text(along):
    """+x, -z ..., or three numbers."""
    way = FreeCAD.Vector(*along).normalize()
    for name, axis in AXES.items():
        if (way - FreeCAD.Vector(*axis)).Length < 1e-9:
            return name
    return ", ".join(f"{a:.4g}" for a in way)


def way_of(text):
    """Throws ValueError."""
    if text in AXES or "+" + text in AXES:
        return AXES.get(text) or AXES["+" + text]
    try:
        x, y, z = (float(a) for a in text.split(","))
    except ValueError:
        raise ValueError(tr("a way is +x, -x, +y, -y, +z, -z or three numbers such as 1, 0, 1"))
    if not FreeCAD.Vector(x, y, z).Length > 0:
        raise ValueError(tr("a way is +x, -x, +y, -y, +z, -z or three numbers such as 1, 0, 1"))
    return x, y, z


def distance_of(text):
    """Throws ValueError."""
    try:
        mm = FreeCAD.Units.Quantity(text).Value
    except (ValueError, OSError, TypeError):
        mm = 0.0
    if not 0 < mm <= 1e12:
        raise ValueError(tr("a step moves its parts by more than 0 mm"))
    return mm
