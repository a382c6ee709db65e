"""What a run says while it goes on: a bar on a terminal, else a line now and then."""

import sys
import time

from .work import Result

_OFTEN, _SELDOM = 0.2, 10.0


def duration(seconds: float) -> str:
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 100 * 60:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"


def printable(text: str) -> str:
    """One line, whatever a file's name holds."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


class Progress:
    """Counts what becomes of so many drawings."""

    def __init__(self, total: int, quiet: bool) -> None:
        self.total, self.quiet = total, quiet
        self.drawn = self.kept = self.failed = self.before = self.bytes = 0
        self.seconds = 0.0
        self._terminal = sys.stderr.isatty()
        self._start = self._last = time.monotonic()
        self._bar = False

    def add(self, results: list[Result]) -> None:
        for result in results:
            self.drawn += result.status == "drawn"
            self.kept += result.status == "kept"
            self.before += result.before
            self.failed += result.status == "failed"
            self.bytes += result.bytes
            self.seconds += result.seconds
            if result.status == "failed":
                words = "failed before (--again tries again)" if result.before else "failed"
                self.say(f"{words}: {printable(result.name)}: {result.kind}: {printable(result.message)}")
        self.show()

    def line(self) -> str:
        done = self.drawn + self.kept + self.failed
        words = f"{done} of {self.total} drawings"
        if self.kept:
            words += f", {self.kept} of them were done"
        if self.failed:
            words += f", {self.failed} failed"
        # What was done before costs next to nothing and tells nothing of the rest.
        anew = done - self.kept - self.before
        rate = anew / max(1e-9, time.monotonic() - self._start)
        if anew:
            words += f", {rate:.3g} a second"
            if done < self.total:
                words += f", {duration((self.total - done) / rate)} left"
        return words

    def show(self) -> None:
        """Tells how far it is, if it is time to."""
        now = time.monotonic()
        if self.quiet or now - self._last < (_OFTEN if self._terminal else _SELDOM):
            return
        self._last = now
        if not self._terminal:
            print(f"burin: batch: {self.line()}", file=sys.stderr, flush=True)
            return
        share = (self.drawn + self.kept + self.failed) / max(1, self.total)
        bar = "#" * round(20 * share)
        print(f"\r\x1b[K[{bar:20}] {self.line()}", end="", file=sys.stderr, flush=True)
        self._bar = True

    def clear(self) -> None:
        if self._bar:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
            self._bar = False

    def say(self, words: str) -> None:
        """A line of its own."""
        self.clear()
        print(f"burin: batch: {words}", file=sys.stderr, flush=True)

    def end(self) -> None:
        self.clear()
        if not self.quiet:
            self.say(f"{self.line()}; {self.seconds:.1f} s of drawing, {self.bytes} bytes")
