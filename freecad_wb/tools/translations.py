#!/usr/bin/env python3
"""Renews the translation files: collects the words of the sources into Burin_*.ts, keeps what is translated, and
compiles Burin_*.qm with lrelease (Debian: qttools5-dev-tools). With --check it changes nothing and ends with 1 where a
word has no translation or a file is not up to date."""

import ast
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from freecad.burin_wb import offers  # noqa: E402

ADDON = ROOT / "freecad" / "burin_wb"
FOLDER = ADDON / "resources" / "translations"


def literal(node):
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def words_of(tree):
    """(context, word) of a source: tr("...") and what commands show of themselves."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "tr" and node.args:
            if literal(node.args[0]):
                yield "Burin", literal(node.args[0])
        if isinstance(node, ast.ClassDef):
            told = {}
            for line in node.body:
                if isinstance(line, ast.Assign):
                    for target in line.targets:
                        names = target.elts if isinstance(target, ast.Tuple) else [target]
                        values = line.value.elts if isinstance(line.value, ast.Tuple) else [line.value]
                        for name, value in zip(names, values):
                            if isinstance(name, ast.Name) and literal(value):
                                told[name.id] = literal(value)
            for key in ("text", "tip"):
                if told.get("name", "").startswith("Burin_") and key in told:
                    yield told["name"], told[key]


def offered():
    """Words of the kernel that panels show: stages of a run, groups of style keys, standard views, what styles are for, symbols of notes."""
    told = offers.kept()
    yield from (*told["stages"], "check")  # the last one is the add-on's own (job.py)
    yield from (group for group in told["groups"] if group not in told["formats"])
    yield "strokes"  # kinds of strokes after the first
    yield from map(offers.title, told["views"])
    yield from told["options"]["hidden"]["words"]
    yield from told["styles"].values()
    for symbol, options in told["symbols"].items():
        yield from (symbol, *(word for words in options.values() for word in words))


def words():
    found = {("Burin", word): None for word in offered()}
    for path in sorted(ADDON.rglob("*.py")):
        for pair in words_of(ast.parse(path.read_text(encoding="utf-8"))):
            found[pair] = None
    ui = xml.parse(ADDON / "resources" / "preferences.ui").getroot()
    for node in ui.iter("string"):
        if node.get("notr") == "true":
            continue
        found[("BurinPreferences", node.text)] = None
    # FreeCAD asks with the workbench's name for menus and toolbars.
    found[("Workbench", "Burin")] = found[("Workbench", "&Burin")] = None
    return sorted(found)


def known(path):
    """(context, word) to translation, as a .ts file has them."""
    have = {}
    if path.exists():
        for context in xml.parse(path).getroot().iter("context"):
            for message in context.iter("message"):
                have[(context.find("name").text, message.find("source").text)] = message.find("translation").text
    return have


def text_of(language, have):
    root = xml.Element("TS", version="2.1", language=language, sourcelanguage="en")
    contexts = {}
    for context, word in words():
        if context not in contexts:
            contexts[context] = xml.SubElement(root, "context")
            xml.SubElement(contexts[context], "name").text = context
        message = xml.SubElement(contexts[context], "message")
        xml.SubElement(message, "source").text = word
        translation = xml.SubElement(message, "translation")
        translation.text = have.get((context, word))
        if not translation.text:
            translation.set("type", "unfinished")
    xml.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + xml.tostring(root, encoding="unicode") + "\n"


def compiled(path):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.qm"
        for tool in ("lrelease", "/usr/lib/qt5/bin/lrelease"):
            try:
                subprocess.run([tool, "-silent", str(path), "-qm", str(out)], check=True)
                return out.read_bytes()
            except FileNotFoundError:
                continue
    sys.exit("lrelease is not installed (Debian: qttools5-dev-tools)")


def main():
    check, failed = "--check" in sys.argv, False
    for path in sorted(FOLDER.glob("Burin_*.ts")):
        language = path.stem.split("_")[1]
        have = known(path)
        text = text_of(language, have)
        open_words = [pair for pair in words() if not have.get(pair)]
        for context, word in open_words:
            print(f"{path.name}: not translated: {context}: {word}")
        if check:
            stale = path.read_text(encoding="utf-8") != text
            if stale:
                print(f"{path.name}: not up to date; run freecad_wb/tools/translations.py")
            failed |= stale or bool(open_words)
        else:
            path.write_text(text, encoding="utf-8")
            path.with_suffix(".qm").write_bytes(compiled(path))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
