"""The panel that numbers the parts of an illustration and lists them."""

from PySide import QtCore

from .. import item_numbers
from ..errors import Refused
from ..features import items, spreadsheet
from ..features.asking import items_in, items_job
from ..features.sheet import Sheet
from ..text import tr
from ..view import scheduler
from . import widgets
from .lights import Lights
from .panel import Panel


class ItemsPanel(Panel):
    @property
    def title(self):
        return tr("Number parts")

    def fill(self):
        self.items = []
        self.callouts = widgets.check(self.obj.Callouts, tr("Numbers in the drawing"), tr("A number with a leader at each item"),
                                      lambda on: self.change("Callouts", on), "callouts")
        self.list = widgets.check(self.obj.PartsList, tr("Parts list on the sheet"),
                                  tr("A list of the items above the lower right corner"), lambda on: self.change("PartsList", on), "parts-list")
        self.column.addWidget(self.callouts)
        self.column.addWidget(self.list)
        self.legend = widgets.check(self.obj.Legend, tr("Legend of colours on the sheet"), tr("The colours of parts with their names"),
                                    lambda on: self.change("Legend", on), "legend")
        self.column.addWidget(self.legend)
        self.table = widgets.table([tr("Name"), tr("No."), tr("Quantity")],
                                   (tr("A row lights up its objects in the 3-D view; objects that are selected there mark their rows"),
                                    tr("Another number; an item that has it gets this one"), tr("How many objects are of this item")), "items")
        self.table.itemChanged.connect(lambda cell: self._edited(cell))
        self.column.addWidget(self.table, 1)
        widgets.row(self.column,
                    widgets.button(tr("Renumber"), tr("Numbers from 1 in the order of the assembly, without holes"), self._renumber, "renumber"),
                    widgets.button(tr("Clockwise"), tr("Numbers from 1 around the drawing, from the top on"), self._clockwise, "clockwise"),
                    widgets.button(tr("Spreadsheet"), tr("Writes the list into a spreadsheet of the document, and puts that on the pages that "
                                                         "show the illustration"), self._spreadsheet, "spreadsheet"))
        self.lights = Lights(self.document, self.table, lambda row: self.items[row]["sources"])
        self.ask()

    def ask(self):
        """Looks which items there are now."""
        try:
            job = items_job(self.obj)
        except Refused as why:
            QtCore.QTimer.singleShot(0, lambda text=str(why): self.message.setText(text))
            return
        scheduler.install().ask("items", self.obj, job, lambda answer, error: self._answered(job, answer, error))

    def _answered(self, job, answer, error):
        if self.over or not self.alive() or error is not None:
            return
        self.show(items_in(job, answer))
        self._keep(item_numbers.kept(dict(self.obj.ItemNumbers), self.items))

    def _keep(self, numbers):
        """Numbers are drawn only where the drawing shows them."""
        if numbers != dict(self.obj.ItemNumbers):
            self.obj.ItemNumbers = numbers
            if self.obj.Callouts or self.obj.PartsList:
                self.changed()

    def refresh(self):
        self.ask()

    def closing(self):
        self.lights.stop()

    def show(self, found):
        self.items = sorted(found, key=lambda item: item["number"])
        self.table.blockSignals(True)
        self.table.setRowCount(len(self.items))
        for r, item in enumerate(self.items):
            self.table.setItem(r, 0, widgets.cell(item["name"], tip="\n".join(item["sources"][:20])))
            self.table.setItem(r, 1, widgets.cell(str(item["number"]), edited=True))
            self.table.setItem(r, 2, widgets.cell(str(item["quantity"])))
        self.table.blockSignals(False)
        self.lights.mark()

    # --- numbers ---

    def _edited(self, cell):
        old, text = str(self.items[cell.row()]["number"]), cell.text().strip()
        if not text.isdigit() or not 1 <= int(text) <= 99999:
            self.message.setText(tr("an item has a number from 1 to 99999"))
            QtCore.QTimer.singleShot(0, lambda: self.over or self.show(self.items))  # not while the cell tells
        elif text != old:
            numbers = items.renumbered(item_numbers.kept(dict(self.obj.ItemNumbers), self.items), old, str(int(text)))
            QtCore.QTimer.singleShot(0, lambda: self.over or self._use(numbers))

    def _renumber(self):
        self._use(items.in_order(self.items))

    def _clockwise(self):
        places = items.places_of(Sheet(self.obj.Drawing)) if self.obj.Drawing else {}
        if not places:
            self.message.setText(tr("the drawing has no numbers yet"))
            return
        self._use(items.clockwise(self.items, places))

    def _use(self, numbers):
        number_of = {name: int(number) for number, name in numbers.items()}
        self._keep(numbers)
        self.show([{**item, "number": number_of.get(item["name"], item["number"])} for item in self.items])

    def _spreadsheet(self):
        sheet = spreadsheet.write(self.obj, self.items)
        for page in spreadsheet.pages_of(self.obj):
            spreadsheet.place_on_page(page, sheet, len(self.items) + 1)
        self.message.setText(tr("written to {0}").format(sheet.Label))
