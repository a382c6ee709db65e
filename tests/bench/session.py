#!/usr/bin/env python3
"""What drawings of one session take: a row a file, seconds, the fewest of some runs.

usage: session.py FOLDER_OF_THE_MODULE FILE... [-- KEY=VALUE...]

`first` draws with nothing kept; the others change one thing and draw again: the light, the widths of lines, the widths of
strokes, the style of the first part, the view. After each the drawing is compared with one of nothing kept. Options after --
are those of burin.draw, such as style=engraving paper=A4.
"""
import sys
import time

RUNS = 3


def main():
    words = sys.argv[1:]
    options = {}
    if "--" in words:
        at = words.index("--")
        options = dict(word.split("=", 1) for word in words[at + 1 :])
        words = words[:at]
    if len(words) < 2:
        sys.exit(__doc__)
    sys.path.insert(0, words[0])
    import burin

    base = {"style": "engraving", **options}
    changes = {
        "light": lambda k: {"light": (0.3 + 0.1 * k, 0.5, 0.8)},
        "lines": lambda k: {"set": {"line.outer": 0.6 + 0.1 * k}},
        "pens": lambda k: {"set": {"hatch.width_max": 0.5 + 0.02 * k}},
        "part": lambda k: {},
        "view": lambda k: {"view": (1, -1, 0.8 + 0.05 * k)},
    }
    print("| file | triangles | first | " + " | ".join(changes) + " |")
    print("|---|---|---|" + "---|" * len(changes))
    for path in words[1:]:
        scene = burin.Scene.read(path)
        first, again = [], {name: [] for name in changes}
        for k in range(RUNS):
            session = burin.Session()
            start = time.perf_counter()
            drawing = burin.draw(scene, session=session, **base)
            first.append(time.perf_counter() - start)
            for name, change in changes.items():
                if name == "part":
                    scene.parts[0].style = "technical"
                start = time.perf_counter()
                got = burin.draw(scene, session=session, **{**base, **change(k)})
                again[name].append(time.perf_counter() - start)
                if got.to_bytes("json") != burin.draw(scene, **{**base, **change(k)}).to_bytes("json"):
                    sys.exit(f"{path}: {name}: the session draws something else")
                scene.parts[0].style = None
                burin.draw(scene, session=session, **base)
        triangles = sum(part["triangles"] for part in drawing.parts)
        print(f"| {path.rsplit('/', 1)[-1]} | {triangles} | {min(first):.2f} | "
              + " | ".join(f"{min(times):.3f}" for times in again.values()) + " |", flush=True)


if __name__ == "__main__":
    main()
