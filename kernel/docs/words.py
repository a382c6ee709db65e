#!/usr/bin/env python3
"""Compares the table "Words" of kernel/docs/architecture.md with the public headers, and finds texts of the kernel that
spell an option as the command line does.

    kernel/docs/words.py

Every name in the column "in the code" has to be declared in a public header; no name there may have a word of the column
"instead of" in it (`child_end` and `ChildEnd` have "child"). No text of the kernel may have
"--bounds", which is how the command line spells `bounds`. Status 1, with a line for each that does not hold."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "kernel/docs/architecture.md"


def rows():
    """(word, names in the code, words that it stands instead of) of each row."""
    section = PAGE.read_text(encoding="utf-8").split("\n## Words\n")[1].split("\n## ")[0]
    table = [line for line in section.splitlines() if line.startswith("|")]
    if len(table) < 10:
        sys.exit(f"words.py: no table of words in {PAGE}")
    for line in table[2:]:
        word, names, others, _ = (cell.strip() for cell in line.strip("|").split("|"))
        yield word, re.findall(r"`(\w+)`", names), re.findall(r"\w+", others)


def headers():
    """{path: code of a public header without comments and texts}."""
    found = {}
    for folder in ("kernel", "converters"):
        for path in (ROOT / folder).rglob("include/burin/**/*.h"):
            text = path.read_text(encoding="utf-8")
            found[path] = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|#include[^\n]*', " ", text, flags=re.S)
    if len(found) < 50:
        sys.exit("words.py: the public headers are not where they were")
    return found


def spelled_options():
    """A line for each text of the kernel that spells an option as the command does."""
    for path in sorted((ROOT / "kernel").rglob("*.cpp")):
        code = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
        for text in re.findall(r'"(?:\\.|[^"\\\n])*"', code):
            for option in re.findall(r"--[a-z][a-z-]*", text):
                name = option[2:].replace("-", "_")
                yield f"{path.relative_to(ROOT)}: {option}: write `{name}`, which each front end spells its way"


def parts(name):
    """The words of a name: of `EdgeKind` edge and kind, of `part_styles` part and styles."""
    return [word.lower() for piece in name.split("_") for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])", piece)]


def main():
    names = {path: set(re.findall(r"[A-Za-z_]\w*", code)) for path, code in headers().items()}
    known = set().union(*names.values())
    wrong, instead = list(spelled_options()), {}
    for word, declared, others in rows():
        wrong += [f"'{word}': no public header has {name}" for name in declared if name not in known]
        instead.update({other: word for other in others})
    for path, used in sorted(names.items()):
        for name in sorted(used):
            wrong += [f"{path.relative_to(ROOT)}: {name}: the word is '{instead[w]}', not '{w}'"
                      for w in parts(name) if w in instead]
    print("\n".join(wrong) or f"{len(instead)} words left, {len(known)} names in {len(names)} public headers: they agree")
    sys.exit(bool(wrong))


main()
