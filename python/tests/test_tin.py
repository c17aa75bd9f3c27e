"""A Tin's answers, by brute force and against other packages."""

import copy
import pickle
import sys

import numpy as np
import pytest

import brute
import hodt


@pytest.fixture
def tin(rng):
    return hodt.triangulate(np.column_stack([rng.random((200, 2)), rng.integers(0, 9, 200)]), 3).tin


def test_a_tin_is_what_it_is_given():
    points, triangles = [[0, 0, 1], [1, 0, 2], [0, 1, 3]], [[0, 1, 2]]
    tin = hodt.Tin(points, triangles, "EPSG:25832")
    assert (tin.points == points).all() and tin.triangles.dtype == np.int32
    assert tin.has_heights and tin.crs == "EPSG:25832"
    assert tin == hodt.Tin(points, triangles, "EPSG:25832") != hodt.Tin(points, [[2, 0, 1]])
    assert "3 points with heights, 1 triangles" in repr(tin)
    flat = hodt.Tin(np.array(points)[:, :2], triangles)
    assert flat.z is None and flat.points is flat.xy
    for f in (flat.interpolate, flat.slope, flat.aspect, flat.minima, flat.pits):
        with pytest.raises(hodt.ParameterError, match="needs heights"):
            f(*([[0, 0]] if f == flat.interpolate else []))


def test_a_tin_keeps_copies():
    points, triangles = np.eye(3), np.array([[0, 1, 2]])
    tin = hodt.Tin(points, triangles)
    points[0], triangles[0] = 9, 0
    assert tin.points[0].tolist() == [1, 0, 0] and tin.triangles[0].tolist() == [0, 1, 2]


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda t: pickle.loads(pickle.dumps(t))],
                         ids=["copy", "deepcopy", "pickle"])
def test_copies_are_frozen_and_know_nothing_yet(again, tin):
    crs, flat = hodt.Tin(tin.points, tin.triangles, "EPSG:25832"), hodt.Tin(tin.xy, tin.triangles)
    for one in (tin, crs, flat, hodt.Tin(np.empty((0, 2)), [])):
        one.points, one.find_triangle([0, 0])
        assert one is not tin or len(one.gradient)
        other = again(one)
        assert other == one and "gradient" not in vars(other) and not other._is_mesh
        for array in (other.xy, other.triangles, other.points, *([] if other.z is None else [other.z])):
            assert not array.flags.writeable
    overlapping = again(hodt.Tin([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [0, 1, 3]]))
    with pytest.raises(hodt.InputError, match="overlap"):
        overlapping.find_triangle([0, 0])


@pytest.mark.parametrize("points, triangles, error, says", [
    ([[0, 0], [1, 0], [0, 1]], [[0, 1, 3]], hodt.ParameterError, "triangles.*3 rows"),
    ([[0, 0], [1, 0], [0, 1]], [[0, 1, -1]], hodt.ParameterError, "triangles"),
    ([[0, 0], [1, 0], [0, 1]], [[0, 1]], hodt.ParameterError, "shape"),
    ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2.0]], hodt.ParameterError, "integers"),
    ([[0, 0], [1, 0], [0, np.inf]], [[0, 1, 2]], hodt.InputError, "row 2"),
    ([0, 1], [[0, 1, 2]], hodt.ParameterError, "shape"),
])
def test_what_is_no_tin(points, triangles, error, says):
    with pytest.raises(error, match=says):
        hodt.Tin(points, triangles)


def test_interpolation_is_linear_on_each_triangle(tin, rng):
    at = rng.random((300, 5, 2)) * 1.2 - 0.1
    heights, where = tin.interpolate(at), tin.find_triangle(at)
    assert heights.shape == (300, 5) and where.dtype == np.int32
    assert (np.isnan(heights) == (where < 0)).all() and (where >= 0).any()
    corners = tin.points[tin.triangles]
    for place, height, t in zip(at.reshape(-1, 2), heights.ravel(), where.ravel()):
        if t < 0:
            continue
        b = np.linalg.solve(np.vstack([corners[t, :, :2].T, np.ones(3)]), [*place, 1])
        assert (b > -1e-9).all() and b @ corners[t, :, 2] == pytest.approx(height)
    assert np.array_equal(tin.interpolate(tin.xy), tin.z)
    assert tin.interpolate([0.5, 0.5]).shape == () and tin.interpolate(np.empty((0, 2))).shape == (0,)
    for places in ([[0, 0, 0]], [np.nan, 0]):
        with pytest.raises(hodt.Error):
            tin.interpolate(places)


