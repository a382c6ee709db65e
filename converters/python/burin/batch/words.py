"""What the commands that are written in Python share: their parser, and how they end."""

import argparse
import contextlib
import os
import signal
import sys
from collections.abc import Callable
from typing import NoReturn

from .child import Cancelled
from .errors import NO_OUTPUT, STOPPED, USAGE, BatchError


class Parser(argparse.ArgumentParser):
    """Throws BatchError for words that it does not take."""

    def error(self, message: str) -> NoReturn:
        raise BatchError(f"{message} (see {self.prog} --help)", USAGE)


def _interrupt(*_: object) -> None:
    raise KeyboardInterrupt


def exit_status(work: Callable[[], int]) -> int:
    """The exit status of `work`. What goes wrong is one line; signals that end it are as Ctrl-C."""
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _interrupt)
    try:
        status = work()
        sys.stdout.flush()
        return status
    except BatchError as e:
        print(f"burin: error: {e}", file=sys.stderr)
        return e.status
    except (KeyboardInterrupt, Cancelled):
        print("burin: error: cancelled", file=sys.stderr)
        return STOPPED
    except BrokenPipeError:
        with contextlib.suppress(OSError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        return NO_OUTPUT
