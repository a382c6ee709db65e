"""Files of TOML that users write, catalogues and books: every value is looked at before it is used."""

import difflib
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from .errors import BatchError


def nearest(word: str, words: Iterable[str]) -> str:
    return max(sorted(words), key=lambda other: difflib.SequenceMatcher(None, word, other).ratio())


class TomlReader:
    """Errors of one file. All throw BatchError, which names the file and the place in it."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def fail(self, what: str) -> BatchError:
        return BatchError(f"{self.path}: {what}")

    def load(self) -> dict[str, Any]:
        try:
            with open(self.path, "rb") as file:
                return tomllib.load(file)
        except OSError as e:
            raise self.fail(f"cannot be read: {e.strerror}") from e
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as e:
            raise self.fail(f"is no TOML: {e}") from e

    def table(self, value: Any, where: str, known: set[str]) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise self.fail(f"{where} is no table")
        for key in value:
            if key not in known:
                raise self.fail(f"{where} has no key '{key}'; the nearest is '{nearest(key, known)}'")
        return value

    def text(self, value: Any, where: str) -> str:
        if not isinstance(value, str):
            raise self.fail(f"{where} takes a text")
        return value

    def texts(self, value: Any, where: str) -> list[str]:
        values = [value] if isinstance(value, str) else value
        if not isinstance(values, list) or not values or not all(isinstance(v, str) and v for v in values):
            raise self.fail(f"{where} takes a text or a list of texts")
        return values

    def option(self, value: Any, where: str) -> list[str]:
        """The texts of an option, as they stand on the command line."""
        if isinstance(value, dict):
            texts = {key: self.option(v, where) for key, v in value.items()}
            if all(len(t) == 1 for t in texts.values()):
                return [f"{key}={t[0]}" for key, t in texts.items()]
        if isinstance(value, list):
            return [text for v in value for text in self.option(v, where)]
        if isinstance(value, bool):
            return ["true" if value else "false"]
        if isinstance(value, (str, int, float)):
            return [str(value)]
        raise self.fail(f"{where} takes a text, a number, true or false, a list or a table of them")