def test_triangles_that_overlap_have_no_surface():
    overlapping = hodt.Tin([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.9, 0.9, 1]], [[0, 1, 2], [0, 1, 3]])
    for f in (lambda: overlapping.interpolate([0, 0]), overlapping.pits, overlapping.order,
              lambda: overlapping.find_triangle([0, 0])):
        with pytest.raises(hodt.InputError, match="overlap"):
            f()
    assert overlapping.check()["embedded"] is False and overlapping.check()["problem"]


def test_slope_and_aspect_of_planes():
    square, triangles = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]), [[0, 1, 2], [2, 0, 3]]
    for gradient, slope, aspect in (((1, 0), 45, 270), ((-1, 0), 45, 90), ((0, 1), 45, 180),
                                    ((0, -3**0.5), 60, 0), ((0, 0), 0, np.nan), ((-1, -1), 54.7356, 45)):
        tin = hodt.Tin(np.column_stack([square, square @ gradient]), triangles)
        np.testing.assert_allclose(tin.slope(), [slope] * 2, atol=1e-4)
        np.testing.assert_allclose(tin.aspect(), [aspect] * 2, atol=1e-9)
        np.testing.assert_allclose(tin.gradient, [gradient] * 2, atol=1e-12)


def test_extrema_by_the_definition(rng):
    for n in (3, 10, 40):
        points = np.column_stack([rng.integers(0, 9, (n, 2)), rng.integers(0, 4, n)]).astype(float)
        points = np.vstack([points, [[20, 0, 1], [0, 20, 1]]])
        tin = hodt.triangulate(points, 2).tin
        minima = brute.minima(tin.points, tin.triangles)
        assert tin.minima().tolist() == minima and tin.minima().dtype == np.int32
        upside_down = tin.points * [-1, -1, -1]
        assert tin.maxima().tolist() == brute.minima(upside_down, tin.triangles)
        assert len(tin.minima()) == sum(tin.check()["local_minima"].values())


def test_pits_by_flooding(rng):
    for _ in range(5):
        points = np.column_stack([rng.random((40, 2)), rng.permutation(40)])
        tin = hodt.triangulate(points, objective="none").tin
        z, neighbours = tin.z, [set() for _ in tin.z]
        for t in tin.triangles.tolist():
            for v in t:
                neighbours[v] |= set(t) - {v}
        border = set(tin.boundary().ravel().tolist())
        vertices, depths = tin.pits()
        assert vertices.tolist() == tin.minima().tolist()
        for v, depth in zip(vertices.tolist(), depths):
            # The lowest level at which water from v gets to the border, or to something lower.
            for level in range(41):
                reached, todo = {v}, [v]
                while todo:
                    new = {w for w in neighbours[todo.pop()] if z[w] <= level} - reached
                    reached |= new
                    todo += new
                if reached & border or min(z[w] for w in reached) < z[v]:
                    break
            assert depth == (0 if v in border else max(level, z[v]) - z[v])


def test_vertices_without_a_triangle_are_neither_pits_nor_extrema():
    points = [[5, 5, 0], [0, 0, 1], [1, 0, 2], [0, 1, 3.0]]
    lonely, empty = hodt.Tin(points, [[1, 2, 3]]), hodt.Tin(points, np.empty((0, 3), int))
    assert [a.tolist() for a in lonely.pits()] == [[1], [0]]
    assert lonely.minima().tolist() == [1] and lonely.maxima().tolist() == [3]
    for tin in (empty, hodt.Tin(np.empty((0, 3)), [])):
        assert [len(a) for a in tin.pits()] == [0, 0]
        assert len(tin.minima()) == len(tin.maxima()) == len(tin.boundary()) == 0
        assert len(tin.area()) == len(tin.slope()) == len(tin.aspect()) == 0
        assert np.isnan(tin.interpolate([0, 0])) and tin.find_triangle([[0, 0]]).tolist() == [-1]
    assert empty.contours([1]) == empty.contours(interval=1) == [] and empty.check()["triangles"] == 0


