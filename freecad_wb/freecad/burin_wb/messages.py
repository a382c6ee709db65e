"""What FreeCAD and the worker process say to each other: pickled tuples, each behind its length as eight bytes."""

import pickle
import signal
import struct

_HEAD = struct.Struct("<Q")


def ignore_broken_pipes():
    """Has writing to a process that is gone raise BrokenPipeError. FreeCAD 1.0 and 1.1 start Python without its signal
    handlers, so that it would end FreeCAD. Only the main thread may do so; others leave it."""
    if not hasattr(signal, "SIGPIPE") or signal.getsignal(signal.SIGPIPE) is not signal.SIG_DFL:
        return
    try:
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    except ValueError:
        pass


def send(stream, message):
    data = pickle.dumps(message, protocol=4)
    stream.write(_HEAD.pack(len(data)))
    stream.write(data)
    stream.flush()


def receive(stream):
    """The next message; nothing where the other side is gone."""
    head = stream.read(_HEAD.size)
    if len(head) < _HEAD.size:
        return None
    size = _HEAD.unpack(head)[0]
    data = stream.read(size)
    return pickle.loads(data) if len(data) == size else None
