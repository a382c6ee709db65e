#!/usr/bin/env python3
"""Runs a test script in FreeCAD's GUI on a screen of its own: run.py BURIN_PYTHON OUT SCRIPT.

Ends with 77 (skipped) where FreeCAD or Xvfb is absent, else with the script's status."""

import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
HERE = pathlib.Path(__file__).resolve().parent
ADDON = pathlib.Path(os.environ.get("BURIN_ADDON") or HERE.parent.parent.parent / "freecad_wb")

# FreeCAD 1.0 would turn the camera slowly, and a test would read it on its way; and what tests print would lie before its window.
# The navigation cube is painted with each frame of the 3-D view, and a new one for each document.
CONFIG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">%s</FCText><FCText Name="Language">%s</FCText></FCParamGroup>
<FCParamGroup Name="MainWindow"><FCText Name="StyleSheet">%s</FCText></FCParamGroup>
<FCParamGroup Name="NotificationArea"><FCBool Name="NonIntrusiveNotificationsEnabled" Value="0"/></FCParamGroup>
<FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/><FCBool Name="ShowNaviCube" Value="%d"/></FCParamGroup>
<FCParamGroup Name="OutputWindow"><FCBool Name="checkShowReportViewOnWarning" Value="0"/>
<FCBool Name="checkShowReportViewOnError" Value="0"/></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def screen():
    """Starts Xvfb on a display of its own; the process and the display's name. The number is drawn by lot: one that is free in
    this root may be taken in another on the machine, and programs would come to that screen and go with it."""
    for number in random.SystemRandom().sample(range(100, 30000), 20):
        read, write = os.pipe()
        server = subprocess.Popen(["Xvfb", f":{number}", "-displayfd", str(write), "-screen", "0", os.environ.get("BURIN_TEST_SCREEN", "1024x768") + "x24", "-nolisten", "tcp"],
                                  pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as told:
            if told.readline().strip():
                return server, f":{number}"
        server.wait()
    sys.exit("Xvfb does not start")


def main():
    kernel, out, script = sys.argv[1:4]
    freecad = next((p for p in map(shutil.which, ("freecad", "FreeCAD")) if p), None)
    for name, found in (("freecad", freecad), ("Xvfb (package xvfb)", shutil.which("Xvfb"))):
        if not found:
            print(f"skipped: {name} is not installed")
            return SKIP
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    verdict = out / (pathlib.Path(script).stem + ".verdict")
    verdict.unlink(missing_ok=True)
    home = tempfile.mkdtemp(prefix="burin-freecad-")
    with open(os.path.join(home, "user.cfg"), "w", encoding="utf-8") as config:
        config.write(CONFIG % (os.environ.get("BURIN_TEST_START", "BurinWorkbench"),
                               os.environ.get("BURIN_TEST_LANGUAGE", "English"), os.environ.get("BURIN_TEST_STYLESHEET", ""),
                               int(os.environ.get("BURIN_TEST_CUBE", "0"))))
    addon = ADDON
    if os.environ.get("BURIN_TEST_COPY"):  # apart from any kernel: that of the build folder is found, and that of an archive
        addon = os.path.join(home, "addon")
        shutil.copytree(ADDON, addon, ignore=shutil.ignore_patterns("native"))
    server, display = screen()
    environment = dict(os.environ, DISPLAY=display, FREECAD_USER_HOME=home, QTWEBENGINE_DISABLE_SANDBOX="1",
                       BURIN_TEST_OUT=str(out), BURIN_TEST_VERDICT=str(verdict), PYTHONDONTWRITEBYTECODE="1",
                       LC_ALL="C.UTF-8",
                       # The processor paints the 3-D view, in the thread that waits for it: other tests have the other processors.
                       # Its buffers of some MB are kept, for the system would clear their pages for each frame.
                       LP_NUM_THREADS=os.environ.get("LP_NUM_THREADS", "0"), MALLOC_MMAP_THRESHOLD_=str(256 << 20), MALLOC_TRIM_THRESHOLD_=str(512 << 20),
                       QT_X11_NO_MITSHM="1")  # Qt 5.15 may wait for ever for Xvfb's word on shared memory
    environment.pop("PYTHONPATH", None)
    if kernel != "none":
        environment["BURIN_PYTHON_PATH"] = kernel
    else:
        environment.pop("BURIN_PYTHON_PATH", None)
    try:
        status = subprocess.run([freecad, os.path.abspath(script), "-M", str(addon)],
                                env=environment, stdin=subprocess.DEVNULL,
                                timeout=float(os.environ.get("BURIN_TEST_TIMEOUT", "120"))).returncode
    except subprocess.TimeoutExpired:
        print("FreeCAD did not end in time")
        status = 1
    finally:
        server.terminate()
        server.wait()
        shutil.rmtree(home, ignore_errors=True)
    if status == 0 and not verdict.exists():
        print("FreeCAD ended before the tests did")
        status = 1
    return status if status >= 0 else 1


if __name__ == "__main__":
    sys.exit(main())
