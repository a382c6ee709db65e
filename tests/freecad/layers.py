#!/usr/bin/env python3
"""Whether imports in the workbench go downwards: the layers are the table of freecad_wb/docs/layers.md."""

import ast
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2] / "freecad_wb"
PACKAGE = "freecad.burin_wb"
FOREIGN = {"FreeCAD", "FreeCADGui", "Part", "TechDraw", "PySide", "pivy"}  # what a worker process does not have


def tables(page):
    """The rows of each table of a page, as lists of cells without the head."""
    found = [[]]
    for line in page.splitlines():
        if line.startswith("|"):
            found[-1].append([cell.strip() for cell in line.strip("|").split("|")])
        elif found[-1]:
            found.append([])
    return [rows[2:] for rows in found if rows]


def layers_of(rows):
    """Module or folder to the number of its layer, from 0 at the bottom."""
    return {name: k for k, row in enumerate(reversed(rows)) for name in re.findall(r"`(\w+)`", row[0])}


def later_of(rows):
    """(module, import) pairs that may stand inside functions; the module may be "all"."""
    return {(row[0].strip("`"), row[1].strip("`")) for row in rows}


class Sources:
    """The modules of a package with what they import. Names are without the package's: 'view.scheduler'; a folder's
    __init__ has the folder's."""

    def __init__(self, folder):
        self.trees = {}
        for path in sorted(pathlib.Path(folder).rglob("*.py")):
            parts = path.relative_to(folder).with_suffix("").parts
            name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            self.trees[name] = parts, ast.parse(path.read_text(encoding="utf-8"), str(path))

    def imports(self, name):
        """(own module or None, the first word of another's name, line, whether inside a function) of each import."""
        parts, tree = self.trees[name]
        for node, inside in _nodes(tree):
            for full in self._names(node, parts):
                own = full == PACKAGE or full.startswith(PACKAGE + ".")
                yield full[len(PACKAGE) + 1 :] if own else None, full.partition(".")[0], node.lineno, inside

    def _names(self, node, parts):
        """Full names of the modules that a node imports."""
        if isinstance(node, ast.Import):
            return [alias.name for alias in node.names]
        if isinstance(node, ast.ImportFrom):
            return self._from(node, parts)
        if isinstance(node, ast.Call) and getattr(node.func, "attr", getattr(node.func, "id", "")) in (
                "import_module", "__import__"):
            name = node.args[0].value if node.args and isinstance(node.args[0], ast.Constant) else PACKAGE
            return [name if isinstance(name, str) else PACKAGE]
        if isinstance(node, ast.Name) and node.id == "__package__":  # names of modules put together
            return [PACKAGE]
        return []

    def _from(self, node, parts):
        base = node.module or ""
        if node.level:
            above = (PACKAGE, *parts[: len(parts) - node.level])
            base = ".".join((*above, base) if base else above)
        if not (base == PACKAGE or base.startswith(PACKAGE + ".")):
            return [base]
        inner = base[len(PACKAGE) + 1 :]
        # What is imported from a folder may be one of its modules.
        names = [f"{inner}.{alias.name}".strip(".") for alias in node.names]
        return [f"{PACKAGE}.{n if n in self.trees else inner}".rstrip(".") for n in names]


def _nodes(tree, inside=False):
    for node in ast.iter_child_nodes(tree):
        within = inside or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
        yield node, inside
        yield from _nodes(node, within)


def faults(sources, layers, later):
    """Where the sources break the rules, a line each."""
    found = []
    for name in filter(None, sources.trees):
        layer = name.partition(".")[0]
        if layer not in layers:
            found.append(f"{name}: stands in no layer")
            continue
        for own, word, line, inside in sources.imports(name):
            at = f"{name}:{line}"
            if inside and not {(name, word), ("all", word)} & later:
                found.append(f"{at}: imports {own or word} inside a function")
            other = None if own is None else own.partition(".")[0]
            if other is not None and other != layer and layers.get(other, len(layers)) >= layers[layer]:
                found.append(f"{at}: imports {own or 'by a name put together'}, which is no lower layer")
    return found + circles(sources)


def circles(sources):
    """Modules that import each other, directly or by others."""
    needs = {name: {own for own, _, _, _ in sources.imports(name) if own} - {name} for name in sources.trees}
    while True:
        free = {name for name, others in needs.items() if not others & needs.keys()}
        if not free:
            return [f"{name}: in a circle of imports with {', '.join(sorted(others & needs.keys()))}"
                    for name, others in sorted(needs.items())]
        needs = {name: others for name, others in needs.items() if name not in free}


