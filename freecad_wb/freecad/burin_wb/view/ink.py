"""Drawings as Coin nodes: the ink on the plane of its view, in model coordinates."""

import collections

import FreeCAD
from pivy import coin
from PySide import QtGui

from .. import kernel
from ..features.sheet import NEAR, Sheet, holds

LIT = (0.95, 0.35, 0.05)

# Pixels of a line that is a millimetre wide on paper.
DOTS_PER_MM = 2.5

# Points of a node: what the GUI's thread puts into the 3-D view in one go.
MOST_POINTS = 20_000

# Where the sheet stands in the model, by FreeCAD's vectors; as `features.sheet.Sheet` has it. box: of the first of several views,
# whose lines alone are shown.
ViewPlace = collections.namedtuple("Stand", "center right up direction scale offset box")

# Lines of one width. width: in pixels; points: (n, 3), on the plane through the view's centre; counts: points of each line.
Pen = collections.namedtuple("Pen", "width visible points counts")


# A line of text: place of its base line on the sheet; height of capitals, in mm of paper; start, middle or end.
Text = collections.namedtuple("Text", "at height anchor text turn")

# Capitals of Coin's own font, as a share of its size.
CAPITALS = 0.7


# The sheet as the kernel paints it. size: pixels; rgb: three bytes a pixel, rows from the bottom up; corners: left, bottom, right and
# top of what is shown of it, from 0 to 1.
Painted = collections.namedtuple("Painted", "size rgb corners")

# Pixels of the longer side of a painted sheet. Twice as many take the GUI's thread 0.2 s where no graphics card helps.
PIXELS = 1024

# Pixels of the screen that a drawing takes from which its lines are drawn over the painted sheet: they are wider than a
# pixel there, and the sheet is coarse.
LARGE = 2 * PIXELS * PIXELS


def read(path):
    """Stand, pens, texts and the painted sheet (None without the kernel) of a drawing file. For threads beside the GUI: the
    kernel reads without holding the interpreter, which Python's own reading of JSON does for as long as it takes. Throws OSError,
    ValueError, KeyError or the kernel's errors."""
    if not kernel.found():
        sheet = Sheet(path)
        return view_place_of(sheet), pens(sheet, [p for _, p in sheet.paths()]), _texts(sheet.texts()), None
    drawing = kernel.module().Drawing.load(path)
    view, lines = drawing.view, drawing.arrays()
    view_place = ViewPlace(*(FreeCAD.Vector(*v) for v in (view.center, view.right, view.up, view.direction)), view.scale,
                  tuple(view.offset), drawing.views[0]["box"] if drawing.views else None)
    return (view_place, _pens(view_place, *(lines[name] for name in ("first", "points", "width", "visible", "closed"))),
            _texts(t for layer in drawing.layers for t in layer.texts if holds(view_place.box, t["at"])),
            _painted(drawing, view_place.box))


def _painted(drawing, box):
    width, height = drawing.paper
    png = drawing.to_bytes("png", png_dpi=25.4 * PIXELS / max(width, height))
    image = QtGui.QImage.fromData(png).convertToFormat(QtGui.QImage.Format_RGB888).mirrored()
    w, h, row = image.width(), image.height(), image.bytesPerLine()
    bytes_ = bytes(image.constBits())
    rgb = bytes_ if row == 3 * w else b"".join(bytes_[y * row : y * row + 3 * w] for y in range(h))
    left, bottom, right, top = box or (0, 0, width, height)
    return Painted((w, h), rgb, (left / width, bottom / height, right / width, top / height))


def _texts(said):
    return [Text(tuple(t["at"]), t["height"], t["anchor"], t["text"], t.get("turn", 0)) for t in said]


def view_place_of(sheet):
    return ViewPlace(*(getattr(sheet, name) for name in ViewPlace._fields))


def pens(sheet, paths):
    """Pens of some paths of a sheet."""
    import numpy

    def joined(name):
        return [number for path in paths for number in path[name]]

    counts = [len(path["points"]) for path in paths]
    # A line of one width may tell it once.
    widths = [w for path, count in zip(paths, counts)
              for w in (path["width"] if len(path["width"]) == count else [_mean(path["width"])] * count)]
    return _pens(view_place_of(sheet), numpy.concatenate(([0], numpy.cumsum(counts, dtype=int))), numpy.array(joined("points")),
                 numpy.array(widths), numpy.array([path["visible"] for path in paths]),
                 numpy.array([path["closed"] for path in paths]))


def _mean(numbers):
    return sum(numbers) / len(numbers) if numbers else 0.1


