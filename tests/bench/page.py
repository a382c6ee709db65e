"""How fluent a page of many parts is: makes an illustration of N boxes in a stack of layers, each an item of its own, draws it as
HTML with callouts and without, opens it in headless Chromium and times what pointing at a row costs, layout and style
included, and a search.

    tests/bench/page.py [BURIN] [N]
"""

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BURIN = sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/burin"
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 500

PROBE = """<script>
const rows = [...document.querySelectorAll("tbody tr")], settle = () => document.body.getBoundingClientRect().width +
  getComputedStyle(rows[0]).backgroundColor.length;
const over = e => e.dispatchEvent(new PointerEvent("pointerover", {bubbles: true}));
settle();
const each = [];
for (const row of rows) {
  const begin = performance.now();
  over(row.cells[2]);
  settle();
  each.push(performance.now() - begin);
}
const search = document.querySelector("input");
const begin = performance.now();
search.value = "box17";
search.dispatchEvent(new Event("input"));
settle();
const searched = performance.now() - begin;
each.sort((a, b) => a - b);
document.body.innerHTML = "<pre>" + [rows.length, each[each.length >> 1], each[each.length - 1], searched].join(" ") + "</pre>";
</script></body>"""


def boxes(folder):
    side = int(COUNT ** 0.5) + 1
    corners = [(x, y, z) for x in (0, 8) for y in (0, 8) for z in (0, 8)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    text = ["OFF", f"{len(corners)} {len(faces)} 0", *(" ".join(map(str, c)) for c in corners)]
    text += ["4 " + " ".join(map(str, f)) for f in faces]
    Path(folder, "box.off").write_text("\n".join(text) + "\n")
    parts = [
        {"file": "box.off", "name": f"box{i}a", "place": {"translate": [10 * (i % side), 10 * (i // side), 0]}}
        for i in range(COUNT)
    ]
    Path(folder, "a.burin.json").write_text(
        json.dumps({"burin": "illustration", "parts": parts, "style": "engraving", "paper": {"size": "A2"}})
    )


def opened(folder):
    page = Path(folder, "a.html").read_text().replace("</body>", PROBE)
    Path(folder, "p.html").write_text(page)
    said = subprocess.run(
        ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--dump-dom",
         f"file://{folder}/p.html"], capture_output=True, text=True, timeout=600, check=True).stdout
    return [float(x) for x in re.search("<pre>(.*?)</pre>", said).group(1).split()]


for options in ([], ["--callouts"]):
    with tempfile.TemporaryDirectory() as folder:
        boxes(folder)
        begin = time.monotonic()
        subprocess.run([BURIN, "draw", f"{folder}/a.burin.json", "-o", f"{folder}/a.html", "--quiet", *options], check=True)
        drawn = time.monotonic() - begin
        rows, median, most, searched = opened(folder)
        size = Path(folder, "a.html").stat().st_size / 1e6
        print(f"{rows:.0f} items{' with callouts' if options else ''}: drawn in {drawn:.1f} s, {size:.1f} MB; pointing at one "
              f"{median:.2f} ms in the median, {most:.1f} ms at the most; a search {searched:.1f} ms")
