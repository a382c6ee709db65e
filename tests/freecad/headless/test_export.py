"""Illustrations as files, as scripts and FreeCAD's own export do it."""

import importlib
import os
import subprocess
from unittest import mock

from support import App, Case, burin, content, features

STARTS = {"svg": b"<?xml", "html": b"<!DOCTYPE html>", "pdf": b"%PDF-", "png": b"\x89PNG", "eps": b"%!PS-Adobe", "dxf": b"999", "hpgl": b"IN;",
          "gcode": b"; burin", "json": b"{"}


class Export(Case):
    def test_three_lines(self):
        obj = self.illustration(self.box())
        for suffix, start in STARTS.items():
            path = os.path.join(self.folder, "a." + suffix)
            from freecad.burin_wb import export
            export.export([obj], path)
            written = content(path).lstrip()
            self.assertTrue(written.startswith((start, b"0\n", b"  0\n")) if suffix == "dxf" else
                            written.startswith(start), (suffix, written[:20]))
            self.assertGreater(len(written), 400, suffix)

    def test_the_file_is_the_kept_drawing(self):
        obj = self.illustration(self.box())
        path = os.path.join(self.folder, "a.json")
        from freecad.burin_wb import export

        export.export([self.doc.Box, obj], path)  # what else is selected is left out
        kept, written = burin().Drawing.load(obj.Drawing), burin().Drawing.load(path)
        self.assertEqual(kept.to_bytes("svg"), written.to_bytes("svg"))

    def test_names_that_are_not_ascii(self):
        obj = self.illustration(self.box(name="Box"))
        path = os.path.join(self.folder, "Gehäuse – Maßbild.pdf")
        from freecad.burin_wb import export

        export.export([obj], path)
        self.assertTrue(content(path).startswith(b"%PDF-"))

    def test_what_is_not_up_to_date_is_told_and_written(self):
        from freecad.burin_wb import export
        from freecad.burin_wb.features.stale import is_stale, redraw_all, stale_in

        box = self.box()
        obj, other = self.illustration(box), self.illustration(self.solid(box.Shape, "Other"))
        self.assertEqual(stale_in(self.doc), [])
        box.Length = 33
        self.assertEqual(stale_in(self.doc), [obj], "its model waits for a recompute")
        before, said, path = content(obj.Drawing), [], os.path.join(self.folder, "a.svg")
        with mock.patch.object(export, "tell", lambda text, *level: said.append((text, level))):
            export.export([obj], path)
            export.export([other], path)
        self.assertRegex(said[0][0], "^Illustration: is not up to date.*the drawing before was written to")
        self.assertEqual(said[1][1], (export.NOTE,))
        self.assertEqual(redraw_all(self.doc), [obj, other])
        self.assertNotEqual(content(obj.Drawing), before)
        self.assertFalse(is_stale(obj))
        obj.Sections = ["nowhere"]
        self.assertTrue(is_stale(obj))
        self.doc.recompute()
        self.assertEqual(stale_in(self.doc), [obj], "it could not be drawn")
        style = os.path.join(self.folder, "mine.json")
        with open(style, "w") as file:
            file.write('{"base": "outline"}')
        other.Style = style
        self.doc.recompute()
        before = content(other.Drawing)
        with open(style, "w") as file:
            file.write('{"base": "outline", "line.outer": 2}')
        redraw_all(self.doc)
        self.assertNotEqual(content(other.Drawing), before)

    def test_freecad_knows_the_types(self):
        self.assertEqual(set(STARTS), set(burin().formats()))
        for suffix in burin().formats():
            self.assertIn("freecad.burin_wb.export", App.getExportType(suffix), suffix)
            # What File > Export runs.
            module = importlib.import_module("freecad.burin_wb.export")
            self.assertTrue(callable(module.export))

    def test_freecadcmd_exports_a_document(self):
        obj = self.illustration(self.box())
        self.reopen(obj)
        out = os.path.join(self.folder, "out.eps")
        program = next(p for p in ("/usr/bin/freecadcmd", "/usr/bin/FreeCADCmd") if os.path.exists(p))
        addon = os.path.join(os.path.dirname(features.__file__), "../../..")
        done = subprocess.run([program, self.doc.FileName, "--output", out, "-P", os.path.normpath(addon)],
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60)
        self.assertTrue(os.path.exists(out), done.stdout.decode(errors="replace")[-500:])
        self.assertTrue(content(out).startswith(b"%!PS-Adobe"))
