"""A kept drawing: the way from paper to the model, and from lines to the edges and faces that made them."""

import json
import math

import FreeCAD


class Sheet:
    """The drawing file of an illustration. Paper: mm, origin bottom left, y up."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.data = json.load(file)
        view = self.data["view"]
        self.scale = view["scale"]
        self.offset = view["offset"]
        paper = self.data["paper"]
        self.middle = paper["width"] / 2, paper["height"] / 2
        self.center = FreeCAD.Vector(*view["center"])
        self.right, self.up = FreeCAD.Vector(*view["right"]), FreeCAD.Vector(*view["up"])
        self.direction = FreeCAD.Vector(*view["direction"])
        views = self.data.get("views", ())
        # Left, bottom, right and top of the first view, where the sheet has several; all else there has other numbers.
        self.box = [a for corner in views[0]["box"] for a in corner] if views else None

    def paths(self):
        """The paths with their layers' names, in the order of painting; where the sheet has several views those of the first, the
        one whose places in the model are known."""
        for layer in self.data["layers"]:
            for path in layer["paths"]:
                if holds(self.box, path["points"][0]):
                    yield layer["name"], path

    def texts(self):
        """The texts, of the first view as `paths`."""
        return [text for layer in self.data["layers"] for text in layer.get("texts", ()) if holds(self.box, text["at"])]

    def flat(self, point):
        """A paper point in mm of the model, from the middle of the sheet."""
        return (point[0] - self.middle[0]) / self.scale, (point[1] - self.middle[1]) / self.scale

    def place(self, point, lift=0.0):
        """The model place of a paper point on the plane through the view's centre, `lift` mm to the viewer."""
        x, y = (point[0] - self.offset[0]) / self.scale, (point[1] - self.offset[1]) / self.scale
        return self.center + self.right * x + self.up * y + self.direction * lift

    def on_paper(self, place):
        """The paper point of a place of the sheet's plane (or of what is straight before or behind it)."""
        relative = place - self.center
        return (relative.dot(self.right) * self.scale + self.offset[0],
                relative.dot(self.up) * self.scale + self.offset[1])

    def nearest(self, point, reach):
        """The visible path of a part nearest to a paper point within `reach` mm; lines of edges before strokes."""
        best, found = math.inf, None
        for _, path in self.paths():
            if not path["visible"] or path["part"] < 0:
                continue
            distance = distance_to(path, point)
            if distance > reach:
                continue
            if path["kind"] == "stroke":
                distance += reach
            if distance < best:
                best, found = distance, path
        return found

    def element(self, path, point=None):
        """Of what a path tells: the source object's path ('Assembly.Body') and its element ('Edge3', 'Face7' or '').
        Lines that run over several faces tell of the one at `point`, a paper point; without it of the longest."""
        source = next((p["source"] for p in self.data["parts"] if p["id"] == path["part"]), "")
        if path["edge"] >= 0:
            return source, f"Edge{path['edge'] + 1}"
        face = path["face"]
        if point is not None and path.get("faces"):
            at = nearest_segment(path, point)[1]
            face = [f for first, f in path["faces"] if first <= at][-1]
        return source, f"Face{face + 1}" if face >= 0 else ""

    def paths_of(self, source, element=""):
        """The paths that an object, or one of its elements, made."""
        parts = {p["id"] for p in self.data["parts"] if p["source"] == source}
        for _, path in self.paths():
            if path["part"] in parts and (not element or element in elements_of(path)):
                yield path


# mm of paper: files have rounded numbers.
NEAR = 1e-3


def holds(box, point):
    """Whether a paper point is in the box of a view; everything is where there is none."""
    return box is None or box[0] - NEAR <= point[0] <= box[2] + NEAR and box[1] - NEAR <= point[1] <= box[3] + NEAR


def elements_of(path):
    """All elements that a path tells of."""
    found = {f"Face{face + 1}" for face in [path["face"], *(f for _, f in path.get("faces", ()))] if face >= 0}
    if path["edge"] >= 0:
        found.add(f"Edge{path['edge'] + 1}")
    return found


def distance_to(path, point):
    """From a paper point to a path, in mm."""
    return nearest_segment(path, point)[0]


def nearest_segment(path, point):
    """The distance from a paper point to a path, in mm, and the number of the point that begins the segment there."""
    points = path["points"]
    if path["closed"]:
        points = points + points[:1]
    best = math.inf, 0
    x, y = point
    for k, ((ax, ay), (bx, by)) in enumerate(zip(points, points[1:])):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        t = max(0.0, min(1.0, ((x - ax) * dx + (y - ay) * dy) / square)) if square else 0.0
        best = min(best, (math.hypot(ax + t * dx - x, ay + t * dy - y), k))
    return best
