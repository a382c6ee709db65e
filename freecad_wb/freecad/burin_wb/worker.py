"""The kernel in a process of its own: a crash there leaves FreeCAD and the document alive.

Run as a script it is the worker: jobs come pickled on standard input, messages go pickled to standard output,
each behind its length as eight bytes. Imported it is the side that asks."""

import os
import pickle
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import traceback

HEAD = struct.Struct("<Q")

# Seconds that a worker gets to end a cancelled job before it is ended itself.
PATIENCE = 0.08


class Failed(Exception):
    """The run failed; the text is for the user."""


class Stopped(Exception):
    """The run was cancelled."""


def _send(stream, message):
    data = pickle.dumps(message, protocol=4)
    stream.write(HEAD.pack(len(data)))
    stream.write(data)
    stream.flush()


def _receive(stream):
    """The next message; nothing where the other side is gone."""
    head = stream.read(HEAD.size)
    if len(head) < HEAD.size:
        return None
    size = HEAD.unpack(head)[0]
    data = stream.read(size)
    return pickle.loads(data) if len(data) == size else None


# --- the side that asks ---------------------------------------------------------------------------


def interpreter():
    """A Python of this version that can be started by itself; nothing where there is none."""
    from . import preferences

    named = preferences.python() or os.environ.get("BURIN_PYTHON", "")
    version = "python%d.%d" % sys.version_info[:2]
    for candidate in (named, "/usr/bin/" + version, shutil.which(version), sys._base_executable):
        if candidate and os.path.basename(candidate).startswith("python") and os.access(candidate, os.X_OK):
            return candidate
    return None


class Worker:
    """One worker process; keeps running from job to job. For one thread at a time, except `cancel`."""

    _told = False  # that there is no process of its own; once a session

    def __init__(self):
        self._process = None
        self._log = None
        self._lock = threading.Lock()
        self._sending = threading.Lock()
        self._here = None  # the Cancel of a run in this process
        self._running = None  # stands for the run under way
        self._cancelled = False  # whether that is to end

    def start(self):
        """Starts the process ahead of the first job. Whether there is one: without an interpreter that can be
        started by itself, or where the system lets none start, jobs run in this process."""
        with self._lock:
            if self._process is not None and self._process.poll() is None:
                return True
            self._forget()
            python = interpreter()
            try:
                if python is not None:
                    self._launch(python)
                    return True
                why = "no Python interpreter was found; set BURIN_PYTHON to one"
            except OSError as error:
                why = f"{python}: {error.strerror}"
        if not Worker._told:
            Worker._told = True
            print(f"Burin: drawing inside FreeCAD itself, not in a process of its own ({why})", file=sys.stderr)
        return False

    def draw(self, job, progress=None):
        """Runs a job to its end. Returns a job.Result. `progress(stage, share)` is called from this thread.
        Throws Failed or Stopped."""
        with self._lock:
            self._cancelled, self._running = False, object()
        try:
            if not self.start():
                return self._draw_here(job, progress)
            return self._draw_there(job, progress)
        finally:
            with self._lock:
                self._running = None

    def _draw_there(self, job, progress):
        process, log = self._process, self._log
        try:
            with self._sending:
                if self._cancelled:
                    raise Stopped()
                _send(process.stdin, ("draw", job))
            while True:
                message = _receive(process.stdout)
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
            raise Failed(words) from error

    def _draw_here(self, job, progress):
        from . import kernel

        try:
            burin = kernel.module()
        except kernel.KernelMissing as error:
            raise Failed(str(error)) from error
        self._here = burin.Cancel()
        if self._cancelled:
            self._here.cancel()
        try:
            return job.run(burin, progress, self._here)
        except burin.Cancelled:
            raise Stopped() from None
        except burin.Error as error:
            raise Failed(str(error)) from error
        finally:
            self._here = None

    def cancel(self):
        """Ends the job under way; may be called from any thread. A process that does not end its job within PATIENCE
        seconds is ended itself. Takes as long as a job takes to be sent."""
        run, here, process = self._running, self._here, self._process
        if run is None:
            return
        self._cancelled = True
        if here is not None:
            here.cancel()
        elif process is not None and process.poll() is None:
            try:
                with self._sending:
                    _send(process.stdin, ("cancel",))
            except (OSError, ValueError):
                pass
            timer = threading.Timer(PATIENCE, self._lose_patience, (run,))
            timer.daemon = True
            timer.start()

    def _lose_patience(self, run):
        with self._lock:
            if self._running is run:
                self._kill()

    def stop(self):
        """Ends the process, whatever it does."""
        with self._lock:
            self._kill()

    def _kill(self):
        """With the lock held."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()

    def _launch(self, python):
        from . import kernel

        environment = dict(os.environ)
        environment["BURIN_WORKER_FOLDERS"] = os.pathsep.join(kernel.folders())
        for name in ("PYTHONHOME", "LD_PRELOAD"):
            environment.pop(name, None)
        self._log = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            [python, os.path.abspath(__file__)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=self._log, env=environment, start_new_session=True)

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

    @staticmethod
    def _last_words(process, log):
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
        tail = ": " + said[-1] if said else ""
        return f"the drawing kernel ended unexpectedly ({why}){tail}; the document is as it was, the next run starts it anew"


# --- the worker -----------------------------------------------------------------------------------


def _serve():
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [p for p in sys.path if os.path.abspath(p or ".") != here]
    sys.path.insert(0, os.path.normpath(os.path.join(here, "../..")))
    source, sink = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print does not end up between the messages
    from freecad.burin_wb import kernel  # noqa: E402

    try:
        burin = kernel.module()
    except kernel.KernelMissing as error:
        _receive(source)
        _send(sink, ("failed", str(error)))
        return
    state = {"cancel": None, "jobs": [], "closed": False}
    ready = threading.Condition()

    def listen():
        try:
            hear()
        except BaseException:  # nobody would hear of the jobs to come
            traceback.print_exc()
            sys.stderr.flush()
            os._exit(1)

    def hear():
        while True:
            message = _receive(source)
            with ready:
                if message is None:
                    state["closed"] = True
                if message is None or message[0] == "cancel":
                    if state["cancel"] is not None:
                        state["cancel"].cancel()
                else:
                    state["jobs"].append(message[1])
                    state["cancel"] = burin.Cancel()
                ready.notify()
            if message is None:
                return

    threading.Thread(target=listen, daemon=True).start()
    while True:
        with ready:
            while not state["jobs"] and not state["closed"]:
                ready.wait()
            if state["closed"]:
                return
            job, cancel = state["jobs"].pop(0), state["cancel"]
        try:
            result = job.run(burin, lambda stage, share: _send(sink, ("progress", stage, share)), cancel)
            _send(sink, ("done", result))
        except burin.Cancelled:
            _send(sink, ("cancelled",))
        except burin.Error as error:
            _send(sink, ("failed", str(error)))
        except Exception as error:  # a mistake of ours: told, and the worker lives on
            traceback.print_exc()
            _send(sink, ("failed", f"the drawing kernel failed: {error!r}"))


if __name__ == "__main__":
    try:
        _serve()
    finally:
        sys.stderr.flush()
        os._exit(0)  # the listening thread holds standard input
