#!/usr/bin/env python3
"""bundle.py BUILD: a folder with the command, its libraries and those of others that it needs, for any Linux of glibc 2.36
and later, packed as burin-VERSION-linux-PROCESSOR.tar.zst, and larger as .tar.gz for systems without zstd, each with its
SHA-256, beside a list of what is inside (SPDX). Nothing is installed; the folder may be moved, and deleting it takes all away.
The same build gives the same bytes.

Needs what ./dev bundle installs: patchelf, zstd, gzip, cc, binutils, dpkg."""
import hashlib
import pathlib
import platform
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from gather import SOURCE, commit_time, compiled_in, gather, notices, run, version  # noqa: E402
from listing import listing  # noqa: E402
from pages import keep_links_inside  # noqa: E402


# At the top of the folder, where who unpacks it looks first.
README = """Burin {version}: line art of parts and assemblies.

    bin/burin draw samples/coupling.step -o coupling.svg
    bin/burin --help

The pages are in share/doc/burin and begin with draw.md; the licences are in share/doc/burin/licences.
Nothing else is installed: the folder may be moved, and deleting it takes all away.
"""
# What the first lines of the pages draw.
SAMPLES = ("coupling.step", "gear_pump.step")


def make(build):
    name = f"burin-{version()}-linux-{platform.machine()}"
    top = build / "bundle" / name
    shutil.rmtree(build / "bundle", ignore_errors=True)
    run("cmake", "--install", build, "--prefix", top, "--component", "command", "--strip")
    # Commands that are written in Python run by any Python 3 of the system; the module is for wheels.
    for part in ("batch", "book"):
        shutil.copytree(SOURCE / "converters/python/burin" / part, top / "lib/python3/dist-packages/burin" / part,
                        ignore=lambda _, names: [n for n in names if not n.endswith(".py") and "." in n or n == "__pycache__"])
    files, packages, symbols = gather(top, top / "lib")
    compiled = compiled_in(top)
    notices(top / "share/doc/burin/licences", {**packages, **compiled})
    keep_links_inside(top / "share/doc/burin")
    (top / "README.txt").write_text(README.format(version=version()), encoding="utf-8")
    (top / "samples").mkdir()
    for sample in SAMPLES:
        shutil.copyfile(SOURCE / "samples" / sample, top / "samples" / sample)
    inside = build / f"{name}.spdx.json"
    inside.write_text(listing(packages, compiled, "share/doc/burin/licences"), encoding="utf-8")
    shutil.copyfile(inside, top / "share/doc/burin/packages.spdx.json")
    tar = build / f"{name}.tar"
    run("tar", "--sort=name", f"--mtime=@{commit_time()}", "--owner=0", "--group=0", "--numeric-owner", "--mode=go-w", "--format=gnu",
        "-C", top.parent, "-cf", tar, name)
    run("gzip", "-9", "--keep", "--no-name", "--force", tar)
    run("zstd", "-q", "-f", "--ultra", "-22", "--long=27", "--rm", tar)
    packed = [pathlib.Path(f"{tar}{suffix}") for suffix in (".zst", ".gz")]
    for file in packed:
        digest = hashlib.sha256(file.read_bytes()).hexdigest()
        pathlib.Path(f"{file}.sha256").write_text(f"{digest}  {file.name}\n", encoding="ascii")
    size = sum(f.stat().st_size for f in top.rglob("*") if f.is_file() and not f.is_symlink())
    print(f"{packed[0]}: {' and, as .tar.gz, '.join(f'{file.stat().st_size / 1e6:.1f} MB' for file in packed)} packed, {size / 1e6:.0f} MB, "
          f"{len(files)} libraries of {len(packages)} packages, {symbols} symbols of OCCT's viewer replaced")


if len(sys.argv) != 2:
    sys.exit(__doc__)
make(pathlib.Path(sys.argv[1]).resolve())
