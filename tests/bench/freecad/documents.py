"""Draws what every document of a folder shows; a table of it. Run by documents.sh inside freecadcmd."""

import glob
import os
import sys
import time
import traceback


def row(path):
    import FreeCAD as App
    from freecad.burin_wb import features
    from freecad.burin_wb.features import illustration

    name = os.path.basename(path)
    try:
        document = App.openDocument(path)
    except Exception as error:  # FreeCAD throws many kinds
        return f"| {name} | - | - | - | not opened: {illustration.reason(error)} |"
    try:
        sources = features.visible(document)
        if not sources:
            return f"| {name} | 0 | - | - | shows no object with faces |"
        obj = features.make_illustration(document, sources)
        begin = time.perf_counter()
        obj.recompute()
        seconds = time.perf_counter() - begin
        if not obj.Drawing:
            return f"| {name} | {len(sources)} | - | - | not drawn: {obj.Message} |"
        paths = sum(1 for _ in features.sheet.Sheet(obj.Drawing).paths())
        return f"| {name} | {len(sources)} | {paths} | {seconds:.2f} | drawn{': ' + obj.Message if obj.Message else ''} |"
    finally:
        App.closeDocument(document.Name)


def main():
    from freecad.burin_wb.features import illustration

    illustration._worker.start()
    files = sorted(f for f in glob.glob(os.path.join(os.environ["BURIN_TEST_DATA"], "fcstd", "*", "*"))
                   if f.lower().endswith(".fcstd"))
    with open(os.environ["BURIN_TABLE"], "w", encoding="utf-8") as out:
        print("| document | objects | lines | s | |\n|---|---|---|---|---|", file=out)
        for path in files:
            print(row(path), file=out, flush=True)


try:
    main()
except BaseException:
    traceback.print_exc()
    sys.exit(1)
sys.exit(0)
