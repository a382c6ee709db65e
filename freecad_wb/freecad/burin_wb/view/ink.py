"""Drawings as Coin nodes: the ink on the plane of its view, in model coordinates."""

def width_of(path):
    widths = path["width"]
    return sum(widths) / len(widths) if widths else 0.1


def ink_node(sheet, lift=0.0, dots_per_mm=4.0):
    """A Coin node with all visible lines; one line set a width class."""
    from pivy import coin

    groups = {}
    for _, path in sheet.paths():
        style = max(1, round(width_of(path) * dots_per_mm)), path["visible"]
        groups.setdefault(style, []).append(path)
    root = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    root.addChild(light)
    color = coin.SoBaseColor()
    color.rgb = (0, 0, 0)
    root.addChild(color)
    for (pixels, visible), paths in sorted(groups.items()):
        part = coin.SoSeparator()
        style = coin.SoDrawStyle()
        style.lineWidth = pixels
        if not visible:
            style.linePattern = 0x0F0F
        part.addChild(style)
        points, counts = [], []
        for path in paths:
            run = path["points"] + (path["points"][:1] if path["closed"] else [])
            points.extend(tuple(sheet.place(p, lift)) for p in run)
            counts.append(len(run))
        coordinates = coin.SoCoordinate3()
        coordinates.point.setValues(0, len(points), points)
        lines = coin.SoLineSet()
        lines.numVertices.setValues(0, len(counts), counts)
        part.addChild(coordinates)
        part.addChild(lines)
        root.addChild(part)
    return root
