"""What the definitions say, by brute force in exact arithmetic; shares nothing with the library."""

from fractions import Fraction
from itertools import combinations
from math import lcm


def exact(points):
    """(x, y) of each point, exactly, in multiples of a unit that makes them whole."""
    fractions = [tuple(Fraction(float(x)) for x in p[:2]) for p in points]
    unit = lcm(*(x.denominator for p in fractions for x in p))
    return [tuple(int(x * unit) for x in p) for p in fractions]


def turn(a, b, c):
    """Positive if a, b, c turn left, 0 on a line."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, d):
    """Positive if d is inside the circle through a, b, c (a left turn), 0 if it is on it."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    (ax, ay), (bx, by), (cx, cy) = rows
    a2, b2, c2 = (x * x + y * y for x, y in rows)
    return ax * (by * c2 - b2 * cy) - ay * (bx * c2 - b2 * cx) + a2 * (bx * cy - by * cx)


def left(p, triangle):
    """The triangle's corners, turning left."""
    a, b, c = triangle
    return (a, b, c) if turn(p[a], p[b], p[c]) > 0 else (a, c, b)


def inside(p, triangle):
    """The points strictly inside the circle."""
    a, b, c = left(p, triangle)
    return {d for d in range(len(p)) if d not in (a, b, c)
            and in_circle(p[a], p[b], p[c], p[d]) > 0}


def largest_order(points, triangles):
    p = exact(points)
    return max(len(inside(p, t)) for t in triangles)


def area2(points, triangles):
    """Twice the area of all triangles; of triangles to the left positive."""
    p = exact(points)
    return sum(turn(p[a], p[b], p[c]) for a, b, c in triangles)


def hull_area2(points):
    p = sorted(set(exact(points)))

    def chain(q):
        out = []
        for r in q:
            while len(out) > 1 and turn(out[-2], out[-1], r) <= 0:
                out.pop()
            out.append(r)
        return out[:-1]

    ring = chain(p) + chain(p[::-1])
    return sum(turn(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1))


def is_triangulation(points, triangles):
    """All to the left, no edge twice in a direction, and as large as the hull: so nothing overlaps.
    Every point is a corner, but for duplicates."""
    p = exact(points)
    edges = [(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)]
    places = {p[v] for t in triangles for v in t}
    return (all(turn(p[a], p[b], p[c]) > 0 for a, b, c in triangles)
            and len(set(edges)) == len(edges)
            and area2(points, triangles) == hull_area2(points) and places == set(p))


def kod_triangles(points, k):
    """{(a, b, c): order} of all triangles with at most k points inside; no points on a circle."""
    p = exact(points)
    found = {}
    for t in combinations(range(len(p)), 3):
        if turn(*(p[v] for v in t)) != 0 and (n := len(inside(p, t))) <= k:
            found[t] = n
    return found


def kod_edges(points, k):
    """{(u, v): order}: the fewest points in a circle through both. For points in general position:
    some such circle passes through a third point, counted as inside or as outside."""
    p = exact(points)
    found = {}
    for u, v in combinations(range(len(p)), 2):
        # As the centre moves along the bisector, a point is inside from, or up to, its own circle.
        fewest = len(p)
        others = [w for w in range(len(p)) if w not in (u, v)]
        left_side = {w for w in others if turn(p[u], p[v], p[w]) > 0}
        for side in (left_side, set(others) - left_side):
            fewest = min(fewest, len(side))  # the circle at infinity on the other side
        for w in others:
            fewest = min(fewest, len(inside(p, (u, v, w))))
        if fewest <= k:
            found[u, v] = fewest
    return found


def useful_order(p, u, v):
    """Lemma 4: of the first point to the left of uv, and to the right, the larger count."""
    order = 0
    for sign in (1, -1):
        side = [w for w in range(len(p)) if w not in (u, v) and sign * turn(p[u], p[v], p[w]) > 0]
        for w in side:
            if not any(x in side for x in inside(p, (u, v, w))):
                order = max(order, len(inside(p, (u, v, w))))
    return order


def useful_edges(points, k):
    """{(u, v): useful order}; points in general position."""
    p = exact(points)
    edges = {e: useful_order(p, *e) for e in combinations(range(len(p)), 2)}
    return {e: order for e, order in edges.items() if order <= k}


def minima(points, triangles):
    """The corners without a lower neighbour: lower is (z, x, y) smaller."""
    key = [(p[2], p[0], p[1]) for p in points]
    corners = {int(v) for t in triangles for v in t}
    neighbours = {v: set() for v in corners}
    for t in triangles:
        for v in t:
            neighbours[int(v)] |= {int(w) for w in t if w != v}
    return sorted(v for v in corners if all(key[w] > key[v] for w in neighbours[v]))
