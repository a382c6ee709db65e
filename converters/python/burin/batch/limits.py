"""What a drawing may take: seconds and bytes, as they are written."""

import re
from typing import Any

from .errors import USAGE, BatchError

_UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}
TIMEOUT = 120.0


def memory_bytes(text: str, where: str) -> int:
    """Bytes of "4G", "500M"."""
    match = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)([KMGT]?)", text.strip().upper().removesuffix("B"))
    value = int(float(match[1]) * _UNITS[match[2]]) if match else 0
    if value < 1 << 20:
        raise BatchError(f"{where} takes an amount of memory from 1M, such as 4G, not '{text}'", USAGE)
    return value


def memory_text(value: int) -> str:
    for unit in "TGMK":
        if value >= _UNITS[unit]:
            return f"{value / _UNITS[unit]:.4g}{unit}"
    return str(value)


def seconds(value: Any, where: str) -> float:
    """Seconds of "120" or 0.5."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = -1
    if isinstance(value, bool) or not 0 < number < 1e7:
        raise BatchError(f"{where} takes seconds, more than 0, not '{value}'", USAGE)
    return number
