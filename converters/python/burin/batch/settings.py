"""What holds for all jobs of a run, of what was asked and what the catalogue says."""

import os
import shutil
from pathlib import Path
from typing import Any

from .child import program_version
from .errors import USAGE, BatchError
from .jobs import Batch
from .limits import TIMEOUT, memory_bytes, seconds
from .work import Settings


# In a wheel, whose script need not be on PATH.
_OWN = Path(__file__).resolve().parents[1] / "bin" / "burin"


def command_of(asked: str | None) -> str:
    """The program that draws. Throws BatchError where there is none."""
    found = shutil.which(asked or os.environ.get("BURIN_COMMAND") or "burin") or (None if asked else shutil.which(str(_OWN)))
    if not found:
        raise BatchError(f"{asked or 'burin'} is no command; --burin names it")
    return os.path.abspath(found)


def settings_of(arguments: Any, batch: Batch) -> Settings:
    """What holds for all jobs; options before what the catalogue says. Throws BatchError."""
    command = command_of(arguments.burin)
    program = program_version(command)
    if program != batch.program:
        raise BatchError(f"{arguments.jobs_file}: was planned by burin {batch.program}, this is {program}; plan it again")
    limits = {**batch.limits, **{k: v for k in ("timeout", "memory") if (v := getattr(arguments, k)) is not None}}
    memory = limits.get("memory")
    if arguments.threads < 1:
        raise BatchError(f"option --threads takes a number from 1, not {arguments.threads}", USAGE)
    return Settings(
        base=str(batch.base),
        out=str(batch.out),
        command=command,
        program=program,
        timeout=seconds(limits.get("timeout", TIMEOUT), "option --timeout"),
        memory=memory_bytes(str(memory), "option --memory") if memory is not None else None,
        threads=arguments.threads,
        again=arguments.again,
    )