def reached(sources, start):
    """All modules that importing one loads."""
    found, todo = set(), [start]
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo.extend(own for own, _, _, _ in sources.imports(name) if own)
    return found


class TheWorkbench(unittest.TestCase):
    def setUp(self):
        layers, later = tables((ROOT / "docs" / "layers.md").read_text(encoding="utf-8"))
        self.layers, self.later = layers_of(layers), later_of(later)
        self.sources = Sources(ROOT / "freecad" / "burin_wb")

    def test_imports_go_downwards(self):
        self.assertEqual(faults(self.sources, self.layers, self.later), [])

    def test_the_page_names_what_is_there_and_nothing_else(self):
        there = {name.partition(".")[0] for name in self.sources.trees} - {""}
        self.assertEqual(set(self.layers), there)
        used = {(name, word) for name in self.sources.trees for _, word, _, inside in self.sources.imports(name) if inside}
        for module, word in self.later:
            self.assertTrue(any(w == word and module in ("all", name) for name, w in used),
                            f"{module} imports {word} inside no function")

    def test_the_worker_process_needs_no_freecad(self):
        loaded = reached(self.sources, "serve")
        self.assertLessEqual({"serve", "job", "load", "messages", "errors"}, loaded)
        for name in loaded:
            words = {word for _, word, _, _ in self.sources.imports(name)}
            self.assertFalse(words & FOREIGN, f"{name} imports {words & FOREIGN}")


class TheCheck(unittest.TestCase):
    """That the check finds what it is for, on made-up sources."""

    LAYERS = {"low": 0, "beside": 0, "mid": 1, "top": 2}

    def faults(self, later=(), **texts):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {"low": "", "beside": "", "mid/__init__": "", "top": "", **texts}.items():
                path = pathlib.Path(folder, name.replace("__", "/") if "/" not in name else name).with_suffix(".py")
                path.parent.mkdir(exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return faults(Sources(folder), self.LAYERS, set(later))

    def test_downwards_is_right(self):
        self.assertEqual(self.faults(top="from . import mid\nfrom .low import x\nimport os\n",
                                     mid__a="from .. import low\nfrom . import b\n", mid__b=""), [])

    def test_upwards_sideways_and_unknown(self):
        self.assertEqual(self.faults(low="from . import top\n"),
                         ["low:1: imports top, which is no lower layer"])
        self.assertEqual(self.faults(mid__a="\nfrom ..top import x\n"),
                         ["mid.a:2: imports top, which is no lower layer"])
        self.assertEqual(self.faults(low="import freecad.burin_wb.beside\n"),
                         ["low:1: imports beside, which is no lower layer"])
        self.assertEqual(self.faults(new=""), ["new: stands in no layer"])

    def test_inside_functions(self):
        inside = "def f():\n    if f:\n        from . import {}\n"
        self.assertEqual(self.faults(low=inside.format("top")),
                         ["low:3: imports top inside a function", "low:3: imports top, which is no lower layer"])
        self.assertEqual(self.faults(top=inside.format("low")), ["top:3: imports low inside a function"])
        self.assertEqual(self.faults(top="def f():\n    import numpy\n"), ["top:2: imports numpy inside a function"])
        for where in ("all", "top"):
            self.assertEqual(self.faults({(where, "numpy")}, top="def f():\n    import numpy\n"), [])

    def test_names_that_are_put_together(self):
        self.assertIn("low:2: imports by a name put together, which is no lower layer",
                      self.faults(low="import sys\nx = sys.modules.get(__package__ + '.top')\n"))
        self.assertIn("low:2: imports top, which is no lower layer",
                      self.faults(low="import importlib\nimportlib.import_module('freecad.burin_wb.top')\n"))

    def test_circles_in_a_folder(self):
        found = self.faults(mid__a="from .b import x\n", mid__b="from . import a\n")
        self.assertEqual(found, ["mid.a: in a circle of imports with mid.b", "mid.b: in a circle of imports with mid.a"])
        self.assertIn("mid: in a circle of imports with mid.a",
                      self.faults(**{"mid/__init__": "from .a import x\n", "mid__a": "from . import x\n"}))


if __name__ == "__main__":
    sys.exit(not unittest.main(exit=False).result.wasSuccessful())
