"""The tour of the manual runs as it stands there."""

import os
import tempfile
import unittest
from pathlib import Path

from support import PLATE, SOURCE, cube


def stl(vertices, triangles):
    """ASCII STL; readers make the normals themselves."""
    lines = ["solid cube"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex %r %r %r" % tuple(map(float, vertices[i])) for i in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid cube", ""])


class Tour(unittest.TestCase):
    def test_word_for_word(self):
        manual = (SOURCE / "kernel/docs/python.md").read_text()
        # All its blocks, one after the other.
        tour = "\n".join(block.split("```")[0] for block in manual.split("```python\n")[1:])
        # On sheets of a quarter of the size, whose strokes take a fifth of the time.
        for sheet, quarter in (('"A3"', '"A5"'), ('"A4p"', '"A6p"')):
            self.assertIn(sheet, tour)
            tour = tour.replace(sheet, quarter)
        vertices, triangles = cube(30)
        names = {"vertices": vertices, "triangles": triangles, "text": PLATE, "print": lambda *_: 0}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                Path("bracket.stl").write_text(stl(*cube(20)))
                Path("base.stl").write_text(stl(*cube(50)))
                # A BREP, told by its content: the sample of that name takes long on A3.
                Path("coupling.step").write_text(PLATE)
                Path("gear_pump.step").write_bytes((SOURCE / "samples/gear_pump.step").read_bytes())
                exec(compile(tour, "python.md", "exec"), names)
                made = {path.name for path in Path().iterdir()}
            finally:
                os.chdir(before)
        self.assertLessEqual({"bracket.svg", "pump.pdf", "pump.json", "apart.svg"}, made)
        self.assertEqual(len(names["paths"]["points"]), len(names["again"].arrays()["points"]))


if __name__ == "__main__":
    unittest.main()
