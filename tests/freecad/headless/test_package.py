"""package.xml, which FreeCAD's Addon Manager reads: of the repository, and of the add-on's own folder."""

import os
import re
import shutil
import subprocess
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
                text = file.read()
            for word in ("example.", "localhost", ".invalid"):
                self.assertNotIn(word, text)
            kinds = {url.get("type") for url in xml.parse(path).getroot().findall(f".//{SPACE}url")}
            self.assertIn(kinds, (set(), {"repository", "readme", "bugtracker", "documentation"}))

    def test_the_addresses_of_who_publishes_it(self):
        """freecad_wb/tools/addresses.py in a copy: FreeCAD reads what it writes, and both files still say the same."""
        tool = os.path.join("freecad_wb", "tools", "addresses.py")
        os.makedirs(os.path.join(self.folder, "freecad_wb", "tools"))
        for name in ("package.xml", os.path.join("freecad_wb", "package.xml"), tool):
            shutil.copy(os.path.join(SOURCE, name), os.path.join(self.folder, name))

        def run(*words):
            return subprocess.run(["/usr/bin/python3", os.path.join(self.folder, tool), *words], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, universal_newlines=True)

        for address, page, issues in (("https://gitlab.invalid/a/burin/", "/-/blob/next/", "/-/issues"),
                                      ("https://git.invalid/a/burin.git", "/blob/next/", "/issues")):
            self.assertEqual(run(address, "next").stderr, "")
            plain = re.sub(r"(/|\.git)$", "", address)
            for folder in (self.folder, os.path.join(self.folder, "freecad_wb")):
                data = FreeCAD.Metadata(os.path.join(folder, "package.xml"))
                urls = {url["type"]: url["location"] for url in data.Urls}
                self.assertEqual(urls, {"repository": plain, "readme": plain + page + "freecad_wb/docs/README.md",
                                        "bugtracker": plain + issues, "documentation": plain + page + "kernel/docs/freecad.md"})
                self.assertEqual(len(data.Urls), 4)  # those before are gone
                self.assertEqual([url["branch"] for url in data.Urls if url["type"] == "repository"], ["next"])
        for name in ("freecad_wb/docs/README.md", "kernel/docs/freecad.md"):
            self.assertTrue(os.path.isfile(os.path.join(SOURCE, name)), name)
        wrong = run("nowhere")
        self.assertNotEqual(wrong.returncode, 0)
        self.assertIn("is no address of a repository", wrong.stderr)

    def test_the_version_is_that_of_the_project(self):
        with open(os.path.join(SOURCE, "CMakeLists.txt"), encoding="utf-8") as file:
            version = re.search(r"project\(burin VERSION (\S+)", file.read()).group(1)
        self.assertEqual(version, addon.__version__)
