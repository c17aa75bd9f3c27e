"""Arrays of every kind: taken for what they are, or refused."""

import numpy as np
import pytest

import hodt


@pytest.fixture
def points(rng):
    return rng.integers(0, 1000, (400, 3)).astype(float)


def variants(points):
    """The same points, held otherwise."""
    wide = np.zeros((len(points), 7))
    wide[:, 1:7:2] = points
    thin = np.zeros((3 * len(points), 3))
    thin[::3] = points
    odd = np.zeros(len(points), dtype=[("flag", "i1"), ("p", "f8", 3)])
    odd["p"] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    return {
        "itself": points,
        "columns of more": wide[:, 1:7:2],
        "every third row": thin[::3],
        "backwards": points[::-1].copy()[::-1],
        "Fortran": np.asfortranarray(points),
        "transposed": np.ascontiguousarray(points.T).T,
        "unaligned": odd["p"],
        "read-only": frozen,
        "big-endian": points.astype(">f8"),
        "float32": points.astype(np.float32),
        "float16": points.astype(np.float16),
        "long double": points.astype(np.longdouble),
        "int16": points.astype(np.int16),
        "int64": points.astype(np.int64),
        "uint32": points.astype(np.uint32),
        "list": points.tolist(),
        "matrix": np.matrix(points),
        "masked nowhere": np.ma.masked_array(points, False),
        "a subclass": points.view(type("Own", (np.ndarray,), {})),
        "with __array__": type("Holder", (), {"__array__": lambda self, dtype=None, copy=None: points})(),
    }


def test_any_layout_and_kind_of_number(points):
    plane, job = hodt.delaunay(points[:, :2].copy()), hodt.triangulate(points, 3).tin
    for name, held in variants(points).items():
        before = np.array(held.__array__() if name == "with __array__" else held)
        assert np.array_equal(hodt.triangulate(held, 3).tin.triangles, job.triangles), name
        two = np.asarray(held)[:, :2]
        assert np.array_equal(hodt.delaunay(two), plane), name
        after = np.array(held.__array__() if name == "with __array__" else held)
        assert np.array_equal(before, after), name


def test_one_row_for_all_has_no_triangle():
    with pytest.raises(hodt.InputError, match="1 distinct point"):
        hodt.delaunay(np.broadcast_to([1.0, 2.0], (1000, 2)))


@pytest.mark.parametrize("make, error, says", [
    (lambda: np.zeros(6), hodt.ParameterError, r"shape \(n, 2\) or \(n, 3\).*\(6,\)"),
    (lambda: np.zeros((3, 4)), hodt.ParameterError, r"\(3, 4\)"),
    (lambda: np.zeros((3, 1)), hodt.ParameterError, r"\(3, 1\)"),
    (lambda: np.zeros((2, 3, 2)), hodt.ParameterError, r"\(2, 3, 2\)"),
    (lambda: np.float64(3), hodt.ParameterError, r"\(\)"),
    (lambda: None, hodt.ParameterError, "shape"),
    (lambda: np.zeros((3, 2), complex), hodt.ParameterError, "complex"),
    (lambda: np.zeros((3, 2), bool), hodt.ParameterError, "bool"),
    (lambda: np.zeros((3, 2), object), hodt.ParameterError, "object"),
    (lambda: [["0", "1"], ["1", "2"], ["2", "1"]], hodt.ParameterError, "numbers are needed"),
    (lambda: np.zeros((3, 2), "M8[s]"), hodt.ParameterError, "datetime"),
    (lambda: np.array([[2**53 + 1, 0], [0, 1], [1, 0]]), hodt.InputError, "row 0.*float64"),
    (lambda: np.array([[0, 0], [0, 2**63 + 1]], np.uint64), hodt.InputError, "row 1.*float64"),
    (lambda: np.array([[0, 0], [1, np.longdouble(1) / 3]]), hodt.InputError, "row 1.*float64"),
    (lambda: np.ma.masked_array(np.eye(3), [[0, 0, 0], [0, 1, 0], [0, 0, 0]]), hodt.InputError, "masked"),
])
def test_what_is_no_array_of_points(make, error, says):
    for f in (hodt.delaunay, hodt.Delaunay, hodt.triangulate, hodt.useful_edges, hodt.triangles,
              hodt.kod_edges, hodt.voronoi, hodt.compare):
        with pytest.raises(error, match=says):
            f(make())


def test_ragged_lists_are_refused():
    with pytest.raises(ValueError):
        hodt.delaunay([[0, 0], [1], [2, 2]])


def test_columns_of_a_data_frame_in_another_order():
    class Frame:  # as pandas has it
        columns = ["z", "x", "y"]

        def __array__(self, dtype=None, copy=None):
            return np.eye(3)

    with pytest.raises(hodt.ParameterError, match="z, x, y"):
        hodt.delaunay(Frame())
    Frame.columns = ["X", "Y", "Z"]
    assert len(hodt.delaunay(Frame())) == 1


def test_more_points_than_there_are_numbers_for():
    many = np.broadcast_to(np.zeros(2), (2**32 // 6 + 10, 2))  # one place in memory
    with pytest.raises(hodt.InputError, match="split the input"):
        hodt.delaunay(many)


def test_results_own_their_memory(rng):
    points = rng.random((5000, 3))
    triangles = hodt.delaunay(points)
    result = hodt.triangulate(points, 1)
    tin = result.tin
    copies = triangles.copy(), tin.triangles.copy(), tin.xy.copy(), tin.z.copy()
    del points, result
    junk = [rng.random((5000, 3)) for _ in range(20)]
    assert all(np.array_equal(a, b) for a, b in zip(copies, (triangles, tin.triangles, tin.xy, tin.z)))
    assert junk and triangles.base is not None and triangles.dtype == np.int32
    triangles[0] = 0  # one's own, to change
    with pytest.raises(ValueError):
        tin.xy[0] = 0
