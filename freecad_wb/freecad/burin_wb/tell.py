"""Messages to the user: a line in the report view and, where there is a window, in its status bar."""

import FreeCAD

NOTE, WARNING, ERROR = "PrintMessage", "PrintWarning", "PrintError"

# Milliseconds that a line stays in the status bar.
STAY = 10000


def tell(text, level=WARNING):
    """From FreeCAD's own thread alone."""
    getattr(FreeCAD.Console, level)(text + "\n")
    if FreeCAD.GuiUp:
        import FreeCADGui as Gui

        window = Gui.getMainWindow()
        if window is not None:
            window.statusBar().showMessage(text, STAY)
