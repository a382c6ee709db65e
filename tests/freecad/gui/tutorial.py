"""The way of freecad_wb/docs/README.md, by commands and panel as told there, and as its script; its pictures are the
references. BURIN_TEST_RENEW=1 renews them."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from pictures import DOCS, DRAWING, WINDOW, Pictures  # noqa: E402
from PySide import QtGui  # noqa: E402
from similarity import similarity  # noqa: E402

sys.path.insert(0, str(DOCS))
import bearing  # noqa: E402

class Tutorial(Pictures):
    def test_by_hand(self):
        import TechDrawGui

        for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
            dock.setVisible(dock.windowTitle() == "Combo View")
        part = bearing.assembly(self.document)
        view = Gui.ActiveDocument.ActiveView
        view.viewIsometric()
        view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(1.6, 1, 0), FreeCAD.Vector(0, 0, 1),
                                                   FreeCAD.Vector(1, -1.6, 1.1), "ZXY"))
        view.fitAll()
        self.select(part)
        self.look(support.screenshot("1-select"), WINDOW, "800x")
        Gui.runCommand("Burin_NewIllustration")
        panel = support.panel()
        panel.style.setCurrentIndex(panel.style.findData("engraving"))
        panel.width.setProperty("rawValue", 360.0)
        panel.height.setProperty("rawValue", 250.0)
        support.settle(300)
        support.drawn(panel.obj)
        self.assertEqual(panel.obj.Message, "")
        self.look(support.screenshot("2-panel"), WINDOW, "800x")
        obj = panel.obj
        panel.accept()
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(400)
        Gui.Selection.clearSelection()
        self.look(support.screenshot("3-page"), WINDOW, "800x")
        page = self.document.Page
        pdf = support.OUT / "bearing.pdf"
        TechDrawGui.exportPageAsPdf(page, str(pdf))
        self.look_at_page(pdf, "4-pdf")

    def test_as_a_script(self):
        pdf = support.OUT / "bearing-script.pdf"
        page = bearing.whole(str(pdf))
        self.assertEqual(page.Views[0].Illustration.Message, "")
        self.look_at_page(pdf, "4-pdf")

    def test_the_ink_in_the_3d_view(self):
        obj = bearing.illustration(self.document, bearing.assembly(self.document))
        obj.Style = "technical"
        self.document.recompute()
        support.drawn()
        obj.ViewObject.Paper = True
        view = Gui.ActiveDocument.ActiveView
        view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 75) * FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 60))
        view.fitAll()
        self.look(support.picture("5-ink"), DRAWING)
        obj.ViewObject.Visibility = False
        self.assertLess(similarity(support.picture("no-ink"), support.OUT / "5-ink.png"), 0.98)


support.run(__name__)
