"""Where there is room on a TechDraw page: beside what lies there, inside the template's frame, off its title block."""

import collections
import math
import re

from .. import preferences

# mm that things lie apart, tried in turn.
DISTANCES = (5.0, 2.0, 0.0)

# mm that stay free along the edge of a page.
EDGE = 5

# x, y: of a middle, in mm from the page's bottom left; free: whether nothing else lies there.
Place = collections.namedtuple("Place", "x y free")


def free_place(page, width, height, but=None):
    """The place nearest to the middle of the page's drawing area for something of `width` x `height` mm. `but`: a view
    that is not in the way. Cells of 1 mm."""
    import numpy

    room = _largest(_without_edge(_blank_cells(page.Template)))
    rows, columns = numpy.nonzero(room)
    if not len(rows):
        return Place(room.shape[1] / 2, room.shape[0] / 2, False)
    middle = (columns.min() + columns.max() + 1) / 2, (rows.min() + rows.max() + 1) / 2
    for view in page.Views:
        if view is not but and view.Name != getattr(but, "Name", ""):
            _cover(room, view)
    for distance in DISTANCES:
        found = _nearest(room, middle, width + 2 * distance, height + 2 * distance)
        if found is not None:
            return Place(found[0], room.shape[0] - found[1], True)
    return Place(middle[0], room.shape[0] - middle[1], False)


def _nearest(room, middle, width, height):
    """The middle of the free window of this size that is nearest to a place; nothing where there is none."""
    import numpy

    w, h = math.ceil(width - 1e-6), math.ceil(height - 1e-6)
    if h > room.shape[0] or w > room.shape[1]:
        return None
    sums = numpy.zeros((room.shape[0] + 1, room.shape[1] + 1), dtype=numpy.int64)
    sums[1:, 1:] = (~room).cumsum(0).cumsum(1)
    taken = sums[h:, w:] - sums[:-h, w:] - sums[h:, :-w] + sums[:-h, :-w]
    y, x = numpy.nonzero(taken == 0)
    if not len(x):
        return None
    x, y = x + w / 2, y + h / 2
    away = (x - middle[0]) ** 2 + (y - middle[1]) ** 2
    nearest = numpy.flatnonzero(away < away.min() + 1e-3)
    x, y = x[nearest], y[nearest]
    # Of places that are as near, the one to the right, then the one below.
    best = numpy.lexsort((-y, -x))[0]
    return float(x[best]), float(y[best])


def _cover(room, view):
    """Takes the cells under a view out of the free space."""
    size = extent(view)
    if size is None or not hasattr(view, "X"):
        return
    x, y = view.X.Value, room.shape[0] - view.Y.Value
    left, right = (min(max(round(x + s * size[0] / 2), 0), room.shape[1]) for s in (-1, 1))
    top, bottom = (min(max(round(y + s * size[1] / 2), 0), room.shape[0]) for s in (-1, 1))
    room[top:bottom, left:right] = False


# --- views ----------------------------------------------------------------------------------------


def extent(view):
    """Width and height of a view on its page, in mm; nothing where that is not known or it has no place of its own, as
    dimensions have none."""
    size = _own_extent(view)
    if size is None:
        return None
    turn = math.radians(view.Rotation.Value) if hasattr(view, "Rotation") else 0.0
    c, s = abs(math.cos(turn)), abs(math.sin(turn))
    return size[0] * c + size[1] * s, size[0] * s + size[1] * c


def _own_extent(view):
    if view.isDerivedFrom("TechDraw::DrawViewSpreadsheet"):
        return _spreadsheet_extent(view)
    if view.isDerivedFrom("TechDraw::DrawViewSymbol"):
        return _symbol_extent(view)
    if view.isDerivedFrom("TechDraw::DrawProjGroup"):
        return _group_extent(view)
    if view.isDerivedFrom("TechDraw::DrawViewPart"):
        boxes = [e.BoundBox for e in view.getVisibleEdges()]
        if not boxes:
            return None
        return (max(b.XMax for b in boxes) - min(b.XMin for b in boxes),
                max(b.YMax for b in boxes) - min(b.YMin for b in boxes))
    if view.isDerivedFrom("TechDraw::DrawViewAnnotation"):
        size = view.TextSize.Value
        return 0.6 * size * max(map(len, view.Text), default=0), 1.4 * size * len(view.Text)
    if hasattr(view, "Width") and hasattr(view, "Height"):  # pictures, clips
        return view.Width.Value, view.Height.Value
    return None


