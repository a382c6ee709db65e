"""Lines of ink as curves of FreeCAD: line segments, arcs, circles, B-splines."""

import math

import FreeCAD
import Part

# A path turns by more than this in one point only at a corner: its points are close where it bends.
CORNER = math.radians(30)


def edges_of(points, closed, tolerance):
    """Edges through `points`, (x, y) pairs, nowhere farther than `tolerance` from them."""
    vectors = [FreeCAD.Vector(x, y, 0) for x, y in points]
    if closed:
        vectors.append(vectors[0])
    vectors = [v for k, v in enumerate(vectors) if k == 0 or (v - vectors[k - 1]).Length > 1e-3 * tolerance]
    if len(vectors) < 2:
        return []
    whole = _circle(vectors, tolerance) if closed else None
    if whole is not None:
        return [whole]
    return [edge for run in _between_corners(vectors) for edge in _run(run, tolerance)]


def _between_corners(vectors):
    runs, first = [], 0
    for k in range(1, len(vectors) - 1):
        before, after = vectors[k] - vectors[k - 1], vectors[k + 1] - vectors[k]
        if before.getAngle(after) > CORNER:
            runs.append(vectors[first : k + 1])
            first = k
    runs.append(vectors[first:])
    return runs


def _run(vectors, tolerance):
    a, b = vectors[0], vectors[-1]
    chord = (b - a).Length
    if chord > tolerance and all(v.distanceToLineSegment(a, b).Length <= tolerance for v in vectors[1:-1]):
        return [Part.makeLine(a, b)]
    arc = _circle(vectors, tolerance)
    if arc is not None:
        return [arc]
    try:
        curve = Part.BSplineCurve()
        if len(vectors) > 4:
            curve.approximate(Points=vectors, DegMin=3, DegMax=3, Tolerance=tolerance)
        else:
            curve.interpolate(Points=vectors)
        return [curve.toShape()]
    except Part.OCCError:  # too few points, or too close together
        return [Part.makeLine(p, q) for p, q in zip(vectors, vectors[1:])]


def _circle(vectors, tolerance):
    """The arc or circle that all points are on; None where there is none, or too few points to tell."""
    if len(vectors) < 5:
        return None
    a, b, c = vectors[0], vectors[len(vectors) // 3], vectors[2 * len(vectors) // 3]
    area = (b - a).cross(c - a)
    if area.Length < tolerance * tolerance:
        return None
    center = _center(a, b, c)
    radius = (a - center).Length
    if any(abs((v - center).Length - radius) > tolerance for v in vectors):
        return None
    turn = sum((p - center).getAngle(q - center) for p, q in zip(vectors, vectors[1:]))
    if turn > 2.01 * math.pi:
        return None
    if (vectors[-1] - a).Length <= tolerance:
        return Part.makeCircle(radius, center) if turn > 1.9 * math.pi else None
    return Part.Arc(a, vectors[len(vectors) // 2], vectors[-1]).toShape()


def _center(a, b, c):
    ux, uy, vx, vy = b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y
    d = 2 * (ux * vy - uy * vx)
    u, v = ux * ux + uy * uy, vx * vx + vy * vy
    return FreeCAD.Vector(a.x + (vy * u - uy * v) / d, a.y + (ux * v - vx * u) / d, 0)
