#!/usr/bin/env python3
"""Asks the kernel what it offers, for freecad/burin_wb/resources/offers.json: offers.py FOLDER, which holds the Python
module burin (build/release/python). With --check it changes nothing and ends with 1 where the file says something else."""

import json
import pathlib
import sys

ADDON = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ADDON))


def text_of(told):
    """JSON with a line an entry."""
    groups = []
    for name, entries in told.items():
        if isinstance(entries, dict):
            lines = [f"  {json.dumps(key)}: {json.dumps(value, ensure_ascii=False)}" for key, value in entries.items()]
            groups.append(f" {json.dumps(name)}: {{\n" + ",\n".join(lines) + "\n }")
        else:
            groups.append(f" {json.dumps(name)}: {json.dumps(entries, ensure_ascii=False)}")
    return "{\n" + ",\n".join(groups) + "\n}\n"


def main():
    folders = [word for word in sys.argv[1:] if word != "--check"]
    if len(folders) != 1:
        sys.exit(__doc__)
    sys.path.insert(0, folders[0])
    import burin
    from freecad.burin_wb import offers

    text = text_of(offers.asked(burin))
    path = pathlib.Path(offers.PATH)
    if "--check" not in sys.argv:
        path.write_text(text, encoding="utf-8")
    elif not path.exists() or path.read_text(encoding="utf-8") != text:
        print(f"{path.name} is not what the kernel offers; run freecad_wb/tools/offers.py {folders[0]}, then "
              "freecad_wb/tools/translations.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
