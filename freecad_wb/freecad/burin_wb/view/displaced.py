"""Objects that the 3-D view shows elsewhere than they are: nodes before their own, no placement of the document is touched."""

import FreeCAD
from pivy import coin

from ..features.chosen import numbers_of_path

NEAR = 1e-6  # mm


class Displaced:
    """Of one illustration's parts, until `restore`."""

    def __init__(self, document):
        self._document = document
        self._nodes = {}  # path -> (node of the view that shows it, translation in that)

    def show(self, sources, moves):
        """Each part, by its path, as far from its place as its vector says, in mm. Objects in an assembly that several links show
        have one node for all of them: they move where it is the same way for all, in the assembly's axes."""
        wanted = dict(_heads(sources, moves))
        for path in [path for path in self._nodes if path not in wanted]:
            self._take(path)
        taken = []  # nodes and how they move
        for path, move in wanted.items():
            shown = _shown(self._document, path)
            if shown is None:
                continue
            local = _local(self._document, path, move)
            others = [other for node, other in taken if node == shown]
            if others:
                if (others[0] - local).Length > NEAR:
                    self._take_node(shown)
                continue
            taken.append((shown, local))
            self._translation(path, shown).translation = tuple(local)

    def restore(self):
        for path in list(self._nodes):
            self._take(path)

    def moves(self):
        """What is shown elsewhere, by its path, in the axes that it stands in."""
        return {path: FreeCAD.Vector(*node.translation.getValue().getValue()) for path, (_, node) in self._nodes.items()}

    def _translation(self, path, shown):
        """Links make their nodes anew at times: then another one is put in."""
        if path in self._nodes and (self._nodes[path][0] != shown or shown.findChild(self._nodes[path][1]) < 0):
            self._take(path)
        if path not in self._nodes:
            node = coin.SoTranslation()
            shown.insertChild(node, 0)
            self._nodes[path] = shown, node
        return self._nodes[path][1]

    def _take_node(self, shown):
        for path in [path for path, (node, _) in self._nodes.items() if node == shown]:
            self._take(path)

    def _take(self, path):
        shown, node = self._nodes.pop(path)
        if shown.findChild(node) >= 0:
            shown.removeChild(node)


def _heads(sources, moves):
    """The outermost paths below which everything moves alike, and how."""
    for k, source in enumerate(sources):
        names = source.split(".")
        for depth in range(1, len(names) + 1):
            path = ".".join(names[:depth])
            if all((moves[other] - moves[k]).Length < NEAR for other in numbers_of_path(path, sources)):
                if moves[k].Length > 0:
                    yield path, moves[k]
                break


def _shown(document, path):
    """The node that shows what is at a path; nothing where it is not shown."""
    top, _, sub = path.partition(".")
    view = getattr(document.getObject(top), "ViewObject", None)
    if view is None or not sub:
        return getattr(view, "RootNode", None)
    way = coin.SoPath(20)
    way.ref()
    way.append(view.RootNode)
    view.getDetailPath(sub + ".", way, False)
    for k in range(way.getLength() - 1, 0, -1):
        node = way.getNode(k)
        if node.isOfType(coin.SoSeparator.getClassTypeId()) and node != view.RootNode:
            return node
    return None


def _local(document, path, move):
    """A vector of the model in the axes that an object stands in."""
    top, _, sub = path.partition(".")
    if not sub:
        return move
    above, _, _ = sub.rpartition(".")
    matrix = document.getObject(top).getSubObject(above + "." if above else "", retType=4)
    return FreeCAD.Placement(matrix).Rotation.inverted().multVec(move)
