"""What can go wrong, once for all layers. The texts are for the user and say what to do."""

import sys

HOW_TO_INSTALL = (
    "The drawing kernel (the Python module 'burin') was not found for Python %d.%d. Without a compiler: install the add-on's archive for "
    "Linux, which holds it, or unpack the wheel burin-*-cp%d%d-*.whl (python3 -m zipfile -e WHEEL FOLDER) and name the folder in the "
    "preferences (Edit > Preferences > Burin) or in the environment variable BURIN_PYTHON_PATH. In a checkout: './dev build', then "
    "'cmake --install build/release'. Documents open and show their kept drawings without it."
) % (*sys.version_info[:2], *sys.version_info[:2])


class Refused(ValueError):
    """What is asked for cannot be done; the text says why and what to do."""


class KernelMissing(Refused):
    """The module `burin` cannot be imported; the text says what to install."""

    def __init__(self, why=""):
        super().__init__(f"{HOW_TO_INSTALL} ({why})" if why else HOW_TO_INSTALL)


class Failed(Exception):
    """A run of the kernel failed."""


class Crashed(Failed):
    """The worker ended in the middle of a run."""


class Stopped(Exception):
    """A run was cancelled."""
