"""Jobs: a part and its drawings. They stand in a file of JSON lines, a head and a line a job.

    {"burin": "batch", "version": 1, "base": "..", "out": "out", "program": "0.2.0", "limits": {"timeout": 120}}
    {"part": "parts/a.step", "inputs": ["parts/a.step"], "drawings": [{"id": "...", "name": "a-front",
     "options": {"view": ["front"]}, "outputs": ["a-front.svg"], "lists": []}]}

`base`, where names of inputs and options are looked for, and `out`, from where outputs are named, are as seen from the file: a
catalogue that is copied or mounted elsewhere keeps its ids and its hash.
"""

import dataclasses
import hashlib
import json
import os
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .errors import BatchError
from .files import write_whole

ID_DIGITS = 32


@dataclasses.dataclass
class Drawing:
    """One drawing of a part. Options are those of `burin draw` with underscores, each a list of texts."""

    name: str
    options: dict[str, list[str]]
    outputs: list[str]
    lists: list[str] = dataclasses.field(default_factory=list)
    id: str = ""

    def files(self) -> list[str]:
        return self.outputs + self.lists


@dataclasses.dataclass
class Job:
    """A part with all its drawings: read once, by one process after the other."""

    part: str
    inputs: list[str]
    drawings: list[Drawing]

    def id(self) -> str:
        return digest([self.part, *(d.id for d in self.drawings)])


@dataclasses.dataclass
class Batch:
    """All jobs of a file, and what holds for all of them."""

    base: Path
    out: Path
    program: str
    limits: dict[str, Any]
    jobs: list[Job]

    def drawings(self) -> list[tuple[Job, Drawing]]:
        return [(job, drawing) for job in self.jobs for drawing in job.drawings]


def digest(value: Any) -> str:
    """A name for anything that JSON can hold."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:ID_DIGITS]


def file_hash(path: str | Path) -> str | None:
    """SHA-256 of a file's bytes, None where it cannot be read; what is no file (a pipe, a device) may have no end."""
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            return None
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


def named_files(base: Path, options: dict[str, list[str]]) -> list[str]:
    """Files that options name, such as style files; what else a drawing reads is known when it is drawn."""
    texts = {text for values in options.values() for value in values for text in (value, value.partition("=")[2])}
    return sorted(t for t in texts if t and "\0" not in t and len(t) < 4096 and (base / t).is_file())


def drawing_id(
    program: str,
    base: Path,
    inputs: list[str],
    options: dict[str, list[str]],
    files: list[str],
    hash_of: Callable[[str], str | None],
    more: Any = None,
) -> str:
    """The id of a drawing of these inputs that writes these files; `more` is what else tells it from others."""
    hashes = {name: hash_of(name) for name in [*inputs, *named_files(base, options)]}
    return digest([program, inputs, options, hashes, files, more])


def shard_of(id: str, count: int) -> int:
    """Which of so many shards an id is in, from 0: by the id alone, so that all machines agree."""
    return int(id[:16], 16) % count


def write(batch: Batch, path: Path) -> None:
    """Writes the file, whole or not at all."""
    folder = path.resolve().parent
    head = {
        "burin": "batch",
        "version": 1,
        "base": os.path.relpath(batch.base.resolve(), folder),
        "out": os.path.relpath(batch.out, folder),
        "program": batch.program,
        "limits": batch.limits,
    }
    write_whole(path, "".join(json.dumps(line) + "\n" for line in [head, *map(dataclasses.asdict, batch.jobs)]))


def read(path: Path) -> Batch:
    """Reads such a file. Throws BatchError that names the line."""
    try:
        lines = path.read_text(encoding="utf-8").split("\n")
    except (OSError, UnicodeDecodeError) as e:
        why = e.strerror if isinstance(e, OSError) else "is no text"
        raise BatchError(f"{path}: cannot be read: {why}; burin batch plan CATALOGUE.toml -o {path} writes it") from e
    head = _object(path, 1, lines[0])
    if head.get("burin") != "batch" or head.get("version") != 1:
        raise BatchError(f"{path}:1: is no file of jobs, version 1; burin batch plan CATALOGUE.toml -o {path} writes one")
    folder = path.resolve().parent
    base = (folder / _text(path, 1, head, "base")).resolve()
    out = folder / _text(path, 1, head, "out")
    jobs = [_job(path, number, line) for number, line in enumerate(lines[1:], 2) if line.strip()]
    return Batch(base, out, _text(path, 1, head, "program"), dict(head.get("limits", {})), jobs)


def _object(path: Path, number: int, line: str) -> dict[str, Any]:
    try:
        value = json.loads(line)
    except ValueError:
        value = None
    if not isinstance(value, dict):
        raise BatchError(f"{path}:{number}: is not one JSON object; write the jobs again by burin batch plan")
    return value


def _text(path: Path, number: int, value: dict[str, Any], key: str) -> str:
    text = value.get(key)
    if not isinstance(text, str):
        raise BatchError(f'{path}:{number}: "{key}" is no text; write the jobs again by burin batch plan')
    return text


def _job(path: Path, number: int, line: str) -> Job:
    value = _object(path, number, line)
    try:
        drawings = [
            Drawing(
                name=str(d["name"]),
                options={str(k): [str(t) for t in v] for k, v in d["options"].items()},
                outputs=[str(o) for o in d["outputs"]],
                lists=[str(o) for o in d.get("lists", [])],
                id=str(d["id"]),
            )
            for d in value["drawings"]
        ]
        job = Job(str(value["part"]), [str(i) for i in value["inputs"]], drawings)
    except (KeyError, TypeError, AttributeError) as e:
        raise BatchError(f"{path}:{number}: is no job ({e}); write the jobs again by burin batch plan") from e
    for drawing in job.drawings:
        if not set(drawing.id) <= set("0123456789abcdef") or len(drawing.id) != ID_DIGITS:
            raise BatchError(f"{path}:{number}: {drawing.name} has no id; write the jobs again by burin batch plan")
        for name in drawing.files():
            if not stays_inside(name):
                raise BatchError(f"{path}:{number}: {name!r} is not below the folder of outputs; name it otherwise")
    return job


def stays_inside(name: str) -> bool:
    """Whether the name of an output stays below the folder of outputs, and is none of ours."""
    path = Path(name)
    return bool(path.name) and not path.is_absolute() and ".." not in path.parts and not path.parts[0].startswith(".burin-batch")
