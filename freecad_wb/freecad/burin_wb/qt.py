"""What PySide2 (Qt 5) and PySide6 (Qt 6) do not have alike. Everything else is imported from FreeCAD's neutral `PySide`."""


def number(flags):
    """Flags or an enumerator as a number: PySide2 makes them of int, PySide6 of Python's enum, which int() refuses."""
    return int(getattr(flags, "value", flags))
