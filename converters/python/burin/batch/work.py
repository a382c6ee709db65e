"""Draws what is left of one job. Runs in this process or in a worker elsewhere, which needs the files and the command."""

import contextlib
import dataclasses
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .child import Child, Ended
from .errors import StopRun
from .jobs import Drawing, Job, file_hash
from .state import Hashes, State, disk_error

# So often a drawing is begun whose worker dies each time, and so often one whose inputs change meanwhile.
_ATTEMPTS = 2


@dataclasses.dataclass
class Settings:
    """What holds for all jobs of a run; as seen from the worker."""

    base: str
    out: str
    command: str
    program: str
    timeout: float | None
    memory: int | None
    threads: int = 1
    # Draw again what failed, whatever the reason.
    again: bool = False
    # Tells this run from others, for drawings that end their worker.
    run: str = ""

    def limits(self) -> dict[str, Any]:
        return {"timeout": self.timeout, "memory": self.memory}


@dataclasses.dataclass
class Result:
    """What became of one drawing."""

    name: str
    # "drawn", "kept" (was done before) or "failed"
    status: str
    seconds: float = 0
    bytes: int = 0
    kind: str = ""
    message: str = ""
    # Failed in a run before this one, and was not tried again.
    before: bool = False


def run_job(settings: Settings, job: Job, cancelled: Callable[[], bool] = lambda: False) -> list[Result]:
    """Draws what is not done. A process that ends early takes along the drawing that it was at, and another one goes on
    with the rest. Throws StopRun where nothing more can be written, child.Cancelled."""
    return _Work(settings, job, cancelled).run()


def give_up(settings: Settings, job: Job, why: str) -> list[Result]:
    """Notes that what is left of a job cannot be drawn."""
    work = _Work(settings, job, lambda: False)
    for drawing in job.drawings:
        if not work.keep(drawing):
            work.fail(drawing, "lost", why, {i: work.hashes.of(i) for i in job.inputs})
    return work.results


