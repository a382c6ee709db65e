"""`burin batch`, also as `python3 -m burin.batch`."""

import sys

if not __package__:
    # The command runs this folder. The package around it loads the kernel and numpy, which a batch has no use for: it is
    # stood for by one that has this folder alone.
    import pathlib
    import types

    _around = types.ModuleType("burin")
    _around.__path__ = [str(pathlib.Path(__file__).resolve().parent.parent)]
    sys.modules["burin"] = _around
    sys.path.pop(0)

if sys.version_info < (3, 11):
    sys.exit("burin: error: burin batch needs Python 3.11 or later; BURIN_PYTHON=/path/to/python3 names one")

from burin.batch.command import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
