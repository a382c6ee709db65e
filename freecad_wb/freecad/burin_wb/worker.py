"""The kernel in a process of its own (serve.py): a crash there leaves FreeCAD and the document alive."""

import importlib.util
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import threading

from . import kernel, preferences
from .errors import Crashed, Failed, KernelMissing, Stopped
from .job import UNCHANGED, answer
from .messages import ignore_broken_pipes, receive, send

ignore_broken_pipes()

# Seconds that a process gets to end a cancelled job before it is ended itself: one that has the job, and one that still
# starts.
PATIENCE, PATIENCE_AT_START = 0.08, 1.0

# Seconds that a program gets to say that it can be a worker: importing numpy and the kernel takes 0.3.
HELLO = 30.0

_PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "serve.py")


def interpreters():
    """Programs that may be a Python of this version, the likeliest first: the one that the user names, the one that
    FreeCAD brings (AppImage, Windows), the system's. Whether one can be a worker it says itself when it is started."""
    named = preferences.python() or os.environ.get("BURIN_PYTHON", "")
    version = "python%d.%d" % sys.version_info[:2]
    own = [os.path.join(folder, name) for folder in (sys.prefix, sys.exec_prefix, os.path.dirname(sys.executable or ""))
           for name in (os.path.join("bin", version), version, "python.exe")]
    found = []
    for candidate in (named, *own, sys._base_executable, "/usr/bin/" + version, shutil.which(version)):
        if candidate and candidate not in found and os.path.basename(candidate).startswith("python") \
                and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            found.append(candidate)
    return found


def _numpy_folder():
    """Where this process has numpy, for an interpreter of the same version that has none of its own."""
    spec = importlib.util.find_spec("numpy")
    return os.path.dirname(os.path.dirname(spec.origin)) if spec is not None and spec.origin else ""


