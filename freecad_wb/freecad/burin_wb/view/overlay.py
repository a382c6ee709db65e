"""What panels show in the 3-D view beside the objects of the document."""

import FreeCADGui as Gui
from pivy import coin


class Overlay:
    """A node of its own in the first 3-D view of a document, until `remove`."""

    def __init__(self, document):
        self.root = coin.SoSeparator()
        view = next(iter(Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")), None)
        # The graph is held, not the view: who asks a closed view for it ends FreeCAD.
        self._graph = view.getSceneGraph() if view is not None else None
        if self._graph is not None:
            self._graph.addChild(self.root)

    def remove(self):
        graph, self._graph = self._graph, None
        self.root.removeAllChildren()
        if graph is not None and graph.findChild(self.root) >= 0:
            graph.removeChild(self.root)
