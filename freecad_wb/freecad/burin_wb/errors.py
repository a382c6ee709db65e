"""What can go wrong, once for all layers. The texts are for the user and say what to do."""

HOW_TO_INSTALL = (
    "The drawing kernel (the Python module 'burin') was not found. Build it with './dev build' and "
    "install it with 'cmake --install build/release', or set the environment variable BURIN_PYTHON_PATH "
    "to the folder that holds it (build/release/python), or name that folder in the preferences. Documents open and show their kept drawings "
    "without it."
)


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
