"""The panel that cuts an assembly open."""

import math

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..errors import Refused
from ..features import section
from ..features.details import entries_of, letters_of, to_viewer
from ..features.extent import Extent
from ..features.eye import face_of
from ..text import tr
from ..view.cutting_plane import CuttingPlane
from . import widgets
from .lights import label_of, selected_paths
from .panel import Panel

AXES = {"x": FreeCAD.Vector(1, 0, 0), "y": FreeCAD.Vector(0, 1, 0), "z": FreeCAD.Vector(0, 0, 1)}
STEPS = 1000  # of the slider
NEAR = 1e-6  # mm: what is as near to the end of the model lies at its end


class SectionPanel(Panel):
    @property
    def title(self):
        return tr("Section")

    def fill(self):
        self._quiet = True
        self.extent = Extent(self.obj)
        self._plane = CuttingPlane(self.document)
        self.list = QtGui.QListWidget()
        self.list.setObjectName("sections")
        self.list.setToolTip(tr("The planes that cut, one after the other"))
        self.list.setMaximumHeight(70)
        self.list.currentRowChanged.connect(lambda row: self._chosen())
        self.column.addWidget(self.list)
        widgets.row(self.column, widgets.button(tr("Add"), tr("Another plane: across the view, through the middle"), self._add, "add"),
                    widgets.button(tr("From face"), tr("Another plane: through the selected flat face or datum plane; what lies before it goes"),
                                   self._from_face, "face"),
                    widgets.button(tr("Delete"), tr("Takes the plane away that is chosen above"), self._delete, "delete"))
        self._fill_plane()
        self._fill_whole()
        self._quiet = False
        self._list(0)
        self.begin()

    def begin(self):
        """What the panel is opened with: a plane where there is none."""
        if not self.obj.Sections:
            self._add()

    def _fill_plane(self):
        form = widgets.group(tr("Plane"), self.column)
        line = QtGui.QHBoxLayout()
        self.axis = widgets.choice(["x", "y", "z", ""], "y", tr("The axis of the model that is normal to the plane"), self._across, "axis",
                                   [tr("across x"), tr("across y"), tr("across z"), tr("as it is")])
        line.addWidget(self.axis, 1)
        line.addWidget(widgets.button(tr("Flip"), tr("Takes the other side away"), self._flip, "flip"))
        form.addRow(line)
        self.offset = widgets.quantity(0.0, "mm", tr("Its position along its axis"), lambda v: self._move(v), "offset", -1e6, 1e6)
        form.addRow(tr("At"), self.offset)
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("slider")
        self.slider.setRange(0, STEPS)
        self.slider.setToolTip(tr("Moves the plane through the model"))
        self.slider.valueChanged.connect(lambda k: self._slide(k))
        form.addRow(self.slider)
        line = QtGui.QHBoxLayout()
        self.own = widgets.check(False, tr("View of its own"), tr("Draws the section as a view A-A of the sheet, and leaves the other views whole; a view that "
                                                                  "sees the plane from its edge has the line of the cut"), self._own, "own")
        self.letter = QtGui.QLineEdit()
        self.letter.setObjectName("letter")
        self.letter.setMaximumWidth(50)
        self.letter.setToolTip(tr("Its letter; empty: the next one"))
        self.letter.editingFinished.connect(lambda: self._own(self.own.isChecked()))
        line.addWidget(self.own, 1)
        line.addWidget(self.letter)
        form.addRow(line)

    def _fill_whole(self):
        form = widgets.group(tr("Stays whole"), self.column)
        self.whole = QtGui.QListWidget()
        self.whole.setObjectName("whole")
        self.whole.setToolTip(tr("Objects that this plane does not cut, such as bolts and shafts"))
        self.whole.setMaximumHeight(70)
        form.addRow(self.whole)
        line = QtGui.QHBoxLayout()
        line.addWidget(widgets.button(tr("Exclude"), tr("The objects that are selected in the 3-D view stay whole"), self._exclude, "exclude"))
        line.addWidget(widgets.button(tr("Cut"), tr("Cuts the objects that are chosen above, or all, again"), self._include, "include"))
        form.addRow(line)

    def refresh(self):
        self.extent = Extent(self.obj)
        self._chosen()

    def closing(self):
        self._plane.remove()

    # --- entries ---

    def _entries(self):
        try:
            return section.entries_of(self.obj)
        except Refused as why:
            self._say_later(str(why))
            return []

    def _say_later(self, text):
        """When the panel has said how it stands with the drawing."""
        QtCore.QTimer.singleShot(0, lambda: self.over or self.message.setText(text))

    def _row(self):
        return self.list.currentRow()

    def _entry(self):
        entries, row = self._entries(), self._row()
        return entries[row] if 0 <= row < len(entries) else None

    def _use(self, entries, row):
        self.change("Sections", [section.text_of(entry) for entry in entries])
        self._list(row)

    def _put(self, entry):
        entries = self._entries()
        entries[self._row()] = entry
        self._use(entries, self._row())

    def _list(self, row):
        """The entries as they are now."""
        entries = self._entries()
        self.list.blockSignals(True)
        self.list.clear()
        self.list.addItems(self._called(entries))
        self.list.setCurrentRow(min(row, len(entries) - 1))
        self.list.blockSignals(False)
        self._chosen()

    def _plane_of(self, entry):
        return section.plane_of(entry, to_viewer(self.obj), self.extent.along) if entry is not None else None

    def _offsets(self, normal):
        return section.offsets_along(self._entries(), normal, to_viewer(self.obj), self.extent.along)

    def _taken(self, normal):
        return [offset for offset in self._offsets(normal) if offset is not None]

    def _words(self, entry):
        """What the list says of an entry."""
        plane = self._plane_of(entry)
        if plane is None:
            return section.text_of(entry)
        name, sign = axis_of(plane[0])
        where = name or ", ".join(f"{n:.3g}" for n in plane[0])
        return tr("{0} at {1} mm").format(("-" if sign < 0 else "+") + where if name else where, f"{round(sign * plane[1], 6) + 0.0:.6g}")

    def _called(self, entries):
        """What the list says of all entries; those with views of their own by their letters."""
        letters = iter(letters_of(section.own_views(entries) + self._details()))
        return [("{0}-{0}: ".format(next(letters)) if section.view_of(entry) else "") + self._words(entry) for entry in entries]

    def _details(self):
        try:
            return entries_of(self.obj)
        except Refused:  # which the drawing tells
            return []

    def _chosen(self):
        """Shows the entry that is chosen in the fields."""
        self._quiet = True
        entry = self._entry()
        plane = self._plane_of(entry)
        for field in (self.axis, self.offset, self.slider, self.form.findChild(QtGui.QPushButton, "flip")):
            field.setEnabled(plane is not None)
        view = section.view_of(entry)
        self.own.setEnabled(section.may_have_view(entry))
        self.own.setChecked(bool(view))
        self.letter.setEnabled(bool(view))
        self.letter.setText(view if isinstance(view, str) else "")
        self.whole.clear()
        for path in section.excluded(entry):
            item = QtGui.QListWidgetItem(label_of(self.document, path), self.whole)
            item.setData(QtCore.Qt.UserRole, path)
            item.setToolTip(path)
        self._plane.show(*(plane or (None, 0.0)), self.extent.whole())
        if plane is not None:
            name, sign = axis_of(plane[0])
            self.axis.setCurrentIndex(self.axis.findData(name))
            self.offset.setProperty("rawValue", sign * plane[1])
            low, high = self._range(plane[0], sign)
            self.slider.setValue(round(STEPS * (sign * plane[1] - low) / (high - low)) if high > low else 0)
        self._quiet = False

    def _range(self, normal, sign):
        return self.extent.along(normal * sign)

    def _set(self, normal, offset):
        """The plane of the entry that is chosen; all else of it stays."""
        entry = self._entry()
        kept = {key: value for key, value in entry.items() if key != "plane"} if isinstance(entry, dict) else {}
        self._put({**section.plane(tuple(n + 0.0 for n in normal), round(offset, 6) + 0.0), **kept})

    # --- what widgets do ---

    def _add(self):
        """Across the axis that looks most to the viewer, through the middle; of two that do so alike, across the first: an isometric
        camera is isometric to six digits."""
        to = to_viewer(self.obj)
        name = max("xy" if abs(to.z) < 0.99 * to.Length else "z", key=lambda axis: round(abs(AXES[axis].dot(to)) / to.Length, 3))
        normal = AXES[name] * (1 if AXES[name].dot(to) >= 0 else -1)
        low, high = self.extent.along(normal)
        offset = section.free_offset((low + high) / 2, self._taken(normal), low, high)
        self._use([*self._entries(), section.plane(normal, round(offset, 6) + 0.0)], len(self._entries()))

    def _from_face(self):
        try:
            normal, offset = selected_plane(self.document)
        except Refused as why:
            self.message.setText(str(why))
            return
        self._use([*self._entries(), section.plane(normal, offset)], len(self._entries()))

    def _delete(self):
        entries = self._entries()
        if 0 <= self._row() < len(entries):
            del entries[self._row()]
            self._use(entries, max(self._row() - 1, 0))

    def _across(self, name):
        plane = self._plane_of(self._entry())
        if self._quiet or plane is None or not name:
            return
        normal = AXES[name] * (1 if AXES[name].dot(to_viewer(self.obj)) >= 0 else -1)
        self._set(normal, sum(self.extent.along(normal)) / 2)

    def _own(self, on):
        entry = self._entry()
        view = (self.letter.text().strip() or True) if on else None
        if not self._quiet and entry is not None and view != section.view_of(entry):
            self._put(section.in_view(entry, view))

    def _flip(self):
        plane = self._plane_of(self._entry())
        if plane is not None:
            self._set(-plane[0], -plane[1])

    def _move(self, value):
        plane = self._plane_of(self._entry())
        if not self._quiet and plane is not None:
            self._set(plane[0], axis_of(plane[0])[1] * value)

    def _slide(self, k):
        plane = self._plane_of(self._entry())
        if not self._quiet and plane is not None:
            low, high = self._range(plane[0], axis_of(plane[0])[1])
            self._move(low + (high - low) * k / STEPS)

    def _exclude(self):
        entry, paths = self._entry(), [path for path in selected_paths(self.document) if path.split(".")[0] != self.obj.Name]
        if entry is None or not paths:
            self.message.setText(tr("select objects in the 3-D view or the tree"))
            return
        self._leave_whole(entry, [*section.excluded(entry), *paths])

    def _include(self):
        entry = self._entry()
        chosen = {item.data(QtCore.Qt.UserRole) for item in self.whole.selectedItems()}
        if entry is not None:
            self._leave_whole(entry, [word for word in section.excluded(entry) if chosen and word not in chosen])

    def _leave_whole(self, entry, words):
        entry = entry if isinstance(entry, dict) else {"plane": entry}
        self._put({**entry, "exclude": list(dict.fromkeys(words))})


