"""Styles as properties name them: a built-in one by its name, or a file."""

import hashlib
import os

from ..errors import Refused


def is_file(text):
    """Whether a style's text means a file: it has a folder or a suffix."""
    return os.path.basename(text) != text or "." in text


def resolve(text, document):
    """What the kernel is to be asked for: a built-in style's name as it is, or the path of a file, which may be
    relative to the document. Throws Refused where the file is gone."""
    if not is_file(text):
        return text
    path = os.path.expanduser(text)
    if not os.path.isabs(path):
        folder = os.path.dirname(document.FileName) if document.FileName else os.getcwd()
        path = os.path.join(folder, path)
    if not os.path.isfile(path):
        raise Refused(f"the style file {path} is gone; put it back, or choose another style")
    return os.path.normpath(path)


def contents(texts):
    """Paths of files with hashes of what is in them, of styles as `resolve` gives them. Throws Refused."""
    found = {}
    for path in texts:
        if not path or not is_file(path):
            continue
        try:
            with open(path, "rb") as file:
                found[path] = hashlib.sha256(file.read()).hexdigest()
        except OSError as error:
            raise Refused(f"the style file {path} cannot be read ({error.strerror}); choose another style")
    return found
