"""Commands of menus and toolbars."""

_registered = []


def register():
    """Registers all commands once; their names in the order of the toolbar."""
    if not _registered:
        import FreeCADGui as Gui

        from ..view import scheduler
        from . import export, new, page, select, style, view

        scheduler.install()
        for module in (new, view, style, page, export, select):
            for command in module.COMMANDS:
                Gui.addCommand(command.name, command)
                _registered.append(command.name)
    return list(_registered)


def context():
    """Names for the context menu."""
    return list(_registered)
