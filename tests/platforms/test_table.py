"""Rows of the table of platforms."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import table  # noqa: E402

OLD = [("Debian 12", "bundle", "glibc 2.36", "drawn", "2026-11-01"), ("Debian 12", "wheel", "Python 3.11", "drawn", "2026-11-02"),
       ("Debian 13", "bundle", "glibc 2.41", "drawn", "2026-11-03")]


class Table(unittest.TestCase):
    def test_a_row_takes_the_place_of_the_one_of_the_same_platform_and_thing(self):
        new = ("Debian 12", "wheel", "Python 3.11.2", "3 of 10 drawn", "2026-12-01")
        self.assertEqual(table.with_row(OLD, new), [OLD[0], new, OLD[2]])

    def test_a_new_row_stands_below_those_of_its_platform(self):
        new = ("Debian 12", "tests", "g++ 12", "passed", "2026-12-01")
        self.assertEqual(table.with_row(OLD, new), [*OLD[:2], new, OLD[2]])
        new = ("Debian sid", "bundle", "glibc 2.42", "drawn", "2026-12-01")
        self.assertEqual(table.with_row(OLD, new), [*OLD, new])

    def test_the_page_keeps_what_is_around_the_table(self):
        page = "before\n" + table.BEGIN + "| old |\n" + table.END + "after\n"
        now = table.page_with(page, OLD[:1])
        self.assertTrue(now.startswith("before\n" + table.BEGIN + "| platform | what |"))
        self.assertTrue(now.endswith("| Debian 12 | bundle | glibc 2.36 | drawn | 2026-11-01 |\n" + table.END + "after\n"))
        self.assertEqual(table.page_with(now, OLD[:1]), now)
        with self.assertRaisesRegex(ValueError, "are missing"):
            table.page_with("no table\n", OLD)

    def test_a_row_that_cannot_be_read_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder) / "results.tsv"
            rows.write_text("\t".join(OLD[0]) + "\nDebian 12\tbundle\n", encoding="utf-8")
            with self.assertRaisesRegex(ValueError, ":2: 2 columns; there are 5"):
                table.read(rows)
            rows.write_text("\t".join((*OLD[0][:4], "yesterday")) + "\n", encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "yesterday"):
                table.read(rows)


if __name__ == "__main__":
    unittest.main()
