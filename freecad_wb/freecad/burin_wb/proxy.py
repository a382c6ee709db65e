"""What FreeCAD asks of the Python objects behind the objects of a document."""


class Stateless:
    """A Proxy that documents keep nothing of but the name of its class: what it knows is in properties. FreeCAD 0.20 asks in other words."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps
    __setstate__ = loads
