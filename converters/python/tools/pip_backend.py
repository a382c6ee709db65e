"""What `pip install .` asks for (PEP 517): CMake builds the module, this packs it with the kernel's libraries.

Nothing is fetched: compilers and libraries come from the system (kernel/docs/install.md). The settings:
  build-dir   a build folder to use, made where it is not there; default build/pip
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Bytes of an archive may not depend on when it was made.
WHEN = (1980, 1, 1, 0, 0, 0)


def version() -> str:
    found = re.search(r"^project\(burin VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.M)
    assert found
    return found.group(1)


def metadata() -> str:
    return (
        f"Metadata-Version: 2.1\nName: burin\nVersion: {version()}\n"
        "Summary: Line art of CAD parts, meshes, splines and functions\nLicense: GPL-3.0-or-later\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy\nDescription-Content-Type: text/markdown\n\n"
        "Burin turns models into vector line art: contours, hidden lines removed, strokes that carry the tone.\n"
    )


def run(*words: str) -> None:
    try:
        subprocess.run(words, cwd=ROOT, check=True)
    except FileNotFoundError:
        raise SystemExit(f"burin: {words[0]} is not there; kernel/docs/install.md lists the packages that a build needs") from None
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"burin: {' '.join(words[:3])} failed with status {error.returncode}; see above") from None


def without_links(where: pathlib.Path) -> None:
    """Archives know no links: each library below `where` has the one name that others load it by."""
    for link in [path for path in where.rglob("*.so*") if path.is_symlink()]:
        link.resolve().replace(link)


def build(folder: pathlib.Path, where: pathlib.Path, tag: str = "") -> None:
    """Builds in `folder` and installs the package `burin` into `where`; for another Python than this one where the build has its
    headers and `tag` names it, such as cp313."""
    if not (folder / "CMakeCache.txt").exists():
        run("cmake", "-G", "Ninja", "-S", str(ROOT), "-B", str(folder), "-DCMAKE_BUILD_TYPE=Release",
            "-DBURIN_TESTS=OFF", "-DBURIN_BENCH=OFF", "-Wno-dev", f"-DBURIN_PYTHON_EXECUTABLE={sys.executable}")
    run("cmake", "--build", str(folder), "--target", "burin_bundle", "burin_python_stub", *([f"burin_python_{tag}"] if tag else []))
    run("cmake", "--install", str(folder), "--component", "bundle", "--strip", "--prefix", str(where))
    without_links(where)
    modules = list(where.glob("burin/_burin*.so"))
    if tag:
        for module in modules:
            module.unlink()
        run("cmake", "--install", str(folder), "--component", f"python_{tag}", "--strip", "--prefix", str(where))
    elif not any(module.name == "_burin" + str(sysconfig.get_config_var("EXT_SUFFIX")) for module in modules):
        raise SystemExit(f"burin: {folder} is a build for another Python than {sys.executable}: {[m.name for m in modules]}; "
                         "choose another folder by --config-settings build-dir=FOLDER")


# The command `burin`. It does not import the package, which loads the kernel a second time.
SCRIPT = """#!python
import importlib.util
import runpy

package = importlib.util.find_spec("burin")
if package is None or not package.submodule_search_locations:
    raise SystemExit("burin: error: this Python has no package burin")
runpy.run_path(package.submodule_search_locations[0] + "/__main__.py", run_name="__main__")
"""


class Archive(zipfile.ZipFile):
    """A zip that is written. The same files in the same order give the same bytes."""

    def __init__(self, path: pathlib.Path) -> None:
        super().__init__(path, "w", zipfile.ZIP_DEFLATED)

    def add(self, inside: str, data: bytes, mode: int = 0o644) -> None:
        entry = zipfile.ZipInfo(inside, WHEN)
        entry.external_attr = (0o100000 | mode) << 16
        self.writestr(entry, data, zipfile.ZIP_DEFLATED)


def files_below(top: pathlib.Path) -> "list[tuple[str, bytes, int]]":
    """What is below a folder, in order: name, bytes and mode."""
    return [(path.relative_to(top).as_posix(), path.read_bytes(), 0o755 if os.access(path, os.X_OK) else 0o644)
            for path in sorted(path for path in top.rglob("*") if path.is_file())]


def zipped(top: pathlib.Path, to: pathlib.Path) -> None:
    """Writes the files below `top` as a zip."""
    with Archive(to) as archive:
        for inside, data, mode in files_below(top):
            archive.add(inside, data, mode)


def record(name: str, data: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
    return f"{name},sha256={digest},{len(data)}\n"


def info_folder() -> str:
    return f"burin-{version()}.dist-info"


def pack(top: pathlib.Path, wheel_directory: pathlib.Path, platform: str, tag: str = "") -> str:
    """Writes the files below `top` as a wheel for this Python, or for that of `tag`. Returns its name. The same files give the
    same bytes."""
    tag = tag or f"cp{sys.version_info[0]}{sys.version_info[1]}"
    info = info_folder()
    name = f"burin-{version()}-{tag}-{tag}-{platform}.whl"
    with Archive(wheel_directory / name) as archive:
        listed = ""
        for inside, data, mode in files_below(top):
            archive.add(inside, data, mode)
            listed += record(inside, data)
        if (top / "burin/bin/burin").exists():
            script = f"burin-{version()}.data/scripts/burin"
            archive.add(script, SCRIPT.encode(), 0o755)
            listed += record(script, SCRIPT.encode())
        tags = f"Wheel-Version: 1.0\nGenerator: burin {version()}\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-{platform}\n"
        for inside, data in (("WHEEL", tags.encode()), ("METADATA", metadata().encode()), ("LICENSE", (ROOT / "LICENSE").read_bytes())):
            archive.add(f"{info}/{inside}", data)
            listed += record(f"{info}/{inside}", data)
        archive.add(f"{info}/RECORD", (listed + f"{info}/RECORD,,\n").encode())
    return name


# The names of the hooks are pip's.
def build_wheel(wheel_directory: str, config_settings: dict | None = None, metadata_directory: str | None = None) -> str:
    del metadata_directory
    folder = ROOT / str((config_settings or {}).get("build-dir", "build/pip"))
    with tempfile.TemporaryDirectory() as scratch:
        build(folder, pathlib.Path(scratch))
        return pack(pathlib.Path(scratch), pathlib.Path(wheel_directory), re.sub(r"[-.]", "_", sysconfig.get_platform()))


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    del config_settings
    name = f"burin-{version()}.tar.gz"
    top = name.removesuffix(".tar.gz")
    files = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True, text=True).stdout
    with tarfile.open(pathlib.Path(sdist_directory) / name, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in files.split("\0")[:-1]:
            archive.add(ROOT / file, f"{top}/{file}", recursive=False)
        with tempfile.NamedTemporaryFile("w") as info:
            info.write(metadata())
            info.flush()
            archive.add(info.name, f"{top}/PKG-INFO")
    return name
