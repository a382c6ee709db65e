"""Jobs on the workers of a Dask scheduler, which need the command `burin` and the same folders, no package of ours."""

import collections
import concurrent.futures
import contextlib
import dataclasses
import logging
import queue
import socket
import sys
import time
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .errors import FAILED, USAGE, BatchError, StopRun
from .jobs import Drawing, Job
from .progress import Progress
from .work import Result, Settings, give_up, run_job

# A task costs 2 to 3 ms at the scheduler: short jobs are packed to so many seconds, and no more than so many.
_PACKED, _MOST = 0.5, 32
# Tasks that wait at a worker beyond those that it is at, so that it is never idle, where tasks are short; long ones wait here:
# the scheduler gives them out before it knows how long they are, and in the end one worker would wait for another.
_AHEAD = 2
# So often a job is given out. Those that end their workers are found by their marks before; the scheduler also suspects
# what only waited at a worker that died.
_TRIES = 4
# Seconds between looks at the scheduler, and without it until it counts as lost.
_LOOK, _LOST = 1.0, 5.0


class _Shipped:
    """A function that travels by value: workers import nothing of ours."""

    def __init__(self, function: Callable[..., Any]) -> None:
        import cloudpickle  # type: ignore[import]

        package = sys.modules[__package__]
        cloudpickle.register_pickle_by_value(package)
        try:
            self._function, self._bytes = function, cloudpickle.dumps(function)
        finally:
            cloudpickle.unregister_pickle_by_value(package)

    def __call__(self, *arguments: Any) -> Any:
        return self._function(*arguments)

    def __reduce__(self) -> Any:
        import cloudpickle

        return cloudpickle.loads, (self._bytes,)


def _task(settings: dict[str, Any], jobs: list[dict[str, Any]]) -> dict[str, Any]:
    """In a worker. Plain values alone travel: for exceptions of ours the other side would need our package."""
    results: list[Result] = []
    try:
        if not Path(settings["base"]).is_dir():
            raise StopRun(f"there is no folder {settings['base']} on {socket.gethostname()}; workers need the folders of the catalogue")
        for job in jobs:
            drawings = [Drawing(**d) for d in job["drawings"]]
            results += run_job(Settings(**settings), Job(job["part"], job["inputs"], drawings))
        # Not dataclasses.asdict: classes that came by value have lost what it knows fields by.
        return {"results": [dict(vars(r)) for r in results]}
    except BatchError as e:
        return {"stop": f"{e} (on {socket.gethostname()})", "status": e.status}


def _client(address: str) -> Any:
    """Throws BatchError where there is no Dask, or no scheduler."""
    kind, _, place = address.partition("://")
    if kind != "dask" or ":" not in place:
        raise BatchError(f"option --on takes dask://HOST:PORT, not '{address}'", USAGE)
    try:
        from distributed import Client
    except ImportError as e:
        raise BatchError(f"burin batch run --on needs dask.distributed ({e}); install the package python3-distributed", FAILED) from e
    # What is lost is told by us, in one line; Dask, tornado and asyncio would add what their tasks threw.
    logging.disable(logging.CRITICAL)
    try:
        return Client(f"tcp://{place}", timeout=10, set_as_default=False)  # type: ignore[no-untyped-call]
    except (OSError, ValueError) as e:
        raise BatchError(f"no Dask scheduler answers at {place} ({e}); start it: dask-scheduler", FAILED) from e


