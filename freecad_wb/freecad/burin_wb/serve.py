"""The worker process: jobs come on standard input, what they give goes to standard output (messages.py). Started by its
path, by any Python of FreeCAD's version that finds numpy; there is no FreeCAD in it."""

import importlib
import os
import sys
import threading
import traceback
import types

# The package is where this file lies, and this file's folder, which Python looks into first, holds no modules of others.
_here = os.path.dirname(os.path.abspath(__file__))
sys.path[:] = [p for p in sys.path if os.path.abspath(p or ".") != _here]
sys.path.insert(0, os.path.normpath(os.path.join(_here, "../..")))

# Debian's FreeCAD 1.0 has a package `freecad` on Python's path that imports all of FreeCAD and prints: standard output
# is for messages. Its name leads to this folder alone.
_package = types.ModuleType("freecad")
_package.__path__ = [os.path.dirname(_here)]
sys.modules["freecad"] = _package

from freecad.burin_wb.errors import KernelMissing  # noqa: E402
from freecad.burin_wb.job import answer  # noqa: E402
from freecad.burin_wb.kept_scene import KeptScene  # noqa: E402
from freecad.burin_wb.load import load  # noqa: E402
from freecad.burin_wb.messages import receive, send  # noqa: E402


class Jobs:
    """What comes on standard input, heard in a thread of its own: jobs in order, and the end of the one under way."""

    def __init__(self, source, burin):
        self._source, self._burin = source, burin
        self._ready = threading.Condition()
        self._jobs, self._closed = [], False
        self._cancel = self._number = None
        threading.Thread(target=self._listen, daemon=True).start()

    def next(self):
        """What to do, the job and its Cancel; nothing where the other side is gone."""
        with self._ready:
            while not self._jobs and not self._closed:
                self._ready.wait()
            if self._closed:
                return None
            what, _, job = self._jobs.pop(0)
            return what, job, self._cancel

    def _listen(self):
        try:
            while self._hear(receive(self._source)):
                pass
        except BaseException:  # nobody would hear of the jobs to come
            traceback.print_exc()
            sys.stderr.flush()
            os._exit(1)

    def _hear(self, message):
        """Whether there may be more."""
        with self._ready:
            if message is None:
                self._closed = True
            elif message[0] != "cancel":
                self._jobs.append(message)
                self._cancel, self._number = self._burin.Cancel(), message[1]
            # A cancel may come after the end of its job: not to the next one.
            if self._cancel is not None and (message is None or message[:2] == ("cancel", self._number)):
                self._cancel.cancel()
            self._ready.notify()
        return message is not None


def _find_numpy():
    """This interpreter's own, else that of the side that asks. Throws ImportError."""
    try:
        import numpy  # noqa: F401
    except ImportError:
        folder = os.environ.get("BURIN_WORKER_NUMPY")
        if not folder:
            raise
        sys.path.append(folder)
        importlib.invalidate_caches()
        import numpy  # noqa: F401


def serve():
    source, sink = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print does not end up between the messages
    try:
        _find_numpy()
        burin = load([p for p in os.environ["BURIN_WORKER_FOLDERS"].split(os.pathsep) if p])
    except ImportError as error:
        send(sink, ("unfit", f"it has no numpy ({error})"))
        return
    except KernelMissing as error:
        send(sink, ("unfit", f"it cannot load the drawing kernel ({error.__cause__})"))
        return
    send(sink, ("ready",))
    jobs, kept = Jobs(source, burin), KeptScene(burin)
    while True:
        asked = jobs.next()
        if asked is None:
            return
        what, job, cancel = asked
        send(sink, answer(what, job, burin, lambda stage, share: send(sink, ("progress", stage, share)), cancel, kept))


if __name__ == "__main__":
    try:
        serve()
    finally:
        sys.stderr.flush()
        os._exit(0)  # the listening thread holds standard input
