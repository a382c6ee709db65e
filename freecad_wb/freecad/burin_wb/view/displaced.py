"""Objects that the 3-D view shows elsewhere than they are: nodes before their own, no placement of the document is touched."""

import FreeCAD
from pivy import coin

from ..features.chosen import numbers_of_path


class Displaced:
    """Of one illustration's parts, until `restore`."""

    def __init__(self, document):
        self._document = document
        self._nodes = {}  # path -> (root of the view provider, translation in it)

    def show(self, sources, moves):
        """Each part, by its path, as far from its place as its vector says, in mm. What links show of objects in an assembly moves
        with the link alone: inside it the 3-D view has no nodes of its own."""
        wanted = dict(_heads(self._document, sources, moves))
        for path in [path for path in self._nodes if path not in wanted]:
            self._take(path)
        for path, move in wanted.items():
            node = self._node(path)
            if node is not None:
                node.translation = tuple(_local(self._document, path, move))

    def restore(self):
        for path in list(self._nodes):
            self._take(path)

    def moves(self):
        """What is shown elsewhere, by its path."""
        return {path: FreeCAD.Vector(*node.translation.getValue().getValue()) for path, (_, node) in self._nodes.items()}

    def _node(self, path):
        if path not in self._nodes:
            obj = _object(self._document, path)
            root = getattr(getattr(obj, "ViewObject", None), "RootNode", None)
            if root is None:
                return None
            node = coin.SoTranslation()
            root.insertChild(node, 0)
            self._nodes[path] = root, node
        return self._nodes[path][1]

    def _take(self, path):
        root, node = self._nodes.pop(path)
        try:
            if root.findChild(node) >= 0:
                root.removeChild(node)
        except (ReferenceError, RuntimeError):  # the object is gone
            pass


def _heads(document, sources, moves):
    """The outermost paths below which everything moves alike, and how; none inside links, which share what they show."""
    for k, source in enumerate(sources):
        names = source.split(".")
        for depth in range(1, len(names) + 1):
            path = ".".join(names[:depth])
            alike = all((moves[other] - moves[k]).Length < 1e-9 for other in numbers_of_path(path, sources))
            if alike:
                if moves[k].Length > 0:
                    yield path, moves[k]
                break
            if _is_link(document, path):
                break


def _object(document, path):
    top, _, sub = path.partition(".")
    top = document.getObject(top)
    return top.getSubObject(sub + ".", retType=1) if top is not None and sub else top


def _is_link(document, path):
    obj = _object(document, path)
    return obj is None or obj.getLinkedObject(True) is not obj


def _local(document, path, move):
    """A vector of the model in the axes that an object stands in."""
    top, _, sub = path.partition(".")
    if not sub:
        return move
    above, _, _ = sub.rpartition(".")
    matrix = document.getObject(top).getSubObject(above + "." if above else "", retType=4)
    return FreeCAD.Placement(matrix).Rotation.inverted().multVec(move)
