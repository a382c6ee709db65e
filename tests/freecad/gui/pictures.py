"""Pictures of the tutorial: those that a test makes are like those in the docs. BURIN_TEST_RENEW=1 renews them."""

import os
import pathlib
import shutil
import subprocess

import FreeCAD
import support
from similarity import similarity

DOCS = pathlib.Path(__file__).resolve().parents[3] / "freecad_wb" / "docs"

# Pictures of windows hold text, whose fonts differ between machines; pictures of drawings do not. In another
# Debian another OCCT parts a shape into other faces and triangles, on which single strokes lie elsewhere, and the letters of
# another osifont are a fifth narrower, which leaves pictures beside lists more room.
WINDOW, DRAWING, DRAWING_IN_ANOTHER_DEBIAN = 0.8, 0.9, 0.7

# The release of FreeCAD whose windows the docs show; others have other toolbars and panels.
SHOWN = ["0", "20"]


class Pictures(support.Case):
    def look(self, picture, least, size=None, colors=48):
        """Compares a picture with the one in the docs; one of a window only in the release that they show."""
        if least == WINDOW and FreeCAD.Version()[:2] != SHOWN:
            print(f"{picture.stem}: not compared, for this is FreeCAD {'.'.join(FreeCAD.Version()[:2])}")
            return
        small = support.OUT / f"{picture.stem}-small.png"
        resize = ["-resize", size] if size else []
        subprocess.run(["convert", str(picture), *resize, "+dither", "-colors", str(colors), "-strip", f"PNG8:{small}"], check=True)
        reference = DOCS / "images" / f"{picture.stem}.png"
        if os.environ.get("BURIN_TEST_RENEW"):
            shutil.copy(small, reference)
        self.assertLess(reference.stat().st_size, 150_000)
        value = similarity(small, reference)
        print(f"{picture.stem}: similarity {value:.3f}")
        self.assertGreater(value, least, picture.stem)

    def look_at_page(self, pdf, name, number=1):
        if not shutil.which("pdftoppm"):
            print("pdftoppm (package poppler-utils) is not installed: the PDF is not looked at")
            return
        # At four times the size first: no line is thinner than a pixel to the eye of pdftoppm.
        subprocess.run(["pdftoppm", "-r", "200", "-png", "-singlefile", "-f", str(number), str(pdf), str(support.OUT / name)], check=True)
        least = DRAWING if FreeCAD.Version()[:2] == SHOWN else DRAWING_IN_ANOTHER_DEBIAN
        self.look(support.OUT / f"{name}.png", least, "25%", 16)
