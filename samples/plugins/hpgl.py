"""A writer: HPGL, which pen plotters understand, in fifty lines. `import hpgl` registers it; then burin writes .plt like its own
formats. Burin's own .hpgl knows pens by layer and the shortest way between lines; this one shows how a writer is made:

    python3 hpgl.py part.step part.plt
"""

import sys

import burin

UNITS = 40  # of a plotter, to the mm


def place(point):
    return f"{round(point[0] * UNITS)},{round(point[1] * UNITS)}"


def write(drawing, pen, hidden, speed):
    """The whole file, from a drawing and the values of the options below."""
    lines = ["IN;", f"VS{speed};", f"SP{pen};"]
    for layer in drawing.layers:
        for path in layer.paths:
            if not path.visible and not hidden:
                continue
            points = list(path.points)
            if path.closed:
                points.append(points[0])
            lines.append(f"PU{place(points[0])};PD{','.join(place(p) for p in points[1:])};")
    lines.append("PU0,0;SP0;")
    return "\n".join(lines) + "\n"


def register():
    burin.register_writer(
        "plt",
        write,
        "HPGL, for pen plotters",
        {
            "pen": {"default": 1, "low": 1, "high": 8, "meaning": "the pen that draws"},
            "hidden": {"default": False, "meaning": "draw hidden lines, in full"},
            "speed": {"default": 20, "low": 1, "high": 80, "meaning": "of the pen, in cm/s"},
        },
    )


if __name__ == "__main__":
    register()
    burin.draw(sys.argv[1], style="plotter", paper="A4").save(sys.argv[2])
