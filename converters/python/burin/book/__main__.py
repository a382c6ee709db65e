"""`burin book`, also as `python3 -m burin.book`."""

import sys

if not __package__:
    # As for burin batch: the package around this folder loads the kernel, which a book has no use for.
    import pathlib
    import types

    _around = types.ModuleType("burin")
    _around.__path__ = [str(pathlib.Path(__file__).resolve().parent.parent)]
    sys.modules["burin"] = _around
    sys.path.pop(0)

if sys.version_info < (3, 11):
    sys.exit("burin: error: burin book needs Python 3.11 or later; BURIN_PYTHON=/path/to/python3 names one")

from burin.book.command import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
