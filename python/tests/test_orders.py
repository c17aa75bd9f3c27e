"""Edges and triangles of an order, against the definitions in exact arithmetic."""

from itertools import combinations

import numpy as np
import pytest

import brute
import hodt


def general(seed, n=11):
    return np.random.default_rng(seed).random((n, 2))


def as_dict(rows):
    rows = rows.tolist()
    assert rows == sorted(rows)
    return {tuple(row[:-1]): row[-1] for row in rows}


@pytest.mark.parametrize("seed", range(8))
def test_lists_are_what_the_definitions_say(seed):
    points = general(seed)
    p = brute.exact(points)
    all_edges, all_useful = brute.kod_edges(points, 20), brute.useful_edges(points, 20)
    all_triangles = brute.kod_triangles(points, 20)
    for k in (0, 1, 3, 20):
        edges, useful, triangles = ({what: order for what, order in each.items() if order <= k}
                                    for each in (all_edges, all_useful, all_triangles))
        assert as_dict(hodt.kod_triangles(points, k)) == triangles
        assert as_dict(hodt.kod_edges(points, k)) == edges
        assert as_dict(hodt.useful_edges(points, k)) == useful
        fixed = [e for e in useful if not any(crosses(p, e, f) for f in useful)]
        assert as_dict(hodt.fixed_edges(points, k)) == dict.fromkeys(fixed, 0)
        valid = {}
        for t, order in triangles.items():
            sides = [(t[0], t[1]), (t[0], t[2]), (t[1], t[2])]
            if all(e in useful for e in sides) and not holds_a_point(p, t):
                valid[t] = max(order, *(useful[e] for e in sides))
        assert as_dict(hodt.triangles(points, k)) == valid


def crosses(p, e, f):
    if set(e) & set(f):
        return False
    (a, b), (c, d) = ([p[v] for v in ends] for ends in (e, f))
    return (brute.turn(a, b, c) > 0) != (brute.turn(a, b, d) > 0) and (
        brute.turn(c, d, a) > 0) != (brute.turn(c, d, b) > 0)


def holds_a_point(p, t):
    a, b, c = (p[v] for v in brute.left(p, t))
    return any(brute.turn(a, b, q) >= 0 and brute.turn(b, c, q) >= 0 and brute.turn(c, a, q) >= 0
               for v, q in enumerate(p) if v not in t)


def test_rows_of_duplicates_have_no_edge():
    points = np.concatenate([general(1), general(1)[:3]])
    assert as_dict(hodt.useful_edges(points, 2)) == brute.useful_edges(general(1), 2)


def test_edges_that_have_to_be_there_hide_what_is_beyond(rng):
    points = general(3, 12)
    edge = next(e for e, order in brute.useful_edges(points, 3).items() if order == 3)
    constrained = as_dict(hodt.useful_edges(points, 0, constraints=hodt.Constraints(edges=[edge])))
    assert constrained[edge] == 0
    p = brute.exact(points)
    assert not any(crosses(p, edge, other) for other in constrained)


def test_every_class_knows_of_edges_that_have_to_be_there():
    points = general(3, 12)
    edge = next(e for e, order in brute.useful_edges(points, 3).items() if order == 3)
    there = hodt.Constraints(edges=[edge])
    p = brute.exact(points)
    useful = as_dict(hodt.useful_edges(points, 2, constraints=there))
    edges = as_dict(hodt.kod_edges(points, 2, constraints=there))
    assert edges[edge] == 0 and not any(crosses(p, edge, other) for other in edges)
    assert all(edges[e] <= order for e, order in useful.items())
    triangles = as_dict(hodt.triangles(points, 2, constraints=there))
    kod = as_dict(hodt.kod_triangles(points, 2, constraints=there))
    assert all(kod[t] <= order for t, order in triangles.items())
    assert not any(crosses(p, edge, side) for t in kod for side in combinations(t, 2))


@pytest.mark.parametrize("k, says", [(-1, "0 or more"), (1.5, "whole"), ("2", "whole"),
                                     (None, "whole"), (True, "whole"), (float("nan"), "whole")])
def test_orders_are_whole_numbers(k, says):
    functions = {hodt.useful_edges, hodt.triangles, hodt.triangulate}
    if k is None:  # the usual order
        functions.remove(hodt.triangulate)
    for f in functions:
        with pytest.raises(hodt.ParameterError, match=says):
            f(general(0), k)


def test_order_of_a_mesh_by_the_definition():
    for seed in range(10):
        points = np.random.default_rng(seed).integers(0, 6, (14, 2)).astype(float)
        tin = hodt.triangulate(np.column_stack([points, np.arange(14) % 5]), 3).tin
        assert tin.order(plain=True) == brute.largest_order(tin.points, tin.triangles)
        assert hodt.order(tin) >= tin.order(plain=True)
        turned = hodt.Tin(tin.points, tin.triangles[:, ::-1])
        assert turned.order() == tin.order()


def test_voronoi_cells_are_where_their_points_are_nearest(rng):
    points = rng.random((12, 2))
    for m in (1, 2, 5):
        cells = hodt.voronoi(points, m)
        assert cells.members.shape == (len(cells), m)
        by_members = {tuple(members.tolist()): polygon for members, polygon in cells}
        assert len(by_members) == len(cells)
        for place in rng.random((200, 2)):
            nearest = np.sort(np.argsort(((points - place) ** 2).sum(1))[:m])
            polygon = by_members[tuple(nearest.tolist())]
            ahead = np.roll(polygon, -1, axis=0) - polygon
            to = place - polygon
            assert (ahead[:, 0] * to[:, 1] - ahead[:, 1] * to[:, 0] > -1e-9).all()
    area = sum(shoelace(polygon) for _, polygon in hodt.voronoi(points, 3, box=(-1, -2, 3, 4)))
    assert area == pytest.approx(24)
    for m in (0, 12, -1, 1.5):
        with pytest.raises(hodt.ParameterError):
            hodt.voronoi(points, m)
    with pytest.raises(hodt.ParameterError, match="box"):
        hodt.voronoi(points, 1, box=(0, 0, 0, 1))


def shoelace(polygon):
    x, y = polygon.T
    return (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
