"""Properties as tables: one row a property, so that creation, migration and documentation agree."""

from collections import namedtuple

from ..offers import kept

_OPTIONS = kept()["options"]

# kind: the App::Property type; value: the default, for enumerations the list (first = default).
Row = namedtuple("Row", "name kind group value text")

SCHEMA = 1

ILLUSTRATION = (
    Row("Sources", "App::PropertyLinkSubListGlobal", "Source", None,
        "What is drawn: objects, links, assemblies; sub-names choose objects in an assembly"),
    Row("Looks", "App::PropertyMap", "Source", {},
        "Object name to words: 'not drawn', 'not hatched', 'transparent', 'style=FILE or name'; ';' between"),
    Row("ViewDirection", "App::PropertyVector", "View", (1, -1, 1),
        "From the model to the viewer"),
    Row("ViewUp", "App::PropertyVector", "View", (0, 0, 1), "Up on the sheet"),
    Row("Projection", "App::PropertyEnumeration", "View", ["Orthographic", "Perspective"],
        "Parallel, or with vanishing points"),
    Row("FieldOfView", "App::PropertyAngle", "View", 35.0,
        "Perspective: vertical field of view ({low:g} to {high:g} degrees)".format(**_OPTIONS["perspective"])),
    Row("Views", "App::PropertyStringList", "View", [],
        "Several views on the sheet: front, top, left, iso ... or x,y,z; empty: the one of ViewDirection"),
    Row("ProjectionMethod", "App::PropertyEnumeration", "View", ["First angle", "Third angle"],
        "Where the view from the left goes: to the right of the front view, or to its left"),
    Row("Width", "App::PropertyLength", "Sheet", 180.0, "Width of the drawing on paper"),
    Row("Height", "App::PropertyLength", "Sheet", 130.0, "Height of the drawing on paper"),
    Row("Margin", "App::PropertyLength", "Sheet", 2.0, "Kept free on each side"),
    Row("FitScale", "App::PropertyBool", "Sheet", True,
        "Scale so that the drawing fills the sheet; otherwise Scale holds"),
    Row("Scale", "App::PropertyFloat", "Sheet", 1.0, "Millimetres of paper for a millimetre of the model"),
    Row("Style", "App::PropertyString", "Style", _OPTIONS["style"]["default"], "A built-in style, or the path of a style file"),
    Row("StyleKeys", "App::PropertyMap", "Style", {}, "Keys of the style that differ, such as line.outer = 0.5"),
    Row("Light", "App::PropertyVector", "Style", (-0.5, 0.65, 0.6),
        "From the model to the light: right, up, to the viewer"),
    Row("HiddenLines", "App::PropertyEnumeration", "Style", [word.capitalize() for word in _OPTIONS["hidden"]["words"]],
        "Hidden feature lines: left out or dashed"),
    Row("CentreLines", "App::PropertyBool", "Style", False, "Axes of round faces, and marks where they are seen along their axis"),
    Row("Seed", "App::PropertyInteger", "Style", 1, "Seed of all that is left to chance"),
    Row("Tolerance", "App::PropertyLength", "Style", 0.0,
        "Chord tolerance in the model; 0 = chosen from the sheet"),
    Row("Sections", "App::PropertyStringList", "Section", [],
        "Planes that cut parts open: 'y', '-z=12', or as illustration files have them, {\"plane\": ..., \"exclude\": [object names], \"view\": true}"),
    Row("Explode", "App::PropertyBool", "Explosion", False, "Takes the assembly apart in the drawing; the model stays as it is"),
    Row("ExplodeSteps", "App::PropertyStringList", "Explosion", [],
        "In order: {\"move\": [object names], \"along\": [x, y, z], \"by\": mm, \"trail\": true}; without any they are found"),
    Row("ExplodeAlong", "App::PropertyString", "Explosion", "",
        "Where steps are found: one axis alone (x, y, z, -z ...); empty: all ways"),
    Row("ExplodeFactor", "App::PropertyFloat", "Explosion", 1.0, "How far parts have come on their ways: 0 together, 1 apart"),
    Row("Details", "App::PropertyStringList", "Details", [],
        "Places that are drawn again, larger: {\"select\": [object names]} or {\"at\": [x, y, z], \"radius\": mm}, with \"scale\", \"letter\""),
    Row("Dimensions", "App::PropertyLinkListGlobal", "Dimensions", [], "Objects that say what is measured or noted, in the order of the tree"),
    Row("Callouts", "App::PropertyBool", "Items", False, "A number with a leader at each item"),
    Row("PartsList", "App::PropertyBool", "Items", False, "A list of the items above the lower right corner"),
    Row("Legend", "App::PropertyBool", "Items", False, "The colours of parts with their names; in which corner: the style key callout.legend"),
    Row("ItemNumbers", "App::PropertyMap", "Items", {}, "Numbers and the names of what has them; kept whatever parts come and go"),
    Row("Drawing", "App::PropertyFileIncluded", "Result", "", "The drawing (JSON), kept in the document"),
    Row("Picture", "App::PropertyFileIncluded", "Result", "", "The drawing as SVG, kept in the document"),
    Row("DrawnScale", "App::PropertyFloat", "Result", 0.0, "The scale of the kept drawing"),
    Row("Inputs", "App::PropertyString", "Result", "", "Fingerprint of what the kept drawing was made from"),
    Row("Message", "App::PropertyString", "Result", "", "Messages of the last run"),
    Row("Schema", "App::PropertyInteger", "Result", SCHEMA, "Version of these properties"),
)
CENTRE_LINES = "feature.centre_lines"  # the style key of CentreLines
READ_ONLY = {"Drawing", "Picture", "DrawnScale", "Inputs", "Message", "Schema", "Middle", "Kept", "LeftOut"}
HIDDEN = {"Inputs", "Schema", "Middle", "Kept", "LeftOut"}

