"""Words in the user's language."""

from PySide import QtCore


def tr(text):
    return QtCore.QCoreApplication.translate("Burin", text)
