"""How many pixels of a symbol TechDraw takes for a millimetre of paper: measured on a page that is shown. FreeCAD 0.20
takes 3.78, and 10 from 1.1 on; where another version takes others, illustrations on pages are made anew with what was measured."""

import re

import FreeCAD
import FreeCADGui as Gui
from PySide import QtGui

from .. import preferences
from ..features.sheet_view import SheetView
from ..tell import tell
from ..text import tr

# A millimetre in ten metres.
EXACT = 1e-4


def check(page):
    """Compares symbols of a shown page with the size that they should have. What is off is made anew, and told."""
    measured = measure(page)
    if measured is None or abs(measured / preferences.pixels_per_mm() - 1) < EXACT:
        return
    preferences.set_pixels_per_mm(measured)
    for document in FreeCAD.listDocuments().values():
        for view in document.Objects:
            if isinstance(getattr(view, "Proxy", None), SheetView):
                view.touch()
                view.recompute()
    tell(
        tr("This FreeCAD takes {0} pixels of a symbol for a millimetre; illustrations on pages were made anew for it").format(
            f"{measured:.4f}"))


def measure(page):
    """Pixels a millimetre, from the symbols of a page that is shown; nothing where there is none."""
    symbols = [s for s in map(_Symbol, page.Views) if s.is_plain]
    if not symbols:
        return None
    for area in Gui.getMainWindow().findChildren(QtGui.QGraphicsView):
        if not area.metaObject().className().endswith("::QGVPage"):
            continue
        for item in area.items():
            box = item.boundingRect()
            for symbol in symbols:
                if (box.x(), box.y(), box.width(), box.height()) == (0, 0, *symbol.pixels):
                    found = symbol.pixels_per_mm(item)
                    if found is not None:
                        return found
    return None


class _Symbol:
    """A view with a symbol: its size in pixels and where it should be, in mm from the page's bottom left."""

    def __init__(self, view):
        size = re.search(r'width="(\d+)" height="(\d+)"', getattr(view, "Symbol", "")[:2000])
        self.is_plain = size is not None and isinstance(view.Proxy, SheetView) and view.Rotation.Value == 0
        if self.is_plain:
            self.pixels = int(size.group(1)), int(size.group(2))
            self.place = view.X.Value, view.Y.Value
            self.scale = view.Scale

    def pixels_per_mm(self, item):
        """From the item that shows it in the scene, whose units are some part of a mm, y down; nothing where the item
        shows something else."""
        middle = item.sceneBoundingRect().center()
        x, y = self.place
        units = middle.x() / x if abs(x) > abs(y) else -middle.y() / y if y else 0.0  # of the scene in a mm
        if units <= 0 or abs(middle.x() - units * x) + abs(middle.y() + units * y) > 0.01 * units:
            return None
        return units * self.scale / item.sceneTransform().m11()
