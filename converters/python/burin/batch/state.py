"""What is done: a record a drawing, named by its id, in `.burin-batch` below the folder of outputs.

A drawing is done where its record is there and says that it failed for a reason that would hold again, or that it was
drawn, and all files that it read and all its outputs have the bytes that the record tells. Nothing is decided by times.
"""

import contextlib
import errno
import json
import os
import shutil
import uuid
from pathlib import Path
from typing import Any

from .errors import StopRun
from .jobs import Drawing, file_hash

FOLDER = ".burin-batch"
# Failures of these kinds come again as long as what was read stays as it is.
_LASTING = {"usage", "input", "geometry", "error", "crash", "missing", "lost"}
_FULL = {errno.ENOSPC: "the disk is full; free some space", errno.EDQUOT: "the quota of the disk is used up; free some space"}
_FULL[errno.EROFS] = "the file system is read-only; choose another folder"


def disk_error(e: OSError, path: str | Path) -> StopRun | None:
    """What ends the whole run; None for what concerns this file alone."""
    return StopRun(f"{path}: {_FULL[e.errno]}") if e.errno in _FULL else None


class State:
    """The records of one folder of outputs; `base` is where names of inputs are looked for."""

    def __init__(self, out: Path, base: Path) -> None:
        self.out, self.base = out, base
        self._folder = out / FOLDER

    def record_path(self, id: str) -> Path:
        return self._folder / "records" / id[:2] / f"{id}.json"

    def record(self, id: str) -> dict[str, Any] | None:
        """The record of an id; None where there is none or it is no whole one."""
        try:
            value = json.loads(self.record_path(id).read_text(encoding="ascii"))
        except (OSError, ValueError):
            return None
        return value if isinstance(value, dict) and value.get("id") == id else None

    def ids(self) -> list[str]:
        """Those of all records, sorted."""
        return sorted(path.stem for path in (self._folder / "records").glob("*/*.json"))

    def write_record(self, record: dict[str, Any]) -> None:
        """Throws StopRun where it cannot be written: then nothing can."""
        path = self.record_path(record["id"])
        aside = path.with_name(f".{uuid.uuid4().hex}.part")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            try:
                aside.write_text(json.dumps(record), encoding="ascii")
                aside.replace(path)
            finally:
                aside.unlink(missing_ok=True)
        except OSError as e:
            raise disk_error(e, path) or StopRun(f"{path}: cannot be written: {e.strerror}") from e

    def forget(self, id: str) -> None:
        self.record_path(id).unlink(missing_ok=True)

    def done(self, drawing: Drawing, limits: dict[str, Any], hashes: "Hashes") -> dict[str, Any] | None:
        """The record of a drawing that is done; None where it is to be drawn."""
        record = self.record(drawing.id)
        if record is None or not self._lasts(record, limits):
            return None
        if any(hashes.of(name) != known for name, known in record["files"].items()):
            return None
        if "error" not in record:
            if sorted(record["outputs"]) != sorted(drawing.files()):
                return None
            if not all(self.holds(name, *known) for name, known in record["outputs"].items()):
                return None
        return record

    @staticmethod
    def _lasts(record: dict[str, Any], limits: dict[str, Any]) -> bool:
        """Limits that were at least as wide would be reached again."""
        kind = record.get("error", {}).get("kind")
        if kind in ("timeout", "memory"):
            was, now = record.get("limits", {}).get(kind), limits.get(kind)
            return was is not None and now is not None and now <= was
        return kind is None or kind in _LASTING

    def holds(self, name: str, size: int, known: str) -> bool:
        """Whether an output has these bytes."""
        path = self.out / name
        try:
            if path.stat().st_size != size:
                return False
        except OSError:
            return False
        return file_hash(path) == known

    @contextlib.contextmanager
    def aside(self) -> Any:
        """A folder of one's own for what is not whole yet."""
        folder = self._folder / "aside" / uuid.uuid4().hex
        try:
            folder.mkdir(parents=True)
        except OSError as e:
            raise disk_error(e, folder) or StopRun(f"{folder}: cannot be made: {e.strerror}; choose another folder") from e
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def begun(self, id: str, run: str) -> int:
        """How often a drawing began in this run and did not end: as often its worker died."""
        try:
            return self._mark(id).read_text(encoding="ascii").split().count(run)
        except (OSError, UnicodeDecodeError):
            return 0

    def begin(self, id: str, run: str) -> None:
        """Notes that a drawing begins."""
        path = self._mark(id)
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            with open(path, "a", encoding="ascii") as file:
                file.write(f"{run}\n")
        except OSError as e:
            raise disk_error(e, path) or StopRun(f"{path}: cannot be written: {e.strerror}") from e

    def end(self, id: str) -> None:
        self._mark(id).unlink(missing_ok=True)

    def _mark(self, id: str) -> Path:
        return self._folder / "begun" / id


class Hashes:
    """Hashes of what one job reads, each file read once."""

    def __init__(self, base: Path) -> None:
        self._base = base
        self._known: dict[str, str | None] = {}

    def of(self, name: str) -> str | None:
        if name not in self._known:
            self._known[name] = file_hash(self._base / name)
        return self._known[name]

    def of_read(self, files: list[Any]) -> dict[str, str | None] | None:
        """Of the files that a process says it opened; None where one is another by now."""
        found = {}
        for name, stamp in files:
            if name.startswith(("/proc/", "/dev/")) or "\ufffd" in name:
                continue  # no files of their own; names that are no UTF-8
            found[name] = self.of(name)
            if self._stamp(name) != stamp:
                self._known.pop(name)
                return None
        return found

    def _stamp(self, name: str) -> list[int] | None:
        try:
            s = os.stat(self._base / name)
        except OSError:
            return None
        return [s.st_dev, s.st_ino, s.st_size, s.st_mtime_ns, s.st_ctime_ns]
