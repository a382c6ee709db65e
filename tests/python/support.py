"""What the tests of the Python module share."""

import os
from pathlib import Path

import numpy as np

SOURCE = Path(os.environ["BURIN_SOURCE_DIR"])
SAMPLES = SOURCE / "samples"
COMMAND = os.environ["BURIN_COMMAND"]
PLATE = (SOURCE / "tests/python/plate.brep").read_text()  # 30 x 20 x 10, a bore of radius 5


def cube(size=10.0):
    """Vertices (8, 3) and triangles (12, 3) of a cube with a corner in the origin."""
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float) * size
    triangles = np.array(
        [
            [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
            [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
        ]
    )  # fmt: skip
    return vertices, triangles


def sphere(rings=60):
    """A sphere of radius 10 as a mesh, smooth enough to be hatched."""
    theta = np.linspace(0, np.pi, rings + 1)[1:-1]
    phi = np.arange(2 * rings) * np.pi / rings
    t, p = np.meshgrid(theta, phi, indexing="ij")
    body = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], -1).reshape(-1, 3)
    vertices = 10 * np.vstack([body, [[0, 0, 1], [0, 0, -1]]])
    n, rows = 2 * rings, rings - 1
    triangles = []
    for j in range(n):
        k = (j + 1) % n
        triangles.append([rows * n, j, k])
        triangles.append([rows * n + 1, (rows - 1) * n + k, (rows - 1) * n + j])
        for i in range(rows - 1):
            a, b, c, d = i * n + j, i * n + k, (i + 1) * n + j, (i + 1) * n + k
            triangles += [[a, c, d], [a, d, b]]
    return vertices, np.array(triangles)


