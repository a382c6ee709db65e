"""Each command on a real document: what it does, undo, redo, save, reopen, export."""

import json
import math
import os
import sys
import threading
import unittest.mock

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402
from similarity import grey  # noqa: E402

V = FreeCAD.Vector


def sheet_of(obj):
    from freecad.burin_wb.features.sheet import Sheet

    return Sheet(obj.Drawing)


def runs():
    from freecad.burin_wb.view import scheduler

    return scheduler.scheduler.count


class Workbench(support.Case):
    def test_is_there_with_toolbar_menu_and_icons(self):
        from freecad.burin_wb import commands

        self.assertEqual(Gui.activeWorkbench().MenuText, "Burin")
        self.assertIn("Burin", Gui.activeWorkbench().listToolbars())
        self.assertTrue(any("Burin" in m for m in Gui.activeWorkbench().listMenus()))
        for name in commands._registered:
            self.assertIn(name, Gui.listCommands())
        icons = os.path.join(os.path.dirname(commands.__file__), "..", "resources", "icons")
        for module in ("apart", "dimension", "new", "view", "style", "look", "page", "redraw", "export", "select", "help"):
            for command in __import__(f"freecad.burin_wb.commands.{module}", fromlist=["x"]).COMMANDS:
                pixmap = command.GetResources().get("Pixmap")
                if pixmap:
                    self.assertTrue(os.path.isfile(pixmap), pixmap)
                    # As FreeCAD draws it, which needs no plug-in of Qt for SVG.
                    self.assertFalse(Gui.getIcon(pixmap).pixmap(64, 64).isNull(), pixmap)
                self.assertTrue(command.GetResources()["ToolTip"], command.name)
        self.assertTrue(os.path.isfile(os.path.join(icons, "preferences-burin.svg")))

    def test_commands_that_cannot_be_done_are_grey(self):
        from freecad.burin_wb import commands

        for name in [n for n in commands.LAYOUT if n and n not in ("Burin_View", "Burin_Look")]:
            self.assertFalse(Gui.Command.get(name).isActive(), name)
        box, _ = self.box_and_ball()
        self.select(box)
        self.assertTrue(Gui.Command.get("Burin_NewIllustration").isActive())
        self.assertFalse(Gui.Command.get("Burin_Style").isActive())
        self.assertFalse(Gui.Command.get("Burin_LookNotDrawn").isActive())

    def test_the_context_menu_fits_the_selection(self):
        from freecad.burin_wb import commands

        box, ball = self.box_and_ball()
        self.select()
        self.assertEqual(commands.context(), [])
        self.select(box)
        self.assertIn("Burin_NewIllustration", commands.context())
        obj = self.illustrate(box, ball)
        self.select(obj)
        self.assertIn("Burin_PlaceOnPage", commands.context())

    def test_what_the_first_panel_needs_is_loaded_before(self):
        from freecad.burin_wb import kernel

        self.assertTrue(support.until(lambda: "burin" in sys.modules), "the first click loads the kernel")
        self.assertIs(kernel.offered(), kernel.offered())

    def test_help_opens(self):
        Gui.runCommand("Burin_Help")
        window = Gui.getMainWindow().findChild(QtGui.QDialog, "BurinHelp")
        self.assertIn("TechDraw", window.findChild(QtGui.QTextBrowser).toPlainText())
        window.close()

    def test_the_preferences_page_keeps_files_and_folders(self):
        from freecad.burin_wb import preferences
        from freecad.burin_wb.tasks.preferences import Page

        page = Page()
        page.load()
        fields = {name: page.form.findChild(QtGui.QWidget, widget) for name, widget in (
            ("StyleFile", "style_file"), ("Template", "template_file"), ("KernelFolder", "folder"), ("Python", "python"))}
        try:
            for name, field in fields.items():
                field.setProperty("text" if name == "KernelFolder" else "fileName", "/somewhere/" + name)
            page.save()
            self.assertEqual({name: preferences.group().GetString(name, "") for name in fields},
                             {name: "/somewhere/" + name for name in fields})
            self.assertEqual(preferences.style(), "/somewhere/StyleFile")
            for name, field in fields.items():
                field.setProperty("text" if name == "KernelFolder" else "fileName", "")
            page.save()
            self.assertFalse(set(preferences.group().GetStrings()) & set(fields))
        finally:
            for name in fields:
                preferences.group().RemString(name)

    def test_freecad_opens_the_preferences_page(self):
        shown = []

        def look(times=100):
            dialog = QtGui.QApplication.activeModalWidget()
            shown.extend(box.count() for box in (dialog.findChildren(QtGui.QComboBox, "sheet") if dialog else ()))
            if shown or not times:
                dialog.reject()
            else:
                QtCore.QTimer.singleShot(100, lambda: look(times - 1))

        QtCore.QTimer.singleShot(100, look)
        Gui.showPreferences("Burin", 0)
        self.assertEqual(len(shown), 1)
        self.assertGreater(shown[0], 10)

    def test_the_preferences_page_holds_and_new_illustrations_use_it(self):
        from freecad.burin_wb import kernel, preferences
        from freecad.burin_wb.tasks.preferences import Page

        page = Page()
        page.load()
        burin = kernel.module()
        lists = {name: page.form.findChild(QtGui.QComboBox, name) for name in ("style", "sheet", "hidden")}
        self.assertEqual([lists["style"].itemText(k) for k in range(lists["style"].count())], list(burin.styles()))
        self.assertEqual(lists["style"].currentData(), "technical")
        self.assertEqual(lists["sheet"].count(), 1 + 2 * len(burin.papers()))
        self.assertEqual(lists["hidden"].currentData(), "None")
        try:
            for name, value in (("style", "outline"), ("sheet", "A4p"), ("hidden", "Dashed")):
                lists[name].setCurrentIndex(lists[name].findData(value))
            page.save()
            again = Page()
            again.load()
            self.assertEqual(again.form.findChild(QtGui.QComboBox, "sheet").currentText(), "A4 portrait (190 x 277 mm)")
            obj = self.illustrate(*self.box_and_ball())
        finally:
            for name in ("StyleName", "SheetName", "Hidden"):
                preferences.group().RemString(name)
        self.assertEqual((obj.Style, obj.HiddenLines, obj.Width.Value, obj.Height.Value),
                         ("outline", "Dashed", 190.0, 277.0))
        self.assertTrue(any(not p["visible"] for _, p in sheet_of(obj).paths()))


