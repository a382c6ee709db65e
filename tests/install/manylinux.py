"""What cmake/bundle/manylinux.py finds in small wheels, and that renamed libraries are found. Needs cc, patchelf and readelf."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "cmake/bundle"))
from gather import rename, version  # noqa: E402
from viewer_stub import needed  # noqa: E402

NAME = "burin-1-cp311-cp311-manylinux_2_{}_x86_64.whl"


@unittest.skipUnless(shutil.which("patchelf") and shutil.which("cc"), "patchelf and cc are not there")
class Wheels(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.top = self.folder / "top"
        self.top.mkdir()

    def library(self, name, code="int one(void) { return 1; }", *words, path="$ORIGIN"):
        file = self.top / name
        given = ["-Wl,-rpath," + path] if path else []
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-x", "none", "-o", file, f"-Wl,-soname,{name}", *given, *map(str, words)],
                       input=code, text=True, check=True)
        return file

    def check_wheel(self, glibc=36):
        """(status, messages) of the script for a wheel of what is in `top`."""
        wheel = self.folder / NAME.format(glibc)
        with zipfile.ZipFile(wheel, "w") as archive:
            for file in self.top.iterdir():
                archive.write(file, file.name)
        done = subprocess.run([sys.executable, SOURCE / "cmake/bundle/manylinux.py", wheel], capture_output=True, text=True)
        return done.returncode, done.stderr

    def user(self):
        """A library that needs another, libone.so.1."""
        one = self.library("libone.so.1")
        return one, self.library("libtwo.so.1", "int one(void); int two(void) { return 2 * one(); }", one)

    def test_what_is_inside_may_be_needed(self):
        self.user()
        self.assertEqual(self.check_wheel(), (0, ""))

    def test_what_is_not_inside_is_named(self):
        one, _ = self.user()
        one.unlink()
        status, text = self.check_wheel()
        self.assertEqual(status, 1)
        self.assertIn("libtwo.so.1 needs libone.so.1, which is not inside", text)

    def test_a_library_has_its_own_name_and_looks_beside_itself(self):
        self.library("libone.so.1").rename(self.top / "libother.so.1")
        self.library("libthree.so.1", path="")
        status, text = self.check_wheel()
        self.assertEqual(status, 1)
        self.assertIn("libother.so.1 is libone.so.1 for those who load it", text)
        self.assertIn("libthree.so.1 looks for libraries in '', not beside itself", text)

    def test_a_stack_that_is_executed_is_refused(self):
        self.library("libone.so.1", "int one(void) { return 1; }", "-Wl,-z,execstack")
        self.assertIn("wants a stack that can be executed", self.check_wheel()[1])

    def test_a_newer_glibc_is_refused(self):
        # A stand-in for glibc with a version that none has yet.
        script = self.folder / "map"
        script.write_text("GLIBC_2.99 { global: future; };\n")
        libc = self.library("libm.so.6", "int future(void) { return 1; }", f"-Wl,--version-script={script}")
        self.library("libone.so.1", "int future(void); int one(void) { return future(); }", libc)
        libc.unlink()
        status, text = self.check_wheel()
        self.assertEqual(status, 1)
        self.assertIn("libone.so.1 needs GLIBC 99, 36 is allowed", text)

    def test_a_name_without_a_glibc_is_refused(self):
        done = subprocess.run([sys.executable, SOURCE / "cmake/bundle/manylinux.py", "burin-1-cp311-cp311-linux_x86_64.whl"],
                              capture_output=True, text=True)
        self.assertIn("names no glibc", done.stderr)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nothing is known of glibc 2.17", self.check_wheel(17)[1])

    def test_renamed_libraries_are_found(self):
        one, two = self.user()
        rename(self.top, {file.name: file for file in (one, two)})
        names = sorted(file.name for file in self.top.iterdir())
        self.assertEqual(names, [f"lib{word}-burin{version()}.so.1" for word in ("one", "two")])
        self.assertIn(names[0], needed(self.top / names[1]))
        self.assertEqual(self.check_wheel(), (0, ""))


unittest.main()
