"""How long the GUI stands still: a heart that beats every 5 ms in the GUI's thread while every document of a folder is
illustrated. Run by responsiveness.sh in FreeCAD's GUI.

For each step two numbers are told: the longest time of the GUI's thread's own work between two beats (its CPU time, which
other programs on the machine do not lengthen) and the longest gap by the clock, which they do."""

import glob
import os
import sys
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "freecad", "gui"))
import FreeCAD  # noqa: E402
import FreeCADGui as Gui  # noqa: E402
import support  # noqa: E402
from PySide import QtCore  # noqa: E402

STEPS = ("frame", "new", "key", "cancel", "engraving", "explode", "update", "undo", "open")


def scheduler():
    from freecad.burin_wb.view import scheduler

    return scheduler.scheduler


def steps(path):
    """Beats by step; nothing where the document shows no faces."""
    from freecad.burin_wb import features

    document = FreeCAD.openDocument(path)
    sources = features.visible(document)
    if not sources:
        return None
    document.UndoMode = 1
    for view in Gui.ActiveDocument.mdiViewsOfType("Gui::View3DInventor"):  # a TechDraw page may be in front of it
        view.viewIsometric()
        view.fitAll()
    support.settle(300)
    Gui.Selection.clearSelection()
    for obj in sources:
        Gui.Selection.addSelection(obj)
    scheduler()._kept.clear()
    beats = {}

    def step(name, work, until=None):
        with support.Heartbeat() as beats[name]:
            work()
            support.drawn()
            support.settle(50)

    def change(name, value):
        setattr(obj, name, value)
        document.recompute()

    with support.Heartbeat() as beats["frame"]:  # the 3-D view alone, which software draws here: what no step can be below
        for _ in range(3):
            for view in Gui.ActiveDocument.mdiViewsOfType("Gui::View3DInventor"):
                view.redraw()
            support.settle(20)

    step("new", lambda: Gui.runCommand("Burin_NewIllustration"))
    obj, panel = support.panel().obj, support.panel()
    step("key", lambda: (panel.change("StyleKeys", {"line.outer": "0.6"}), support.settle(250)))

    def cancel():
        panel.change("Style", "engraving")
        support.settle(350)
        scheduler().cancel(obj)

    step("cancel", cancel)
    panel.accept()
    step("engraving", lambda: (obj.touch(), change("Seed", 2)))

    def explode():
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand("Burin_Explode")
        support.drawn()
        slider = support.panel().slider
        for share in range(100, 40, -5):
            slider.setValue(share)
            support.settle(30)

    step("explode", explode)
    support.panel().reject()
    source = obj.Sources[0][0]
    if hasattr(source, "Placement"):
        source.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 1), FreeCAD.Rotation()).multiply(source.Placement)
        support.settle(300)  # FreeCAD's own work for the move
    step("update", lambda: (obj.touch(), obj.recompute()))
    document.recompute()  # of what the move touched, so that undo does not take that back too
    support.drawn()
    document.openTransaction("Change")
    change("Seed", 3)
    support.drawn()
    document.commitTransaction()
    step("undo", lambda: document.undo())
    saved = str(support.OUT / "bench.FCStd")
    document.saveAs(saved)
    FreeCAD.closeDocument(document.Name)

    def reopen():
        again = FreeCAD.openDocument(saved)
        one = next(o for o in again.Objects if features.is_illustration(o))
        support.settle(500)
        with support.Heartbeat() as beats["open"]:  # what the add-on does of it, not FreeCAD's own reading
            one.ViewObject.Proxy._shown = ""
            one.ViewObject.Proxy._renew()
            one.touch()
            one.recompute()
            support.drawn()
            support.settle(50)

    reopen()
    return beats


def main():
    files = sorted(f for f in glob.glob(os.path.join(os.environ["BURIN_TEST_DATA"], "fcstd", "*", "*"))
                   if f.lower().endswith(".fcstd"))
    only = os.environ.get("BURIN_BENCH_ONLY", "")
    worst = {name: [0.0, 0.0] for name in STEPS}
    with open(os.environ["BURIN_TABLE"], "w", encoding="utf-8") as out:
        print("| document | " + " | ".join(STEPS) + " |\n|---|" + "---|" * len(STEPS), file=out)
        for path in files:
            name = os.path.basename(path)
            if only and only not in name:
                continue
            try:
                beats = steps(path)
            except Exception:
                traceback.print_exc()
                print(f"| {name} | failed |", file=out, flush=True)
                beats = None
            if beats is not None:
                cells = []
                for step in STEPS:
                    beat = beats[step]
                    cells.append(f"{1e3 * beat.longest:.0f} ({1e3 * beat.wall:.0f})")
                    worst[step] = [max(worst[step][0], beat.longest), max(worst[step][1], beat.wall)]
                print(f"| {name} | " + " | ".join(cells) + " |", file=out, flush=True)
            if Gui.Control.activeDialog():
                Gui.Control.closeDialog()
            for open_one in list(FreeCAD.listDocuments()):
                FreeCAD.closeDocument(open_one)
            support.settle(50)
        print("| worst | " + " | ".join(f"{1e3 * c:.0f} ({1e3 * w:.0f})" for c, w in worst.values()) + " |", file=out)


def begin():
    status = 1
    try:
        support.settle(300)
        import freecad.burin_wb.commands  # noqa: F401
        from freecad.burin_wb.view import scheduler as module

        module.install().warm()
        support.settle(2000)
        main()
        status = 0
        with open(os.environ["BURIN_TEST_VERDICT"], "w", encoding="utf-8") as verdict:
            verdict.write("0")
    except BaseException:
        traceback.print_exc()
    finally:
        support.stop_worker()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


QtCore.QTimer.singleShot(0, begin)
