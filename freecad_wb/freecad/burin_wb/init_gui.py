"""Run by FreeCAD's GUI at every start: only names here, the rest is imported when the workbench is first used."""

import os

import FreeCADGui as Gui

from freecad.burin_wb import hooks

_RESOURCES = os.path.join(os.path.dirname(__file__), "resources")


class BurinWorkbench(Gui.Workbench):
    """Illustrations of parts and assemblies."""

    MenuText = "Burin"
    ToolTip = "Line art of parts and assemblies: contours, hidden lines removed, strokes that follow the surface"
    Icon = os.path.join(_RESOURCES, "icons", "burin.svg")

    def Initialize(self):
        from freecad.burin_wb import commands

        commands.register()
        self.appendToolbar("Burin", commands.toolbar())
        self.appendMenu("&Burin", commands.menu())

    def Activated(self):
        from freecad.burin_wb import kernel

        if not kernel.found():
            from freecad.burin_wb.commands import base

            base.ask_for_kernel()
            return
        from freecad.burin_wb import tasks
        from freecad.burin_wb.view import scheduler

        scheduler.install().warm()
        tasks.warm()

    def ContextMenu(self, recipient):
        from freecad.burin_wb import commands

        self.appendContextMenu("Burin", commands.context())

    def GetClassName(self):
        return "Gui::PythonWorkbench"


class PreferencesPage:
    """FreeCAD makes one when the preferences are opened."""

    def __init__(self):
        from freecad.burin_wb.tasks.preferences import Page

        self._page = Page()
        self.form = self._page.form

    def loadSettings(self):
        self._page.load()

    def saveSettings(self):
        self._page.save()


def _dress(obj):
    from freecad.burin_wb import view

    view.dress(obj)


def _edit(obj):
    from freecad.burin_wb import tasks

    tasks.edit(obj)


hooks.dress, hooks.edit = _dress, _edit
Gui.addLanguagePath(os.path.join(_RESOURCES, "translations"))
Gui.updateLocale()
Gui.addIconPath(os.path.join(_RESOURCES, "icons"))
Gui.addPreferencePage(PreferencesPage, "Burin")
Gui.addWorkbench(BurinWorkbench())
