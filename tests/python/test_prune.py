"""`burin batch prune`: what a catalogue no longer has goes, and nothing else."""

import unittest

from batch_support import BatchTest, box_off

ALL = '[[parts]]\nfiles = ["parts/**/*.off"]\nstyles = ["outline"]\n'
SOME = '[[parts]]\nfiles = ["parts/*.off"]\nstyles = ["outline"]\n'


class Prune(BatchTest):
    def records(self):
        return {path.stem for path in (self.folder / "out/.burin-batch/records").glob("*/*.json")}

    def prune(self, *words, **more):
        return self.batch("prune", *(words or ["jobs.jsonl"]), **more)

    def test_removes_what_the_catalogue_no_longer_has(self):
        self.parts("a.off", "b.off", "deep/c.off", "deep/er/d.off")
        self.plan(ALL)
        self.run_all()
        everything, gone = set(self.outputs()), {d["id"] for d in self.drawings() if "deep" in d["name"]}
        self.plan(SOME)
        before, known = self.identities(), self.records()
        told = self.prune("jobs.jsonl", "--dry-run")
        self.assertEqual(told.splitlines()[:2], ["would remove  parts/deep/c-iso.svg", "would remove  parts/deep/er/d-iso.svg"])
        self.assertRegex(told, r"out: 2 records and 2 files would be removed, \d+ bytes\n$")
        self.assertEqual((self.identities(), self.records()), (before, known))
        said = self.prune()
        self.assertEqual(said.replace("removed", "would remove", 2).replace(" removed", " would be removed"), told)
        self.assertEqual(set(self.outputs()), {"parts/a-iso.svg", "parts/b-iso.svg"})
        self.assertEqual(self.records(), known - gone)
        self.assertFalse((self.folder / "out/parts/deep").exists())
        self.assertIn("0 records and 0 files removed", self.prune())
        self.assertEqual(self.prune("jobs.jsonl", "-q"), "")
        self.assertIn("2 of them were done", self.run_all())
        # What is wanted again is drawn again.
        self.plan(ALL)
        self.run_all()
        self.assertEqual(set(self.outputs()), everything)

    def test_leaves_what_is_not_ours(self):
        self.parts("a.off", "deep/c.off", "deep/d.off")
        self.plan(ALL)
        self.run_all()
        (self.folder / "out/parts/deep/c-iso.svg").write_text("edited by hand")
        (self.folder / "out/parts/deep/notes.txt").write_text("mine")
        self.plan(SOME)
        said = self.prune()
        self.assertIn("left     parts/deep/c-iso.svg\n", said)
        self.assertIn("2 records and 1 files removed", said)
        self.assertIn("; 1 files left, they have changed since", said)
        self.assertEqual(set(self.outputs()), {"parts/a-iso.svg", "parts/deep/c-iso.svg", "parts/deep/notes.txt"})

    def test_a_drawing_that_was_made_anew_stays(self):
        self.parts("a.off", "broken.off")
        (self.folder / "parts/broken.off").write_text("OFF\n1 1")
        self.plan(SOME)
        self.run_all(status=1)
        (self.folder / "parts/a.off").write_text(box_off(1, 2, 3))
        (self.folder / "parts/broken.off").unlink()
        self.plan(SOME)
        self.run_all()
        before = self.identities()
        self.assertEqual(len(self.records()), 3)
        self.assertIn("2 records and 0 files removed, 0 bytes\n", self.prune())
        self.assertEqual(self.records(), {d["id"] for d in self.drawings()})
        self.assertEqual(self.identities(), before)
        self.assertIn("1 of them were done", self.run_all())

    def test_several_catalogues_in_one_folder(self):
        self.parts("a.off", "deep/c.off")
        for name, pattern in (("one", "parts/*.off"), ("two", "parts/deep/*.off")):
            (self.folder / f"{name}.toml").write_text(f'[[parts]]\nfiles = ["{pattern}"]\nstyles = ["outline"]\n')
            self.batch("plan", f"{name}.toml", "-o", f"{name}.jsonl")
            self.batch("run", f"{name}.jsonl")
        self.assertIn("0 records", self.prune("one.jsonl", "two.jsonl"))
        self.assertEqual(len(self.outputs()), 2)
        (self.folder / "else.toml").write_text('out = "else"\n' + SOME)
        self.batch("plan", "else.toml", "-o", "else.jsonl")
        self.prune("one.jsonl", "else.jsonl", status=2)
        self.refused("draw into several folders")
        self.assertEqual(len(self.outputs()), 2)
        self.prune("none.jsonl", status=3)
        self.refused("none.jsonl")

    def test_beside_shards_that_draw(self):
        self.parts("old.off")
        self.plan(SOME)
        self.run_all()
        (self.folder / "parts/old.off").unlink()
        self.parts(*(f"deep/{k}/slow.off" for k in range(12)))
        command = self.odd()
        self.batch("--burin", command, "plan", self.catalogue(ALL), "-o", "jobs.jsonl")
        shards = [self.start("--burin", command, "run", "jobs.jsonl", "--jobs", "1", "--shard", f"{k}/2") for k in (1, 2)]
        rounds = 0
        while any(shard.poll() is None for shard in shards):
            self.prune()
            rounds += 1
        self.assertGreater(rounds, 1)
        for shard in shards:
            self.assertEqual(shard.returncode, 0, shard.communicate()[1])
        self.assertFalse((self.folder / "out/parts/old-iso.svg").exists())
        summary, known = self.report()
        self.assertEqual(summary, "12 drawn, 0 failed")
        self.assertIn("12 of them were done", self.run_all("--jobs", "2"))
        self.assertEqual(self.report(), (summary, known))

    def catalogue(self, text):
        (self.folder / "catalogue.toml").write_text(text)
        return "catalogue.toml"

    def test_a_record_that_names_other_folders_harms_none(self):
        self.parts("a.off")
        self.plan(SOME)
        self.run_all()
        (self.folder / "kept.txt").write_text("mine")
        [record] = (self.folder / "out/.burin-batch/records").glob("*/*.json")
        false = record.read_text().replace("parts/a-iso.svg", "../kept.txt").replace(record.stem, "0" * 32)
        other = record.parent.parent / "00" / f"{'0' * 32}.json"
        other.parent.mkdir(exist_ok=True)
        other.write_text(false)
        self.assertIn("1 records and 0 files removed", self.prune())
        self.assertEqual((self.folder / "kept.txt").read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
