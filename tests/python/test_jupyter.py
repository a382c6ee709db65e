"""Drawings in notebooks: what a real kernel of Jupyter shows of them."""

import importlib.util
import unittest

from support import SAMPLES

CELLS = [
    "import burin",
    f"burin.draw({str(SAMPLES / 'spindle.stl')!r}, style='outline')",
    f"burin.draw({str(SAMPLES / 'gear_pump.step')!r}, style='outline', callouts=True)",
    f"burin.steps({str(SAMPLES / 'coupling.step')!r}, style='outline')",
]


@unittest.skipUnless(
    importlib.util.find_spec("nbclient") and importlib.util.find_spec("ipykernel"),
    "Jupyter is not there: python3-nbclient python3-ipykernel",
)
class Notebook(unittest.TestCase):
    def test_what_a_kernel_shows(self):
        import nbclient
        import nbformat

        notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in CELLS])
        nbclient.NotebookClient(notebook, timeout=240, kernel_name="python3").execute()
        plain, numbered, book = (cell["outputs"][0]["data"] for cell in notebook.cells[1:])
        self.assertTrue(plain["image/svg+xml"].startswith("<?xml"))
        self.assertIn("<path", plain["image/svg+xml"])
        self.assertNotIn("text/html", plain)  # a notebook would show that before the SVG
        self.assertIn("image/svg+xml", numbered)
        self.assertTrue(numbered["text/html"].startswith("<iframe srcdoc="))
        self.assertIn("data-item=&quot;6&quot;", numbered["text/html"])
        self.assertGreaterEqual(book["text/html"].count("<svg"), 3)


if __name__ == "__main__":
    unittest.main()
