"""Bad input: a message that says what to do, the drawing as it was, the next run as if nothing had been."""

import importlib.machinery
import json
import os
import sys
import shutil
import signal
import stat
import threading

import Part

from support import V, App, Case, content, features

from freecad.burin_wb import export, kernel, worker
from freecad.burin_wb.errors import Refused
from freecad.burin_wb.features import illustration as module
from freecad.burin_wb.job import Brep, Job, PartJob


class Errors(Case):
    def refuses(self, obj, *words):
        """The run of `obj` fails with a message that has all `words`, and what was drawn stays."""
        before = (content(obj.Drawing), content(obj.Picture), obj.Inputs) if obj.Drawing else None
        self.redraw(obj)
        for word in words:
            self.assertIn(word, obj.Message)
        self.assertNotIn("\n", obj.Message)
        if before:
            self.assertEqual((content(obj.Drawing), content(obj.Picture), obj.Inputs), before)
            self.assertIn("the drawing before is kept", obj.Message)

    def draws(self, obj):
        self.redraw(obj)
        self.assertEqual(obj.Message, "")
        self.assertTrue(os.path.exists(obj.Drawing))

    def test_no_sources(self):
        obj = self.illustration()
        self.refuses(obj, "Sources is empty; choose")
        obj.Sources = [(self.box(), ("",))]
        self.draws(obj)
        obj.Sources = []
        self.refuses(obj, "Sources is empty")

    def test_the_source_was_deleted(self):
        obj = self.illustration(self.box())
        self.doc.removeObject("Box")
        self.refuses(obj, "nothing to draw", "choose")

    def test_one_object_of_an_assembly_was_deleted(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.box())
        obj = features.make_illustration(self.doc, [(part, ("Box.",))])
        self.draws(obj)
        self.doc.removeObject("Box")
        self.refuses(obj, "Part.Box", "is gone; choose the sources again")

    def test_a_sketch_only(self):
        sketch = self.doc.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.LineSegment(V(0, 0, 0), V(1, 0, 0)), False)
        self.doc.recompute()
        obj = self.illustration(sketch)
        self.refuses(obj, "Sketch", "no faces", "choose a solid")
        obj.Sources = [(sketch, ("",)), (self.box(), ("",))]
        self.redraw(obj)
        self.assertIn("Sketch", obj.Message)  # the box is drawn, the sketch told
        self.assertTrue(obj.Drawing)

    def test_a_null_shape(self):
        obj = self.illustration(self.doc.addObject("Part::Feature", "Nothing"))
        self.refuses(obj, "Nothing", "has no shape; recompute it, or choose")

    def test_an_empty_body_and_an_empty_mesh(self):
        obj = self.illustration(self.doc.addObject("PartDesign::Body", "Body"))
        self.refuses(obj, "Body", "has no shape")
        obj.Sources = [(self.doc.addObject("Mesh::Feature", "Mesh"), ("",))]
        self.refuses(obj, "Mesh", "is an empty mesh")

    def test_invalid_shapes_draw_or_are_named(self):
        # A bow tie: its wire crosses itself.
        wire = Part.makePolygon([V(0, 0, 0), V(10, 10, 0), V(10, 0, 0), V(0, 10, 0), V(0, 0, 0)])
        bow = self.solid(Part.Face(wire), "Bow")
        self.assertFalse(bow.Shape.isValid())
        obj = self.illustration(bow)
        self.assertTrue(obj.Drawing or "Bow" in obj.Message, obj.Message)
        # A solid with a face missing.
        faces = Part.makeBox(10, 10, 10).Faces[:-1]
        obj = self.illustration(self.solid(Part.Solid(Part.Shell(faces)), "Open"))
        self.assertTrue(obj.Drawing or "Open" in obj.Message, obj.Message)

    def faulty_job(self):
        """A job of a box and of what OCCT calls faulty."""
        wire = Part.makePolygon([V(0, 0, 0), V(10, 10, 0), V(10, 0, 0), V(0, 10, 0), V(0, 0, 0)])
        texts = {"Box": Part.makeBox(1, 2, 3).exportBrepToString().encode(),
                 "Bow": Part.Face(wire).exportBrepToString().encode()}
        return Job([PartJob(name, name, Brep(text)) for name, text in texts.items()], {"style": "outline"})

    def test_a_run_that_fails_for_its_shapes_names_the_faulty_ones(self):
        job = self.faulty_job()
        job.parts.append(PartJob("Torn", "Torn", job.parts[0].brep[:700]))
        with self.assertRaises(worker.Failed) as caught:
            module._worker.draw(job)
        self.assertIn("; faulty shapes (see Part > Check geometry): Bow, Torn", str(caught.exception))

    def test_a_crash_names_the_faulty_shapes(self):
        one = worker.Worker()
        try:
            one.start()
            os.kill(one._process.pid, signal.SIGSTOP)
            for seconds, number in ((0.3, signal.SIGSEGV), (0.35, signal.SIGCONT)):
                threading.Timer(seconds, os.kill, (one._process.pid, number)).start()
            with self.assertRaises(worker.Failed) as caught:
                one.draw(self.faulty_job())
            self.assertIn("ended unexpectedly (signal 11)", str(caught.exception))
            self.assertIn("; faulty shapes (see Part > Check geometry): Bow", str(caught.exception))
        finally:
            one.stop()

    def test_an_error_that_is_not_about_shapes_checks_none(self):
        wire = Part.makePolygon([V(0, 0, 0), V(10, 10, 0), V(10, 0, 0), V(0, 10, 0), V(0, 0, 0)])
        obj = self.illustration(self.box(), self.solid(Part.Face(wire), "Bow"), StyleKeys={"line.outr": "1"})
        self.assertIn("line.outr", obj.Message)
        self.assertNotIn("faulty", obj.Message)

    def test_a_source_whose_recompute_failed(self):
        box = self.box()
        cut = self.doc.addObject("Part::Fillet", "Fillet")
        cut.Base = box
        cut.Edges = [(1, 1.0, 1.0)]
        obj = self.illustration(cut)
        self.assertEqual(obj.Message, "")
        cut.Edges = [(1, 1000.0, 1000.0)]
        self.redraw(obj)
        self.assertIn("Invalid", cut.State)
        self.redraw(obj)
        self.assertTrue(os.path.exists(obj.Drawing))
        cut.Edges = [(1, 2.0, 2.0)]
        self.doc.recompute()
        self.draws(obj)

    def test_a_link_to_a_missing_file(self):
        other = App.newDocument("Other")
        other.addObject("Part::Box", "Box")
        other.recompute()
        path = os.path.join(self.folder, "other.FCStd")
        other.saveAs(path)
        self.doc.saveAs(os.path.join(self.folder, "this.FCStd"))
        link = self.doc.addObject("App::Link", "Link")
        link.LinkedObject = other.Box
        obj = self.illustration(link)
        self.assertEqual(obj.Message, "")
        before, name = content(obj.Drawing), obj.Name
        self.doc.save()
        App.closeDocument("Other")
        App.closeDocument(self.doc.Name)
        os.unlink(path)
        self.doc = App.openDocument(os.path.join(self.folder, "this.FCStd"))
        obj = self.doc.getObject(name)
        self.assertEqual(content(obj.Drawing), before)
        self.doc.recompute()  # FreeCAD tells of the link itself, and goes no further
        self.assertIn("Invalid", self.doc.Link.State)
        obj.recompute()
        self.assertIn("links to something that is not there; open the file", obj.Message)
        self.assertEqual(content(obj.Drawing), before)

    def test_a_link_to_nothing(self):
        obj = self.illustration(self.doc.addObject("App::Link", "Link"))
        self.refuses(obj, "links to something that is not there", "repair the link")

    def test_an_assembly_with_nothing_visible(self):
        part = self.doc.addObject("App::Part", "Part")
        box = self.box()
        part.addObject(box)
        box.Visibility = False
        obj = self.illustration(part)
        self.refuses(obj, "Part", "no visible shape in it; show what is to be drawn")
        box.Visibility = True
        self.draws(obj)

    def test_values_that_make_no_sense(self):
        obj = self.illustration(self.box())
        for name, bad in (("ViewDirection", V(0, 0, 0)), ("ViewUp", V(1, -1, 1)), ("Width", 0), ("Margin", 500),
                          ("Scale", -1), ("Light", V(0, 0, 0)), ("StyleKeys", {"no.such": "1"}),
                          ("StyleKeys", {"line.outer": "thick"}), ("Style", "no such style"),
                          ("Looks", {"Box": "style=no such style"})):
            good = getattr(obj, name)
            if name == "Scale":
                obj.FitScale = False
            setattr(obj, name, bad)
            self.redraw(obj)
            if name == "ViewUp":  # something sensible is drawn instead
                self.assertNotIn("the drawing before is kept", obj.Message, name)
            else:
                self.assertIn("the drawing before is kept", obj.Message, name)
            setattr(obj, name, good)
            obj.FitScale = True
            self.draws(obj)

    def test_words_of_looks_that_are_not_known(self):
        obj = self.illustration(self.box(), Looks={"Box": "not hatchd"})
        self.assertIn("not hatchd", obj.Message)
        self.assertTrue(obj.Drawing)

    def test_the_style_file_is_gone(self):
        path = os.path.join(self.folder, "mine.json")
        with open(path, "w") as file:
            json.dump({"base": "outline"}, file)
        obj = self.illustration(self.box(), Style=path)
        os.unlink(path)
        self.refuses(obj, path, "is gone; put it back, or choose another style")
        with open(path, "w") as file:
            file.write("{ no style")
        self.refuses(obj, "mine.json")
        obj.Style = "technical"
        self.draws(obj)
        obj.Looks = {"Box": "style=/nowhere/at/all.json"}
        self.refuses(obj, "/nowhere/at/all.json is gone")

    def test_the_page_was_deleted(self):
        obj = self.illustration(self.box())
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        features.place_on_page(page, obj)
        self.doc.recompute()
        self.doc.removeObject(page.Name)
        self.doc.Box.Length = 15
        self.doc.recompute()
        self.draws(obj)
        self.assertNotIn("IllustrationView", [o.Name for o in self.doc.Objects])  # views go with their page

    def test_the_illustration_was_deleted(self):
        obj = self.illustration(self.box())
        page = self.doc.addObject("TechDraw::DrawPage", "Page")
        view = features.place_on_page(page, obj)
        self.doc.recompute()
        symbol = view.Symbol
        self.doc.removeObject(obj.Name)
        view.touch()
        self.doc.recompute()
        self.assertEqual(view.Symbol, symbol)

    def test_a_read_only_document(self):
        obj = self.illustration(self.box())
        obj = self.reopen(obj)
        os.chmod(self.doc.FileName, stat.S_IRUSR)
        self.doc.Box.Length = 12
        self.doc.recompute()
        self.draws(obj)  # in memory, as all changes of such a document

    def test_no_room_for_the_drawing(self):
        obj = self.illustration(self.box())
        obj.Seed = 7
        folder = self.doc.TransientDir
        shutil.move(folder, folder + ".away")
        try:
            self.redraw(obj)
            self.assertIn("cannot be kept in the document", obj.Message)
        finally:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.move(folder + ".away", folder)
        self.draws(obj)

    def test_without_the_kernel(self):
        obj = self.illustration(self.box())
        before = content(obj.Drawing)
        running, module._worker = module._worker, worker.Worker()
        folders, kernel.folders = kernel.folders, lambda: []
        found, kernel.found = kernel.found, lambda: False
        try:
            obj = self.reopen(obj)
            self.assertEqual(content(obj.Drawing), before)
            self.redraw(obj)
            self.assertEqual(obj.Message, "")  # nothing changed: nothing to be told
            self.doc.Box.Length = 12
            self.refuses(obj, "The drawing kernel (the Python module 'burin') was not found", "install")
            for one in (obj, features.make_illustration(self.doc, [self.doc.Box])):  # drawn before, and never
                target = os.path.join(self.folder, "none.svg")
                with self.assertRaisesRegex(Refused, "was not found"):
                    export.export([one], target)
                self.assertFalse(os.path.exists(target))
            self.doc.removeObject(one.Name)
            page = self.doc.addObject("TechDraw::DrawPage", "Page")
            self.assertIn("<svg", features.place_on_page(page, obj).Symbol)
        finally:
            module._worker.stop()
            module._worker, kernel.folders, kernel.found = running, folders, found
        self.draws(obj)

    def test_a_kernel_for_another_python_is_none(self):
        package = os.path.join(self.folder, "burin")
        os.mkdir(package)
        before = os.environ.get("BURIN_PYTHON_PATH", "")
        os.environ["BURIN_PYTHON_PATH"] = os.pathsep.join((self.folder, before))
        try:
            for suffix, fits in ((".cpython-27-x86_64-linux-gnu.so", False), (importlib.machinery.EXTENSION_SUFFIXES[0], True)):
                with open(os.path.join(package, "_burin" + suffix), "w", encoding="utf-8"):
                    pass
                self.assertEqual(self.folder in kernel.folders(), fits, suffix)
                self.assertEqual(f"{self.folder} holds it for Python 2.7." in kernel.why_missing(), not fits)
            os.environ["BURIN_PYTHON_PATH"] = package  # the package itself
            self.assertIn(self.folder, kernel.folders())
            wheel = os.path.join(self.folder, "burin-cp27.whl")
            os.environ["BURIN_PYTHON_PATH"] = os.pathsep.join((wheel, self.folder + "/none", os.path.dirname(self.folder)))
            why = kernel.why_missing()
            self.assertIn(f"{wheel} is to be unpacked.", why)
            self.assertIn(f"{self.folder}/none is not there.", why)
            self.assertIn(f"{os.path.dirname(self.folder)} holds none.", why)
            self.assertIn("cp%d%d" % sys.version_info[:2], why)
        finally:
            os.environ["BURIN_PYTHON_PATH"] = before

    def test_exports_that_cannot_be(self):
        box = self.box()
        obj = self.illustration(box)
        empty = features.make_illustration(self.doc, [box])
        for objects, name, words in (
            ([], "a.svg", "choose one illustration"), ([box], "a.svg", "choose one illustration"),
            ([empty], "a.svg", "no drawing yet; recompute"), ([obj], "a.xyz", "xyz"),
            ([obj], "nowhere/a.svg", "nowhere")):
            with self.assertRaises(Exception) as caught:
                export.export(objects, os.path.join(self.folder, name))
            self.assertIn(words, str(caught.exception))
        self.assertEqual(os.listdir(self.folder), [])
