"""What a document shows. Documents from before FreeCAD 0.19 keep that in the part of the file that is for the GUI alone;
without a GUI it is read from there, for else all that a model was made from would be shown with it."""

import os
import xml.etree.ElementTree as xml
import zipfile

import FreeCAD

_files = {}  # path -> (time of change, names of hidden objects): one look a saved document, whatever it held


def is_shown(obj):
    if not getattr(obj, "Visibility", True):
        return False
    return FreeCAD.GuiUp or obj.Name not in _hidden(obj.Document)


def _hidden(document):
    path = document.FileName
    try:
        changed = os.path.getmtime(path)
    except OSError:  # never saved, or gone
        return frozenset()
    if path not in _files or _files[path][0] != changed:
        _files[path] = changed, _read(path)
    return _files[path][1]


def _read(path):
    """Names of the objects that the GUI's part alone says are hidden; none where there is no such part, or it cannot be read."""
    try:
        with zipfile.ZipFile(path) as file:
            if "GuiDocument.xml" not in file.namelist():
                return frozenset()
            objects = xml.fromstring(file.read("Document.xml"))
            views = xml.fromstring(file.read("GuiDocument.xml"))
    except (OSError, KeyError, zipfile.BadZipFile, xml.ParseError):
        return frozenset()
    said = {o.get("name") for o in objects.iter("Object") if _visibility(o) is not None}
    return frozenset(v.get("name") for v in views.iter("ViewProvider") if _visibility(v) is False) - said


def _visibility(node):
    for value in node.iterfind(".//Property[@name='Visibility']/Bool"):
        return value.get("value") == "true"
    return None
