#!/usr/bin/env python3
"""wheel.py BUILD: BUILD/burin-VERSION-cpXY-cpXY-manylinux_2_N_PROCESSOR.whl for this Python, with the libraries of others that the
module needs. 2.N is the glibc that the files inside need at least. The same build gives the same bytes.

Needs what ./dev wheel installs: patchelf, cc, binutils, dpkg."""
import pathlib
import platform
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("cmake/bundle", "converters/python/tools")]
import pip_backend  # noqa: E402
from gather import elves, gather, notices, rename  # noqa: E402
from listing import listing  # noqa: E402
from manylinux import glibc  # noqa: E402


def make(build):
    for old in build.glob("burin-*manylinux*.whl"):
        old.unlink()
    with tempfile.TemporaryDirectory() as scratch:
        top = pathlib.Path(scratch)
        pip_backend.build(build, top)
        files, packages, _ = gather(top, top / "burin")
        rename(top, files)
        info = top / pip_backend.info_folder()
        notices(info / "licences", packages)
        (info / "sboms").mkdir()
        (info / "sboms/burin.spdx.json").write_text(listing(packages, "licences"), encoding="utf-8")
        name = pip_backend.pack(top, build, f"manylinux_2_{glibc(elves(top))}_{platform.machine()}")
        size = sum(f.stat().st_size for f in top.rglob("*") if f.is_file())
    packed = build / name
    print(f"{packed}: {packed.stat().st_size / 1e6:.1f} MB packed, {size / 1e6:.0f} MB, {len(files)} libraries of {len(packages)} packages")


if len(sys.argv) != 2:
    sys.exit(__doc__)
make(pathlib.Path(sys.argv[1]).resolve())