SHEET_VIEW = (
    Row("Illustration", "App::PropertyLinkGlobal", "Burin", None, "The illustration that this view places"),
    Row("Trim", "App::PropertyBool", "Burin", True, "Shows only the part of the sheet that has lines"),
    Row("Middle", "App::PropertyVector", "Burin", None, "From the middle of the sheet to the middle of this view, in mm"),
    Row("Schema", "App::PropertyInteger", "Burin", SCHEMA, "Version of these properties"),
)

FLAT_EDGES = (
    Row("Illustration", "App::PropertyLinkGlobal", "Burin", None, "The illustration whose lines these are"),
    Row("Strokes", "App::PropertyBool", "Burin", False, "The strokes of hatching too (slow where there are thousands)"),
    Row("Hidden", "App::PropertyBool", "Burin", False, "The dashed hidden lines too"),
    Row("Schema", "App::PropertyInteger", "Burin", SCHEMA, "Version of these properties"),
)

DIMENSION = (
    Row("Kind", "App::PropertyEnumeration", "Dimension", ["Overall", "Distance", "Diameter", "Radius", "Angle", "Depth", "Thread", "Note"],
        "What is measured; Overall: width, depth and height of all that is drawn; Note: nothing, Text is written"),
    Row("Features", "App::PropertyLinkSubListGlobal", "Dimension", None,
        "The faces, edges or vertices that are measured: one, or two for Distance and Angle; of a note any number, and whole objects"),
    Row("Along", "App::PropertyVector", "Dimension", (0, 0, 0), "Distance: measured in this direction; 0, 0, 0: the shortest way"),
    Row("Supplement", "App::PropertyBool", "Dimension", False, "Angle: the one beside that between the features"),
    Row("Text", "App::PropertyString", "Text", "",
        "What is written instead of the number with its sign, such as 4x ⌀{value}; of a note its words, \\n begins a line, {part.name}, {volume} are values"),
    Row("Tolerance", "App::PropertyString", "Text", "", "Behind the number: H7, 0.1 (±0.1), or the upper and the lower deviation, +0.1/-0.2"),
    Row("Frame", "App::PropertyBool", "Text", False, "Note: a frame around the words"),
    Row("Symbol", "App::PropertyString", "Text", "", "Note: the symbol around the words, such as surface, weld, balloon or warning; empty: none"),
    Row("SymbolKeys", "App::PropertyMap", "Text", {}, "Note: options of the symbol, such as warning_of = hot"),
    Row("Mark", "App::PropertyEnumeration", "Text", ["Auto", "Dot", "Arrow", "None"], "Note: the end of its leaders"),
    Row("Place", "App::PropertyVector", "Text", (0, 0, 0), "Note: its lower left corner, x and y in mm of the sheet; 0, 0: beside the drawing, where there is room"),
    Row("Decimals", "App::PropertyInteger", "Text", -1, "Places after the point, 0 to 6; -1: those of the style"),
    Row("View", "App::PropertyString", "Text", "", "The view of the sheet that has it, such as top or A-A; empty: the first that shows it best"),
    Row("Kept", "App::PropertyStringList", "Result", [], "What its features look like, an entry each: they are found again by that"),
    Row("LeftOut", "App::PropertyString", "Result", "", "Why the last drawing is without it"),
    Row("Message", "App::PropertyString", "Result", "", "Why it is not drawn"),
    Row("Schema", "App::PropertyInteger", "Result", SCHEMA, "Version of these properties"),
)
# What notes alone have, and what they have not.
OF_NOTES = ("Frame", "Symbol", "SymbolKeys", "Mark", "Place")
NOT_OF_NOTES = ("Along", "Supplement", "Tolerance")


def default_of(name):
    """The value of a property that new illustrations have."""
    return next(row.value for row in ILLUSTRATION if row.name == name)


def words_of(name):
    """The words of an enumeration; new illustrations have the first."""
    return list(default_of(name))


def is_newer(obj):
    """Whether a newer version made the object: it is shown and not touched."""
    return getattr(obj, "Schema", 0) > SCHEMA


def ensure(obj, rows):
    """Adds what is missing, so that objects of older schemas get new properties with their defaults, and new words of enumerations.
    Leaves objects of newer schemas alone."""
    if is_newer(obj):
        return
    have = set(obj.PropertiesList)
    for row in rows:
        if row.name in have:
            _renew_words(obj, row)
            continue
        obj.addProperty(row.kind, row.name, row.group, row.text)
        if row.value not in (None, ""):
            setattr(obj, row.name, row.value)
    for row in rows:
        if row.name in READ_ONLY:
            obj.setEditorMode(row.name, 3 if row.name in HIDDEN else 1)
    if obj.Schema != SCHEMA:
        obj.Schema = SCHEMA


def _renew_words(obj, row):
    """Documents keep the words that an enumeration had when its object was made."""
    if row.kind != "App::PropertyEnumeration" or obj.getEnumerationsOfProperty(row.name) == row.value:
        return
    chosen = getattr(obj, row.name)
    setattr(obj, row.name, row.value)
    setattr(obj, row.name, chosen if chosen in row.value else row.value[0])


def show_alone(obj, shown, hidden):
    """Shows some properties and hides others, by their names."""
    for names, mode in ((shown, 0), (hidden, 2)):
        for name in set(names).intersection(obj.PropertiesList):
            obj.setEditorMode(name, mode)
