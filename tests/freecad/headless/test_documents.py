"""Documents that others made: what they show is drawn, or one line says why not."""

import glob
import os
import unittest
import zipfile

from support import DATA, App, Case, features

FILES = sorted(f for f in glob.glob(os.path.join(DATA, "fcstd", "*", "*")) if f.lower().endswith(".fcstd"))
# A document of sketches alone.
WITHOUT_FACES = {"7x5 pirate.FCStd"}


class Documents(Case):
    @unittest.skipUnless(FILES, "the models of others are not here (BURIN_TEST_DATA)")
    def test_all_of_them_draw(self):
        for path in FILES:
            name = os.path.basename(path)
            with self.subTest(name):
                document = App.openDocument(path)
                sources = features.visible(document)
                if name in WITHOUT_FACES:
                    self.assertEqual(sources, [])
                else:
                    obj = features.make_illustration(document, sources)
                    obj.Style = "outline"
                    obj.recompute()
                    self.assertTrue(obj.Drawing, obj.Message)
                    self.assertGreater(sum(1 for _ in features.sheet.Sheet(obj.Drawing).paths()), 5)
                App.closeDocument(document.Name)

    def test_what_only_the_gui_part_of_an_old_file_hides(self):
        self.box(name="Shown")
        self.box(name="Hidden")
        self.doc.recompute()
        path = os.path.join(self.folder, "now.FCStd")
        self.doc.saveAs(path)
        App.closeDocument(self.doc.Name)
        old = os.path.join(self.folder, "old.FCStd")
        gui = "".join(f'<ViewProvider name="{n}"><Properties><Property name="Visibility"><Bool value="{v}"/></Property>'
                      "</Properties></ViewProvider>" for n, v in (("Shown", "true"), ("Hidden", "false")))
        with zipfile.ZipFile(path) as source, zipfile.ZipFile(old, "w") as out:
            for item in source.namelist():
                # As before FreeCAD 0.19, where objects did not tell.
                out.writestr(item, source.read(item).replace(b'name="Visibility"', b'name="Other"'))
            out.writestr("GuiDocument.xml", f"<Document><ViewProviderData>{gui}</ViewProviderData></Document>")
        self.doc = App.openDocument(old)
        self.assertEqual([o.Name for o in features.visible(self.doc)], ["Shown"])

    def test_visible_objects_through_their_assemblies(self):
        part = self.doc.addObject("App::Part", "Part")
        part.addObject(self.box(name="Inside"))
        folder = self.doc.addObject("App::DocumentObjectGroup", "Folder")
        folder.addObject(self.box(name="InFolder"))
        self.box(name="Hidden").Visibility = False
        self.doc.addObject("Sketcher::SketchObject", "Sketch")
        self.doc.recompute()
        self.illustration(part)
        self.assertEqual(sorted(o.Name for o in features.visible(self.doc)), ["InFolder", "Part"])