class New(support.Case):
    def test_undo_removes_and_redo_restores(self):
        obj = self.illustrate(*self.box_and_ball())
        name = obj.Name
        self.assertTrue(os.path.exists(obj.Drawing))
        before, count = open(obj.Drawing).read(), runs()
        self.document.undo()
        support.drawn()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        support.drawn()
        again = self.document.getObject(name)
        self.assertEqual(open(again.Drawing).read(), before)
        self.assertEqual(again.ViewObject.Proxy.Object.Name, name)
        self.assertEqual(runs(), count)

    def test_nothing_selected_takes_all_that_is_shown(self):
        box, ball = self.box_and_ball()
        hidden = self.document.addObject("Part::Box", "Hidden")
        hidden.Visibility = False
        part = self.document.addObject("App::Part", "Part")
        part.addObject(ball)
        self.document.recompute()
        self.select()
        self.assertTrue(Gui.Command.get("Burin_NewIllustration").isActive())
        obj = self.illustrate()
        self.assertEqual({p["source"] for p in sheet_of(obj).data["parts"]}, {"Box", "Part.Ball"})
        again = self.illustrate()  # not of the illustration that is there now
        self.assertEqual([s.Name for s, _ in again.Sources], [s.Name for s, _ in obj.Sources])

    def test_cancel_leaves_nothing(self):
        self.select(*self.box_and_ball())
        objects = [o.Name for o in self.document.Objects]
        Gui.runCommand("Burin_NewIllustration")
        support.panel().reject()
        support.drawn()
        self.assertEqual([o.Name for o in self.document.Objects], objects)

    def test_all_kinds_of_objects(self):
        import Mesh
        import Part

        body = self.document.addObject("PartDesign::Body", "Body")
        pad = self.document.addObject("PartDesign::AdditiveBox", "Pad")
        body.addObject(pad)
        feature = self.document.addObject("Part::Feature", "Plain")
        feature.Shape = Part.makeCylinder(5, 10, V(30, 0, 0))
        assembly = self.document.addObject("App::Part", "Assembly")
        inner = self.document.addObject("Part::Box", "Inner")
        assembly.addObject(inner)
        assembly.Placement.Base = V(60, 0, 0)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = assembly
        link.Placement = FreeCAD.Placement(V(90, 0, 0), FreeCAD.Rotation())
        mesh = self.document.addObject("Mesh::Feature", "Net")
        mesh.Mesh = Mesh.createSphere(6, 30)
        mesh.Placement.Base = V(120, 5, 5)
        self.document.recompute()
        obj = self.illustrate(body, feature, assembly, link, mesh)
        self.assertEqual(obj.Message, "")
        parts = {p["source"] for p in sheet_of(obj).data["parts"]}
        self.assertEqual(parts, {"Body", "Plain", "Assembly.Inner", "Link.Inner", "Net"})
        # Placements hold: each part's ink lies where the part is.
        sheet = sheet_of(obj)
        for source, x in (("Assembly.Inner", 65), ("Link.Inner", 95), ("Net", 120)):
            points = [p for path in sheet.paths_of(source) for p in path["points"]]
            at = sheet.on_paper(V(x, 5, 5))
            near = min(math.dist(p, at) for p in points)
            self.assertLess(near, 9 * sheet.scale, source)

    def test_scripts_get_the_same_view(self):
        from freecad.burin_wb.features import make_illustration
        from freecad.burin_wb.view.provider import IllustrationView

        obj = make_illustration(self.document, list(self.box_and_ball()))
        self.document.recompute()
        support.drawn()
        self.assertIsInstance(obj.ViewObject.Proxy, IllustrationView)
        self.assertGreater(obj.ViewObject.Proxy._ink.getNumChildren(), 0)

    def test_a_new_drawing_lies_on_its_paper_before_the_model(self):
        from pivy import coin

        box, ball = self.box_and_ball()
        self.select(box, ball)
        Gui.runCommand("Burin_NewIllustration")
        obj = support.panel().obj
        support.drawn(obj)
        proxy = obj.ViewObject.Proxy
        self.assertEqual(proxy._paper.getNumChildren(), 0, "the model is hidden while the panel works at it")
        support.panel().accept()
        support.settle()
        self.assertEqual((obj.ViewObject.Plane, obj.ViewObject.Paper), ("Before the model", True))

        def is_painted():
            search = coin.SoSearchAction()
            search.setType(coin.SoTexture2.getClassTypeId())
            search.apply(proxy._paper)
            return search.getPath() is not None

        self.assertTrue(support.until(is_painted), "the sheet is empty")
        self.assertEqual(max(proxy._painted.size), 1024)
        sheet = grey(support.picture("on-paper"))
        obj.ViewObject.Plane = "Behind the model"
        obj.ViewObject.Paper = False
        self.assertEqual(proxy._paper.getNumChildren(), 0)
        model = grey(support.picture("no-paper"))
        self.assertGreater(((sheet > 0.97) & (model < 0.9)).mean(), 0.05, "there is no paper before the shaded model")

    def test_the_ink_is_made_once_for_each_drawing(self):
        from freecad.burin_wb.view import ink

        name, path = self.illustrate(*self.box_and_ball()).Name, str(support.OUT / "once.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        read, threads, true = [], set(), ink.read

        def note(path):
            read.append(path)
            threads.add(threading.current_thread())
            return true(path)

        with unittest.mock.patch.object(ink, "read", note):
            self.document = FreeCAD.openDocument(path)
            again = self.document.getObject(name)
            again.ViewObject.InkColor = (0.2, 0.3, 0.4)
            support.drawn()
            again.ViewObject.Plane = "Before the model"
            again.ViewObject.Paper = True
            support.drawn()
            self.assertEqual(read, [again.Drawing], "what each property tells made the ink again")
            self.assertNotIn(threading.main_thread(), threads, "the GUI waits for it")

    def test_the_kernel_and_python_read_the_same_ink(self):
        import numpy

        from freecad.burin_wb.features.sheet import Sheet
        from freecad.burin_wb.view import ink

        obj = self.illustrate(*self.box_and_ball())
        obj.Style, obj.HiddenLines = "engraving", "Dashed"
        self.document.recompute()
        support.drawn()
        drawing = sheet_of(obj).data
        drawing["layers"][0]["paths"][3]["closed"] = True
        file = str(support.OUT / "closed.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(drawing, out)
        sheet = Sheet(file)
        paths = [path for _, path in sheet.paths()]
        with unittest.mock.patch.object(ink, "MOST_POINTS", 500):
            stand, found, texts, painted = ink.read(file)
            self.assertEqual(texts, [])
            self.assertEqual(stand.direction, sheet.direction)
            others = ink.pens(sheet, paths)
        self.assertGreater(len(found), 5)
        self.assertEqual({pen.visible for pen in found}, {True, False})
        self.assertEqual(sum(len(pen.points) for pen in found), sum(len(p["points"]) + p["closed"] for p in paths))
        for a, b in zip(found, others, strict=True):
            self.assertEqual((a.width, a.visible, a.counts), (b.width, b.visible, b.counts))
            numpy.testing.assert_allclose(a.points, b.points, atol=1e-4)
        path = next(p for p in paths if p["closed"])
        self.assertGreater(len(path["points"]), 1)
        ring = ink.pens(sheet, [path])[0]
        self.assertEqual(tuple(ring.points[0]), tuple(ring.points[-1]))
        place = sheet.place(path["points"][1])
        self.assertLess((V(*map(float, ring.points[1])) - place).Length, 1e-4)

    def test_saved_and_opened_again_shows_the_kept_drawing_without_the_kernel(self):
        obj = self.illustrate(*self.box_and_ball())
        name, before, count = obj.Name, open(obj.Drawing).read(), runs()
        path = str(support.OUT / "kept.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        again = self.document.getObject(name)
        support.drawn()
        self.assertEqual(open(again.Drawing).read(), before)
        self.assertGreater(again.ViewObject.Proxy._ink.getNumChildren(), 0)
        again.touch()
        self.document.recompute()
        support.drawn()
        self.assertEqual(runs(), count, "an unchanged illustration was computed")

    def test_what_a_save_without_gui_lost_comes_back(self):
        import zipfile

        obj = self.illustrate(*self.box_and_ball())
        name, path = obj.Name, str(support.OUT / "full.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        bare = str(support.OUT / "bare.FCStd")
        with zipfile.ZipFile(path) as full, zipfile.ZipFile(bare, "w") as less:
            for entry in full.namelist():
                if entry != "GuiDocument.xml":
                    less.writestr(entry, full.read(entry))
        self.document = FreeCAD.openDocument(bare)
        proxy = self.document.getObject(name).ViewObject.Proxy
        support.drawn()
        self.assertGreater(proxy._ink.getNumChildren(), 0)


class Views(support.Case):
    def setUp(self):
        super().setUp()
        self.box, self.ball = self.box_and_ball()
        self.obj = self.illustrate(self.box, self.ball)

    def run_view(self, name, *more):
        self.select(self.obj, *more)
        self.assertTrue(Gui.Command.get(name).isActive(), name)
        Gui.runCommand(name)
        support.drawn()

    def test_standard_views_undo_and_redo(self):
        first = open(self.obj.Picture).read()
        self.run_view("Burin_ViewTop")
        self.assertEqual(tuple(self.obj.ViewDirection), (0, 0, 1))
        self.assertAlmostEqual(sheet_of(self.obj).direction.z, 1, 6)
        top, count = open(self.obj.Picture).read(), runs()
        self.assertNotEqual(top, first)
        self.document.undo()
        support.drawn()
        self.assertEqual(open(self.obj.Picture).read(), first)
        self.document.redo()
        support.drawn()
        self.assertEqual(open(self.obj.Picture).read(), top)
        self.assertEqual(runs(), count, "undo and redo ran the kernel though their drawings are kept")

    def test_all_standard_views(self):
        from freecad.burin_wb import kernel
        from freecad.burin_wb.offers import title

        for name, (direction, _) in kernel.module().views().items():
            self.run_view("Burin_View" + title(name))
            self.assertLess((sheet_of(self.obj).direction - V(*direction).normalize()).Length, 1e-6, name)

    def test_from_the_camera_parallel_and_in_perspective(self):
        view = Gui.ActiveDocument.ActiveView
        view.setCameraOrientation(FreeCAD.Rotation(V(1, 0, 0), 50))
        self.run_view("Burin_ViewFromCamera")
        wanted = view.getCameraOrientation().multVec(V(0, 0, 1))
        self.assertLess((sheet_of(self.obj).direction - wanted).Length, 1e-5)
        view.setCameraType("Perspective")
        self.run_view("Burin_ViewFromCamera")
        self.assertEqual(self.obj.Projection, "Perspective")
        self.assertEqual(sheet_of(self.obj).data["view"]["projection"], "perspective")
        view.setCameraType("Orthographic")

    def test_following_the_camera_draws_whenever_it_rests(self):
        view = Gui.ActiveDocument.ActiveView
        self.obj.ViewObject.Follow = True
        try:
            for angle in (20, 65):
                count = runs()
                view.setCameraOrientation(FreeCAD.Rotation(V(1, 0.2, 0), angle))
                wanted = view.getCameraOrientation().multVec(V(0, 0, 1))
                support.until(lambda: (self.obj.ViewDirection - wanted).Length < 1e-6)
                support.drawn()
                self.assertLess((sheet_of(self.obj).direction - wanted).Length, 1e-5)
                self.assertEqual(runs(), count + 1)
                support.settle(600)
                self.assertEqual(runs(), count + 1, "drawn again though the camera rests")
        finally:
            self.obj.ViewObject.Follow = False
        view.setCameraOrientation(FreeCAD.Rotation(V(0, 0, 1), 30))
        support.settle(600)
        self.assertLess((self.obj.ViewDirection - wanted).Length, 1e-6)

    def test_square_onto_a_face(self):
        for face, normal in (("Face1", V(-1, 0, 0)), ("Face6", V(0, 0, 1))):
            self.run_view("Burin_ViewFromFace", (self.box, face))
            self.assertLess((sheet_of(self.obj).direction - normal).Length, 1e-6)

    def test_square_onto_a_face_in_assemblies_and_links(self):
        def turned(axis, angle, *base):
            return FreeCAD.Placement(V(*base), FreeCAD.Rotation(V(*axis), angle))

        inner, outer = (self.document.addObject("App::Part", n) for n in ("Inner", "Outer"))
        inner.addObject(self.box)
        outer.addObject(inner)
        inner.Placement, outer.Placement = turned((1, 0, 0), 30, 5, 0, 9), turned((0, 0, 1), 40, 0, 7, 0)
        self.box.Placement = turned((0, 1, 0), 20)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = outer
        link.Placement = turned((1, 1, 0), 70, 100, 0, 0)
        array = self.document.addObject("App::Link", "Array")
        array.LinkedObject = self.box
        array.ShowElement = False
        array.ElementCount = 2
        array.PlacementList = [FreeCAD.Placement(), turned((1, 0, 0), 45, 0, 0, 80)]
        self.document.recompute()
        nested = outer.Placement * inner.Placement * self.box.Placement
        mirror = self.document.addObject("App::Link", "Mirror")
        mirror.LinkedObject = self.box
        mirror.ScaleVector = V(1, 1, -1)
        mirror.Placement = turned((1, 0, 0), 40)
        self.document.recompute()
        self.run_view("Burin_ViewFromFace", (mirror, "Face6"))  # whose normals point inwards
        away = sheet_of(self.obj).direction - mirror.Placement.Rotation.multVec(V(0, 0, -1))
        self.assertLess(away.Length, 1e-6)
        for top, sub, placement in ((outer, "Inner.Box.Face6", nested),
                                    (self.box, "Face6", nested),  # as scripts may select it
                                    (link, "Inner.Box.Face6", link.Placement * inner.Placement * self.box.Placement),
                                    (array, "1.Face6", array.PlacementList[1])):
            self.run_view("Burin_ViewFromFace", (top, sub))
            away = sheet_of(self.obj).direction - placement.Rotation.multVec(V(0, 0, 1))
            self.assertLess(away.Length, 1e-6, f"{top.Name}.{sub}")

    def test_looks_of_objects(self):
        parts = lambda: {p["part"] for _, p in sheet_of(self.obj).paths()}  # noqa: E731
        self.assertEqual(len(parts()), 2)
        self.run_view("Burin_LookNotDrawn", self.ball)
        self.assertEqual(dict(self.obj.Looks), {"Ball": "not drawn"})
        self.assertEqual(len(parts()), 1)
        self.document.undo()
        support.drawn()
        self.assertEqual(len(parts()), 2)
        self.run_view("Burin_LookNotHatched", self.ball)
        strokes = [p for _, p in sheet_of(self.obj).paths() if p["kind"] == "stroke"]
        self.assertTrue(strokes)
        self.assertEqual(len({p["part"] for p in strokes}), 1)
        self.run_view("Burin_LookNotHatched", self.ball)  # once more takes it back
        self.assertEqual(dict(self.obj.Looks), {})


class Pages(support.Case):
    def setUp(self):
        super().setUp()
        self.box, self.ball = self.box_and_ball()
        self.obj = self.illustrate(self.box, self.ball)

    def place(self):
        self.select(self.obj)
        Gui.runCommand("Burin_PlaceOnPage")
        support.settle(200)
        return next(o for o in self.document.Objects if o.isDerivedFrom("TechDraw::DrawPage"))

    def test_makes_the_page_and_undo_takes_it_back(self):
        before = len(self.document.Objects)
        page = self.place()
        self.assertEqual(len(page.Views), 1)
        self.assertEqual(page.Views[0].Scale, 1.0)
        self.assertEqual((page.Template.Width.Value, page.Template.Height.Value), (297, 210), "the sheet is 180 x 130")
        self.document.undo()
        support.settle(100)
        self.assertEqual(len(self.document.Objects), before)
        self.document.redo()
        support.settle(100)
        self.assertEqual(len(self.document.Objects), before + 3)

    def test_page_follows_and_exports_true_scale(self):
        import re

        import TechDrawGui

        page = self.place()
        first = page.Views[0].Symbol
        self.select(self.obj)
        Gui.runCommand("Burin_ViewFront")
        support.drawn()
        self.assertNotEqual(page.Views[0].Symbol, first)
        svg, pdf = str(support.OUT / "page.svg"), str(support.OUT / "page.pdf")
        TechDrawGui.exportPageAsSvg(page, svg)
        TechDrawGui.exportPageAsPdf(page, pdf)
        self.assertGreater(os.path.getsize(pdf), 2000)
        self.assertEqual(open(pdf, "rb").read(5), b"%PDF-")
        box = re.search(rb"/MediaBox \[0 0 (\S+) (\S+)\]", open(pdf, "rb").read())
        self.assertAlmostEqual(float(box.group(1)) / 72 * 25.4, 297, 0)
        # The matrix of the symbol: 10 scene units are a millimetre of paper.
        matrices = re.findall(r'matrix\(([^)]*)\)', open(svg).read())
        scales = {round(float(m.split(",")[0]), 3) for m in matrices}
        self.assertIn(10.0, scales)

    def exported_scales(self, page):
        """The matrices of a page that TechDraw exports, by their first numbers."""
        import re

        import TechDrawGui

        svg = str(support.OUT / "scales.svg")
        TechDrawGui.exportPageAsSvg(page, svg)
        return {round(float(m), 3) for m in re.findall(r"matrix\(([-0-9.e]+),", open(svg).read())}

    def test_the_scale_of_symbols_is_measured_and_corrected(self):
        from freecad.burin_wb import preferences
        from freecad.burin_wb.view import page_scale

        true = preferences.pixels_per_mm()
        preferences.set_pixels_per_mm(3.54)  # as if TechDraw had taken another number
        try:
            page = self.place()
            self.assertTrue(support.until(lambda: abs(preferences.pixels_per_mm() - 3.54) > 1e-3), "nothing was measured")
            self.assertAlmostEqual(preferences.pixels_per_mm(), preferences.PIXELS_PER_MM, 5)
            support.settle(100)
            self.assertIn(10.0, self.exported_scales(page))
            self.assertAlmostEqual(page_scale.measure(page), preferences.PIXELS_PER_MM, 5)
        finally:
            preferences.set_pixels_per_mm(true)

    def test_export_by_command_and_by_file_menu(self):
        self.select(self.obj)
        from freecad.burin_wb import export, kernel

        asked = []
        for suffix in kernel.module().formats():
            path = str(support.OUT / f"by-command.{suffix}")
            if os.path.exists(path):
                os.unlink(path)
            with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName",
                                            lambda *args: asked.append(args) or (path, "")):
                Gui.runCommand("Burin_Export")
            self.assertGreater(os.path.getsize(path), 500, suffix)
            self.assertIn(f"(*.{suffix})", asked[-1][-1])

        path = str(support.OUT / "by-menu.svg")
        export.export([self.obj], path)
        self.assertIn('width="180mm"', open(path).read()[:2000])
        self.assertIn("freecad.burin_wb.export", FreeCAD.getExportType("svg"))


    def test_an_illustration_file_by_command(self):
        from freecad.burin_wb import commands, kernel

        self.assertIn("Burin_ExportFile", commands.menu())
        self.select(self.obj)
        self.assertIn("Burin_ExportFile", commands.context())
        undos = self.document.UndoCount
        path = str(support.OUT / "by-command")
        with unittest.mock.patch.object(QtGui.QFileDialog, "getSaveFileName", lambda *_: (path, "")):
            Gui.runCommand("Burin_ExportFile")
        kept, other = (sheet_of(self.obj).data, json.loads(kernel.module().draw(path + ".burin.json").to_bytes("json")))
        lines = lambda data: [len(layer["paths"]) for layer in data["layers"]]  # noqa: E731
        self.assertEqual(lines(kept), lines(other))
        self.assertEqual((self.document.UndoCount, "Touched" in self.obj.State), (undos, False))

    def new_from(self, path):
        """Runs the command with that choice of a file; names of the objects that it made, and steps that can be undone."""
        before, undos = {o.Name for o in self.document.Objects}, self.document.UndoCount
        with unittest.mock.patch.object(QtGui.QFileDialog, "getOpenFileName", lambda *_: (path, "")):
            Gui.runCommand("Burin_NewFromFile")
        support.drawn()
        return [o for o in self.document.Objects if o.Name not in before], self.document.UndoCount - undos

    def test_a_new_illustration_from_a_file_by_command(self):
        from freecad.burin_wb import commands, illustration_file

        self.assertIn("Burin_NewFromFile", commands.menu())
        self.assertTrue(Gui.Command.get("Burin_NewFromFile").isActive())
        self.assertEqual(self.new_from(""), ([], 0), "nothing was chosen")
        path = str(support.OUT / "from-file.burin.json")
        self.obj.ViewDirection, self.obj.StyleKeys, self.obj.Looks = V(2, -1, 1), {"line.outer": "0.9"}, {"Ball": "not hatched"}
        self.document.recompute()
        support.drawn()
        illustration_file.write(self.obj, path)
        (made,), steps = self.new_from(path)
        self.assertEqual((steps, made.Message, [o.Name for o in Gui.Selection.getSelection()]), (1, "", [made.Name]))
        for name in ("Style", "StyleKeys", "Looks", "ViewDirection", "Width", "Height", "Margin", "Light"):
            self.assertEqual(getattr(made, name), getattr(self.obj, name), name)
        kept, drawn = sheet_of(self.obj).data, sheet_of(made).data
        self.assertEqual(kept["layers"], drawn["layers"])
        name = made.Name
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        self.assertEqual(sheet_of(self.document.getObject(name)).data["layers"], kept["layers"])

    def test_a_file_that_cannot_be_taken_leaves_the_document(self):
        path = str(support.OUT / "broken.burin.json")
        for text, words in (("{", "not valid JSON"), (json.dumps({"burin": "illustration", "parts": [{"file": "none.step"}]}),
                                                      "no object of the file's parts")):
            with open(path, "w") as file:
                file.write(text)
            said = []
            with unittest.mock.patch("freecad.burin_wb.commands.base.tell", said.append):  # the status bar shortens what is long
                self.assertEqual(self.new_from(path), ([], 0))
            self.assertEqual(len(said), 1)
            self.assertIn(words, said[0])


class Colors(support.Case):
    def paint(self, view, color):
        material = view.ShapeMaterial
        material.DiffuseColor = color
        view.ShapeMaterial = material
        view.OverrideMaterial = True

    def colors(self, *objects):
        from freecad.burin_wb.features.sources import collect

        parts, notes = collect([(o, ("",)) for o in objects])
        self.assertEqual(notes, [])
        return {p.source: p.color for p in parts}

    def test_links_have_the_colours_that_they_show(self):
        box, ball = self.box_and_ball()
        box.ViewObject.ShapeColor = (1.0, 0.0, 0.0)
        ball.ViewObject.ShapeColor = (0.0, 1.0, 0.0)
        part = self.document.addObject("App::Part", "Part")
        part.addObject(ball)
        plain, painted, over, again = (self.document.addObject("App::Link", n) for n in ("Plain", "Painted", "Over", "Again"))
        plain.LinkedObject = painted.LinkedObject = box
        over.LinkedObject = part
        again.LinkedObject = painted  # a link to a link
        self.paint(painted.ViewObject, (0.0, 0.0, 1.0))
        self.paint(over.ViewObject, (1.0, 1.0, 0.0))
        array = self.document.addObject("App::Link", "Array")
        array.LinkedObject = box
        array.ShowElement = False
        array.ElementCount = 3
        self.document.recompute()
        material = painted.ViewObject.ShapeMaterial
        array.ViewObject.OverrideMaterialList = [False, True, False]
        array.ViewObject.MaterialList = [material, material, material]
        self.assertEqual(self.colors(box, plain, painted, over, again, array), {
            "Box": "#ff0000", "Plain": "#ff0000", "Painted": "#0000ff", "Over.Ball": "#ffff00", "Again": "#0000ff",
            "Array.0": "#ff0000", "Array.1": "#0000ff", "Array.2": "#ff0000"})
        box.ViewObject.DiffuseColor = [(1.0, 0.0, 0.0)] * 5 + [(0.0, 0.0, 0.0)]
        self.assertEqual(self.colors(box, painted), {"Box": "", "Painted": "#0000ff"})


class Sources(support.Case):
    def setUp(self):
        super().setUp()
        self.box, self.ball = self.box_and_ball()
        self.obj = self.illustrate(self.box, self.ball)
        self.view = Gui.ActiveDocument.ActiveView

    def test_a_click_on_a_line_selects_its_edge(self):
        from freecad.burin_wb.commands.select import Picker
        sheet = sheet_of(self.obj)
        self.obj.ViewObject.Plane = "Behind the model"
        picker = Picker(self.obj, self.view)
        self.assertFalse(self.obj.ViewObject.Paper, "paper hides what is selected")
        lift = self.obj.ViewObject.Proxy.lift(sheet)
        self.assertGreater(lift, 0, "the ink is behind the model while one clicks on it")
        for _, path in sheet.paths():
            source, element = sheet.element(path)
            if path["kind"] != "crease" or source != "Box":
                continue
            a, b = path["points"][:2]
            middle = sheet.place(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2), lift)
            where = self.view.getPointOnScreen(middle.x, middle.y, middle.z)
            self.assertEqual(picker.pick(where), (source, element))
            chosen = Gui.Selection.getSelectionEx()[0]
            self.assertEqual((chosen.ObjectName, chosen.SubElementNames), (source, (element,)))
            # The edge in the model is where the line is on the paper.
            edge = chosen.SubObjects[0]
            ends = [sheet.on_paper(v.Point) for v in edge.Vertexes]
            self.assertLess(support.off_segment(a, ends), 0.1)
            break
        else:
            self.fail("no crease of the box is drawn")
        self.assertIsNone(picker.pick((3, 3)))
        support.picture("picking")
        picker.stop()
        self.assertLess(self.obj.ViewObject.Proxy.lift(sheet), 0)
        self.assertTrue(self.obj.ViewObject.Paper)

    def test_select_source_by_mouse_and_escape(self):
        from freecad.burin_wb.commands import select

        self.select(self.obj)
        Gui.runCommand("Burin_SelectSource")
        area = support.glass()
        sheet = sheet_of(self.obj)
        path = next(p for _, p in sheet.paths() if p["kind"] == "crease")
        (ax, ay), (bx, by) = path["points"][:2]
        place = sheet.place(((ax + bx) / 2, (ay + by) / 2), self.obj.ViewObject.Proxy.lift(sheet))
        x, y = self.view.getPointOnScreen(place.x, place.y, place.z)
        width, height = self.view.getSize()
        at = QtCore.QPointF(x * area.width() / width, area.height() * (1 - y / height) - 1)
        for kind, buttons in ((QtCore.QEvent.MouseMove, QtCore.Qt.NoButton),
                              (QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton),
                              (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton)):
            button = QtCore.Qt.NoButton if kind == QtCore.QEvent.MouseMove else QtCore.Qt.LeftButton
            QtGui.QApplication.sendEvent(area, QtGui.QMouseEvent(kind, at, area.mapToGlobal(at.toPoint()), button,
                                                                 buttons, QtCore.Qt.NoModifier))
        source, element = sheet.element(path)
        chosen = lambda: [(c.ObjectName, c.SubElementNames) for c in Gui.Selection.getSelectionEx()]  # noqa: E731
        self.assertTrue(support.until(lambda: chosen() == [(source, (element,))], 10), chosen())
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            QtGui.QApplication.sendEvent(area, QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier))
        self.assertTrue(support.until(lambda: select.picker is None))

    def test_lines_of_a_face_light_up_until_the_selection_changes(self):
        from freecad.burin_wb.commands import select

        self.obj.ViewObject.Paper = True
        self.select(self.obj, (self.box, "Face6"))
        self.assertTrue(Gui.Command.get("Burin_ShowLines").isActive())
        Gui.runCommand("Burin_ShowLines")
        support.settle(50)
        proxy = self.obj.ViewObject.Proxy
        self.assertTrue(proxy.lit())
        lit = {sheet.element(p)[1] for sheet in [sheet_of(self.obj)] for name in select.edges_of(self.box, "Face6")
               for p in sheet.paths_of("Box", name)}
        self.assertEqual(len(lit), 4, "a face has its four edges lit")
        self.view.setCameraOrientation(FreeCAD.Rotation(V(0, 0, 1), 70) * FreeCAD.Rotation(V(1, 0, 0), 55))
        self.view.fitAll()
        support.picture("lit")
        self.select(self.ball)
        support.settle(50)
        self.assertFalse(proxy.lit())


support.run(__name__)
