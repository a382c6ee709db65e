"""Loads the kernel. Needs no FreeCAD: the worker process does it too."""

import importlib
import sys

from .errors import KernelMissing


def load(folders):
    """The module `burin`, looked for on sys.path and in `folders`. Throws KernelMissing."""
    for folder in folders:
        if folder not in sys.path:
            sys.path.append(folder)
    try:
        burin = importlib.import_module("burin")
        burin.draw  # a folder that only has the name is a module too
        return burin
    except (ImportError, AttributeError) as error:
        sys.modules.pop("burin", None)
        raise KernelMissing(error) from error
