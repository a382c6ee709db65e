#!/usr/bin/python3
"""What drawings of many files on sheets of many sizes draw wrong or twice: a row a drawing, then a table of sums.

usage: true_at_sizes.py BURIN ROWS.tsv FILE|FOLDER... [--papers A3,A6,105x74] [--views "iso front top 1,-1,-1 -2,1,0.5"]
                        [--hidden none] [--limit 60] [--most 300000] [--twice] [--set KEY=VALUE ...]

Each file is drawn in `outline` with --verify, one drawing at a time. Wrong: mm of line that rays contradict, places and loose ends of
the outline, as `--verify` counts them. Twice (with --twice, wants numpy and scipy): mm of feature line within 0.03 mm of another one, or
of a place 0.3 mm and more before on the same one, that runs the same way within 0.1 radian, in samples of 0.1 mm.
--limit ends a drawing after so many seconds by the clock. A file of more triangles than --most is drawn once and then left out, as
are files that do not draw. Rows that ROWS.tsv holds
already are not drawn again, so that a run can be stopped and go on; without FILEs the table of the rows is printed alone.
"""
import argparse
import collections
import json
import pathlib
import resource
import subprocess
import tempfile

SUFFIXES = ".stl .obj .off .ply .3mf .step .stp .iges .igs .brep .bez .bbp .itd .irt .scad .csg .implicit .fcstd .glb".split()
HEAD = "file paper view hidden status triangles mm wrong places loose drawn twice cpu".split()
KEY = HEAD[:4]
LEAST = 0.5  # mm contradicted that count


def files(paths):
    for path in map(pathlib.Path, paths):
        if path.is_dir():
            yield from sorted(p for p in path.rglob("*") if p.suffix.lower() in SUFFIXES and "broken" not in p.parts)
        else:
            yield path


def run(command, limit):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        status = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=limit).returncode
    except subprocess.TimeoutExpired:
        status = "time"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return status, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def samples_of(drawing):
    """Middles (x, y), directions, lengths, path and way along it of pieces of 0.1 mm at the most."""
    import numpy as np

    out = []
    for layer in drawing["layers"]:
        for number, path in enumerate(layer["paths"]):
            if layer["name"] == "pattern" or path["kind"] in ("stroke", "pattern", "leader", "frame"):
                continue
            points = np.array(path["points"], float)[:, :2]
            if path.get("closed"):
                points = np.vstack([points, points[:1]])
            steps = np.diff(points, axis=0)
            lengths = np.hypot(steps[:, 0], steps[:, 1])
            counts = np.maximum(1, np.ceil(lengths / 0.1)).astype(int)
            counts[lengths <= 0] = 0
            segment = np.repeat(np.arange(len(steps)), counts)
            share = (np.arange(len(segment)) - np.repeat(np.cumsum(counts) - counts, counts) + 0.5) / counts[segment]
            way = np.concatenate([[0], np.cumsum(lengths)])[segment] + share * lengths[segment]
            middles = points[segment] + share[:, None] * steps[segment]
            owner = np.full(len(segment), len(out))
            out.append(np.column_stack([middles, steps[segment] / lengths[segment, None], lengths[segment] / counts[segment],
                                        owner, way, np.full(len(segment), lengths.sum() if path.get("closed") else np.inf)]))
    return np.vstack(out) if out else np.zeros((0, 8))


def drawn_twice(drawing, near=0.03):
    """mm drawn, and mm of it that lie on another line."""
    import numpy as np
    from scipy.spatial import cKDTree

    s = samples_of(drawing)
    if not len(s):
        return 0.0, 0.0
    tree = cKDTree(s[:, :2])
    twice = np.zeros(len(s), bool)
    for first in range(0, len(s), 20000):
        part = s[first:first + 20000]
        near_by = tree.query_ball_point(part[:, :2], near + 0.06)
        j = np.repeat(np.arange(len(part)), [len(n) for n in near_by])
        i = np.concatenate([np.asarray(n, int) for n in near_by])
        apart = s[i, :2] - part[j, :2]
        aside = np.abs(apart[:, 0] * part[j, 3] - apart[:, 1] * part[j, 2])
        same_way = np.abs((s[i, 2:4] * part[j, 2:4]).sum(axis=1)) > np.cos(0.1)
        along = np.abs(s[i, 6] - part[j, 6])
        along = np.minimum(along, s[i, 7] - along)
        other = (s[i, 5] != part[j, 5]) | (along > 0.3)
        # Of two samples the later one is drawn twice.
        hit = (i < j + first) & other & same_way & (aside <= near)
        twice[first + j[hit]] = True
    return float(s[:, 4].sum()), float(s[twice, 4].sum())


