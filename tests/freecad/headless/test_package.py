"""package.xml, which FreeCAD's Addon Manager reads: of the repository, and of the add-on's own folder."""

import os
import re
import xml.etree.ElementTree as xml

import FreeCAD

from support import Case

import freecad.burin_wb as addon

SOURCE = os.environ.get("BURIN_SOURCE_DIR", "")
SPACE = "{https://wiki.freecad.org/Package_Metadata}"


class Package(Case):
    def files(self):
        for folder in (SOURCE, os.path.join(SOURCE, "freecad_wb")):
            yield folder, os.path.join(folder, "package.xml")

    def test_both_say_the_same_but_for_their_folders(self):
        repository, own = (open(path, encoding="utf-8").read() for _, path in self.files())
        plain = [re.sub(r"<!--.*?-->\n", "", text) for text in (repository, own)]
        self.assertEqual(plain[0].replace("./freecad_wb/", "./").replace("<icon>freecad_wb/", "<icon>"), plain[1])

    def test_freecad_reads_them_and_their_files_are_there(self):
        for folder, path in self.files():
            data = FreeCAD.Metadata(path)
            self.assertEqual((data.Name, str(data.Version)), ("Burin", addon.__version__))
            self.assertTrue(os.path.isfile(os.path.join(folder, data.Icon)), data.Icon)
            workbench = data.Content["workbench"][0]
            inside = os.path.join(folder, workbench.Subdirectory)
            self.assertTrue(os.path.isfile(os.path.join(inside, workbench.Icon)), workbench.Icon)
            self.assertTrue(os.path.isfile(os.path.join(inside, "freecad", "burin_wb", "init_gui.py")))
            with open(os.path.join(inside, "freecad", "burin_wb", "init_gui.py"), encoding="utf-8") as file:
                self.assertIn(f"class {workbench.Classname}(", file.read())

    def test_no_address_is_made_up(self):
        for _, path in self.files():
            with open(path, encoding="utf-8") as file:
                self.assertNotIn("example.", file.read())
            root = xml.parse(path).getroot()
            self.assertEqual(root.findall(f".//{SPACE}url"), [])

    def test_the_version_is_that_of_the_project(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(burin VERSION (\S+)", file.read()).group(1)
        self.assertEqual(version, addon.__version__)
