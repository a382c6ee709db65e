"""Plug-ins in FreeCAD: their names and options stand in the panel of styles, and the worker draws with them."""

import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import support  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
from PySide import QtGui  # noqa: E402


def child(kind, name):
    return support.panel().form.findChild(kind, name)


class Plugins(support.Case):
    def setUp(self):
        super().setUp()
        self.obj = self.illustrate(*self.box_and_ball())

    def drawn(self):
        support.drawn()

    def test_a_direction_is_chosen_and_its_option_changed_in_the_panel(self):
        Gui.runCommand("Burin_Style")
        field = child(QtGui.QComboBox, "hatch.field")
        self.assertGreaterEqual(field.findData("spiral"), 0)
        field.setCurrentIndex(field.findData("spiral"))
        self.drawn()
        before = open(self.obj.Picture).read()
        climb = child(QtGui.QDoubleSpinBox, "hatch.spiral.climb")
        self.assertEqual((climb.minimum(), climb.maximum()), (-89, 89))
        climb.setValue(50)
        self.drawn()
        self.assertEqual(dict(self.obj.StyleKeys), {"hatch.field": "spiral", "hatch.spiral.climb": "50"})
        self.assertNotEqual(open(self.obj.Picture).read(), before)
        support.panel().accept()
        self.assertIn("tone.grain.steps", json.dumps([row["key"] for row in self.kernel_keys()]))

    @staticmethod
    def kernel_keys():
        from freecad.burin_wb import kernel

        return kernel.module().style_keys()


support.run(__name__)
