"""What FreeCAD and the worker process say to each other: pickled tuples, each behind its length as eight bytes."""

import pickle
import struct

_HEAD = struct.Struct("<Q")


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
