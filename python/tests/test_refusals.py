"""Arguments that cannot be: an error of hodt's own that names them, and none of another kind."""

import os

import numpy as np
import pytest

import hodt

POINTS = hodt.sample("jacksboro", 60)
TIN = hodt.Tin(POINTS, hodt.delaunay(POINTS))
EMPTY = hodt.Tin(POINTS, [])
OWN = hodt.Measure(lambda a, b, c: np.ones(len(a)))
TWO = np.array([1, 2])
NO_TEXTS = ["\0", "\udcff", "\ud800"]


class Frame:
    """Columns in another order, as pandas has them."""

    columns = ["y", "x"]

    def __array__(self, dtype=None, copy=None):
        return np.array([[200.0, 300.0]])


@pytest.mark.parametrize("call, says", [
    (lambda: hodt.triangulate(POINTS, 2, method=None), "method"),
    (lambda: hodt.triangulate(POINTS, TWO), "k is to be"),
    (lambda: hodt.useful_edges(POINTS, TWO), "k is to be"),
    (lambda: hodt.voronoi(POINTS, TWO), "m is to be"),
    (lambda: hodt.triangulate(POINTS, 2, threads=TWO), "threads"),
    (lambda: hodt.triangulate(POINTS, 2, time_limit=TWO), "time_limit"),
    (lambda: hodt.compare(POINTS, 2, OWN), "objectives"),
    (lambda: hodt.compare(POINTS, 2, [OWN]), "objectives"),
    (lambda: hodt.compare(POINTS, 2, None), "objectives"),
    (lambda: hodt.compare(POINTS, 2, 3), "objectives"),
    (lambda: hodt.compare(POINTS, None), "orders"),
    (lambda: hodt.compare(POINTS, TWO[:, None]), "orders"),
    *[(lambda box=box: hodt.voronoi(POINTS, box=box), "box")
      for box in (3, (1, 2, 3), [[0, 1], [2, 3]], "abcd", (0, 0, 0, 1), (0, 0, np.nan, 1))],
    *[(lambda columns=columns: hodt.read_points("none.csv", columns), "columns")
      for columns in (3, "abc", {"x": None}, {"x": "\udcff"}, {3: 1})],
    (lambda: hodt.Constraints(None), "breaklines"),
    (lambda: hodt.Constraints(outline=3), "outline"),
    (lambda: hodt.Constraints([3]), r"breaklines\[0\]"),
    (lambda: hodt.Constraints(edges=None), "edges"),
    (lambda: hodt.Constraints(edges=[[1], [1, 2]]), "edges"),
    (lambda: hodt.Constraints(max_edge=TWO), "max_edge"),
    (lambda: hodt.Places(polygons=3), "polygons"),
    (lambda: hodt.Places(polygons=[3]), r"polygons\[0\]"),
    (lambda: hodt.triangulate(POINTS, 2, keep=3), "keep"),
    (lambda: hodt.triangulate(POINTS, 2, keep=[[1, 2, 3]]), "keep"),
    (lambda: hodt.compare(POINTS, 2, keep=OWN), "keep"),
    (lambda: TIN.interpolate(None), "xy"),
    (lambda: TIN.interpolate([[1], [2, 3]]), "xy"),
    (lambda: hodt.Tin(POINTS, None), "triangles"),
    (lambda: hodt.Tin([[1], [2, 3]], []), "points"),
])
def test_arguments_of_another_kind(call, says):
    with pytest.raises(hodt.ParameterError, match=says):
        call()


def test_a_place_to_keep_that_is_not_finite():
    with pytest.raises(hodt.InputError, match="keep: row 0"):
        hodt.triangulate(POINTS, 2, keep=[[1, np.nan]])


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("column", [0, 1, 2])
def test_truth_that_is_not_finite(bad, column):
    truth = POINTS[:3].copy()
    truth[1, column] = bad
    for points in (POINTS, TIN):
        with pytest.raises(hodt.InputError, match="truth: row 1"):
            hodt.compare(points, 1, truth=truth)


