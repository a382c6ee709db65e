"""Files that are written whole or not at all."""

import contextlib
import os
from pathlib import Path

from .errors import NO_OUTPUT, BatchError


def write_whole(path: Path, text: str) -> bool:
    """Whether the file was another before; one that has this text stays untouched. Throws BatchError."""
    data = text.encode()
    with contextlib.suppress(OSError):
        if path.read_bytes() == data:
            return False
    aside = path.with_name(f".{path.name}.part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        aside.write_bytes(data)
        os.replace(aside, path)
    except OSError as e:
        raise BatchError(f"{path}: cannot be written: {e.strerror}", NO_OUTPUT) from e
    return True
