"""`python3 -m burin`: the command itself, with its status."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import cube


class Command(unittest.TestCase):
    def command(self, *words):
        return subprocess.run([sys.executable, "-m", "burin", *words], capture_output=True, text=True)

    def test_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            model, out = Path(folder, "cube.obj"), Path(folder, "a.svg")
            vertices, triangles = cube()
            model.write_text("".join("v %g %g %g\n" % tuple(v) for v in vertices)
                             + "".join("f %d %d %d\n" % tuple(i + 1 for i in t) for t in triangles))
            done = self.command("draw", str(model), "-o", str(out))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("<path", out.read_text())

    def test_the_status_and_the_words_are_the_commands(self):
        done = self.command("drow")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "burin: error: unknown command 'drow'; the nearest is 'draw' (see burin --help)\n")

    def test_what_is_written_in_python(self):
        self.assertIn("usage: burin batch", self.command("help", "batch").stdout)


if __name__ == "__main__":
    unittest.main()
