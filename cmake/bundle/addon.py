#!/usr/bin/env python3
"""addon.py BUILD [TAG...]: BUILD/burin-workbench-VERSION-linux-PROCESSOR.zip: FreeCAD's add-on with its kernel and all libraries
that it needs, for this Python and those of TAGs (cp313, whose headers the build has). One archive for each FreeCAD whose Python is
one of these, on any Linux whose glibc is that of this machine or newer. The same build gives the same bytes.

Needs what ./dev addon --python installs: patchelf, cc, binutils, dpkg."""
import pathlib
import platform
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("cmake/bundle", "converters/python/tools")]
import pip_backend  # noqa: E402
from gather import compiled_in, elves, gather, notices, rename, run, version  # noqa: E402
from listing import listing  # noqa: E402
from manylinux import faults, glibc  # noqa: E402


def make(build, tags):
    packed = build / f"burin-workbench-{version()}-linux-{platform.machine()}.zip"
    with tempfile.TemporaryDirectory() as scratch:
        top = pathlib.Path(scratch)
        run("cmake", "--install", build, "--component", "freecad_archive", "--strip", "--prefix", top)
        native = top / "Burin/freecad/burin_wb/native"
        pip_backend.without_links(native)
        for tag in tags:
            run("cmake", "--install", build, "--component", f"python_{tag}", "--strip", "--prefix", native)
        files, packages, _ = gather(native, native / "burin")
        rename(native, files)
        compiled = compiled_in(native)
        notices(native / "licences", {**packages, **compiled})
        (native / "burin.spdx.json").write_text(listing(packages, compiled, "licences"), encoding="utf-8")
        limit = glibc(elves(native))
        for line in faults(native, limit):
            sys.exit(f"addon.py: {line}")
        modules = sorted(path.name for path in native.glob("burin/_burin*.so"))
        pip_backend.zipped(top, packed)
    print(f"{packed}: {packed.stat().st_size / 1e6:.1f} MB, glibc 2.{limit}, {len(files)} libraries of {len(packages)} packages; "
          + ", ".join(modules))


if len(sys.argv) < 2:
    sys.exit(__doc__)
make(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:])