def _spreadsheet_extent(view):
    """Its symbol says no size; it has a rectangle a cell, in pixels."""
    cells = re.findall(r'<rect x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)" height="([0-9.]+)"', view.Symbol)
    if not cells:
        return None
    x, y, width, height = zip(*([float(n) for n in cell] for cell in cells))
    return tuple(max(a + b for a, b in zip(at, size)) * view.Scale / preferences.pixels_per_mm() for at, size in ((x, width), (y, height)))


def _symbol_extent(view):
    found = [re.search(rf'<svg[^>]*?\s{name}="([0-9.]+)(mm|px)?"', view.Symbol[:4000]) for name in ("width", "height")]
    if None in found:
        return None
    is_drawn = view.isDerivedFrom("TechDraw::DrawViewArch") or view.isDerivedFrom("TechDraw::DrawViewDraft")
    pixels = 1.0 if is_drawn else preferences.pixels_per_mm()
    return tuple(float(f.group(1)) * view.Scale / (1.0 if f.group(2) == "mm" else pixels) for f in found)


def _group_extent(group):
    """Twice the farthest reach from the group's place: its views need not lie around it evenly."""
    reach = [0.0, 0.0]
    for view in group.Views:
        size = extent(view)
        if size is not None:
            reach = [max(r, abs(at.Value) + s / 2) for r, at, s in zip(reach, (view.X, view.Y), size)]
    return 2 * reach[0], 2 * reach[1]


# --- the template ---------------------------------------------------------------------------------


def _without_edge(cells):
    cells[:EDGE] = cells[-EDGE:] = False
    cells[:, :EDGE] = cells[:, -EDGE:] = False
    return cells


def _blank_cells(template):
    """Cells of a page, from its top left, in which its template has no ink."""
    import numpy

    width, height = round(template.Width.Value), round(template.Height.Value)
    blank = numpy.ones((height, width), dtype=bool)
    try:
        with open(template.PageResult, encoding="utf-8") as file:
            text = file.read()
    except (AttributeError, OSError, UnicodeDecodeError):  # a template without a picture
        return blank
    from PySide import QtCore, QtGui, QtSvg

    renderer = QtSvg.QSvgRenderer(QtCore.QByteArray(_TEXT.sub(_as_box, text).encode()))
    if not renderer.isValid():
        return blank
    image = QtGui.QImage(width, height, QtGui.QImage.Format_Grayscale8)
    image.fill(QtCore.Qt.white)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    renderer.render(painter)
    painter.end()
    data = numpy.frombuffer(image.constBits(), numpy.uint8, image.bytesPerLine() * height)
    return data.reshape(height, image.bytesPerLine())[:, :width] > 250


# Texts are taken for boxes: without a window there are no fonts.
_TEXT = re.compile(r"<text\b([^>]*)>(.*?)</text>", re.DOTALL)


def _as_box(match):
    tag, inside = match.groups()
    said = re.sub(r"<[^>]*>|\s+", " ", inside).strip()

    def get(name, default):
        found = re.search(rf'\b{name}\s*[=:]\s*"?\s*([-0-9.]+)', tag) or re.search(rf'\b{name}\s*[=:]\s*"?\s*([-0-9.]+)', inside)
        return float(found.group(1)) if found else default

    size = get("font-size", 3.0)
    width = 0.6 * size * len(said)
    shift = {"middle": 0.5, "end": 1.0}.get((re.search(r"text-anchor\s*[=:]\s*\"?(\w+)", match.group(0)) or [0, ""])[1], 0.0)
    transform = re.search(r'transform="[^"]*"', tag)
    return (f'<rect x="{get("x", 0.0) - shift * width}" y="{get("y", 0.0) - size}" width="{width}" height="{size}" '
            f'{transform.group(0) if transform else ""}/>')


def _largest(cells):
    """The largest part of the cells that hang together: not the margin outside a frame, nor the fields of a title block."""
    import numpy

    parent, sizes, rows, before = [], [], [], []

    def root(k):
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    for row in cells:
        steps = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], row.view(numpy.int8), [0]))))
        here = []
        for first, last in zip(steps[0::2].tolist(), steps[1::2].tolist()):
            number = len(parent)
            parent.append(number)
            sizes.append(last - first)
            here.append((first, last, number))
            for other_first, other_last, other in before:
                if other_first < last and first < other_last:
                    a, b = root(other), root(number)
                    if a != b:
                        parent[b] = a
                        sizes[a] += sizes[b]
        rows.append(here)
        before = here
    largest = max(range(len(parent)), key=lambda k: sizes[k] if parent[k] == k else -1, default=None)
    out = numpy.zeros_like(cells)
    for y, here in enumerate(rows):
        for first, last, number in here:
            if root(number) == largest:
                out[y, first:last] = True
    return out
