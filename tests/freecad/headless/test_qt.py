"""Differences between PySide2 and PySide6 that are bridged."""

import enum

from PySide import QtCore

from support import Case

from freecad.burin_wb.qt import number


class Qt(Case):
    def test_flags_as_numbers(self):
        class Buttons(enum.Flag):  # what PySide6 makes of QDialogButtonBox.StandardButton
            Ok = 0x400
            Cancel = 0x400000

        with self.assertRaises(TypeError):
            int(Buttons.Ok | Buttons.Cancel)
        self.assertEqual(number(Buttons.Ok | Buttons.Cancel), 0x400400)
        self.assertEqual(number(QtCore.Qt.AlignLeft | QtCore.Qt.AlignTop), 0x21)
        self.assertEqual(number(7), 7)
