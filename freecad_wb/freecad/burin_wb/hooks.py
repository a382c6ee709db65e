"""What lower layers ask of higher ones without naming them: the GUI puts its functions here (init_gui.py). FreeCAD loads
this at every start: nothing else is imported."""


def _nothing(obj):
    """There is no GUI."""


# Called with an illustration, or a dimension or note of one, that was made or came from a file: gives it its view provider, and takes runs out
# of the GUI's way.
dress = _nothing

# Called with an illustration, or a dimension or note of one, that is double-clicked: opens its panel.
edit = _nothing
