"""The way to the kernel: the Python module `burin`, in this process or in a worker process."""

import functools
import importlib.machinery
import importlib.util
import os
import sys

from . import offers, preferences
from .errors import KernelMissing
from .load import load


def folders():
    """Folders that hold the module and are searched besides sys.path, in order: the environment's, the preferences',
    this add-on's own, the one that was installed with it, and the build folder of a development checkout."""
    here = os.path.dirname(os.path.realpath(__file__))
    named = os.environ.get("BURIN_PYTHON_PATH", "")
    found = [p for p in named.split(os.pathsep) if p]
    found.append(preferences.kernel_folder())
    found.append(os.path.join(here, "native"))
    found.extend(_installed(here))
    found.append(os.path.normpath(os.path.join(here, "../../../build/release/python")))
    return [p for p in found if p and _holds_module(p)]


def _installed(here):
    """PREFIX/lib/pythonX.Y/dist-packages beside PREFIX/share/freecad/Mod/Burin, wherever the prefix was moved to; for
    add-ons installed elsewhere what the installation noted."""
    prefix = os.path.normpath(os.path.join(here, "../../../../../.."))
    python = "lib/python%d.%d" % sys.version_info[:2]
    found = [os.path.join(prefix, python, packages) for packages in ("dist-packages", "site-packages")]
    try:
        with open(os.path.join(here, "kernel.path"), encoding="utf-8") as noted:
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
