"""Packages with the entry point `burin.plugins`: each names a function, which is called once, when burin is imported,
and registers what it has (`burin.register_direction` and so on)."""

import os
import sys


def _has_entries():
    """Whether any package may have one: `importlib.metadata` takes longer to import than to look."""
    for folder in sys.path:
        try:
            with os.scandir(folder or ".") as entries:
                names = [e.path for e in entries if e.name.endswith((".dist-info", ".egg-info"))]
        except OSError:
            continue
        for name in names:
            try:
                with open(os.path.join(name, "entry_points.txt"), encoding="utf-8") as file:
                    if "[burin.plugins]" in file.read():
                        return True
            except (OSError, UnicodeDecodeError):
                continue
    return False


def load(refuse):
    """Calls all entry points; `refuse(name, why)` is told those that fail."""
    if not _has_entries():
        return
    from importlib.metadata import entry_points

    for entry in entry_points(group="burin.plugins"):
        try:
            entry.load()()
        except Exception as error:
            refuse(f"{entry.name} ({entry.value})", f"{type(error).__name__}: {error}".split("\n")[0])
