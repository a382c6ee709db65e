"""The second way of freecad_wb/docs/README.md, an assembly from a STEP file explained, by commands and panels as told there, and as its
script; its pictures are the references. BURIN_TEST_RENEW=1 renews them."""

import os
import pathlib
import sys
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from pictures import DOCS, WINDOW, Pictures  # noqa: E402
from PySide import QtGui  # noqa: E402

sys.path.insert(0, str(DOCS))
import gear_pump  # noqa: E402

from freecad.burin_wb.features import details  # noqa: E402
from freecad.burin_wb.view import book  # noqa: E402

PUMP = str(pathlib.Path(__file__).resolve().parents[3] / "samples" / "gear_pump.step")
V = FreeCAD.Vector


def look_from(direction, up):
    """Turns the 3-D view."""
    view = Gui.ActiveDocument.ActiveView
    across = up.cross(direction)
    view.setCameraOrientation(FreeCAD.Rotation(across, direction.cross(across), direction, "ZXY"))
    view.fitAll()
    support.settle()


class Tutorial(Pictures):
    def illustrate_by_hand(self, part, width, height):
        self.select(part)
        Gui.runCommand("Burin_NewIllustration")
        panel = support.panel()
        panel.style.setCurrentIndex(panel.style.findData("engraving"))
        panel.width.setProperty("rawValue", width)
        panel.height.setProperty("rawValue", height)
        self.wait()
        obj = panel.obj
        panel.accept()
        support.settle()
        return obj

    def open(self, command, obj):
        self.select(obj)
        Gui.runCommand(command)
        self.wait()
        return support.panel()

    def wait(self):
        support.drawn()

    def test_by_hand(self):
        import TechDrawGui

        for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
            dock.setVisible(dock.windowTitle() == "Combo View")
        part = gear_pump.assembly(self.document, PUMP)
        look_from(V(1, -1.2, 0.8), V(0, 1, 0))
        obj = self.illustrate_by_hand(part, 390.0, 270.0)
        obj.ViewObject.Visibility = False
        panel = self.open("Burin_Explode", obj)
        self.assertEqual(len(panel.steps), 11)
        Gui.ActiveDocument.ActiveView.fitAll()
        self.wait()
        self.assertEqual(panel.message.text(), "drawn")
        self.look(support.screenshot("6-explode"), WINDOW, "800x")
        panel.accept()
        panel = self.open("Burin_NumberParts", obj)
        panel.callouts.setChecked(True)
        panel.list.setChecked(True)
        self.wait()
        panel.table.selectRow(9)
        Gui.ActiveDocument.ActiveView.fitAll()
        self.look(support.screenshot("7-numbers"), WINDOW, "800x")
        self.assertEqual([(i["number"], i["name"], i["quantity"]) for i in panel.items][8:], [(9, "dowel", 2), (10, "screw M6", 6), (11, "washer 6", 6)])
        panel.accept()
        self.wait()
        self.assertEqual(obj.Message, "")
        self.select(obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(400)
        pdf = support.OUT / "pump.pdf"
        TechDrawGui.exportPageAsPdf(self.document.Page, str(pdf))
        self.look_at_page(pdf, "8-pump")
        support.close_pages()
        look_from(V(0.5, -1, 0.6), V(0, 0, 1))
        other = self.illustrate_by_hand(part, 270.0, 180.0)
        panel = self.open("Burin_Section", other)
        whole = gear_pump.paths(part, "drive shaft", "idler shaft", "key", "dowel")
        self.select(*((part, path.partition(".")[2] + ".") for path in whole))
        panel.form.findChild(QtGui.QPushButton, "exclude").click()
        shown = [panel.whole.item(k).text() for k in range(panel.whole.count())]
        dowels = ["dowel001"] if part.getSubObject("Link001.", retType=1).ElementCount else ["dowel", "dowel001"]  # an array or not
        self.assertEqual(shown, ["drive shaft", "key", "idler shaft", "key001", *dowels])
        self.wait()
        Gui.Selection.clearSelection()
        self.assertEqual(panel.list.item(0).text(), "-y at 0 mm")
        self.look(support.screenshot("9-section"), WINDOW, "800x")
        panel.accept()
        self.wait()
        self.assertEqual(other.Message, "")
        dowel = gear_pump.dowel(part)
        self.select(other, (part, dowel.partition(".")[2] + "."))
        Gui.runCommand("Burin_Detail")
        self.wait()
        panel = support.panel()
        self.assertEqual(panel.table.item(0, 0).text(), "dowel")
        for column, text in ((2, "4:1"), (3, "9")):
            panel.table.item(0, column).setText(text)
            support.settle()
        self.wait()
        self.assertEqual(panel.message.text(), "drawn")
        panel.accept()
        self.wait()
        self.assertEqual(details.entries_of(other), [{"select": [dowel], "scale": "4:1", "radius": 9.0}])
        self.write_book(obj, support.OUT / "pump-steps.pdf")
        self.look_at_page(support.OUT / "pump-steps.pdf", "12-step-book", 6)

    def write_book(self, obj, path):
        """By the command."""
        path.unlink(missing_ok=True)
        with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (str(path), "")), \
                unittest.mock.patch.object(QtGui.QInputDialog, "getInt", lambda *_: (6, True)):
            self.select(obj)
            Gui.runCommand("Burin_StepBook")
        self.assertTrue(support.until(lambda: not book.busy()))

    def test_as_a_script(self):
        pdfs = [str(support.OUT / name) for name in ("pump-script.pdf", "section-script.pdf", "detail-script.pdf")]
        pages = gear_pump.whole(PUMP, *pdfs)
        self.assertEqual([page.Views[0].Illustration.Message for page in pages], ["", "", ""])
        self.look_at_page(pdfs[0], "8-pump")
        self.look_at_page(pdfs[1], "10-section")
        self.look_at_page(pdfs[2], "11-detail")
        steps = support.OUT / "steps-script.pdf"
        self.assertEqual(gear_pump.book(pages[0].Views[0].Illustration, str(steps)), 11)
        self.look_at_page(steps, "12-step-book", 6)


support.run(__name__)
