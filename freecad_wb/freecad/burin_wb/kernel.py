"""The way to the kernel: the Python module `burin`, in this process or in a worker process."""

import functools
import importlib.machinery
import importlib.util
import os
import re
import sys

from . import errors, offers, preferences
from .errors import KernelMissing
from .load import load

_HERE = os.path.dirname(os.path.realpath(__file__))
# The kernel of an add-on that holds one.
_NATIVE = os.path.join(_HERE, "native")
# In the name of a compiled module: the version of its Python.
_PYTHON = re.compile(r"cpython-(\d)(\d+)")


def folders():
    """Folders that hold the module and are searched besides sys.path, in order: the environment's, the preferences',
    this add-on's own, the one that was installed with it, and the build folder of a development checkout."""
    found = [*_named(), _NATIVE, *_installed(), os.path.normpath(os.path.join(_HERE, "../../../build/release/python"))]
    return [p for p in found if _holds_module(p)]


def _named():
    """The folders that the user names. One that is the package itself stands for that which holds it."""
    named = [*os.environ.get("BURIN_PYTHON_PATH", "").split(os.pathsep), preferences.kernel_folder()]
    return [_above_package(p) for p in named if p]


def _above_package(path):
    above, name = os.path.split(os.path.abspath(path))
    return above if name == "burin" and _modules(above) else path


def why_missing():
    """What to do where no kernel is found, with what is unfit of what is named and of what the add-on holds."""
    unfit = [_unfit(p) for p in [*_named(), *([_NATIVE] if _modules(_NATIVE) else [])]]
    return " ".join([errors.HOW_TO_INSTALL, *(line for line in unfit if line)])


def _unfit(path):
    """Why a path holds no kernel for this Python; empty where it does."""
    if _holds_module(path):
        return ""
    modules = _modules(path)
    if modules:
        pythons = sorted({"%s.%s" % found.groups() for found in map(_PYTHON.search, modules) if found})
        return "%s holds it for Python %s." % (path, " and ".join(pythons) or "of another kind")
    if path.endswith(".whl"):
        return "%s is to be unpacked." % path
    return "%s holds none." % path if os.path.exists(path) else "%s is not there." % path


def _modules(folder):
    """The compiled modules of the package in a folder, for whatever Python."""
    try:
        return [name for name in os.listdir(os.path.join(folder, "burin")) if name.startswith("_burin.") and name.endswith((".so", ".pyd"))]
    except OSError:
        return []


def _installed():
    """PREFIX/lib/pythonX.Y/dist-packages beside PREFIX/share/freecad/Mod/Burin, wherever the prefix was moved to; for
    add-ons installed elsewhere what the installation noted."""
    prefix = os.path.normpath(os.path.join(_HERE, "../../../../../.."))
    python = "lib/python%d.%d" % sys.version_info[:2]
    found = [os.path.join(prefix, python, packages) for packages in ("dist-packages", "site-packages")]
    try:
        with open(os.path.join(_HERE, "kernel.path"), encoding="utf-8") as noted:
            found.append(noted.read().strip())
    except OSError:
        pass
    return found


def _holds_module(folder):
    """Whether the module there is one for this Python."""
    return any(os.path.isfile(os.path.join(folder, "burin", "_burin" + suffix)) for suffix in importlib.machinery.EXTENSION_SUFFIXES)


def found():
    """Whether the module is there; does not load it."""
    if "burin" in sys.modules or folders():
        return True
    spec = importlib.util.find_spec("burin")
    return spec is not None and spec.origin is not None


def module():
    """The module `burin`. Throws errors.KernelMissing."""
    return load(folders())


@functools.lru_cache(maxsize=None)
def _asked(burin):
    """Once a module: panels are opened often, and it takes 5 ms."""
    return offers.asked(burin)


def offered():
    """What the kernel offers: the one that is there; without one, that which the add-on was made with."""
    try:
        return _asked(module()) if found() else offers.kept()
    except KernelMissing:
        return offers.kept()
