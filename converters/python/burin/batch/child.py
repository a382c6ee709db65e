"""One process of `burin batch job`, with limits of time and memory."""

import contextlib
import json
import os
import resource
import selectors
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .errors import BatchError
from .jobs import Drawing
from .limits import memory_text

# Seconds between looks at memory and at a cancel.
_LOOK = 0.05
# So much later a signal to all processes of a run has reached this one.
_SOON = 1.0
# How a process ends that was asked to from outside: 5 is the status of a cancelled burin.
_FROM_OUTSIDE = {5, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP, -signal.SIGKILL}
_PAGE = os.sysconf("SC_PAGE_SIZE")


class Cancelled(Exception):
    """The run was ended while the process was at work."""


class Ended(Exception):
    """The process ended, or was ended, before its work was done: the kind of failure, and words."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind, self.message = kind, message


class Child:
    """A process in a group of its own, that gets a request and answers in lines of JSON. It is gone after `close`.

    `memory` bounds the writable private memory of each process (RLIMIT_DATA, which the system keeps) and, looked at
    every 50 ms, what it and the processes that it starts hold resident together.
    """

    def __init__(self, command: str, request: dict[str, Any], folder: Path, memory: int | None, cancelled: Callable[[], bool]) -> None:
        self._memory, self._cancelled = memory, cancelled
        self._said = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                [command, "batch", "job"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._said,
                cwd=folder,
                start_new_session=True,
            )
        except OSError as e:
            self._said.close()
            raise BatchError(f"{command} cannot be started: {e.strerror}; --burin names the command") from e
        assert self._process.stdin and self._process.stdout
        self._selector = selectors.DefaultSelector()
        self._selector.register(self._process.stdout, selectors.EVENT_READ)
        self._bytes = b""
        self.allow(None)
        # It waits for its request, so that the limits hold before it does anything. Without a word after the fork no
        # thread of ours can be in its way.
        with contextlib.suppress(ProcessLookupError):
            resource.prlimit(self._process.pid, resource.RLIMIT_CORE, (0, 0))
            if memory:
                resource.prlimit(self._process.pid, resource.RLIMIT_DATA, (memory, memory))
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write(json.dumps(request).encode())
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.close()

    def close(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._selector.close()
        assert self._process.stdout
        self._process.stdout.close()
        self._said.close()

    def __enter__(self) -> "Child":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def allow(self, seconds: float | None) -> None:
        """So many seconds from now all answers must have come, or another `allow`; None: no end."""
        self._timeout = seconds
        self._end = time.monotonic() + seconds if seconds else None

    def answer(self) -> dict[str, Any]:
        """The next line. Throws Ended where none comes in time or at all; Cancelled."""
        while b"\n" not in self._bytes:
            if self._selector.select(_LOOK):
                assert self._process.stdout
                more = os.read(self._process.stdout.fileno(), 1 << 16)
                if not more:
                    raise self._ended()
                self._bytes += more
                continue
            if self._cancelled():
                raise Cancelled
            if self._memory and _resident(self._process.pid) > self._memory:
                raise Ended("memory", f"needs more than {memory_text(self._memory)} of memory; allow more (--memory) or draw less")
            if self._end and time.monotonic() > self._end:
                raise _too_long(self._timeout)
        line, self._bytes = self._bytes.split(b"\n", 1)
        try:
            value = json.loads(line)
        except ValueError:
            value = None
        if not isinstance(value, dict):
            raise Ended("crash", f"answered {line[:80]!r}, which is no answer")
        return value

    def _ended(self) -> Ended:
        status = self._process.wait()
        self._said.seek(0, os.SEEK_END)
        self._said.seek(max(0, self._said.tell() - 2000))
        lines = [line for line in self._said.read().decode(errors="replace").split("\n") if line.strip()]
        last = f": {lines[-1]}" if lines else ""
        if self._memory and any(sign in last for sign in ("bad_alloc", "MemoryError")):
            return Ended("memory", f"needs more than {memory_text(self._memory)} of memory; allow more (--memory) or draw less")
        if status in _FROM_OUTSIDE:
            self._wait_for_cancel()
        if status >= 0:
            kind = "killed" if status in _FROM_OUTSIDE else "crash"
            return Ended(kind, f"ended with status {status} before it was done{last}")
        name = signal.Signals(-status).name if -status in signal.valid_signals() else f"signal {-status}"
        if -status == signal.SIGKILL:
            return Ended("killed", f"was ended by {name}; perhaps this machine's memory ran out{last}")
        return Ended("killed" if status in _FROM_OUTSIDE else "crash", f"was ended by {name}{last}")

    def _wait_for_cancel(self) -> None:
        """Who ends a whole run, such as Slurm, may end its processes one after the other: ours comes, too."""
        end = time.monotonic() + _SOON
        while time.monotonic() < end:
            if self._cancelled():
                raise Cancelled
            time.sleep(_LOOK)


def _resident(pid: int) -> int:
    """Bytes that a process and those below it hold."""
    try:
        with open(f"/proc/{pid}/statm", encoding="ascii") as file:
            total = int(file.read().split()[1]) * _PAGE
        with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as file:
            below = [int(word) for word in file.read().split()]
    except (OSError, IndexError, ValueError):
        return 0
    return total + sum(_resident(child) for child in below)


def run_to_end(
    words: list[str], folder: Path, timeout: float | None, cancelled: Callable[[], bool], env: dict[str, str] | None = None
) -> tuple[int, str, str]:
    """Exit status, output and errors of a program, which gets no input. Its group is gone afterwards. Throws Ended where it
    takes longer than so many seconds, Cancelled, OSError where it cannot be started."""
    process = subprocess.Popen(
        words,
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        errors="replace",
        env=env,
        start_new_session=True,
    )
    end = time.monotonic() + timeout if timeout else None
    try:
        while True:
            with contextlib.suppress(subprocess.TimeoutExpired):
                said, errors = process.communicate(timeout=_LOOK)
                return process.returncode, said, errors
            if cancelled():
                raise Cancelled
            if end and time.monotonic() > end:
                raise _too_long(timeout)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def _too_long(seconds: float | None) -> Ended:
    return Ended("timeout", f"takes longer than {seconds:g} s; allow more (--timeout) or draw less")


def program_version(command: str) -> str:
    """The version of the command. Throws BatchError where it does not start."""
    try:
        run = subprocess.run([command, "--version"], capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired) as e:
        raise BatchError(f"{command} cannot be started ({e}); --burin names the command") from e
    words = run.stdout.partition("\n")[0].split()
    if run.returncode != 0 or len(words) != 2 or words[0] != "burin":
        raise BatchError(f"{command} is no burin; --burin names the command")
    return words[1]


def check_drawings(command: str, base: Path, drawings: list[Drawing]) -> list[str]:
    """What is wrong with the options and output names of each drawing; empty where nothing is."""
    request = {
        "inputs": [],
        "check": True,
        "drawings": [{"options": d.options, "outputs": d.outputs, "lists": d.lists} for d in drawings],
    }
    found: list[str] = []
    with Child(command, request, base, None, lambda: False) as child:
        try:
            while "done" not in (answer := child.answer()):
                if "seconds" in answer:
                    found.append(str(answer.get("error", {}).get("message", "")))
        except Ended as e:
            raise BatchError(f"{command}: {e.message}") from e
    return found
