"""Drawings as Coin nodes: the ink on the plane of its view, in model coordinates."""

import json

import FreeCAD


class Sheet:
    """A kept drawing with the way from paper to model space."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.data = json.load(file)
        view = self.data["view"]
        self.scale = view["scale"]
        self.offset = view["offset"]
        self.center = FreeCAD.Vector(*view["center"])
        self.right, self.up = FreeCAD.Vector(*view["right"]), FreeCAD.Vector(*view["up"])
        self.direction = FreeCAD.Vector(*view["direction"])

    def paths(self):
        """All paths with their layers' names, in the order of painting."""
        for layer in self.data["layers"]:
            for path in layer["paths"]:
                yield layer["name"], path

    def place(self, point, lift=0.0):
        """The model place of a paper point on the plane through the view's centre, `lift` mm to the viewer."""
        x, y = (point[0] - self.offset[0]) / self.scale, (point[1] - self.offset[1]) / self.scale
        return self.center + self.right * x + self.up * y + self.direction * lift

    def on_paper(self, place):
        """The paper point of a place in the model (orthographic onto the plane)."""
        relative = place - self.center
        return (relative.dot(self.right) * self.scale + self.offset[0],
                relative.dot(self.up) * self.scale + self.offset[1])


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