class SectionViewPanel(SectionPanel):
    """The same panel, opened with another section, which has a view of its own. `plane`: its normal and offset; nothing: across y,
    through the middle."""

    def __init__(self, obj, plane=None):
        self._first = plane
        super().__init__(obj)

    def begin(self):
        normal, offset = self._first or (AXES["y"] * (1 if AXES["y"].dot(to_viewer(self.obj)) > 1e-9 else -1), math.inf)
        low, high = self.extent.along(normal)
        entries = self._entries()
        if not low + NEAR < offset < high - NEAR:  # a plane that bounds the model cuts nothing
            offset = section.free_offset((low + high) / 2, self._taken(normal), low, high)
        row = next((k for k, one in enumerate(self._offsets(normal)) if one is not None and abs(one - offset) <= section.NEAR), None)
        if row is not None:
            self._list(row)
            self._say_later(tr("a section lies in this plane already; move it, or add another one"))
            return
        plane = section.plane(tuple(n + 0.0 for n in normal), round(offset, 6) + 0.0)
        self._use([*entries, section.in_view(plane)], len(entries))


def axis_of(normal):
    """The axis that a normal lies along, and its sign; an empty name and 1 where it lies along none."""
    for name, axis in AXES.items():
        if abs(normal.dot(axis)) > 1 - 1e-12:
            return name, 1 if normal.dot(axis) > 0 else -1
    return "", 1


def selected_plane(document):
    """Normal and offset of the flat face or the datum plane that is selected. Throws Refused."""
    plane = chosen_plane(document)
    if plane is None:
        raise Refused(tr("select a flat face or a datum plane"))
    return plane


def chosen_plane(document):
    """As `selected_plane`; nothing where no face and no plane is selected. Throws Refused where a face is curved."""
    for chosen in Gui.Selection.getSelectionEx(document.Name, 0):
        for sub in chosen.SubElementNames or ("",):
            obj = chosen.Object.getSubObject(sub, retType=1) if sub else chosen.Object
            if obj is not None and any(obj.isDerivedFrom(kind) for kind in ("App::Plane", "PartDesign::Plane")):  # without end
                return section.of_placement(FreeCAD.Placement(chosen.Object.getSubObject(sub, retType=4)))
            if sub.rpartition(".")[2].startswith("Face"):
                return section.of_face(*face_of(chosen.Object, sub))
    return None
