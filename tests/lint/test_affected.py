"""What .ci/affected gives the linter, for a small tree of its own."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Affected(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.build = self.root / "build"
        for below in (".ci", "kernel/base", "converters/python", "build/lint", "build/tests/Unity"):
            (self.root / below).mkdir(parents=True)
        shutil.copy(SOURCE / ".ci/affected", self.root / ".ci/affected")

    def row(self, file, flags, target):
        return {"directory": str(self.build), "file": str(self.root / file), "command": f"g++ {flags}-o {target}.o -c {self.root / file}"}

    def affected(self, rows):
        """{source: command}, and the rows that clang-tidy gets."""
        for row in rows:
            pathlib.Path(row["file"]).touch()
        (self.build / "compile_commands.json").write_text(json.dumps(rows))
        done = subprocess.run([sys.executable, self.root / ".ci/affected", self.build, "--all"], capture_output=True, text=True, check=True)
        words = done.stdout.split("\0")[:-1]
        names = [str(pathlib.Path(name).relative_to(self.root)) for name in words[::2]]
        return dict(zip(names, words[1::2], strict=True)), json.loads((self.build / "lint/compile_commands.json").read_text())

    def test_a_source_has_one_command_that_of_this_python(self):
        module = "converters/python/call.cpp"
        own = self.row(module, "-isystem /usr/include/python3.11 ", "burin_python")
        for order in (1, -1):
            others = [self.row(module, f"-isystem {self.build}/cp{n} -isystem {self.build}/cp{n}/python ", f"burin_python_cp{n}") for n in (313, 314)]
            sources, rows = self.affected([self.row("kernel/base/a.cpp", "", "base"), *[own, *others][::order]])
            self.assertEqual(sorted(sources), [module, "kernel/base/a.cpp"])
            self.assertEqual(sources[module], own["command"])
            self.assertEqual([row["command"] for row in rows if row["file"] == own["file"]], [own["command"]])

    def test_what_a_unit_joins(self):
        for name in ("a", "b"):
            (self.root / f"kernel/base/{name}.cpp").touch()
        unit = self.row("build/tests/Unity/unity_0_cxx.cxx", "", "tests")
        pathlib.Path(unit["file"]).write_text("".join(f'#include "{self.root}/kernel/base/{name}.cpp"\n' for name in ("a", "b")))
        sources, _ = self.affected([unit])
        self.assertEqual(sorted(sources), ["kernel/base/a.cpp", "kernel/base/b.cpp"])
        self.assertTrue(sources["kernel/base/b.cpp"].endswith("kernel/base/b.cpp"))


if __name__ == "__main__":
    unittest.main()
