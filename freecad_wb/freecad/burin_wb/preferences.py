"""What the user prefers: read where it is used, so that a change holds at once. Works without a GUI."""

import FreeCAD

from . import offers

GROUP = "User parameter:BaseApp/Preferences/Mod/Burin"

# Width and height in mm of the drawing where no sheet is chosen, and what else the frame of a page takes of its sides.
SMALL, FRAME = (180.0, 130.0), 20.0


def group():
    return FreeCAD.ParamGet(GROUP)


def style():
    """The style of new illustrations: a built-in one, or a file where one is named; empty = that of illustrations."""
    return group().GetString("StyleFile", "") or group().GetString("StyleName", "")


def sheets():
    """Names of sheets that fit on a page of that paper, with width and height in mm; with a trailing p portrait."""
    found = {"": SMALL}
    for paper, (width, height) in offers.kept()["papers"].items():
        found[paper] = width - FRAME, height - FRAME
        found[paper + "p"] = height - FRAME, width - FRAME
    return found


def sheet():
    """Width and height of new illustrations, in mm."""
    return sheets().get(group().GetString("SheetName", ""), SMALL)


def hidden():
    """How new illustrations draw hidden lines; empty = as illustrations do."""
    return group().GetString("Hidden", "")


def template():
    """The template of new pages; empty = the smallest A4 to A0 without a frame that holds the drawing."""
    return group().GetString("Template", "")


# Pixels of a symbol that TechDraw takes for a millimetre of paper; in FreeCAD 1.1 a pixel is a unit of its page.
PIXELS_PER_MM = 3.78 if [int(n) for n in FreeCAD.Version()[:2]] < [1, 1] else 10.0


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
    obj.Width, obj.Height = sheet()
    if style():
        obj.Style = style()
    if hidden() in obj.getEnumerationsOfProperty("HiddenLines"):
        obj.HiddenLines = hidden()
