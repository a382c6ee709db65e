#!/usr/bin/env python3
"""Writes the tables of the pages reference.md and styles.md, from what the command reports of itself.

    kernel/docs/options.py BURIN             writes them (so does --write)
    kernel/docs/options.py BURIN --check     compares them with what the command reports (status 1 where they differ)

A table stands between a line of the form <!-- TABLE ARGUMENT --> and the line <!-- end -->. TABLES below lists the tables:
options of one group, options that one command has alone, options that commands share, style keys by group, the scopes of groups of style keys, styles,
kinds of strokes, names (of formats or stages), and the keys of illustration files."""
import argparse
import json
import pathlib
import re
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
#: The first lists all: what has no table there is missing.
PAGES = [FOLDER / "reference.md", FOLDER / "styles.md"]
HELP_COLUMN = 28


def cell(text):
    return text.replace("|", "\\|")


def table(head, rows):
    lines = [head, "|---" * (head.count("|") - 1) + "|"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


class Command:
    """What the command BURIN reports of itself."""

    def __init__(self, burin):
        self.burin = burin
        self.catalogues = json.loads(self.output("options", "--json"))
        self.schema = json.loads(self.output("options", "--illustration-schema"))

    def output(self, *words):
        return subprocess.run([self.burin, *words], check=True, capture_output=True, text=True).stdout

    def help(self, command):
        """{"-o,--output FILE": meaning} of each option that `burin COMMAND --help` lists."""
        found, name = {}, None
        for line in self.output(command, "--help").splitlines():
            if line.startswith("  -"):
                # A name that is longer than its column has a line of its own.
                both = len(line) > HELP_COLUMN and line[HELP_COLUMN - 1] == " "
                name = (line[:HELP_COLUMN] if both else line).strip().removesuffix(" ...")
                found[name] = line[HELP_COLUMN:] if both else ""
            elif name and line.startswith(" " * HELP_COLUMN):
                found[name] += " " + line.strip()
            else:
                name = None
        return {name: " ".join(text.split()) for name, text in found.items() if name != "-h,--help"}


def option_names(option):
    """{name as `--help` writes it: meaning}; a switch that can be turned off has two."""
    name = option["name"].rstrip("_").replace("_", "-")
    words = f"-{option['letter']},--{name}" if option["letter"] else f"--{name}"
    label = " " + option["label"] if option["label"] else ""
    names = {words + label: option["meaning"]}
    if option["negated"]:
        names[f"--no-{name}"] = option["negated"]
    return names


def options(command, group):
    rows = {}
    for option in command.catalogues["options"]:
        if option["group"] == group:
            rows |= option_names(option)
    return table(f"| {group} | |", [(f"`{cell(name)}`", cell(text)) for name, text in rows.items()])


def command_options(command, name):
    """The options of a command that neither a group nor `burin draw` has with the same meaning."""
    shared = {} if name == "draw" else command.help("draw")
    for option in command.catalogues["options"]:
        shared |= option_names(option)
    own = {words: text for words, text in command.help(name).items() if shared.get(words) != text}
    return table(f"| `burin {name}` alone | |", [(f"`{cell(words)}`", cell(text)) for words, text in own.items()])


def shared_options(command, commands):
    """Which options of `burin draw` each command takes, in the shorter of two ways."""
    def listed(words):
        return ", ".join(f"`{re.sub('^-.,', '', word.split(' ')[0])}`" for word in words)

    draw, rows = command.help("draw"), []
    for name in commands.split():
        own = {words.split(" ")[0] for words in command.help(name)}
        taken = [words for words in draw if words.split(" ")[0] in own]
        left = [words for words in draw if words not in taken]
        text = f"all except {listed(left)}" if left else "all"
        rows.append((f"`burin {name}`", text if len(left) < len(taken) else listed(taken)))
    return table("| command | options of `burin draw` that it takes |", rows)


def style_keys(command, groups):
    rows = [(f"`{key['name']}`", cell(key["takes"]), cell(key["value"]), key["scope"], cell(key["meaning"]))
            for key in command.catalogues["style_keys"] if key["name"].split(".")[0] in groups.split()]
    return table("| key | takes | in `technical` | scope | meaning |", rows)


def scopes(command, _):
    """Which groups of style keys concern a part, which the drawing; of a group of both kinds the fewer keys by name."""
    groups = {}
    for key in command.catalogues["style_keys"]:
        groups.setdefault(key["name"].split(".")[0], {}).setdefault(key["scope"], []).append(key["name"])

    def listed(scope):
        found = []
        for name, keys in groups.items():
            own, other = keys.get(scope, []), [key for of in keys if of != scope for key in keys[of]]
            if own and len(own) < len(other):
                found += [f"`{key}`" for key in own]
            elif own:
                found.append(f"`{name}.*`" + (f" (not {', '.join(f'`{key}`' for key in other)})" if other else ""))
        return ", ".join(found)

    return table("| scope | style keys |", [(scope, listed(scope)) for scope in ("part", "drawing")])


def catalogue(head, member):
    def rows(command, _):
        return table(head, [(f"`{row['name']}`", cell(row["meaning"])) for row in command.catalogues[member]])
    return rows


def names(command, member):
    found = command.catalogues[member]
    return [", ".join(f"`{name}`" for name in found)] if found else []


def takes(schema):
    """What a value of a JSON Schema may be, in a few words."""
    if "enum" in schema:
        return ", ".join(map(str, schema["enum"]))
    if "const" in schema:
        return str(schema["const"]).lower() if isinstance(schema["const"], bool) else str(schema["const"])
    if "$ref" in schema:
        return "object"
    kinds = schema.get("type", [])
    kinds = [kinds] if isinstance(kinds, str) else list(kinds)
    for other in schema.get("anyOf", []):
        kinds += takes(other).split(" or ")
    return " or ".join(dict.fromkeys(kinds))


def members(schema):
    """(name, schema) of each member of an object, or of the objects of a list, that a schema allows."""
    for name, member in schema.get("properties", {}).items():
        yield name, member
    nested = schema.get("anyOf", []) + ([schema["items"]] if isinstance(schema.get("items"), dict) else [])
    for other in nested:
        yield from members(other)


def illustration_keys(command, _):
    reading = {option["name"] for option in command.catalogues["options"]}
    rows = {}

    def add(schema, path):
        for name, member in members(schema):
            key = path + name
            if path == "parts." and name in reading:
                continue  # the page names them as a whole
            text = member.get("description", "")
            rows.setdefault(key, (f"`{key}`", cell(takes(member)), cell(text)))
            add(member, key + ".")

    add(command.schema, "")
    return table("| key | takes | meaning |", list(rows.values()))


TABLES = {
    "options": options,
    "options of": command_options,
    "shared options of": shared_options,
    "style keys": style_keys,
    "scopes of style keys": scopes,
    "styles": catalogue("| style | what it draws |", "styles"),
    "kinds of strokes": catalogue("| kind | what it draws |", "stroke_kinds"),
    "names": names,
    "illustration keys": illustration_keys,
}
KINDS = "|".join(sorted(TABLES, key=len, reverse=True))
REGION = re.compile(rf"(<!-- ({KINDS})(?: ([^>]*?))? -->\n).*?(<!-- end -->\n)", re.DOTALL)


def missing_tables(page, command):
    """A line for each group of options or style keys that has no table in the page."""
    found = [(match[2], match[3] or "") for match in REGION.finditer(page)]
    wanted = {("options", option["group"]) for option in command.catalogues["options"]}
    groups = {group for kind, text in found if kind == "style keys" for group in text.split()}
    missing = [f"no table of {kind} {what}" for kind, what in sorted(wanted - set(found))]
    missing += [f"no table of the style keys {name}." for name in sorted(
        {key["name"].split(".")[0] for key in command.catalogues["style_keys"]} - groups)]
    return missing


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("burin", help="the command")
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--check", action="store_true", help="compare; write nothing")
    mode.add_argument("--write", action="store_true", help="write the page (the default)")
    arguments = parser.parse_args()
    command = Command(arguments.burin)
    for page in PAGES:
        def region(match):
            head, kind, what, end = match.groups()
            rows = TABLES[kind](command, what or "")
            if len(rows) == 2 or not rows:
                sys.exit(f"options.py: {page.name}: nothing to list for <!-- {kind} {what or ''} -->")
            return head + "\n" + "\n".join(rows) + "\n\n" + end

        old = page.read_text(encoding="utf-8")
        new = REGION.sub(region, old)
        missing = missing_tables(new, command) if page == PAGES[0] else []
        if missing:
            sys.exit("\n".join(f"options.py: {page.name}: {line}" for line in missing))
        if new != old and arguments.check:
            sys.exit(f"options.py: {page.name}: not what the command reports; run kernel/docs/options.py {arguments.burin}")
        if new != old:
            page.write_text(new, encoding="utf-8")


main()