@pytest.mark.parametrize("call", [TIN.interpolate, TIN.find_triangle, hodt.Delaunay(POINTS).find_simplex])
def test_places_that_are_masked_or_in_another_order(call):
    masked = np.ma.masked_array([[200.0, 300.0]], [[True, False]])
    with pytest.raises(hodt.InputError, match="x[yi]: some values are masked"):
        call(masked)
    with pytest.raises(hodt.ParameterError, match="x[yi]: the columns are y, x"):
        call(Frame())
    assert call(np.ma.masked_array(POINTS[:1, :2], False)) == call(POINTS[:1, :2])


def test_rows_that_are_masked():
    rows = np.ma.masked_array([[0, 1, 2]], [[False, True, False]])
    with pytest.raises(hodt.InputError, match="triangles: some values are masked"):
        hodt.Tin(POINTS, rows)
    for call in (lambda: TIN.check(rows[:, :2]), lambda: hodt.Constraints(edges=rows[:, :2])):
        with pytest.raises(hodt.InputError, match="edges: some values are masked"):
            call()


PATHS = [hodt.read_points, hodt.read_tin, TIN.write, hodt.Constraints,
         lambda path: hodt.Constraints(outline=path), lambda path: hodt.triangulate(POINTS, 2, keep=path),
         lambda path: hodt.compare(POINTS, 2, truth=path)]


@pytest.mark.parametrize("call", PATHS)
@pytest.mark.parametrize("path", ["a\0.ply", "\ud800.ply"])
def test_what_no_file_can_be_called(call, path):
    with pytest.raises(hodt.ParameterError, match="path"):
        call(path)


def test_a_null_byte_among_bytes():
    with pytest.raises(hodt.ParameterError, match="null byte"):
        hodt.read_points(b"a\0.csv")


@pytest.mark.parametrize("call", PATHS)
def test_errors_about_names_that_are_not_utf_8(call, tmp_path):
    path = os.fsdecode(os.fsencode(tmp_path) + b"/no/n\xff.ply")
    with pytest.raises((hodt.FileError, hodt.ParameterError), match=r"no(/n\\xff.ply)?"):
        call(path)


def test_files_whose_names_are_not_utf_8(tmp_path):
    path = os.fsdecode(os.fsencode(tmp_path) + b"/n\xff.ply")
    TIN.write(path)
    assert hodt.read_tin(path) == TIN == hodt.read_tin(os.fsencode(path))


@pytest.mark.parametrize("text", NO_TEXTS)
@pytest.mark.parametrize("call, says", [
    (lambda text: hodt.triangulate(POINTS, 2, text), "objective"),
    (lambda text: hodt.triangulate(POINTS, objective=text), "objective"),
    (lambda text: hodt.triangulate(POINTS, 2, method=text), "method"),
    (lambda text: hodt.compare(POINTS, 2, text), "objectives"),
    (lambda text: hodt.sample(text), "terrain"),
    (lambda text: hodt.Measure(len, name=text), "name"),
])
def test_texts_that_are_none(call, says, text):
    with pytest.raises(hodt.ParameterError, match=says):
        call(text)


def test_pictures_and_grids_that_cannot_be():
    pytest.importorskip("matplotlib")
    with pytest.raises(hodt.ParameterError, match="plot needs triangles"):
        EMPTY.plot()
    pytest.importorskip("xarray")
    for tin in (EMPTY, hodt.Tin(np.empty((0, 3)), [])):
        with pytest.raises(hodt.ParameterError, match="to_xarray needs triangles"):
            tin.to_xarray(1)
    for resolution in ("a", None, np.inf, 0, 1e-300, 5e-324, TWO):
        with pytest.raises(hodt.ParameterError, match="resolution"):
            TIN.to_xarray(resolution)
