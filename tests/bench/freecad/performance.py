"""From a change to the drawing kept in the document, beside TechDraw's own view of the same shape. Run by run.sh."""

import glob
import os
import sys
import time
import traceback

REPEATS = 3


def best(run):
    """The least of some runs in seconds: what else the machine does only adds."""
    taken = []
    for k in range(REPEATS):
        begin = time.perf_counter()
        run(k)
        taken.append(time.perf_counter() - begin)
    return min(taken)


def shapes():
    import Part

    data = os.environ["BURIN_TEST_DATA"]
    files = sorted(glob.glob(os.path.join(data, "step", "nist", "*.stp")))
    files += [f for f in ("/usr/share/opencascade/data/step/linkrods.step",
                          "/usr/share/opencascade/data/occ/Motor-c.brep") if os.path.exists(f)]
    for path in files:
        shape = Part.Shape()
        shape.read(path)
        yield os.path.basename(path), shape


def techdraw(document, source, obj, coarse):
    """Seconds of a recompute of a DrawViewPart, and its visible edges."""
    import FreeCAD as App

    page = document.addObject("TechDraw::DrawPage", "Page")
    template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = os.path.join(App.getResourceDir(), "Mod/TechDraw/Templates/A3_Landscape_blank.svg")
    page.Template = template
    view = document.addObject("TechDraw::DrawViewPart", "View")
    page.addView(view)
    view.Source = [source]
    view.Direction, view.XDirection = App.Vector(1, -1, 1), App.Vector(1, 1, 0)
    view.ScaleType, view.Scale, view.CoarseView = "Custom", obj.DrawnScale, coarse

    def run(k):
        view.touch()
        view.recompute()

    seconds = best(run)
    count = len(view.getVisibleEdges())
    document.removeObject(page.Name)
    return seconds, count


def row(name, shape):
    import FreeCAD as App
    from freecad.burin_wb import features
    from freecad.burin_wb.features import illustration
    from freecad.burin_wb.features.sheet import Sheet

    document = App.newDocument()
    source = document.addObject("Part::Feature", "Part")
    source.Shape = shape
    document.recompute()
    obj = features.make_illustration(document, [source])

    def change(k):
        obj.Seed = k + 1
        obj.recompute()

    whole = best(change)
    collect = best(lambda k: illustration.make_job(obj))
    job = illustration.make_job(obj)

    def hashed(k):
        job.parts[0].brep.digest = None  # it is kept with the text
        job.exact_fingerprint()

    exact = best(hashed)
    tolerant = best(lambda k: job.fingerprint())
    burin = illustration.kernel_module()
    drawn = []
    kernel = best(lambda k: drawn.append(job.draw(burin)))
    write = best(lambda k: (drawn[0].to_bytes("json", json_points3=False), drawn[0].to_bytes("svg", svg_merge=True)))
    nothing = best(lambda k: (obj.touch(), obj.recompute()))
    read = best(lambda k: burin.Drawing.load(obj.Drawing).arrays())
    fine, fine_edges = techdraw(document, source, obj, False)
    coarse, coarse_edges = techdraw(document, source, obj, True)
    lines = sum(1 for _ in Sheet(obj.Drawing).paths())
    size = len(job.parts[0].brep) / 1e3
    App.closeDocument(document.Name)
    return (f"| {name} | {len(shape.Faces)} | {lines} | {whole:.2f} | {fine:.2f} ({fine_edges}) | {coarse:.2f} ({coarse_edges}) |",
            f"| {name} | {size:.0f} | {1e3 * collect:.0f} | {1e3 * exact:.1f} | {1e3 * tolerant:.0f} | {1e3 * kernel:.0f} | "
            f"{1e3 * write:.0f} | {1e3 * read:.0f} | {1e3 * nothing:.0f} |")


