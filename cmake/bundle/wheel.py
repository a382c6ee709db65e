#!/usr/bin/env python3
"""wheel.py BUILD [TAG]: BUILD/burin-VERSION-cpXY-cpXY-manylinux_2_N_PROCESSOR.whl for this Python, or for that of TAG (cp313, whose
headers the build has), with the libraries of others that the module needs. 2.N is the glibc that the files inside need at least. The same build gives the same bytes.

Needs what ./dev wheel installs: patchelf, cc, binutils, dpkg."""
import pathlib
import platform
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("cmake/bundle", "converters/python/tools")]
import pip_backend  # noqa: E402
from gather import compiled_in, elves, gather, notices, rename  # noqa: E402
from listing import listing  # noqa: E402
from manylinux import glibc  # noqa: E402

# The tag of the Python that runs this.
THIS = f"cp{sys.version_info[0]}{sys.version_info[1]}"


def make(build, tag=""):
    for old in build.glob(f"burin-*-{tag or THIS}-*manylinux*.whl"):
        old.unlink()
    with tempfile.TemporaryDirectory() as scratch:
        top = pathlib.Path(scratch)
        pip_backend.build(build, top, tag)
        files, packages, _ = gather(top, top / "burin")
        rename(top, files)
        info = top / pip_backend.info_folder()
        compiled = compiled_in(top)
        notices(info / "licences", {**packages, **compiled})
        (info / "sboms").mkdir()
        (info / "sboms/burin.spdx.json").write_text(listing(packages, compiled, "licences"), encoding="utf-8")
        name = pip_backend.pack(top, build, f"manylinux_2_{glibc(elves(top))}_{platform.machine()}", tag)
        size = sum(f.stat().st_size for f in top.rglob("*") if f.is_file())
    packed = build / name
    print(f"{packed}: {packed.stat().st_size / 1e6:.1f} MB packed, {size / 1e6:.0f} MB, {len(files)} libraries of {len(packages)} packages")


if not 2 <= len(sys.argv) <= 3:
    sys.exit(__doc__)
make(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:])
