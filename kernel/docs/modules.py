#!/usr/bin/env python3
"""Draws kernel/docs/modules.svg, the picture of the modules, from the targets of the build.

    kernel/docs/modules.py BUILD             writes it
    kernel/docs/modules.py BUILD --check     compares it with the build, and counts the sources of each folder (status 1
                                           where the picture differs or a folder has too many)

An arrow is what the compiler enforces: a module may include the module that it points at, and those behind that one. Arrows
that follow from others are left out. BUILD is a folder that cmake has configured."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile
from xml.sax.saxutils import escape

HERE = pathlib.Path(__file__).resolve().parent
# Parts of a module that are targets of their own, because a library's headers are theirs alone.
PARTS = ("_exact", "_refine", "_occt", "_openmesh")
LIBRARIES = {"OpenMeshCore": "OpenMesh", "embree": "Embree", "CGAL": "CGAL", "Eigen3::Eigen": "Eigen", "Boost::headers": "Boost", "TBB::tbb": "TBB",
             "glm::glm": "GLM", "nlohmann_json::nlohmann_json": "JSON", "pugixml::pugixml": "pugixml", "ZLIB::ZLIB": "zlib",
             "libzip.so": "libzip", "PkgConfig::CAIRO": "cairo", "TinyGLTF::TinyGLTF": "tinygltf", "CLI11::CLI11": "CLI11", "pybind11::module": "pybind11"}
OUTSIDE = ("samples", "cad_samples", "bench", "areas", "judge", "sections", "fuzz", "probe", "mesh_to_svg")  # no modules: they are built from them
MOST = 25  # sources in a folder
BOX, ROW, GAP, LETTER = 34, 74, 16, 6.6


def room(target):
    """The module of a target as a path, or None."""
    name = target.removeprefix("burin_")
    if not target.startswith("burin") or "verify_interface" in name or "precompiled" in name or name in OUTSIDE:
        return None
    for part in PARTS:
        name = name.removesuffix(part)
    if name == "burin":
        return name
    if name == "io":
        return "libburin_io"
    if name in ("cad", "convert_cad"):
        return "converters/cad"
    if name in ("cairo", "write"):
        return "converters/write"
    if name in ("read", "request", "cli"):
        return "converters/" + name
    if name == "python":
        return "converters/python"
    name = name.replace("forms_implicit_", "forms_implicit/")
    return re.sub("^(forms|convert)_", lambda m: m[1].replace("convert", "converters") + "/", name)


def graph(build):
    """{module: modules that it may include}, {module: libraries}, the modules of libburin."""
    with tempfile.TemporaryDirectory() as folder:
        dot = pathlib.Path(folder) / "targets.dot"
        subprocess.run(["cmake", f"--graphviz={dot}", "."], cwd=build, check=True, capture_output=True)
        text = dot.read_text()
    needs, libraries, inside = {}, {}, set()
    for source, target in re.findall(r"// (\S+) -> (\S+)$", text, re.M):
        a, b = room(source), room(target)
        if a is None or a == b:
            continue
        if a == "burin":
            inside.add(b)
        elif b:
            needs.setdefault(a, set()).add(b)
            needs.setdefault(b, set())
        elif target.startswith("TK") or target == "burin_forms_brep_occt":
            libraries.setdefault(a, set()).add("OCCT")
        else:
            word = LIBRARIES.get(target) or LIBRARIES.get(target.rsplit("/", 1)[-1])
            if word:
                libraries.setdefault(a, set()).add(word)
    needs.pop("burin", None)
    inside.discard(None)
    needs["burin"] = set(inside)
    return needs, libraries, inside


def reach(needs, start):
    seen, open_ = set(), [start]
    while open_:
        for b in needs[open_.pop()]:
            if b not in seen:
                seen.add(b)
                open_.append(b)
    return seen


def reduced(needs):
    return {a: {b for b in bs if not any(b in reach(needs, c) for c in bs - {b})} for a, bs in needs.items()}


def layers(needs, inside):
    """Rows of modules, those that include nothing first; nothing of libburin above anything else."""
    level = {}

    def of(r):
        if r not in level:
            least = 1 + max((of(o) for o in inside), default=0) if r not in inside else 0
            level[r] = max([least] + [1 + of(b) for b in needs[r] if b != "burin"])
        return level[r]

    for r in sorted(needs.keys() - {"burin"}):
        of(r)
    rows = [[] for _ in range(1 + max(level.values()))]
    for r in sorted(level):
        rows[level[r]].append(r)
    return rows


def order(rows, needs):
    """Every module near the middle of those that it includes and that include it; a few rounds."""
    place = {r: i - len(row) / 2 for row in rows for i, r in enumerate(row)}
    near = {r: [o for o in place if o in needs[r] or r in needs[o]] for r in place}
    for _ in range(12):
        for row in rows:
            want = {r: sum(place[o] for o in near[r]) / max(1, len(near[r])) for r in row}
            row.sort(key=lambda r: (round(want[r], 6), r))
            for i, r in enumerate(row):
                place[r] = i - (len(row) - 1) / 2


def draw(needs, libraries, inside):
    needs = reduced(needs)
    rows = layers(needs, inside)
    order(rows, needs)
    words = {r: " ".join(sorted(libraries.get(r, ()))) for r in needs}
    width = {r: 20 + LETTER * max(len(r), 0.85 * len(words[r])) for r in needs}
    total = 80 + max(sum(width[r] + GAP for r in row) for row in rows)
    height = 40 + ROW * len(rows)
    at = {}
    for level, row in enumerate(rows):
        x = (total - sum(width[r] + GAP for r in row) + GAP) / 2
        for r in row:
            at[r] = (x, height - 30 - BOX - level * ROW)
            x += width[r] + GAP
    top = min(at[r][1] for r in inside) - 14
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{total:.0f}" height="{height}" font-family="sans-serif" '
           f'font-size="12" role="img"><title>The modules of Burin and what each may include</title>',
           f'<rect width="{total:.0f}" height="{height}" fill="#fff"/>',
           f'<rect x="20" y="{top:.0f}" width="{total - 40:.0f}" height="{height - 12 - top:.0f}" rx="6" fill="#f4f4f0" '
           'stroke="#999"/>', f'<text x="30" y="{top + 18:.0f}" fill="#666">libburin</text>']
    for a in sorted(at):
        for b in sorted(needs[a]):
            x, y = at[a][0] + width[a] / 2, at[a][1] + BOX
            u, v = (x, top) if b == "burin" else (at[b][0] + width[b] / 2, at[b][1])
            out.append(f'<path d="M{x:.1f} {y:.1f}C{x:.1f} {y + 22:.1f} {u:.1f} {v - 22:.1f} {u:.1f} {v:.1f}" fill="none" '
                       f'stroke="#555" stroke-width=".8"><title>{escape(a)} includes {escape(b)}</title></path>')
    for r in sorted(at):
        x, y = at[r]
        fill = "#fff" if r in inside else "#e8f0f8"
        out.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width[r]:.1f}" height="{BOX}" rx="4" fill="{fill}" '
                   'stroke="#333"/>')
        middle = x + width[r] / 2
        out.append(f'<text x="{middle:.1f}" y="{y + (15 if words[r] else 21):.1f}" text-anchor="middle">{escape(r)}</text>')
        if words[r]:
            out.append(f'<text x="{middle:.1f}" y="{y + 28:.1f}" text-anchor="middle" font-size="10" '
                       f'fill="#777">{escape(words[r])}</text>')
    return "\n".join([*out, "</svg>", ""])


def too_large():
    """Folders with more sources than a reader takes in at once, each as a line."""
    counts = {}
    for top in ("kernel", "converters"):
        for source in (HERE.parents[1] / top).rglob("*.cpp"):
            folder = source.parent.relative_to(HERE.parents[1]).as_posix()
            counts[folder] = counts.get(folder, 0) + 1
    return [f"{folder} has {count} sources, {MOST} at the most: part it along what its sources mean"
            for folder, count in sorted(counts.items()) if count > MOST]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    picture, path = draw(*graph(options.build)), HERE / "modules.svg"
    if not options.check:
        path.write_text(picture)
    elif large := too_large():
        sys.exit("\n".join(large))
    elif not path.exists() or path.read_text() != picture:
        sys.exit(f"{path.name} differs from the build: kernel/docs/modules.py {options.build} draws it again")


main()
