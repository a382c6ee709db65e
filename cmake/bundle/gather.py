"""A folder with programs or libraries of Burin becomes one that needs nothing of the system but glibc and g++'s libraries: what
bundles and wheels are made of. Needs what ./dev bundle installs: patchelf, cc, binutils, dpkg."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from viewer_stub import VIEWER, needed, replace_viewer  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[2]
# Packages of Debian whose code, or font, is compiled in.
COMPILED_IN = ("fonts-osifont", "libboost-dev", "libcgal-dev", "libcli11-dev", "libeigen3-dev", "libglm-dev", "libtinygltf-dev",
               "nlohmann-json3-dev", "pybind11-dev")
COMMON = pathlib.Path("/usr/share/common-licenses")
# A system has these itself, and no two of them may be in one process.
SYSTEM = re.compile(r"(ld-linux.*|libc|libm|libdl|libpthread|librt|libresolv|libutil|libstdc\+\+|libgcc_s)\.so")


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True, **options).stdout


def version():
    return re.search(r"^project\(burin VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]


def elves(folder):
    """The programs and libraries below a folder, links left out."""
    def is_elf(file):
        with open(file, "rb") as opened:
            return opened.read(4) == b"\x7fELF"

    return sorted(f for f in folder.rglob("*") if f.is_file() and not f.is_symlink() and is_elf(f))


def gather(top, lib):
    """Copies the libraries of others that the files below `top` load into its folder `lib`, without OCCT's viewer, and has all
    files look for libraries there. Returns ({name: path in lib}, {package of Debian: version}, symbols of the viewer)."""
    own = elves(top)
    found = _libraries(own, lib)
    viewers = {n: p for n, p in found.items() if VIEWER.match(n)}
    files = {}
    for so, path in found.items():
        if not VIEWER.match(so):
            files[so] = shutil.copyfile(os.path.realpath(path), lib / so)
            os.chmod(files[so], 0o755)
    symbols = replace_viewer(list(files.values()) + own, viewers, lib) if viewers else 0
    # What the viewer alone loaded is not needed any more.
    still = set(_libraries(elves(top), lib))
    used = _used(own, lib)
    for so in list(files):
        if so not in used:
            os.remove(files.pop(so))
    if still:
        sys.exit("bundle: not inside: " + ", ".join(sorted(still)))
    for file in elves(top):
        _set_path(file, lib)
    return files, dict(_package_of(found[so]) for so in files), symbols


def rename(top, files):
    """Gives the libraries of gather names that no other library of the process has: the loader takes the first of a name,
    and other modules of Python bring their own libpng. The name holds the version of Burin."""
    names = {so: f"{so.split('.so')[0]}-burin{version()}.so{so.split('.so', 1)[1]}" for so in files}
    pairs = {so: ["--replace-needed", so, name] for so, name in names.items()}
    for file in elves(top):
        words = [word for so in needed(file) if so in pairs for word in pairs[so]]
        if words:
            run("patchelf", *words, file)
        # On its own: patchelf 0.14 mixes up the names where it is asked for both.
        if file.name in names:
            run("patchelf", "--set-soname", names[file.name], file)
    for so, name in names.items():
        os.rename(files[so], files[so].with_name(name))


def compiled_in(top):
    """{package of Debian: version} of what is part of the programs and libraries of Burin below `top`."""
    module = any(top.rglob("_burin*.so"))
    return {name: run("dpkg-query", "-W", "-f=${Version}", name) for name in COMPILED_IN if module or name != "pybind11-dev"}


def notices(folder, packages):
    """Copies the licences of Debian's packages into a folder, and the texts that they name, which other systems lack."""
    folder.mkdir(parents=True)
    texts = set()
    for name in packages:
        notice = pathlib.Path(f"/usr/share/doc/{name}/copyright").read_bytes()
        (folder / name).write_bytes(notice)
        texts |= {text.decode().rstrip(".") for text in re.findall(rb"common-licenses/([\w.+-]+)", notice)}
    (folder / COMMON.name).mkdir()
    for text in sorted(texts & set(os.listdir(COMMON))):
        shutil.copyfile(COMMON / text, folder / COMMON.name / text)
    (folder / "README").write_text(f"Notices of what is inside, by packages of Debian. A text that one names, {COMMON}/NAME,\n"
                                   f"is {COMMON.name}/NAME here.\n", encoding="utf-8")


def commit_time():
    """Seconds: of the commit, so that the bytes depend on nothing else."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    return int(run("git", "-C", SOURCE, "log", "-1", "--format=%ct").strip())


def _libraries(files, lib):
    """{name: path} of the libraries of others that files load, directly and through each other."""
    found = {}
    for file in files:
        for line in run("ldd", file, env={**os.environ, "LD_LIBRARY_PATH": str(lib)}).splitlines():
            match = re.match(r"\s*(\S+) => (/\S+)", line)
            if "not found" in line:
                sys.exit(f"bundle: {file}: {line.strip()}")
            if match and not SYSTEM.match(match[1]) and not match[2].startswith(str(lib)):
                found[match[1]] = match[2]
    return found


def _used(own, lib):
    """Names of the libraries in `lib` that the files of Burin load, directly and through each other."""
    todo, seen = list(own), set()
    while todo:
        for name in needed(todo.pop()):
            if name not in seen and (lib / name).exists():
                seen.add(name)
                todo.append(lib / name)
    return seen


def _package_of(file):
    """Debian's package that a file is from: (name, version)."""
    for path in (os.path.realpath(file), file, re.sub("^/lib/", "/usr/lib/", os.path.realpath(file))):
        try:
            name = run("dpkg-query", "-S", path).splitlines()[0].split(":")[0]
        except subprocess.CalledProcessError:
            continue
        return name, run("dpkg-query", "-W", "-f=${Version}\n", name).splitlines()[0]
    sys.exit(f"bundle: no package has {file}")


def _set_path(file, lib):
    """Has a program or library look for libraries in `lib`, before all that LD_LIBRARY_PATH names: an old-style path is."""
    up = os.path.relpath(lib, file.parent)
    file.chmod(0o755)
    run("strip", "--strip-unneeded", file)
    run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN" if up == "." else f"$ORIGIN/{up}", file)