def _pens(view_place, first, points, width, visible, closed):
    """`first`: numbers of the first points of the paths, and that of all points."""
    import numpy

    first, visible, closed = first.astype(int), visible.astype(bool), closed.astype(bool)
    count = numpy.diff(first)
    if not len(count):
        return []
    wide = numpy.maximum(1, numpy.rint(numpy.add.reduceat(width, first[:-1]) / count * DOTS_PER_MM)).astype(int)
    places_ = places(view_place, points).astype(numpy.float32)
    found = []
    shown = holds_all(view_place.box, numpy.asarray(points, dtype=float).reshape(-1, 2)[first[:-1]])
    for kind in numpy.unique((2 * wide + visible)[shown]):
        chosen = numpy.flatnonzero(shown & (2 * wide + visible == kind))
        total = count[chosen] + closed[chosen]
        for some in numpy.split(chosen, numpy.flatnonzero(numpy.diff(numpy.cumsum(total) // MOST_POINTS)) + 1):
            total = count[some] + closed[some]
            ends = numpy.cumsum(total)
            at = numpy.arange(ends[-1]) + numpy.repeat(first[some] - (ends - total), total)
            at[ends[closed[some]] - 1] = first[some][closed[some]]  # a closed line ends where it began
            found.append(Pen(int(kind) // 2, bool(kind % 2), places_[at], total.tolist()))
    return found


def holds_all(box, points):
    """As features.sheet.holds, of many points at once."""
    import numpy

    if box is None:
        return numpy.ones(len(points), dtype=bool)
    return ((points >= numpy.array(box[:2]) - NEAR) & (points <= numpy.array(box[2:]) + NEAR)).all(axis=1)


def lines_node(pen, extra=0.0):
    """The lines of a pen. `extra`: pixels more."""
    part = coin.SoSeparator()
    style = coin.SoDrawStyle()
    style.lineWidth = pen.width + extra
    if not pen.visible:
        style.linePattern = 0x0F0F
    part.addChild(style)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(pen.points), pen.points)
    lines = coin.SoLineSet()
    lines.numVertices.setValues(0, len(pen.counts), pen.counts)
    part.addChild(coordinates)
    part.addChild(lines)
    return part


def when_large(node):
    """A node only while it is seen large."""
    level = coin.SoLevelOfDetail()
    level.screenArea.setValues(0, 1, [LARGE])
    level.addChild(node)
    level.addChild(coin.SoSeparator())
    return level


def texts_node(view_place, texts):
    """Texts on the sheet, as Coin writes them."""
    root = coin.SoSeparator()
    turn = FreeCAD.Rotation(view_place.right, view_place.up, view_place.direction, "ZXY")
    sides = {"start": coin.SoAsciiText.LEFT, "middle": coin.SoAsciiText.CENTER, "end": coin.SoAsciiText.RIGHT}
    for text, at in zip(texts, places(view_place, [t.at for t in texts])):
        one, pose, font, letters = coin.SoSeparator(), coin.SoTransform(), coin.SoFont(), coin.SoAsciiText()
        pose.translation, pose.rotation = tuple(float(x) for x in at), (turn * FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), text.turn)).Q
        font.name, font.size = "sans", text.height / CAPITALS / view_place.scale
        letters.string, letters.justification = text.text, sides[text.anchor]
        for node in (pose, font, letters):
            one.addChild(node)
        root.addChild(one)
    return root


def colored(color):
    """What comes before lines and sheets: a colour that no light changes."""
    root = coin.SoGroup()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    root.addChild(light)
    base = coin.SoBaseColor()
    base.rgb = color
    root.addChild(base)
    return root


def lifted(view_place, lift):
    """Moves what follows from the plane through the view's centre, `lift` mm of the model to the viewer."""
    move = coin.SoTranslation()
    move.translation = tuple(view_place.direction * lift)
    return move


def places(view_place, points):
    """As Sheet.place, of many points at once: (n, 3)."""
    import numpy

    flat = (numpy.asarray(points, dtype=float).reshape(-1, 2) - view_place.offset[:2]) / view_place.scale
    frame = numpy.array([tuple(view_place.right), tuple(view_place.up)])
    return flat @ frame + tuple(view_place.center)


def paper_node(view_place, size, painted=None):
    """A sheet, seen from both sides, a hair behind the ink; of several views the place of the first. White, or with the
    drawing on it: lines that are thinner than a pixel have their tone there."""
    left, bottom, right, top = view_place.box or (0, 0, *size)
    root = coin.SoSeparator()
    root.addChild(colored((1, 1, 1)))
    root.addChild(lifted(view_place, -0.1 / view_place.scale))
    if painted is not None:
        root.addChild(_texture(painted))
        left_, bottom_, right_, top_ = painted.corners
        corners = coin.SoTextureCoordinate2()
        corners.point.setValues(0, 4, [(left_, bottom_), (right_, bottom_), (right_, top_), (left_, top_)])
        root.addChild(corners)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, 4, places(view_place, [(left, bottom), (right, bottom), (right, top), (left, top)]))
    face = coin.SoFaceSet()
    face.numVertices.setValues(0, 1, [4])
    root.addChild(coordinates)
    root.addChild(face)
    return root


def _texture(painted):
    group = coin.SoGroup()
    quality = coin.SoComplexity()
    quality.textureQuality = 1.0  # smaller copies of it, so that lines do not flicker far away
    texture = coin.SoTexture2()
    texture.image.setValue(coin.SbVec2s(*painted.size), 3, painted.rgb)
    texture.wrapS = texture.wrapT = coin.SoTexture2.CLAMP
    group.addChild(quality)
    group.addChild(texture)
    return group
