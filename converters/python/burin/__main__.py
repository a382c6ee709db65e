"""The command `burin` as `python3 -m burin`, and what the script `burin` of a wheel runs: the program takes the place of Python.

A wheel holds the program; in a build and in an installation it is where these have it."""

import os
import sys
from pathlib import Path

_HERE = Path(__file__).resolve().parent
# Of a wheel; of a build, beside python/burin; of a prefix, where this is lib/pythonX.Y/dist-packages/burin.
_PLACES = [_HERE / "bin", _HERE.parents[1] / "bin", _HERE.parents[3] / "bin"]


def main() -> None:
    """Does not return."""
    for program in [place / "burin" for place in _PLACES]:
        if os.access(program, os.X_OK):
            # What the program starts in Python (burin batch) is for this one.
            os.environ.setdefault("BURIN_PYTHON", sys.executable)
            os.execv(program, ["burin", *sys.argv[1:]])
    places = " and ".join(str(place) for place in _PLACES)
    sys.exit(f"burin: error: this package holds no command (looked in {places}); install the package burin")


if __name__ == "__main__":
    main()
