"""OCCT's library of documents (TKXCAF) is linked with its viewer, which wants X11, OpenEXR and FreeImage: 15 MB that nothing
here calls. A library with the same names stands in for it."""
import pathlib
import re
import subprocess

# OCCT's viewer, and what it alone needs falls away with it.
VIEWER = re.compile(r"libTK(VCAF|V3d|Service|OpenGl|HLR)\.so")
NAME = "libburin_no_viewer.so"


def _symbols(file, defined):
    """{name: (type, size)} of the dynamic symbols that a library has, or lacks."""
    lines = subprocess.run(["readelf", "--dyn-syms", "--wide", file], check=True, capture_output=True, text=True).stdout
    found = {}
    for line in lines.splitlines():
        fields = line.split()
        if len(fields) < 8 or not fields[0].rstrip(":").isdigit():
            continue
        size, kind, binding, place, name = int(fields[2], 0), fields[3], fields[4], fields[6], fields[7].split("@")[0]
        if name and (place != "UND") == defined and binding != "LOCAL":
            found[name] = (kind, size)
    return found


def needed(file):
    """The libraries that a file names."""
    out = subprocess.run(["patchelf", "--print-needed", file], check=True, capture_output=True, text=True).stdout
    return out.split()


def replace_viewer(files, viewers, folder):
    """Writes the stand-in into `folder` and has `files` name it instead of the viewer's libraries, {name: path}. Returns how
    many symbols it has."""
    users = [f for f in files if any(VIEWER.match(name) for name in needed(f))]
    wanted = {}
    given = {}
    for path in viewers.values():
        given |= _symbols(path, True)
    for file in users:
        wanted |= {name: given[name] for name in _symbols(file, False) if name in given}
    lines = ["#include <stdio.h>", "#include <stdlib.h>", "static char nothing[64];",
             'static void called(const char* name) { fprintf(stderr, "burin: OCCT\'s viewer is not in this bundle: %s\\n", name); abort(); }']
    for number, (name, (kind, size)) in enumerate(sorted(wanted.items())):
        if kind != "FUNC":
            lines.append(f'char data_{number}[{max(size, 1)}] __asm__("{name}") __attribute__((aligned(32)));')
        elif "get_type_descriptor" in name:  # asked for as the library is loaded
            lines.append(f'void* call_{number}(void) __asm__("{name}"); void* call_{number}(void) {{ return nothing; }}')
        else:
            lines.append(f'void call_{number}(void) __asm__("{name}"); void call_{number}(void) {{ called("{name}"); }}')
    source = pathlib.Path(folder) / "no_viewer.c"
    source.write_text("\n".join(lines) + "\n", encoding="ascii")
    target = pathlib.Path(folder) / NAME
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-Wl,-z,noexecstack", "-Wl,--build-id=none", f"-Wl,-soname,{NAME}",
                    "-o", target, source], check=True)
    source.unlink()
    for file in users:
        for name in needed(file):
            if VIEWER.match(name):
                subprocess.run(["patchelf", "--remove-needed", name, file], check=True)
        subprocess.run(["patchelf", "--add-needed", NAME, file], check=True)
    return len(wanted)
