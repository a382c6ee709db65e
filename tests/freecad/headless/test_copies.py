"""Copies of illustrations: each with files of its own."""

import os
import shutil

from support import App, Case, content, features


class Copies(Case):
    def drawings(self, *objects):
        return [content(o.Drawing) for o in objects] + [content(o.Picture) for o in objects]

    def check_apart(self, one, other):
        """Neither touches what the other keeps: drawn anew, deleted, undone, saved."""
        for name in ("Drawing", "Picture"):
            paths = [getattr(o, name) for o in (one, other)]
            self.assertNotEqual(*paths)
            for path in paths:
                self.assertTrue(os.path.isfile(path), path)
        # FreeCAD 1.0 leaves copied sources touched; a copy that is drawn anew has the names of its own sources in it.
        for document in {one.Document, other.Document}:
            document.recompute()
        for mine, theirs in ((one, other), (other, one)):
            before, drawn = self.drawings(theirs), content(mine.Drawing)
            mine.Seed += 1
            mine.Width = mine.Width.Value + 10
            mine.Document.recompute()
            self.assertEqual(mine.Message, "")
            self.assertTrue(self.drawings(theirs) == before, "one overwrites the other")
            self.assertFalse(content(mine.Drawing) == drawn)

    def test_a_copy_in_the_document(self):
        self.doc.UndoMode = 1
        one = self.illustration(self.box())
        before = self.drawings(one)
        self.doc.openTransaction("Copy")
        other = self.doc.copyObject(one)
        self.doc.commitTransaction()
        self.assertTrue(self.drawings(one) == before)
        self.assertTrue(self.drawings(other) == before)
        self.check_apart(one, other)
        before = self.drawings(one)
        self.doc.removeObject(other.Name)
        self.assertTrue(self.drawings(one) == before)

    def test_undo_of_a_copy_leaves_the_original(self):
        self.doc.UndoMode = 1
        one = self.illustration(self.box())
        before = self.drawings(one)
        self.doc.openTransaction("Copy")
        name = self.doc.copyObject(one).Name
        self.doc.commitTransaction()
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.assertTrue(self.drawings(one) == before)
        self.doc.redo()
        self.assertTrue(self.drawings(self.doc.getObject(name)) == before)
        self.check_apart(one, self.doc.getObject(name))

    def test_a_copy_with_its_sources_and_a_copy_of_a_copy(self):
        one = self.illustration(self.box())
        other = next(o for o in self.doc.copyObject([one, self.doc.Box]) if features.is_illustration(o))
        self.assertNotEqual(other.Sources[0][0], one.Sources[0][0])
        third = self.doc.copyObject(other)
        self.check_apart(one, other)
        self.check_apart(other, third)

    def test_copies_are_saved_and_opened(self):
        one = self.illustration(self.box())
        other = self.doc.copyObject(one)
        other.Seed = 9
        self.doc.recompute()
        before, name = self.drawings(one, other), other.Name
        one = self.reopen(one)
        self.assertTrue(self.drawings(one, self.doc.getObject(name)) == before)

    def test_into_a_copy_of_the_document_whose_files_have_the_same_names(self):
        one = self.illustration(self.box())
        path = os.path.join(self.folder, "second.FCStd")
        self.doc.saveAs(os.path.join(self.folder, "first.FCStd"))
        shutil.copy(self.doc.FileName, path)
        old = self.drawings(one)
        one.Seed = 9
        self.doc.recompute()
        second = App.openDocument(path)
        self.assertIsNot(second, self.doc)
        theirs = second.getObject(one.Name)
        pasted = second.copyObject(one, True)
        self.assertTrue(self.drawings(theirs) == old)
        self.assertTrue(self.drawings(pasted) == self.drawings(one))
        self.check_apart(theirs, pasted)
