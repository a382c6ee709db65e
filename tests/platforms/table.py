#!/usr/bin/env python3
"""What was run where, with what came out: the table "Platforms" of kernel/docs/install.md, from tests/platforms/results.tsv.

    tests/platforms/table.py                        writes the table
    tests/platforms/table.py --check                status 1 where the page has another one
    tests/platforms/table.py add PLATFORM WHAT VERSIONS RESULT
                                                    a row of today, in place of the one of the same PLATFORM and WHAT

./dev bundle --try, ./dev wheel --try, ./dev addon --try and ./dev test --root add theirs."""
import csv
import datetime
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROWS = HERE / "results.tsv"
PAGE = HERE.parents[1] / "kernel/docs/install.md"
BEGIN, END = "<!-- platforms: tests/platforms/table.py writes this -->\n", "<!-- platforms end -->\n"
COLUMNS = ("platform", "what", "versions", "result", "date")


def read(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = [tuple(row) for row in csv.reader(file, delimiter="\t") if row]
    for number, row in enumerate(rows, 1):
        if len(row) != len(COLUMNS):
            raise ValueError(f"{path}:{number}: {len(row)} columns; there are {len(COLUMNS)}: {', '.join(COLUMNS)}")
        datetime.date.fromisoformat(row[4])
    return rows


def with_row(rows, row):
    """The rows with one more, or with it in place of the one of the same platform and thing."""
    at = next((k for k, old in enumerate(rows) if old[:2] == row[:2]), None)
    if at is not None:
        return [*rows[:at], row, *rows[at + 1:]]
    # Below those of its platform.
    last = max((k for k, old in enumerate(rows) if old[0] == row[0]), default=len(rows) - 1)
    return [*rows[:last + 1], row, *rows[last + 1:]]


def table(rows):
    lines = ["| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
    return "".join(line + "\n" for line in lines + ["| " + " | ".join(row) + " |" for row in rows])


def page_with(text, rows):
    before, marked, rest = text.partition(BEGIN)
    _, ended, after = rest.partition(END)
    if not marked or not ended:
        raise ValueError(f"{PAGE}: the lines around the table are missing: {BEGIN.strip()} and {END.strip()}")
    return before + BEGIN + table(rows) + END + after


def main(words):
    try:
        rows = read(ROWS)
        text = PAGE.read_text(encoding="utf-8")
        if words == ["--check"]:
            if page_with(text, rows) != text:
                raise ValueError(f"{PAGE} has another table; tests/platforms/table.py writes it")
            return
        if words[:1] == ["add"] and len(words) == 5:
            row = tuple(" ".join(word.replace("|", "/").split()) for word in words[1:])
            rows = with_row(rows, (*row, datetime.date.today().isoformat()))
            with open(ROWS, "w", encoding="utf-8", newline="") as file:
                csv.writer(file, delimiter="\t", lineterminator="\n").writerows(rows)
        elif words:
            sys.exit(__doc__)
        PAGE.write_text(page_with(text, rows), encoding="utf-8")
    except (OSError, ValueError) as error:
        sys.exit(f"table.py: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
