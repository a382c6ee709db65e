"""The add-on without its kernel, in German, from a start of FreeCAD that does not name it."""

import os
import sys

AT_THE_START = set(sys.modules)
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402


class Alone(support.Case):
    def test_says_what_to_install_and_breaks_nothing(self):
        from freecad.burin_wb import kernel

        if kernel.found():
            self.skipTest("the kernel is installed in the system")
        Gui.activateWorkbench("BurinWorkbench")
        support.settle(100)
        boxes = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QMessageBox)]
        self.assertEqual(len(boxes), 1)
        self.assertIn("cmake --install", boxes[0].informativeText())
        boxes[0].close()
        support.settle(50)
        box, ball = self.box_and_ball()
        self.select(box)
        Gui.runCommand("Burin_NewIllustration")
        support.settle(50)
        self.assertEqual(len(self.document.Objects), 2)
        self.assertFalse(Gui.Control.activeDialog())
        for w in QtGui.QApplication.topLevelWidgets():
            if isinstance(w, QtGui.QMessageBox):
                w.close()
        from freecad.burin_wb.features import make_illustration

        obj = make_illustration(self.document, [box])
        self.document.recompute()
        support.drawn(obj)
        self.assertIn("BURIN_PYTHON_PATH", obj.Message)

    def test_a_start_of_freecad_loads_little_of_it(self):
        loaded = {name for name in AT_THE_START if name.partition(".")[0] == "burin" or name.startswith("freecad.burin_wb.")}
        self.assertEqual(loaded, {f"freecad.burin_wb.{name}" for name in ("hooks", "init", "init_gui", "offers")})

    def test_speaks_german(self):
        translate = QtCore.QCoreApplication.translate
        self.assertEqual(translate("Burin_NewIllustration", "New illustration"), "Neue Illustration")
        action = Gui.Command.get("Burin_NewIllustration").getAction()[0]
        self.assertEqual(action.text().replace("&", ""), "Neue Illustration")
        self.assertEqual(translate("Burin", "Stop"), "Anhalten")
        Gui.runCommand("Burin_Help")
        window = Gui.getMainWindow().findChild(QtGui.QDialog, "BurinHelp")
        self.assertIn("Baugruppen", window.findChild(QtGui.QTextBrowser).toPlainText())
        window.close()


support.run(__name__)
