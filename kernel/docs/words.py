#!/usr/bin/env python3
"""Compares the table "Words" of kernel/docs/architecture.md with the public headers, finds texts of the kernel that
spell an option as the command line does, and words that only we would know in texts and comments.

    kernel/docs/words.py

Every name in the column "in the code" has to be declared in a public header; no name there may have a word of the column
"instead of" in it (`child_end` and `ChildEnd` have "child"). No text of the kernel may have
"--bounds", which is how the command line spells `bounds`. No message or help has a word of PRIVATE_TEXT, no comment one of
PRIVATE_COMMENT, but for what ALLOWED names with its reason. Status 1, with a line for each that does not hold."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "kernel/docs/architecture.md"
# In their private meanings: a module is no room, a front end no door, a message is not told.
PRIVATE_TEXT = re.compile(
    r"\b(rooms|(the|this|each|every) room|house|doors?|courts?|teller|told|tells|telling|stands?|standing|brought|brings?|said|says|"
    r"rests|inked|inks)\b|\btell (of|what|how|which)\b|[,;:] say [^,]")
PRIVATE_COMMENT = re.compile(r"\b(rooms|(the|this|that|each|every|a|other) room|houses?|doors?|courts?|tellers?)\b(?! (for|on|that|to|about|beside)\b)")
# (part of a path, part of the text): why it may stay.
ALLOWED = {
    ("freecad_wb/freecad/burin_wb/view/ink.py", "Stand"): "the name of a type",
}


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


def pieces(path, text):
    """(line, whether it is a comment, text) of each text and comment of a source; texts that follow each other are one."""
    if path.suffix == ".py":
        pattern = r'[rRfFbB]{0,2}"""(?:.*?)"""|#[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
    else:
        pattern = r"(?:[ \t]*//[^\n]*\n)+|//[^\n]*|/\*.*?\*/|#include[^\n]*|'(?:\\.|[^'\\\n])'" r'|"(?:\\.|[^"\\\n])*"(?:\s*"(?:\\.|[^"\\\n])*")*'
    for m in re.finditer(pattern, text, flags=re.S):
        piece = m.group(0)
        if piece.startswith(("#include", "'")) and path.suffix != ".py":
            continue
        comment = piece.lstrip().startswith(("/", "#")) or '"""' in piece
        plain = re.sub(r"`[^`]*`", " ", re.sub(r"\n\s*//+", " ", piece) if comment else re.sub(r'"\s*"|\{[^{}]*\}', "", piece))
        yield text.count("\n", 0, m.start()) + 1, comment, plain


def private_words():
    """A line for each private word in a text or comment."""
    for top in ("kernel", "converters", "freecad_wb"):
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix not in (".h", ".cpp", ".py") or path == pathlib.Path(__file__).resolve():
                continue
            where = str(path.relative_to(ROOT))
            for line, comment, text in pieces(path, path.read_text(encoding="utf-8")):
                if not comment and " " not in text.strip("\"'"):
                    continue
                for found in (PRIVATE_COMMENT if comment else PRIVATE_TEXT).finditer(text):
                    if not any(where.startswith(folder) and words in text for folder, words in ALLOWED):
                        yield f"{where}:{line}: '{found.group(0).strip()}' in: {' '.join(text.split())[:90]}"


def parts(name):
    """The words of a name: of `EdgeKind` edge and kind, of `part_styles` part and styles."""
    return [word.lower() for piece in name.split("_") for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])", piece)]


def main():
    names = {path: set(re.findall(r"[A-Za-z_]\w*", code)) for path, code in headers().items()}
    known = set().union(*names.values())
    wrong, instead = list(spelled_options()) + list(private_words()), {}
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
