"""The way to the kernel: the Python module `burin`, in this process or in a worker process."""

import importlib
import importlib.util
import os
import sys

HOW_TO_INSTALL = (
    "The drawing kernel (the Python module 'burin') was not found. Build it with './dev build' and "
    "install it with 'cmake --install build/release', or set the environment variable BURIN_PYTHON_PATH "
    "to the folder that holds it (build/release/python), or name that folder in the preferences. Documents open and show their kept drawings "
    "without it."
)


class KernelMissing(Exception):
    """The module `burin` cannot be imported; the text says what to install."""


def folders():
    """Folders that are searched besides sys.path, in order: the environment's, this add-on's own, and
    the build folder of a development checkout."""
    here = os.path.dirname(os.path.realpath(__file__))
    named = os.environ.get("BURIN_PYTHON_PATH", "")
    found = [p for p in named.split(os.pathsep) if p]
    if "FreeCAD" in sys.modules:  # not in the worker
        from . import preferences

        found.append(preferences.kernel_folder())
    found.append(os.path.join(here, "native"))
    found.append(os.path.normpath(os.path.join(here, "../../../build/release/python")))
    return [p for p in found if os.path.isdir(os.path.join(p, "burin"))]


def found():
    """Whether the module is there; does not load it."""
    if "burin" in sys.modules or folders():
        return True
    return importlib.util.find_spec("burin") is not None


def module():
    """The module `burin`. Throws KernelMissing."""
    if "burin" in sys.modules:
        return sys.modules["burin"]
    for folder in folders():
        if folder not in sys.path:
            sys.path.append(folder)
    try:
        return importlib.import_module("burin")
    except ImportError as error:
        raise KernelMissing(f"{HOW_TO_INSTALL} ({error})") from error
