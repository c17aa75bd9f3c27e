"""The Delaunay triangulation, against the definition and against scipy."""

import copy
import pickle
import re

import numpy as np
import pytest
from conftest import ROOT

import brute
import hodt

scipy_spatial = pytest.importorskip("scipy.spatial")


def canonical(triangles):
    return {tuple(sorted(map(int, t))) for t in triangles}


def degenerate_sets():
    lattice = np.stack(np.meshgrid(np.arange(4), np.arange(5)), -1).reshape(-1, 2).astype(float)
    angles = np.arange(8) * np.pi / 4
    ring = np.array([[3, 4], [4, 3], [-3, 4], [-4, 3], [3, -4], [4, -3], [-3, -4], [-4, -3], [5, 0],
                     [0, 5], [-5, 0], [0, -5], [0, 0]], float)
    return {
        "lattice": lattice,
        "lattice far away": lattice + 2.0**40,
        "ring": ring,
        "two lines": np.array([[i, j] for i in range(6) for j in (0, 1)], float),
        "line and a point": np.array([[i, i] for i in range(7)] + [[0, 1]], float),
        "duplicates": np.repeat(lattice, 2, axis=0),
        "almost a line": np.array([[0, 0], [1, 0], [2, 5e-324], [3, 0]]),
        "huge and tiny": np.array([[0, 0], [1e300, 1e-300], [-1e300, 1], [1, 1e300], [2, 3]]),
        "star": np.array([[np.cos(a), np.sin(a)] for a in angles] + [[0, 0]]),
        "triangle": np.array([[0, 0], [1, 0], [0, 1]], float),
    }


@pytest.mark.parametrize("name", degenerate_sets())
def test_degenerate_sets_by_the_definition(name):
    points = degenerate_sets()[name]
    triangles = hodt.delaunay(points)
    assert triangles.dtype == np.int32 and triangles.flags.c_contiguous
    assert brute.is_triangulation(points, triangles)
    assert brute.largest_order(points, triangles) == 0
    whole = hodt.Delaunay(points)
    assert np.array_equal(whole.simplices, triangles)
    check_attributes(whole, points)


def check_attributes(d, points):
    """By what scipy's documentation says of the attributes."""
    n, edges = len(points), {}
    for t, corners in enumerate(d.simplices):
        for j in range(3):
            edges[corners[(j + 1) % 3], corners[(j + 2) % 3]] = t
    for t, corners in enumerate(d.simplices):
        for j in range(3):
            across = edges.get((corners[(j + 2) % 3], corners[(j + 1) % 3]), -1)
            assert d.neighbors[t, j] == across
    hull = {tuple(sorted(e)) for e in edges if (e[1], e[0]) not in edges}
    assert {tuple(sorted(e)) for e in d.convex_hull.tolist()} == hull
    neighbours = {v: set() for v in range(n)}
    for u, v in edges:
        neighbours[u].add(v), neighbours[v].add(u)
    indptr, indices = d.vertex_neighbor_vertices
    for v in range(n):
        assert set(indices[indptr[v]:indptr[v + 1]].tolist()) == neighbours[v]
        if neighbours[v]:
            assert v in d.simplices[d.vertex_to_simplex[v]]
        else:
            assert d.vertex_to_simplex[v] == -1
    alone = {v for v in neighbours if not neighbours[v]}
    assert set(d.coplanar[:, 0].tolist()) == alone
    for row, triangle, vertex in d.coplanar:
        assert (d.points[row] == d.points[vertex]).all() and vertex in d.simplices[triangle]
    assert (d.min_bound == d.points.min(0)).all() and (d.max_bound == d.points.max(0)).all()
    assert (d.npoints, d.nsimplex, d.ndim) == (n, len(d.simplices), 2)


@pytest.mark.parametrize("seed", range(40))
def test_as_scipy_on_scattered_points(seed):
    rng = np.random.default_rng(seed)
    points = rng.random((int(rng.integers(3, 400)), 2))
    if seed % 3 == 0:
        points = np.concatenate([points, rng.normal(0.5, 0.01, (200, 2))])
    points *= rng.choice([1e-3, 1, 1e5])
    theirs, ours = scipy_spatial.Delaunay(points), hodt.Delaunay(points)
    assert canonical(ours.simplices) == canonical(theirs.simplices)
    assert canonical(np.sort(ours.convex_hull)) == canonical(np.sort(theirs.convex_hull))
    assert len(ours.coplanar) == len(theirs.coplanar) == 0
    order = {tuple(sorted(map(int, t))): i for i, t in enumerate(theirs.simplices)}
    to_theirs = np.array([order[tuple(sorted(map(int, t)))] for t in ours.simplices] + [-1])
    for t, corners in enumerate(ours.simplices):
        their_corners = theirs.simplices[to_theirs[t]].tolist()
        for j, v in enumerate(corners):
            across = theirs.neighbors[to_theirs[t], their_corners.index(v)]
            assert to_theirs[ours.neighbors[t, j]] == across
    (p, q), (r, s) = ours.vertex_neighbor_vertices, theirs.vertex_neighbor_vertices
    for v in range(len(points)):
        assert set(q[p[v]:p[v + 1]]) == set(s[r[v]:r[v + 1]])
    xi = rng.random((50, 4, 2)) * np.ptp(points, axis=0) * 1.2 + points.min(0)
    found = theirs.find_simplex(xi)
    assert ours.find_simplex(xi).shape == (50, 4)
    assert (to_theirs[ours.find_simplex(xi)] == found).all()
    np.testing.assert_allclose(ours.min_bound, theirs.min_bound)
    check_attributes(ours, points)


