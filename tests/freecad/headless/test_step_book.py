"""Step books: what a macro asks for is what the kernel writes."""

import os
import re

from pump import pump
from support import Case, burin, content

from freecad.burin_wb import step_book
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import asking, explosion
from freecad.burin_wb.features.illustration import make_job
from freecad.burin_wb.kept_scene import KeptScene


class StepBook(Case):
    def stack(self, **properties):
        return self.illustration(pump(self.doc), Style="outline", **properties)

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_all_kinds_by_steps_that_are_found(self):
        obj = self.stack()
        before = dict((name, repr(getattr(obj, name))) for name in obj.PropertiesList)
        files = [self.path("pump" + suffix) for suffix in step_book.KINDS]
        steps = step_book.write(obj, *files)
        self.assertEqual(steps, 2, "the lid on the plate, the bolts")
        self.assertTrue(content(files[0]).startswith(b"%PDF"))
        page, text = content(files[1]).decode(), content(files[2]).decode()
        self.assertIn("<title>Illustration", page)
        self.assertEqual(len(re.findall("pump-step-", text)), steps)
        self.assertEqual(sorted(name for name in os.listdir(self.folder) if name.endswith(".svg")),
                         [f"pump-step-{k:02d}.svg" for k in range(1, steps + 1)])
        for name in ("Bolt", "Lid", "Plate"):
            self.assertIn(name, text)
        self.assertEqual(before, dict((name, repr(getattr(obj, name))) for name in obj.PropertiesList), "nothing changes")

    def test_by_its_own_steps_view_paper_and_numbers(self):
        obj = self.stack(Width=150, Height=110, ItemNumbers={"7": "Lid"}, Callouts=True, Projection="Perspective", Views=["front"],
                         Details=["Pump.Bolt"], PartsList=True)
        explosion.set_steps(obj, [explosion.Step(["Pump.Bolt", "Pump.Bolt001", "Pump.Lid"], (0, 0, 1), 40)])
        job = step_book.job_of(obj, [self.path("a.pdf")])
        self.assertEqual(set(job.options["illustration"]), {"title", "explode", "items"})
        self.assertEqual(job.options["illustration"]["explode"], {"steps": [{"move": ["@index=1", "@index=2", "@index=3"], "along": [0, 0, 1],
                                                                            "by": 40, "trail": True}]})
        self.assertEqual((job.options["perspective"], job.options["paper"], job.notes), (35, (150, 110), []))
        markdown = self.path("a.md")
        self.assertEqual(step_book.write(obj, markdown), 1)
        self.assertRegex(content(markdown).decode(), r"\n\| 7 \| 1 \| Lid \|")
        self.assertIn(b'width="150mm" height="110mm"', content(self.path("a-step-01.svg"))[:600])

    def test_new_items_part_steps(self):
        obj = self.stack()
        explosion.set_steps(obj, [explosion.Step(["Pump.Bolt", "Pump.Bolt001", "Pump.Lid"], (0, 0, 1), 40)])
        self.assertEqual(step_book.write(obj, self.path("a.html"), new_items=1), 2)
        self.assertEqual(step_book.write(obj, self.path("b.html"), new_items=2), 1)

    def test_a_step_that_moves_what_is_gone_is_told(self):
        obj = self.stack(Explode=True)
        explosion.set_steps(obj, asking.find_steps(obj)[0])
        self.doc.removeObject("Lid")
        self.doc.recompute()
        for on in (True, False):
            obj.Explode = on
            notes = step_book.job_of(obj, [self.path("a.pdf")]).notes
            self.assertEqual(len([note for note in notes if "Pump.Lid" in note]), 1, (on, notes))

    def test_refused_with_what_to_do(self):
        obj = self.stack()
        for files, items, words in ((["a.doc"], 6, r"a.doc: a step book is a file that ends with .pdf, .html, .md"), ([], 6, "needs a file"),
                                    (["a.pdf"], 0, "one item at the least"), ([self.path("none/a.pdf")], 6, "^Illustration: .*none")):
            with self.assertRaisesRegex(Refused, words):
                step_book.write(obj, *files, new_items=items)
        self.assertEqual(os.listdir(self.folder), [])
        obj.Sources = []
        with self.assertRaisesRegex(Refused, "nothing to draw"):
            step_book.write(obj, self.path("a.pdf"))

    def test_one_part_alone_is_one_page(self):
        obj = self.illustration(self.box(), Style="outline")
        self.assertEqual(step_book.write(obj, self.path("a.pdf")), 1)

    def test_here_without_a_process_it_is_the_same(self):
        obj = self.stack()
        job = step_book.job_of(obj, [self.path("here.html")])
        steps, messages = job.write_book(burin())
        self.assertEqual((steps, messages), (2, []))
        step_book.write(obj, self.path("there.html"))
        self.assertEqual(content(self.path("here.html")), content(self.path("there.html")))

    def test_drawings_after_it_are_as_before(self):
        obj = self.stack(Sections=["y"], Callouts=True)
        kept = KeptScene(burin())
        job = make_job(obj)
        before = job.draw(burin(), kept=kept).to_bytes("json")
        step_book.job_of(obj, [self.path("a.md")]).write_book(burin(), kept=kept)
        self.assertIn("Bolt", content(self.path("a.md")).decode())
        self.assertEqual(job.draw(burin(), kept=kept).to_bytes("json"), before)

    def test_cancelled_it_writes_nothing(self):
        obj = self.stack()
        job = step_book.job_of(obj, [self.path("a.pdf")])
        cancel = burin().Cancel()
        with self.assertRaises(burin().Cancelled):
            job.write_book(burin(), lambda stage, share: cancel.cancel(), cancel)
        self.assertEqual(os.listdir(self.folder), [])