def draw(burin, path, key, words, scratch):
    out = scratch / "out.json"
    out.unlink(missing_ok=True)
    command = [burin, "draw", str(path), "-o", str(out), "--style", "outline", "--paper", key["paper"], f"--view={key['view']}",
               "--hidden", key["hidden"], "--verify", "--no-progress", "--set", "json.points3=false"]
    command += [w for pair in words.set for w in ("--set", pair)]
    status, cpu = run(command, words.limit)
    row = dict.fromkeys(HEAD, 0) | key | {"status": status, "cpu": f"{cpu:.2f}"}
    if status == 0:
        drawing = json.loads(out.read_text())
        told = drawing["stats"]["verify"]
        row |= {"triangles": drawing["stats"]["triangles"], "mm": f"{told['length']:.1f}", "wrong": f"{told['contradicted']:.2f}",
                "places": told["count"], "loose": told["loose_ends"]}
        if words.twice:
            drawn, twice = drawn_twice(drawing)
            row |= {"drawn": f"{drawn:.1f}", "twice": f"{twice:.2f}"}
    return row


def kept(path):
    if not path.exists():
        return []
    lines = path.read_text().splitlines()
    return [dict(zip(HEAD, line.split("\t"))) for line in lines[1:]]


def report(rows):
    good = [r for r in rows if r["status"] == "0"]
    print("| sheet | hidden | drawings | m tested | wrong over 0.5 mm | mm wrong | loose ends | drawn twice, mm | most, % |")
    print("|---|---|---|---|---|---|---|---|---|")
    groups = collections.defaultdict(list)
    for r in good:
        groups[r["paper"], r["hidden"]].append(r)
    for (paper, hidden), group in sorted(groups.items()):
        share = max(100 * float(r["twice"]) / max(float(r["drawn"]), 1e-9) for r in group)
        print(f"| {paper} | {hidden} | {len(group)} | {sum(float(r['mm']) for r in group) / 1000:.0f} "
              f"| {sum(float(r['wrong']) > LEAST for r in group)} | {sum(float(r['wrong']) for r in group):.1f} "
              f"| {sum(int(r['loose']) for r in group)} | {sum(float(r['twice']) for r in group):.0f} | {share:.2f} |")
    print()
    for r in good:
        share = 100 * float(r["twice"]) / max(float(r["drawn"]), 1e-9)
        if float(r["wrong"]) > LEAST or int(r["loose"]) or share > 0.5:
            print(f"{r['file']} on {r['paper']} from {r['view']}, hidden {r['hidden']}: {r['wrong']} of {r['mm']} mm wrong in "
                  f"{r['places']} places, {r['loose']} loose ends, {share:.2f} % drawn twice")
    for r in rows:
        if r["status"] != "0":
            print(f"{r['file']} on {r['paper']} from {r['view']}: ended with {r['status']}")


def measure(words, table):
    have = {tuple(r[k] for k in KEY) for r in kept(table)}
    if not table.exists():
        table.write_text("\t".join(HEAD) + "\n")
    with tempfile.TemporaryDirectory() as folder, table.open("a") as out:
        for path in files(words.paths):
            skip = False
            for view in words.views:
                for paper in words.papers:
                    for hidden in words.hidden:
                        key = {"file": str(path), "paper": paper, "view": view, "hidden": hidden}
                        if skip or tuple(key.values()) in have:
                            continue
                        row = draw(words.burin, path, key, words, pathlib.Path(folder))
                        out.write("\t".join(str(row[k]) for k in HEAD) + "\n")
                        out.flush()
                        skip = row["status"] != 0 or row["triangles"] > words.most


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("burin")
    parser.add_argument("rows", type=pathlib.Path)
    parser.add_argument("paths", nargs="*")
    parser.add_argument("--papers", default="A3,A6,105x74", type=lambda text: text.replace(",", " ").split())
    parser.add_argument("--views", default="iso front top 1,-1,-1 -2,1,0.5", type=str.split)
    parser.add_argument("--hidden", default="none", type=lambda text: text.split(","))
    parser.add_argument("--set", default=[], action="append")
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--most", type=int, default=300000)
    parser.add_argument("--twice", action="store_true")
    words = parser.parse_args()
    measure(words, words.rows)
    report(kept(words.rows))


main()
