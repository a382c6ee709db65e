"""What the user prefers: read where it is used, so that a change holds at once. Works without a GUI."""

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/Burin"

# Millimetres of the drawing, by the index of the preference "Sheet": what fits on the page with its frame.
SHEETS = {0: (180.0, 130.0), 1: (277.0, 190.0), 2: (190.0, 277.0), 3: (400.0, 277.0), 4: (574.0, 400.0)}
HIDDEN = {0: "None", 1: "Dashed"}
STYLES = ("technical", "outline", "engraving", "haloed", "wireframe")


def group():
    return FreeCAD.ParamGet(GROUP)


def style():
    """The style of new illustrations: a built-in one, or a file where one is named."""
    return group().GetString("StyleFile", "") or STYLES[min(group().GetInt("Style", 0), len(STYLES) - 1)]


def sheet():
    """Width and height of new illustrations, in mm."""
    return SHEETS.get(group().GetInt("Sheet", 0), SHEETS[0])


def hidden():
    return HIDDEN.get(group().GetInt("HiddenLines", 0), "None")


def template():
    """The template of new pages; empty = A3 without a frame."""
    return group().GetString("Template", "")


# Pixels of a symbol that TechDraw takes for a millimetre of paper.
PIXELS_PER_MM = 3.78


def _pixels_key():
    return "PixelsPerMm-" + ".".join(FreeCAD.Version()[:3])


def pixels_per_mm():
    """Pixels of a symbol that TechDraw takes for a millimetre of paper: what was measured in this version of FreeCAD."""
    return group().GetFloat(_pixels_key(), PIXELS_PER_MM)


def set_pixels_per_mm(pixels):
    group().SetFloat(_pixels_key(), pixels)


def kernel_folder():
    """A folder that holds the module `burin`; empty = where the add-on looks by itself."""
    return group().GetString("KernelFolder", "")


def python():
    """The Python program that runs the worker; empty = the system's."""
    return group().GetString("Python", "")


def apply_to(obj):
    """New illustrations start with what the user prefers."""
    obj.Style, obj.HiddenLines = style(), hidden()
    obj.Width, obj.Height = sheet()