class Worker:
    """One worker process; keeps running from job to job. For one thread at a time, except `cancel`."""

    _told = False  # that there is no process of its own; once a session
    _unfit = {}  # programs that turned out to be no workers, and why

    def __init__(self):
        self._process = None
        self._log = None
        self._lock = threading.Lock()  # of what follows; never held for long
        self._starting = threading.Lock()
        self._sending = threading.Lock()
        self._ended = None  # the process that this side ended
        self._here = None  # the Cancel of a run in this process
        self._running = None  # stands for the run under way: its number
        self._cancelled = False  # whether that is to end
        self._sent = False  # whether the process has it
        self._number = 0

    def start(self):
        """Starts the process ahead of the first job, and waits until it can take one. Whether there is one: where no
        interpreter can be a worker, jobs run in this process. Throws Stopped where it is ended meanwhile."""
        with self._starting:
            if self._process is not None and self._process.poll() is None:
                return True
            with self._lock:
                self._forget()
            for python in interpreters():
                if python in Worker._unfit:
                    continue
                why = self._launch(python)
                if why is None:
                    return True
                Worker._unfit[python] = why
            whys = "; ".join(f"{python}: {why}" for python, why in Worker._unfit.items())
        if not Worker._told:
            Worker._told = True
            print("Burin: drawing inside FreeCAD itself, not in a process of its own "
                  f"({whys or 'no Python interpreter was found'}; set BURIN_PYTHON to one)", file=sys.stderr)
        return False

    def draw(self, job, progress=None, wanted=lambda: True):
        """Runs a job to its end. Returns a job.Result."""
        return self.do("draw", job, progress, wanted)

    def do(self, what, job, progress=None, wanted=lambda: True):
        """What `job.answer` gives. `progress(stage, share)` is called from this thread. `wanted()` is
        asked as soon as `cancel` is of effect: whether the job was not cancelled before. Throws Failed or Stopped."""
        if not kernel.found():
            if what == "draw" and job.is_drawn():
                return UNCHANGED
            raise Failed(kernel.why_missing())
        with self._lock:
            self._number += 1
            self._cancelled, self._sent, self._running = False, False, self._number
        try:
            if not wanted():
                raise Stopped()
            if not self.start():
                return self._do_here(what, job, progress)
            try:
                return self._ask(what, job, progress)
            except Crashed as crash:
                raise Failed(str(crash) + self._faults(job, progress)) from crash
        finally:
            with self._lock:
                self._running = None

    def _faults(self, job, progress):
        """After a crash: another process looks which shapes are faulty; if it crashes too, so be it."""
        try:
            return self._ask("check", job, progress) if self.start() else ""
        except Failed:
            return ""

    def _ask(self, what, job, progress):
        process, log = self._process, self._log
        try:
            with self._sending:
                if self._cancelled:
                    raise Stopped()
                self._sent = True
                send(process.stdin, (what, self._running, job))
            while True:
                message = receive(process.stdout)
                if message is None:
                    raise EOFError
                kind, *rest = message
                if kind == "progress":
                    if progress is not None:
                        progress(*rest)
                elif kind == "done":
                    return rest[0]
                elif kind == "cancelled":
                    raise Stopped()
                else:
                    raise Failed(rest[0])
        except (OSError, ValueError, EOFError, pickle.UnpicklingError) as error:
            words = self._last_words(process, log)
            if self._cancelled:
                self.start()  # the next run is not to wait for it
                raise Stopped() from error
            raise Crashed(words) from error

    def _do_here(self, what, job, progress):
        try:
            burin = kernel.module()
        except KernelMissing as error:
            raise Failed(str(error)) from error
        self._here = burin.Cancel()
        if self._cancelled:
            self._here.cancel()
        try:
            kind, given = answer(what, job, burin, progress, self._here)
        finally:
            self._here = None
        if kind == "cancelled":
            raise Stopped()
        if kind == "failed":
            raise Failed(given)
        return given

    def cancel(self):
        """Ends the job under way; may be called from any thread, and returns at once. A process that does not end its
        job in time is ended itself."""
        run, here, process = self._running, self._here, self._process
        if run is None:
            return
        self._cancelled = True
        if here is not None:
            here.cancel()
            return
        if process is not None:
            # A process that hangs takes nothing: who writes to it waits.
            threading.Thread(target=self._ask_to_end, args=(process, run), daemon=True).start()
        for seconds, has_it in ((PATIENCE, True), (PATIENCE_AT_START, False)):
            timer = threading.Timer(seconds, self._lose_patience, (run, has_it))
            timer.daemon = True
            timer.start()

    def _ask_to_end(self, process, run):
        try:
            with self._sending:
                send(process.stdin, ("cancel", run))
        except (OSError, ValueError):
            pass

    def _lose_patience(self, run, has_it):
        """Ends the process where the run is still under way, and the process has its job or has it not yet."""
        with self._lock:
            if self._running == run and self._sent == has_it:
                self._kill()

    def stop(self):
        """Ends the process, whatever it does."""
        with self._lock:
            self._kill()

    def _kill(self):
        """With the lock held."""
        if self._process is not None:
            self._ended = self._process
            self._process.kill()
            try:
                self._process.wait(2)
            except subprocess.TimeoutExpired:  # it is gone as soon as the system gets to it
                pass

    def _launch(self, python):
        """Starts a program and waits for its hello. Nothing where it is a worker now, else why it is none."""
        environment = dict(os.environ)
        environment["BURIN_WORKER_FOLDERS"] = os.pathsep.join(kernel.folders())
        environment["BURIN_WORKER_NUMPY"] = _numpy_folder()
        for name in ("PYTHONHOME", "LD_PRELOAD"):
            environment.pop(name, None)
        log = tempfile.TemporaryFile()
        try:
            process = subprocess.Popen(
                [python, _PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=log, env=environment, start_new_session=True)
        except OSError as error:
            log.close()
            return error.strerror
        with self._lock:
            self._process, self._log = process, log
        alarm = threading.Timer(HELLO, process.kill)
        alarm.daemon = True
        alarm.start()
        try:
            message = receive(process.stdout)
        except (OSError, ValueError, MemoryError, pickle.UnpicklingError):
            message = None
        late = not alarm.is_alive()
        alarm.cancel()
        if message == ("ready",):
            return None
        if self._ended is process:
            raise Stopped()
        process.kill()
        why = message[1] if message else "gave no answer for %g s" % HELLO if late else self._said(process, log)
        with self._lock:
            self._forget()
        return why

    def _forget(self):
        """With the lock held: closes what an ended process left."""
        if self._process is None:
            return
        for stream in (self._process.stdin, self._process.stdout, self._log):
            try:
                stream.close()
            except OSError:
                pass
        self._process = None

    def _last_words(self, process, log):
        said = self._said(process, log)
        return f"the drawing kernel ended unexpectedly ({said}); the document is unchanged, the next run starts the kernel again"

    @staticmethod
    def _said(process, log):
        """How a process ended, and the last that it said."""
        try:
            status = process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            process.kill()
            status = process.wait()
        try:
            log.seek(0)
            said = log.read().decode(errors="replace").strip().splitlines()
        except (OSError, ValueError):
            said = []
        why = "signal %d" % -status if status < 0 else "status %d" % status
        return why + (": " + said[-1] if said else "")
