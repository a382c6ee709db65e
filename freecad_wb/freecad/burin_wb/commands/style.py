"""The style of an illustration, and the panel that edits everything of it."""

from ..tasks import edit, show
from ..tasks.style import StylePanel
from .base import Command, one_illustration, selected_illustrations


class Style(Command):
    name = "Burin_Style"
    text = "Style"
    tip = "Chooses a style and edits its keys, shown as they change; saves it as a file"
    icon = "burin_style.svg"
    transaction = False  # the panel's own
    needs_kernel = True

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        document.openTransaction(self.text)
        show(StylePanel(illustration))


class Edit(Command):
    name = "Burin_Edit"
    text = "Edit illustration"
    tip = "Opens the panel of the selected illustration (a double-click in the tree does too)"
    icon = "burin_illustration.svg"
    transaction = False

    def possible(self):
        return len(selected_illustrations()) == 1

    def run(self, document):
        illustration = one_illustration()
        edit(illustration)


COMMANDS = [Style(), Edit()]