def test_the_page_about_python_says_which_attributes_there_are():
    there = {name for name in dir(hodt.Delaunay([[0, 0], [1, 0], [0, 1]])) if not name.startswith("_")}
    theirs = {name for name in dir(scipy_spatial.Delaunay([[0, 0], [1, 0], [0, 1]]))
              if not name.startswith("_")}
    page = (ROOT / "docs" / "python.md").read_text().split("## From scipy")[1].split("\n## ")[0].split("```")[2]
    told, missing = (set(re.findall(r"`(\w+)`", part)) for part in page.split("What is about", 1))
    assert told == there and missing == theirs - there


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda d: pickle.loads(pickle.dumps(d))],
                         ids=["copy", "deepcopy", "pickle"])
def test_copies_are_frozen_and_find_out_the_rest_anew(again):
    d = hodt.Delaunay([[0, 0, 5], [1, 0, 0], [0, 1, 0], [0, 0, 3.0]])
    assert d.coplanar.tolist() == [[0, 0, 3]] and len(d.transform)
    other = again(d)
    assert not {"coplanar", "transform"} & set(vars(other))
    assert other.coplanar.tolist() == [[0, 0, 3]] and other.find_simplex([0.2, 0.2]) == 0
    for mine, copied in ((d.points, other.points), (d.simplices, other.simplices),
                         (d.neighbors, other.neighbors)):
        assert np.array_equal(mine, copied) and not copied.flags.writeable


def test_transform_gives_barycentric_coordinates(rng):
    d = hodt.Delaunay(rng.random((100, 2)))
    x = rng.random((200, 2)) * 0.8 + 0.1
    t = d.find_simplex(x)
    b = np.einsum("ijk,ik->ij", d.transform[t, :2], x - d.transform[t, 2])
    b = np.column_stack([b, 1 - b.sum(axis=1)])
    assert (b > -1e-9).all()
    np.testing.assert_allclose(np.einsum("ij,ijk->ik", b, d.points[d.simplices[t]]), x)


def test_find_simplex_is_exact_at_corners_and_beyond(rng):
    points = rng.integers(0, 8, (60, 2)).astype(float)
    d = hodt.Delaunay(points)
    at = d.find_simplex(d.points)
    for place, t in zip(d.points, at):
        assert place.tolist() in d.points[d.simplices[t]].tolist()
    assert d.find_simplex([[np.nan, 0], [np.inf, 1], [1e9, 0]]).tolist() == [-1, -1, -1]
    assert d.find_simplex([3.5, 3.5]).shape == ()
    assert d.find_simplex(np.empty((0, 2))).shape == (0,)
    with pytest.raises(hodt.ParameterError, match="exact"):
        d.find_simplex([[0, 0]], tol=1e-3)
    with pytest.raises(hodt.ParameterError):
        d.find_simplex([[0, 0, 0]])


def test_the_lowest_of_duplicates_stays():
    points = np.array([[0, 0, 5], [1, 0, 0], [0, 1, 0], [0, 0, 3], [0, 0, 3.0]])
    assert canonical(hodt.delaunay(points)) == {(1, 2, 3)}
    assert hodt.Delaunay(points).coplanar.tolist() == [[0, 0, 3], [4, 0, 3]]
    assert canonical(hodt.delaunay(points[:, :2])) == {(0, 1, 2)}


@pytest.mark.parametrize("points, says", [
    ([], "0 distinct points"),
    ([[0, 0]], "1 distinct point"),
    ([[0, 0], [1, 1], [1, 1]], "2 distinct points"),
    ([[0, 0], [1, 1], [2, 2], [3, 3]], "on one line"),
    ([[0, 0], [1, np.nan], [2, 2]], "point 1 .*not finite"),
    ([[0, 0], [1, 2], [np.inf, 2]], "point 2 .*not finite"),
    ([[0, 0, 1], [1, 2, np.nan], [0, 2, 3]], "point 1 .*not finite"),
])
def test_what_has_no_triangulation_is_refused(points, says):
    for make in (hodt.delaunay, hodt.Delaunay, lambda p: hodt.triangulate(p, objective="none")):
        with pytest.raises(hodt.InputError, match=says):
            make(points)
        with pytest.raises(ValueError):
            make(points)


def test_the_same_on_any_number_of_threads(rng):
    points = rng.random((100_000, 2))
    one = hodt.delaunay(points, threads=1)
    assert all(np.array_equal(one, hodt.delaunay(points, threads=t)) for t in (2, 3, None))
