#!/usr/bin/env python3
"""bundle.py BUILD: a folder with the command, its libraries and those of others that it needs, for any Linux of glibc 2.36
and later, packed as burin-VERSION-linux-PROCESSOR.tar.zst beside a list of what is inside (SPDX) and its SHA-256. Nothing
is installed; the folder may be moved, and deleting it takes all away. The same build gives the same bytes.

Needs what ./dev bundle installs: patchelf, zstd, cc, binutils, dpkg."""
import hashlib
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from viewer_stub import VIEWER, needed, replace_viewer  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[2]
# A system has these itself, and no two of them may be in one process.
SYSTEM = re.compile(r"(ld-linux.*|libc|libm|libdl|libpthread|librt|libresolv|libutil|libstdc\+\+|libgcc_s)\.so")


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True, **options).stdout


def is_elf(file):
    with open(file, "rb") as opened:
        return opened.read(4) == b"\x7fELF"


def elves(folder):
    return sorted(f for f in folder.rglob("*") if f.is_file() and not f.is_symlink() and is_elf(f))


def libraries(files, own):
    """{name: path} of the libraries of others that files load, directly and through each other."""
    found = {}
    for file in files:
        for line in run("ldd", file, env={**os.environ, "LD_LIBRARY_PATH": str(own)}).splitlines():
            match = re.match(r"\s*(\S+) => (/\S+)", line)
            if "not found" in line:
                sys.exit(f"bundle.py: {file}: {line.strip()}")
            if match and not SYSTEM.match(match[1]) and not match[2].startswith(str(own)):
                found[match[1]] = match[2]
    return found


def package_of(file):
    """Debian's package that a file is from: (name, version)."""
    for path in (os.path.realpath(file), file, re.sub("^/lib/", "/usr/lib/", os.path.realpath(file))):
        try:
            name = run("dpkg-query", "-S", path).splitlines()[0].split(":")[0]
        except subprocess.CalledProcessError:
            continue
        return name, run("dpkg-query", "-W", "-f=${Version}\n", name).splitlines()[0]
    sys.exit(f"bundle.py: no package has {file}")


def set_path(file, top):
    """Has a program or library look for libraries in the bundle."""
    up = os.path.relpath(top / "lib", file.parent)
    file.chmod(0o755)
    run("strip", "--strip-unneeded", file)
    run("patchelf", "--set-rpath", "$ORIGIN" if up == "." else f"$ORIGIN/{up}", file)


def spdx(version, packages, when):
    """What is inside, as SPDX 2.3."""
    own = {"SPDXID": "SPDXRef-burin", "name": "burin", "versionInfo": version, "licenseConcluded": "GPL-3.0-or-later",
           "licenseDeclared": "GPL-3.0-or-later", "downloadLocation": "NOASSERTION", "filesAnalyzed": False}
    rows, relations = [own], [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-burin"}]
    for name, of in sorted(packages.items()):
        key = "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)
        rows.append({"SPDXID": key, "name": name, "versionInfo": of, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                     "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION",
                     "comment": f"from Debian; its licence is in share/doc/burin/licences/{name}",
                     "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                       "referenceLocator": f"pkg:deb/debian/{name}@{of}?arch={run('dpkg', '--print-architecture').strip()}"}]})
        relations.append({"spdxElementId": "SPDXRef-burin", "relationshipType": "DYNAMIC_LINK", "relatedSpdxElement": key})
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"burin-{version}",
            "documentNamespace": f"urn:burin:{version}:{when}", "creationInfo": {"created": when, "creators": ["Tool: bundle.py"]},
            "packages": rows, "relationships": relations}


def commit_time():
    """Seconds: of the commit, so that the bytes depend on nothing else."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    return int(run("git", "-C", SOURCE, "log", "-1", "--format=%ct").strip())


def make(build):
    version = re.search(r"^project\(burin VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
    name = f"burin-{version}-linux-{platform.machine()}"
    top = build / "bundle" / name
    shutil.rmtree(build / "bundle", ignore_errors=True)
    run("cmake", "--install", build, "--prefix", top, "--component", "command", "--strip")
    # Commands that are written in Python run by any Python 3 of the system; the module is for wheels.
    for part in ("batch", "book"):
        shutil.copytree(SOURCE / "converters/python/burin" / part, top / "lib/python3/dist-packages/burin" / part,
                        ignore=lambda _, names: [n for n in names if not n.endswith(".py") and "." in n or n == "__pycache__"])
    found = libraries(elves(top), top / "lib")
    viewers = {n: p for n, p in found.items() if VIEWER.match(n)}
    files = {}
    for so, path in found.items():
        if not VIEWER.match(so):
            files[so] = shutil.copyfile(os.path.realpath(path), top / "lib" / so)
            os.chmod(files[so], 0o755)
    symbols = replace_viewer(list(files.values()) + elves(top), viewers, top / "lib") if viewers else 0
    # What the viewer alone loaded is not needed any more.
    still = set(libraries(elves(top), top / "lib"))
    own = set(libraries_in(top))
    for so in list(files):
        if so not in own:
            os.remove(files.pop(so))
    if still:
        sys.exit("bundle.py: not in the bundle: " + ", ".join(sorted(still)))
    for file in elves(top):
        set_path(file, top)
    packages = {}
    for so in files:
        of, number = package_of(found[so])
        packages[of] = number
    notices(top, packages)
    time = commit_time()
    when = run("date", "-u", "-d", f"@{time}", "+%Y-%m-%dT%H:%M:%SZ").strip()
    listing = build / f"{name}.spdx.json"
    listing.write_text(json.dumps(spdx(version, packages, when), indent=1) + "\n", encoding="utf-8")
    shutil.copyfile(listing, top / "share/doc/burin/packages.spdx.json")
    packed = build / f"{name}.tar.zst"
    tar = subprocess.Popen(["tar", "--sort=name", f"--mtime=@{time}", "--owner=0", "--group=0", "--numeric-owner", "--mode=go-w",
                            "--format=gnu", "-C", top.parent, "-cf", "-", name], stdout=subprocess.PIPE)
    subprocess.run(["zstd", "-q", "-f", "--ultra", "-22", "--long=27", "-o", packed], stdin=tar.stdout, check=True)
    if tar.wait():
        sys.exit("bundle.py: tar failed")
    digest = hashlib.sha256(packed.read_bytes()).hexdigest()
    pathlib.Path(f"{packed}.sha256").write_text(f"{digest}  {packed.name}\n", encoding="ascii")
    size = sum(f.stat().st_size for f in top.rglob("*") if f.is_file() and not f.is_symlink())
    print(f"{packed}: {packed.stat().st_size / 1e6:.1f} MB packed, {size / 1e6:.0f} MB, {len(files)} libraries of {len(packages)} packages, "
          f"{symbols} symbols of OCCT's viewer replaced")


def libraries_in(top):
    """Names of the bundle's libraries that its programs and libraries load, by name."""
    todo = [f for f in elves(top) if f.parent != top / "lib" or f.name.startswith(("libburin", "burin"))]
    seen = set()
    while todo:
        for name in needed(todo.pop()):
            if name not in seen and (top / "lib" / name).exists():
                seen.add(name)
                todo.append(top / "lib" / name)
    return seen


def notices(top, packages):
    folder = top / "share/doc/burin/licences"
    folder.mkdir(parents=True)
    for name in packages:
        shutil.copyfile(f"/usr/share/doc/{name}/copyright", folder / name)


if len(sys.argv) != 2:
    sys.exit(__doc__)
make(pathlib.Path(sys.argv[1]).resolve())
