#!/usr/bin/env python3
"""Writes the tables of options and style keys in the pages, from what the command says of itself.

    kernel/docs/options.py BURIN             writes them
    kernel/docs/options.py BURIN --check     tells whether they are what the command says (status 1 where they are not)

A table stands between the lines <!-- options GROUP --> or <!-- style keys GROUP... --> and <!-- end -->."""
import argparse
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGES = ("cli.md", "style.md")
REGION = re.compile(r"(<!-- (options|style keys) ([^>]*?) -->\n).*?(<!-- end -->\n)", re.DOTALL)


def cell(text):
    return text.replace("|", "\\|")


def option_rows(options, group):
    """One row an option as `--help` tells it; a switch that can be turned off has two."""
    rows = [f"| {group} | |", "|---|---|"]
    for option in options:
        if option["group"] != group:
            continue
        name = option["name"].rstrip("_").replace("_", "-")
        words = f"-{option['letter']},--{name}" if option["letter"] else f"--{name}"
        label = " " + option["label"] if option["label"] else ""
        rows.append(f"| `{cell(words + label)}` | {cell(option['meaning'])} |")
        if option["negated"]:
            rows.append(f"| `--no-{name}` | {cell(option['negated'])} |")
    return rows


def key_rows(keys, groups):
    rows = ["| key | takes | in `technical` | |", "|---|---|---|---|"]
    for key in keys:
        if key["name"].split(".")[0] in groups:
            rows.append(f"| `{key['name']}` | {cell(key['takes'])} | {key['value']} | {cell(key['meaning'])} |")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("burin", help="the command")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    told = subprocess.run([arguments.burin, "options", "--json"], check=True, capture_output=True, text=True)
    catalogues = json.loads(told.stdout)

    def table(match):
        head, kind, what, end = match.groups()
        if kind == "options":
            rows = option_rows(catalogues["options"], what)
        else:
            rows = key_rows(catalogues["style_keys"], what.split())
        if len(rows) == 2:
            sys.exit(f"options.py: no {kind} of {what}")
        return head + "\n".join(rows) + "\n" + end

    stale = []
    for name in PAGES:
        page = HERE / name
        old = page.read_text()
        new = REGION.sub(table, old)
        if new == old:
            continue
        stale.append(name)
        if not arguments.check:
            page.write_text(new)
    if arguments.check and stale:
        sys.exit(f"options.py: {', '.join(stale)}: not what the command says; run kernel/docs/options.py {arguments.burin}")


main()