def symbol_rows(out):
    """Setting a TechDraw symbol of many strokes, written by the kernel in one group or as one path each."""
    import json

    import FreeCAD as App
    from freecad.burin_wb import features, kernel
    from freecad.burin_wb.features.symbol import Window, to_symbol

    burin = kernel.module()
    document = App.newDocument()
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    obj = features.make_illustration(document, [box])
    obj.Style = "engraving"
    obj.recompute()
    with open(obj.Drawing, encoding="utf-8") as file:
        data = json.load(file)
    layer = next(x for x in data["layers"] if any(p["kind"] == "stroke" for p in x["paths"]))
    stroke = dict(next(p for p in layer["paths"] if p["kind"] == "stroke"), faces=[])
    del stroke["faces"]
    view = document.addObject("TechDraw::DrawViewSymbolPython", "View")
    for count in (100, 1000, 5000, 20000):
        layer["paths"] = [dict(stroke, points=[[5 + k % 170, 5 + (k // 170) % 110 + 0.1 * n] for n in range(12)],
                               width=[0.1 + 0.02 * n for n in range(12)]) for k in range(count)]
        drawing = burin.Drawing.from_json(json.dumps(data))
        seconds = []
        for merged in (True, False):
            if not merged and count > 1000:
                seconds.append(None)
                continue
            text = to_symbol(drawing.to_bytes("svg", svg_merge=merged).decode(), Window(0, 0, 180, 130))

            def assign(k):
                view.Symbol = text.replace("</desc>", f"{k}</desc>")

            seconds.append((best(assign), text.count("<path")))
        told = " | ".join("-" if s is None else f"{s[0]:.3f} ({s[1]})" for s in seconds)
        print(f"| {count} | {told} |", file=out, flush=True)
    App.closeDocument(document.Name)


def worker_rows(out):
    """Starting a worker, and cancelling a run in it at many moments."""
    import threading

    import Part
    from freecad.burin_wb import worker
    from freecad.burin_wb.job import Job, PartJob

    block = Part.makeBox(60, 60, 10)
    for i in range(25):
        block = block.cut(Part.makeCylinder(4, 20, vector(6 + 12 * (i % 5), 6 + 12 * (i // 5), -5)))
    parts = [PartJob("Block", "Block", block.exportBrepToString().encode())]
    cold = best(lambda k: worker.Worker().draw(Job(parts, {"style": "outline"})))
    one = worker.Worker()
    one.draw(Job(parts, {"style": "outline"}))
    warm = best(lambda k: one.draw(Job(parts, {"style": "outline"})))
    job = Job(parts, {"style": "engraving", "paper": (500, 500), "tolerance": 0.01})
    begin = time.perf_counter()
    one.draw(job)
    whole = time.perf_counter() - begin
    late = []
    for k in range(12):
        asked = []

        def cancel():
            asked.append(time.perf_counter())
            one.cancel()

        timer = threading.Timer(whole * (k + 0.5) / 12, cancel)
        timer.start()
        try:
            one.draw(job)
        except worker.Stopped:
            late.append(time.perf_counter() - asked[0])
        timer.cancel()
    one.stop()
    print(f"First run with a new worker {cold:.2f} s, the same run with one that runs {warm:.2f} s. A run of {whole:.1f} s "
          f"cancelled at {len(late)} moments: {1e3 * sorted(late)[len(late) // 2]:.0f} ms until it has ended (median), "
          f"{1e3 * max(late):.0f} ms at most.\n", file=out, flush=True)


def vector(x, y, z):
    import FreeCAD

    return FreeCAD.Vector(x, y, z)


def main():
    from freecad.burin_wb import kernel
    from freecad.burin_wb.features import illustration

    illustration.kernel_module = kernel.module
    illustration._worker.start()
    time.sleep(1)  # the worker imports the kernel meanwhile, as after the first drawing of a session
    rows = [row(name, shape) for name, shape in shapes()]
    with open(os.environ["BURIN_TABLE"], "w", encoding="utf-8") as out:
        print("| shape | faces | lines | Burin, s | TechDraw fine, s (edges) | TechDraw coarse, s (edges) |\n"
              "|---|---|---|---|---|---|", *(r[0] for r in rows), "", sep="\n", file=out)
        print("| shape | BREP, kB | collect | hash | hash of stored | kernel | JSON and SVG | read | unchanged |\n"
              "|---|---|---|---|---|---|---|---|---|", *(r[1] for r in rows), "", sep="\n", file=out)
        worker_rows(out)
        print("| strokes | merged, s (elements) | one path each, s (elements) |\n|---|---|---|", file=out, flush=True)
        symbol_rows(out)


try:
    main()
except BaseException:
    traceback.print_exc()
    sys.exit(1)
sys.exit(0)