class _Work:
    def __init__(self, settings: Settings, job: Job, cancelled: Callable[[], bool]) -> None:
        self.settings, self.job, self.cancelled = settings, job, cancelled
        self.base = Path(settings.base)
        self.state = State(Path(settings.out), self.base)
        self.hashes = Hashes(self.base)
        self.results: list[Result] = []
        self.changed: dict[str, int] = {}

    def run(self) -> list[Result]:
        left = [d for d in self.job.drawings if not self.keep(d)]
        left = [d for d in left if not self.ended_its_worker(d)]
        while left:
            with self.state.aside() as aside:
                left = self.draw(left, aside)
        return self.results

    def keep(self, drawing: Drawing) -> bool:
        """Whether it is done."""
        record = self.state.done(drawing, self.settings.limits(), self.hashes)
        if record is None or ("error" in record and self.settings.again):
            return False
        if "error" in record:
            error, own = record["error"], bool(self.settings.run) and record.get("run") == self.settings.run
            self.results.append(Result(drawing.name, "failed", 0, 0, error["kind"], error["message"], not own))
        else:
            size = sum(n for n, _ in record["outputs"].values())
            self.results.append(Result(drawing.name, "kept", 0, size))
        return True

    def ended_its_worker(self, drawing: Drawing) -> bool:
        if self.settings.run == "" or self.state.begun(drawing.id, self.settings.run) < _ATTEMPTS:
            return False
        words = f"its worker died {_ATTEMPTS} times while it was drawn; draw it alone to see why"
        self.fail(drawing, "lost", words, {i: self.hashes.of(i) for i in self.job.inputs})
        return True

    def draw(self, left: list[Drawing], aside: Path) -> list[Drawing]:
        """Draws with one process until it has ended; returns what is still to be drawn."""
        s = self.settings
        request = {"inputs": self.job.inputs, "threads": s.threads, "drawings": [_request(d, k, aside) for k, d in enumerate(left)]}
        if s.run:
            self.state.begin(left[0].id, s.run)
        at, stage = 0, "start"
        again: list[Drawing] = []
        with Child(s.command, request, self.base, s.memory, self.cancelled) as child:
            child.allow(s.timeout)
            try:
                while "done" not in (answer := child.answer()):
                    if "version" in answer:
                        if answer["version"] != s.program:
                            words = f"{s.command} is burin {answer['version']} here, the jobs are of {s.program}"
                            raise StopRun(f"{words}; install that, or plan again")
                    elif "stage" in answer:
                        stage = answer["stage"]
                    elif "seconds" in answer:
                        if not self.finish(left[at], at, answer, aside):
                            again.append(left[at])
                        at += 1
                        child.allow(s.timeout)
                    elif s.run and at:
                        self.state.begin(left[at].id, s.run)
            except Ended as e:
                # What ends while it reads the part would do so for each of its drawings.
                ends = left[at:] if stage in ("start", "read") else left[at : at + 1]
                for drawing in ends:
                    self.fail(drawing, e.kind, f"{e.message} (stage {stage})", {i: self.hashes.of(i) for i in self.job.inputs})
                at += len(ends)
        return again + left[at:]

    def finish(self, drawing: Drawing, number: int, answer: dict[str, Any], aside: Path) -> bool:
        """Puts the outputs in their places and notes what was read. False where it is to be drawn again."""
        error = answer.get("error")
        if error and error["kind"] == "output":
            # Outputs stand in a folder of ours that could be written a moment ago.
            raise StopRun(_without(error["message"], drawing, number, aside))
        files = self.hashes.of_read(answer["files"])
        if files is None:
            self.changed[drawing.id] = self.changed.get(drawing.id, 0) + 1
            if self.changed[drawing.id] < _ATTEMPTS:
                return False
            self.fail(drawing, "changed", "a file that it reads was written while it was drawn; run again", {})
            return True
        if error:
            self.fail(drawing, error["kind"], _without(error["message"], drawing, number, aside), files, answer["seconds"])
            return True
        outputs: dict[str, tuple[int, str]] = {}
        for name, written in zip(drawing.files(), _asides(drawing, number, aside)):
            target = self.state.out / name
            try:
                known = file_hash(written)
                if known is None:
                    self.fail(drawing, "crash", f"did not write {name}", files, answer["seconds"])
                    return True
                outputs[name] = (written.stat().st_size, known)
                target.parent.mkdir(parents=True, exist_ok=True)
                os.replace(written, target)
            except OSError as e:
                full = disk_error(e, target)
                if full:
                    raise full from e
                self.fail(drawing, "output", f"{target}: cannot be written: {e.strerror}", files, answer["seconds"])
                return True
        self.note(drawing, {"files": files, "outputs": outputs, "diagnostics": answer["diagnostics"], "seconds": answer["seconds"]})
        self.results.append(Result(drawing.name, "drawn", answer["seconds"], sum(n for n, _ in outputs.values())))
        return True

    def fail(self, drawing: Drawing, kind: str, message: str, files: dict[str, str | None], seconds: float = 0) -> None:
        """Notes a failure; outputs of an earlier drawing of the same name are gone, they would be taken for this one."""
        for name in drawing.files():
            with contextlib.suppress(OSError):
                (self.state.out / name).unlink()
        error = {"kind": kind, "message": message}
        self.note(drawing, {"files": files, "error": error, "limits": self.settings.limits(), "seconds": seconds})
        self.results.append(Result(drawing.name, "failed", seconds, 0, kind, message))

    def note(self, drawing: Drawing, what: dict[str, Any]) -> None:
        whose = {"id": drawing.id, "name": drawing.name, "part": self.job.part}
        self.state.write_record({**whose, "program": self.settings.program, "run": self.settings.run, **what})
        if self.settings.run:
            self.state.end(drawing.id)


def _asides(drawing: Drawing, number: int, aside: Path) -> list[Path]:
    return [aside / f"{number}-{k}{Path(name).suffix}" for k, name in enumerate(drawing.files())]


def _request(drawing: Drawing, number: int, aside: Path) -> dict[str, Any]:
    paths = [str(p) for p in _asides(drawing, number, aside)]
    count = len(drawing.outputs)
    return {"options": drawing.options, "outputs": paths[:count], "lists": paths[count:]}


def _without(message: str, drawing: Drawing, number: int, aside: Path) -> str:
    """The message with the names that the outputs would have had."""
    for path, name in zip(_asides(drawing, number, aside), drawing.files()):
        message = message.replace(str(path), name)
    return message
