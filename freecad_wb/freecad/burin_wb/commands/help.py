"""The help page."""

import os

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..text import tr
from .base import Command

PAGE = os.path.join(os.path.dirname(os.path.dirname(__file__)), "resources", "help")


def page():
    """The help page in the user's language: translation files name theirs."""
    path = os.path.join(PAGE, tr("help_en") + ".md")
    return path if os.path.exists(path) else os.path.join(PAGE, "help_en.md")


class Help(Command):
    name = "Burin_Help"
    text = "Burin help"
    tip = "What the commands do, and the way from a part to a printed page"
    icon = "burin_help.svg"
    transaction = False

    def IsActive(self):
        return True

    def run(self, document):
        with open(page(), encoding="utf-8") as file:
            text = file.read()
        window = QtGui.QDialog(Gui.getMainWindow())
        window.setObjectName("BurinHelp")
        window.setWindowTitle(QtCore.QCoreApplication.translate(self.name, self.text))
        window.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        browser = QtGui.QTextBrowser(window)
        browser.setOpenExternalLinks(True)
        browser.setMarkdown(text)
        QtGui.QVBoxLayout(window).addWidget(browser)
        window.resize(640, 720)
        window.show()
        return window


COMMANDS = [Help()]
