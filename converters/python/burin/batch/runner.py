"""Runs jobs: what all ways have in common, and the way on this machine."""

import collections
import contextlib
import queue
import threading
from collections.abc import Iterable
from pathlib import Path

from .child import Cancelled
from .jobs import Batch, Drawing, Job, shard_of
from .progress import Progress
from .work import Result, Settings, run_job


def chosen(jobs: list[Job], shard: tuple[int, int]) -> list[Job]:
    """The jobs of a shard, (number from 1, count)."""
    number, count = shard
    return [job for job in jobs if shard_of(job.id(), count) == number - 1]


def clashing(batch: Batch) -> dict[str, str]:
    """By name, the drawings that would write a file that another one writes, too: catalogues have none, but files of jobs may
    be put together by others."""
    owners: dict[str, list[tuple[Job, Drawing]]] = collections.defaultdict(list)
    for job, drawing in batch.drawings():
        for name in drawing.files():
            owners[name].append((job, drawing))
    words = {}
    for name, all in owners.items():
        if len(all) > 1:
            parts = " and ".join(job.part for job, _ in all)
            for _, drawing in all:
                words[drawing.name] = f"{name} is an output of two drawings ({parts}); name one of them otherwise"
    return words


def without_clashes(batch: Batch, jobs: list[Job]) -> tuple[list[Job], list[Result]]:
    """The jobs without the drawings that cannot be, and what became of those."""
    words = clashing(batch)
    results = [Result(d.name, "failed", 0, 0, "clash", words[d.name]) for j in jobs for d in j.drawings if d.name in words]
    left = [Job(j.part, j.inputs, [d for d in j.drawings if d.name not in words]) for j in jobs]
    return [j for j in left if j.drawings], results


def large_first(jobs: list[Job], base: Path) -> list[Job]:
    """In the order of what is likely to take long, by bytes of parts times drawings: a long job that begins last is waited for
    by all. Jobs alike stay in their order."""

    def cost(job: Job) -> int:
        size = 0
        for name in job.inputs:
            with contextlib.suppress(OSError):
                size += (base / name).stat().st_size
        return size * len(job.drawings)

    return sorted(jobs, key=cost, reverse=True)


class _Pool:
    def __init__(self, settings: Settings, jobs: Iterable[Job]) -> None:
        self.settings, self.jobs = settings, iter(jobs)
        self.lock = threading.Lock()
        self.stop = threading.Event()
        self.ended: queue.SimpleQueue[list[Result] | BaseException | None] = queue.SimpleQueue()

    def work(self) -> None:
        try:
            while not self.stop.is_set():
                with self.lock:
                    job = next(self.jobs, None)
                if job is None:
                    break
                self.ended.put(run_job(self.settings, job, self.stop.is_set))
        except Cancelled:
            pass
        except BaseException as e:
            self.stop.set()
            self.ended.put(e)
        finally:
            self.ended.put(None)


def run_here(settings: Settings, jobs: list[Job], count: int, progress: Progress) -> None:
    """So many jobs at once, each in a process of its own. Throws BatchError, KeyboardInterrupt; then none of them is left."""
    pool = _Pool(settings, jobs)
    threads = [threading.Thread(target=pool.work) for _ in range(min(count, len(jobs)))]
    for thread in threads:
        thread.start()
    error: BaseException | None = None
    left = len(threads)
    try:
        while left:
            try:
                ended = pool.ended.get(timeout=0.2)
            except queue.Empty:
                progress.show()
                continue
            if ended is None:
                left -= 1
            elif isinstance(ended, BaseException):
                error = error or ended
            else:
                progress.add(ended)
    finally:
        pool.stop.set()
        for thread in threads:
            thread.join()
    if error:
        raise error
