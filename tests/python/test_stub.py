"""The type stub says what the module has: the same names, the same arguments, the same defaults."""

import ast
import importlib.util
import inspect
import re
import unittest
from pathlib import Path

import burin

STUB = ast.parse(Path(burin.__file__).with_name("__init__.pyi").read_text())
# What pybind11 writes before "->" in the first line of a docstring.
SIGNATURE = re.compile(r"^(\w+)\((.*)\) -> ", re.DOTALL)
ALIASES = {"Progress"}


def is_private(name):
    return name.startswith("_")


def members(node):
    return {n.name: n for n in node.body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}


def attributes(node):
    return {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}


def arguments(function):
    """[(name, kind, default)] of a function of the stub."""
    a = function.args
    out, plain = [], a.posonlyargs + a.args
    defaults = [None] * (len(plain) - len(a.defaults)) + a.defaults
    out += [(x.arg, "plain", d and ast.unparse(d)) for x, d in zip(plain, defaults)]
    if a.vararg:
        out.append((a.vararg.arg, "*", None))
    out += [(x.arg, "keyword", d and ast.unparse(d)) for x, d in zip(a.kwonlyargs, a.kw_defaults)]
    if a.kwarg:
        out.append((a.kwarg.arg, "**", None))
    return [x for x in out if x[0] != "self"]


def real_arguments(function, case):
    """The same, from the function itself, or from the docstring that pybind11 made."""
    if inspect.isfunction(function):
        return arguments(ast.parse(f"def f{inspect.signature(function)}: ...").body[0])
    match = SIGNATURE.match(function.__doc__ or "")
    case.assertTrue(match, function)
    # Types that Python cannot parse, and those of C++, are of no interest.
    text = re.sub(r": (?:[\w.]+)(?:\[[^=]*?\])?", "", match[2])
    return arguments(ast.parse(f"def f({text}): ...").body[0])


class Stub(unittest.TestCase):
    def compare(self, name, stub, real):
        ours, theirs = arguments(stub), real_arguments(real, self)
        kinds = [(kind, default) if kind in ("*", "**") else (n, kind, default) for n, kind, default in ours]
        other = [(kind, default) if kind in ("*", "**") else (n, kind, default) for n, kind, default in theirs]
        other = [entry for entry in other if entry[0] not in ("self", "arg0")]
        self.assertEqual(kinds, other, name)

    def test_names(self):
        stub = set(members(STUB)) | attributes(STUB)
        stub |= {t.id for n in STUB.body if isinstance(n, ast.Assign) for t in n.targets}
        stub = {n for n in stub if not is_private(n)}
        self.assertEqual(stub, set(burin.__all__))
        self.assertTrue(all(hasattr(burin, name) for name in stub))

    def test_functions(self):
        for name, node in members(STUB).items():
            if isinstance(node, ast.FunctionDef):
                self.compare(name, node, getattr(burin, name))
                self.assertTrue(ast.get_docstring(node), name)
                self.assertGreater(len(getattr(burin, name).__doc__.splitlines()), 1, name)

    def test_classes(self):
        for name, node in members(STUB).items():
            if not isinstance(node, ast.ClassDef):
                continue
            real = getattr(burin, name)
            self.assertTrue(real.__doc__, name)
            self.assertEqual(real.__module__, "burin")
            bases = [ast.unparse(base) for base in node.bases]
            self.assertEqual(bases, [b.__name__ for b in real.__bases__] if bases else [], name)
            stub = set(members(node)) | attributes(node)
            public = {n for n in vars(real) if not is_private(n)}
            self.assertEqual({n for n in stub if not is_private(n)}, public, name)
            for method, function in members(node).items():
                if any(ast.unparse(d) == "property" for d in function.decorator_list):
                    self.assertIsInstance(vars(real)[method], property)
                elif method != "__init__":
                    self.compare(f"{name}.{method}", function, getattr(real, method))
            if not issubclass(real, Exception):
                for attribute in public:
                    doc = vars(real)[attribute]
                    doc = doc.__func__.__doc__ if isinstance(doc, staticmethod) else doc.__doc__
                    self.assertTrue(doc, f"{name}.{attribute} has no docstring")

    def test_settable_attributes_are_settable(self):
        for name, node in members(STUB).items():
            real = getattr(burin, name)
            if not isinstance(node, ast.ClassDef) or issubclass(real, Exception):
                continue
            for attribute in attributes(node):
                with self.subTest(f"{name}.{attribute}"):
                    self.assertIsNotNone(vars(real)[attribute].fset)

    def test_the_comparison_can_fail(self):
        stub = ast.parse("def draw(source, *, view='front'): ...").body[0]
        with self.assertRaises(AssertionError):
            self.compare("draw", stub, burin.draw)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "python3-mypy is not installed")
    def test_mypy_reads_it(self):
        from mypy import api

        out, _, status = api.run(["--strict", str(Path(burin.__file__).with_name("__init__.pyi")), "--cache-dir=/dev/null"])
        self.assertEqual(status, 0, out)


if __name__ == "__main__":
    unittest.main()