class _Run:
    """One run: a bounded number of tasks at the scheduler, the rest here."""

    def __init__(self, client: Any, address: str, settings: Settings, jobs: list[Job], progress: Progress, patience: float) -> None:
        self.client, self.address, self.progress, self.patience = client, address, progress, patience
        self.settings = dataclasses.replace(settings, run=uuid.uuid4().hex)
        self.todo = collections.deque(jobs)
        self.tries: dict[int, int] = collections.Counter()
        self.flying: dict[str, tuple[Any, list[Job]]] = {}
        self.ended: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self.task = _Shipped(_task)
        self.room, self.pack, self.ahead = 1, 1, 0
        now = time.monotonic()
        self.looked, self.heard, self.staffed = 0.0, now, now

    def go(self) -> None:
        while self.todo or self.flying:
            self.look()
            while self.todo and len(self.flying) < self.room:
                # Towards the end packs get smaller, so that no worker waits for another.
                count = max(1, min(self.pack, len(self.todo) // (2 * self.room)))
                self.send([self.todo.popleft() for _ in range(count)])
            try:
                self.take(self.ended.get(timeout=0.2))
            except queue.Empty:
                self.progress.show()

    def look(self) -> None:
        """Asks the scheduler for its workers now and then. Throws BatchError where it, or all of them, are gone."""
        now = time.monotonic()
        if now - self.looked < _LOOK:
            return
        self.looked = now
        threads = 0
        if self.client.status == "running":
            with contextlib.suppress(Exception):  # lost while it is asked: `heard` tells
                info = self.client.sync(self.client.scheduler.identity, callback_timeout=_LOST)
                threads = sum(w["nthreads"] for w in info["workers"].values())
                self.heard = time.monotonic()
        flying = [job for _, jobs in self.flying.values() for job in jobs]
        left = sum(len(job.drawings) for job in [*self.todo, *flying])
        if now - self.heard > _LOST:
            raise BatchError(f"the Dask scheduler at {self.address} was lost; {left} drawings are left: start it, and run again", FAILED)
        if threads:
            self.staffed, self.room = now, threads * (1 + self.ahead)
        elif now - self.staffed > self.patience:
            words = f"the Dask scheduler at {self.address} has no worker; {left} drawings are left"
            raise BatchError(f"{words}: start dask-worker, and run again", FAILED)

    def send(self, jobs: list[Job]) -> None:
        key = f"burin-{uuid.uuid4().hex}"
        settings, values = dataclasses.asdict(self.settings), [dataclasses.asdict(job) for job in jobs]
        future = self.client.submit(self.task, settings, values, key=key, pure=False)
        self.flying[key] = (future, jobs)
        future.add_done_callback(self.ended.put)

    def take(self, future: Any) -> None:
        """What became of one task."""
        flown = self.flying.pop(future.key, None)
        if flown is None:
            return
        jobs = flown[1]
        if future.status != "finished":
            return self.try_again(jobs, future)
        try:
            answer = future.result(timeout=_LOST)
        except (OSError, TimeoutError, concurrent.futures.CancelledError):
            # The scheduler went while its answer was on the way. What was drawn has its record, and is not drawn again.
            return self.once_more(jobs, "the answer of its task was lost")
        if "stop" in answer:
            raise BatchError(answer["stop"], answer["status"])
        results = [Result(**r) for r in answer["results"]]
        self.progress.add(results)
        # What was done before takes no time: it says nothing of what is to come.
        if all(r.status == "drawn" for r in results):
            mean = sum(r.seconds for r in results) / len(jobs)
            self.pack = max(1, min(_MOST, int(_PACKED / max(mean, 1e-3))))
            self.ahead = _AHEAD if mean < _PACKED else 0

    def try_again(self, jobs: list[Job], future: Any) -> None:
        """A worker was lost with it, or the scheduler."""
        why = "its task was lost"
        if future.status == "error":
            try:
                error = future.exception(timeout=_LOST)
            except (OSError, TimeoutError, concurrent.futures.CancelledError):
                return self.once_more(jobs, why)
            if type(error).__name__ != "KilledWorker":
                raise BatchError(f"a Dask worker cannot draw: {type(error).__name__}: {error}; it needs the same Python as here", FAILED)
            why = "its workers died"
        elif self.client.status != "running":
            self.todo += jobs  # `look` tells
            return
        self.once_more(jobs, why)

    def once_more(self, jobs: list[Job], why: str) -> None:
        """So often a job is sent at the most."""
        self.pack = 1
        for job in jobs:
            self.tries[id(job)] += 1
            if self.tries[id(job)] < _TRIES:
                self.todo.append(job)
            else:
                self.progress.add(give_up(self.settings, job, f"{why} {_TRIES} times"))


def run_on_dask(address: str, settings: Settings, jobs: list[Job], progress: Progress, patience: float) -> None:
    """Runs jobs there. What workers have begun when the run is ended they draw to its end. Throws BatchError."""
    client = _client(address)
    run = _Run(client, address, settings, jobs, progress, patience)
    try:
        run.go()
    finally:
        with contextlib.suppress(Exception):
            client.cancel([future for future, _ in run.flying.values()], force=True)
        with contextlib.suppress(Exception):
            client.close(timeout=2)
