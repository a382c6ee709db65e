"""What ends a batch, in one line for the user, and the exit status that it means: those of `burin draw`."""

FAILED, USAGE, BAD_INPUT, NO_OUTPUT, STOPPED = 1, 2, 3, 4, 5


class BatchError(Exception):
    """One line that says what is wrong, where, and what to do."""

    def __init__(self, message: str, status: int = BAD_INPUT) -> None:
        super().__init__(" ".join(message.split("\n")))
        self.status = status


class StopRun(BatchError):
    """Ends the whole run, as all jobs that follow would fail, too: mostly since nothing more can be written."""

    def __init__(self, message: str) -> None:
        super().__init__(message, NO_OUTPUT)
