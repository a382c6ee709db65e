"""Drawings as Coin nodes: the ink on the plane of its view, in model coordinates."""

from pivy import coin

LIT = (0.95, 0.35, 0.05)


def width_of(path):
    widths = path["width"]
    return sum(widths) / len(widths) if widths else 0.1


def ink_node(sheet, paths, lift, color, extra=0.0, dots_per_mm=2.5):
    """A Coin node with some paths; one line set a width class. `lift`: model mm to the viewer; `extra`: pixels more."""
    groups = {}
    for path in paths:
        style = max(1, round(width_of(path) * dots_per_mm) + extra), path["visible"]
        groups.setdefault(style, []).append(path)
    root = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    root.addChild(light)
    base = coin.SoBaseColor()
    base.rgb = color
    root.addChild(base)
    for (pixels, visible), some in sorted(groups.items()):
        root.addChild(_lines(sheet, some, lift, pixels, visible))
    return root


def _lines(sheet, paths, lift, pixels, visible):
    part = coin.SoSeparator()
    style = coin.SoDrawStyle()
    style.lineWidth = pixels
    if not visible:
        style.linePattern = 0x0F0F
    part.addChild(style)
    flat, counts = [], []
    for path in paths:
        run = path["points"] + (path["points"][:1] if path["closed"] else [])
        flat.extend(run)
        counts.append(len(run))
    coordinates = coin.SoCoordinate3()
    points = places(sheet, flat, lift)
    coordinates.point.setValues(0, len(points), points)
    lines = coin.SoLineSet()
    lines.numVertices.setValues(0, len(counts), counts)
    part.addChild(coordinates)
    part.addChild(lines)
    return part


def places(sheet, points, lift):
    """As Sheet.place, of many points at once: (n, 3)."""
    import numpy

    flat = (numpy.asarray(points, dtype=float).reshape(-1, 2) - sheet.offset[:2]) / sheet.scale
    frame = numpy.array([tuple(sheet.right), tuple(sheet.up)])
    return flat @ frame + tuple(sheet.center + sheet.direction * lift)


def paper_node(sheet, size, lift):
    """A white sheet, seen from both sides."""
    width, height = size
    corners = places(sheet, [(0, 0), (width, 0), (width, height), (0, height)], lift)
    root = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    root.addChild(light)
    base = coin.SoBaseColor()
    base.rgb = (1, 1, 1)
    root.addChild(base)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, 4, corners)
    face = coin.SoFaceSet()
    face.numVertices.setValues(0, 1, [4])
    root.addChild(coordinates)
    root.addChild(face)
    return root