def test_contours_are_at_their_level_with_higher_ground_on_the_left(tin):
    lines = tin.contours(interval=2, base=0.5)
    assert {level for level, _ in lines} == {0.5, 2.5, 4.5, 6.5} and lines == sorted(
        lines, key=lambda line: line[0])
    again = tin.contours([0.5, 2.5, 4.5, 6.5])
    assert all(np.array_equal(a, b) for (_, a), (_, b) in zip(lines, again))
    for level, xy in lines:
        np.testing.assert_allclose(tin.interpolate(xy[1:-1]), level, atol=1e-9)
        along = np.diff(xy, axis=0)
        aside = 1e-6 * np.stack([-along[:, 1], along[:, 0]], axis=1) / np.hypot(*along.T)[:, None]
        long = np.hypot(*along.T) > 1e-3
        left = tin.interpolate((xy[1:] - along / 2 + aside)[long])
        assert (left[~np.isnan(left)] > level).all()
    for arguments in (dict(), dict(levels=[1], interval=1), dict(levels=[2, 1]), dict(interval=0),
                      dict(levels="high"), dict(interval=3, base=1e17), dict(interval=3, base=np.nan)):
        with pytest.raises(hodt.ParameterError):
            tin.contours(**arguments)


def test_boundary_and_check(tin):
    edges = tin.boundary()
    assert (np.sort(edges[:, 0]) == np.sort(edges[:, 1])).all()
    found = tin.check()
    assert found["embedded"] and found["covers_hull"] and found["boundary_edges"] == len(edges)
    assert found["order"] == tin.order() and sum(found["order_histogram"]) == len(tin.triangles)
    assert 0 < found["quality"]["smallest_angle"]["min"] < 60
    assert hodt.check(tin) == found
    for f in (hodt.check, hodt.order, lambda t: hodt.write_tin(t, "x.ply")):
        with pytest.raises(hodt.ParameterError, match="Tin"):
            f(np.eye(3))


def test_matplotlib(tin):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    ax = tin.plot()
    assert ax.collections and tin.plot(ax, edges=False) is ax
    hodt.Tin(tin.xy, tin.triangles).plot(color="k")


def test_meshio(tin, tmp_path):
    meshio = pytest.importorskip("meshio")
    tin.to_meshio().write(tmp_path / "t.vtk")
    back = meshio.read(tmp_path / "t.vtk")
    assert np.array_equal(back.points, tin.points)
    assert np.array_equal(back.cells_dict["triangle"], tin.triangles)


def test_pyvista(tin):
    pytest.importorskip("pyvista")
    mesh = tin.to_pyvista()
    assert mesh.n_cells == len(tin.triangles) and np.array_equal(mesh["height"], tin.z)


def test_geopandas(tin):
    pytest.importorskip("geopandas")
    frame = hodt.Tin(tin.points, tin.triangles, "EPSG:25832").to_geodataframe()
    np.testing.assert_allclose(frame.area, tin.area())
    assert frame.crs.to_epsg() == 25832 and frame.geometry.iloc[0].has_z


def test_xarray(tin):
    pytest.importorskip("xarray")
    grid = tin.to_xarray(0.05)
    assert grid.dims == ("y", "x") and grid.y[0] > grid.y[-1]
    x, y = float(grid.x[7]), float(grid.y[3])
    assert float(grid.sel(x=x, y=y)) == pytest.approx(float(tin.interpolate([x, y])))
    for resolution in (0, -1, np.nan):
        with pytest.raises(hodt.ParameterError):
            tin.to_xarray(resolution)


@pytest.mark.parametrize("method, package", [("plot", "matplotlib"), ("to_meshio", "meshio"),
                                             ("to_pyvista", "pyvista"),
                                             ("to_geodataframe", "geopandas"), ("to_xarray", "xarray")])
def test_packages_that_are_not_there_are_named(tin, method, package, monkeypatch):
    for name in [n for n in sys.modules if n.split(".")[0] == package] + [package, f"{package}.pyplot"]:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(ImportError, match=f"pip install {package}"):
        getattr(tin, method)(*([1] if method == "to_xarray" else []))
