"""Removes what stands in records that nobody asks for any more: the records, and the files that they tell of."""

import contextlib
import dataclasses
import os
from pathlib import Path

from .errors import StopRun
from .jobs import stays_inside
from .state import State, disk_error


@dataclasses.dataclass
class Pruned:
    """What was removed, or would be. Names of files are seen from the folder of outputs."""

    # Of the drawings whose records went.
    names: list[str] = dataclasses.field(default_factory=list)
    files: list[str] = dataclasses.field(default_factory=list)
    bytes: int = 0
    # Files that a record tells of and that have other bytes by now: they are someone else's.
    left: list[str] = dataclasses.field(default_factory=list)

    def words(self, dry: bool) -> str:
        verb = "would be removed" if dry else "removed"
        words = f"{len(self.names)} records and {len(self.files)} files {verb}, {self.bytes} bytes"
        return words + (f"; {len(self.left)} files left, they have changed since" if self.left else "")


def prune(state: State, ids: set[str], outputs: set[str], dry: bool = False) -> Pruned:
    """Removes all records but those of `ids`, and their files but `outputs`, where they have the bytes that the record tells;
    then folders that are empty and that none of `outputs` lies in. Files that no record tells of are never touched. Others may
    draw what is kept meanwhile. Throws StopRun where the disk does not let it."""
    pruned = Pruned()
    records = {id: record for id in state.ids() if id not in ids and (record := state.record(id)) is not None}
    emptied: set[Path] = set()
    for id, record in sorted(records.items(), key=lambda pair: (str(pair[1].get("name", "")), pair[0])):
        for name, known in sorted(record.get("outputs", {}).items()):
            if name in outputs or name in pruned.files or not stays_inside(name) or not os.path.lexists(state.out / name):
                continue
            if not state.holds(name, *known):
                pruned.left.append(name)
                continue
            pruned.files.append(name)
            pruned.bytes += known[0]
            emptied.update((state.out / name).parents)
            if not dry:
                _remove(state.out / name)
        pruned.names.append(str(record.get("name", id)))
        if not dry:
            state.forget(id)
    # Of several records of one file one may tell its bytes.
    pruned.left = sorted(set(pruned.left) - set(pruned.files))
    if not dry:
        needed = {parent for name in outputs for parent in (state.out / name).parents}
        for folder in sorted(emptied - needed, key=lambda p: len(p.parts), reverse=True):
            if state.out in folder.parents:
                with contextlib.suppress(OSError):
                    folder.rmdir()
    return pruned


def _remove(path: Path) -> None:
    try:
        path.unlink(missing_ok=True)
    except OSError as e:
        raise disk_error(e, path) or StopRun(f"{path}: cannot be removed: {e.strerror}") from e
