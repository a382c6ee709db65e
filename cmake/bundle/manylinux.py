#!/usr/bin/env python3
"""manylinux.py WHEEL: status 1, with a line for each reason, where a wheel needs more of a system than its name says (PEP 600):
a library that is neither inside nor glibc's or g++'s, a newer glibc, or a newer libstdc++ than the oldest Debian of that glibc has.
Also where a library is not loaded by its own name from beside the others, or wants a stack that can be executed.
Needs readelf and patchelf."""
import pathlib
import re
import sys
import tempfile
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from gather import SYSTEM, elves, run  # noqa: E402
from viewer_stub import needed  # noqa: E402

# Of glibc 2.N on: (GLIBCXX 3.4.N, CXXABI 1.3.N, GCC N) of Debian 12 (g++ 12) and of Debian 13 (g++ 14).
OF_GCC = {36: (30, 13, 12), 41: (33, 15, 14)}
OLDEST = min(OF_GCC)


def versions(file):
    """The versions of symbols that a file needs of glibc and g++: ("GLIBC", 36) for GLIBC_2.36."""
    text = run("readelf", "--version-info", "--wide", file).split(".gnu.version_r", 1)
    found = re.findall(r"Name: (GLIBC|GLIBCXX|CXXABI|GCC)_(\d+)\.(\d+)(?:\.(\d+))?", text[1]) if len(text) > 1 else []
    for name, first, second, third in found:
        yield name, int({"GLIBC": second, "GCC": first}.get(name, third or 0))


def glibc(files):
    """N of the glibc 2.N that files need, at least that of the oldest Debian that Burin is built on."""
    return max([OLDEST, *(number for file in files for name, number in versions(file) if name == "GLIBC")])


def faults(folder, limit):
    """A line for each thing that the files below a folder need beyond glibc 2.`limit`."""
    files = elves(folder)
    inside = {file.name for file in files}
    of_gcc = OF_GCC[max(of for of in OF_GCC if of <= limit)]
    most = dict(zip(("GLIBC", "GLIBCXX", "CXXABI", "GCC"), (limit, *of_gcc)))
    for file in files:
        name = file.relative_to(folder)
        for so in needed(file):
            if so not in inside and not SYSTEM.match(so):
                yield f"{name} needs {so}, which is not inside"
        for of, number in versions(file):
            if number > most[of]:
                yield f"{name} needs {of} {number}, {most[of]} is allowed"
        called = run("patchelf", "--print-soname", file).strip() if ".so" in file.name else ""
        if called not in ("", file.name):
            yield f"{name} is {called} for those who load it"
        path = run("patchelf", "--print-rpath", file).strip()
        if not path.startswith("$ORIGIN"):
            yield f"{name} looks for libraries in '{path}', not beside itself"
        if re.search(r"GNU_STACK.*RWE", run("readelf", "--program-headers", "--wide", file)):
            yield f"{name} wants a stack that can be executed"


def main(wheel):
    limit = re.search(r"-manylinux_2_(\d+)_\w+\.whl$", wheel.name)
    if not limit:
        sys.exit(f"manylinux.py: the name of {wheel.name} names no glibc")
    if int(limit[1]) < OLDEST:
        sys.exit(f"manylinux.py: nothing is known of glibc 2.{limit[1]}")
    with tempfile.TemporaryDirectory() as scratch:
        zipfile.ZipFile(wheel).extractall(scratch)
        found = sorted(set(faults(pathlib.Path(scratch), int(limit[1]))))
        count = len(elves(pathlib.Path(scratch)))
    for line in found:
        print(f"manylinux.py: {line}", file=sys.stderr)
    if not count:
        sys.exit(f"manylinux.py: {wheel.name} holds no library")
    print(f"{wheel.name}: {count} programs and libraries need glibc 2.{limit[1]} and what is inside")
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1])))
