"""The whole job: orders, values and reports, by brute force and against the command."""

import json
import math
import subprocess

import numpy as np
import pytest

import brute
import hodt


def terrain(seed, n=12, grid=False):
    rng = np.random.default_rng(seed)
    xy = rng.integers(0, 5, (n, 2)) if grid else rng.random((n, 2))
    return np.column_stack([xy, rng.integers(0, 6, n)]).astype(float)


def all_triangulations(points, triangles):
    """Of the points, with these (left-turning) triangles only: sets of rows of `triangles`."""
    p = brute.exact(points)
    by_edge = {}
    for i, t in enumerate(triangles):
        for j in range(3):
            by_edge.setdefault((t[j], t[(j + 1) % 3]), []).append(i)

    def disjoint(s, t):
        for a, b in ((s, t), (t, s)):
            for j in range(3):
                u, v = a[j], a[(j + 1) % 3]
                if all(brute.turn(p[u], p[v], p[w]) <= 0 for w in b):
                    return True
        return False

    def is_outside(edge):
        return all(brute.turn(p[edge[0]], p[edge[1]], p[w]) <= 0 for w in range(len(p)))

    def extend(chosen, wanting):
        """`wanting`: edges that lack the triangle on their left."""
        if not wanting:
            yield chosen
            return
        for i in by_edge.get(min(wanting), ()):
            t = triangles[i]
            if all(disjoint(t, triangles[j]) for j in chosen):
                sides = {(t[j], t[(j + 1) % 3]) for j in range(3)}
                new = {(v, u) for u, v in sides - wanting if not is_outside((v, u))}
                yield from extend([*chosen, i], (wanting - sides) | new)

    yield from extend([], {next(e for e in by_edge if is_outside(e[::-1]))})


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("k", [1, 2])
def test_fewest_local_minima_of_all_triangulations(seed, k):
    points = terrain(seed, 9)
    p = brute.exact(points)
    triangles = [brute.left(p, t) for t in brute.kod_triangles(points, k)]
    triangles = [t for t in triangles if not any(
        all(brute.turn(p[t[j]], p[t[(j + 1) % 3]], p[v]) >= 0 for j in range(3))
        for v in range(len(p)) if v not in t)]
    fewest = min(len(brute.minima(points, [triangles[i] for i in chosen]))
                 for chosen in all_triangulations(points, triangles))
    result = hodt.triangulate(points, k, method="exact")
    assert result.value["result"] == fewest
    assert result.value["optimal"] and result.value["bound"] == fewest


@pytest.mark.parametrize("objective", ["min-local-minima", "min-local-extrema", "min-max-degree",
                                       "min-max-angle", "max-sum-small-angle", "min-sum-abn", "none"])
@pytest.mark.parametrize("grid", [False, True])
def test_results_are_triangulations_of_the_order(objective, grid):
    for seed in range(4):
        for k in (0, 1, 3, math.inf):
            points = terrain(seed, 16, grid)
            result = hodt.triangulate(points, k, objective)
            tin = result.tin
            assert brute.is_triangulation(tin.points, tin.triangles)
            assert brute.largest_order(tin.points, tin.triangles) <= result.order <= k
            kept = np.unique(points, axis=0)[np.unique(np.unique(points, axis=0)[:, :2], axis=0,
                                                       return_index=True)[1]]
            assert {tuple(q) for q in tin.points} == {tuple(q) for q in kept}
            assert result.duplicates == len(points) - len(tin.points)
            counted = result.local_minima["result"]
            assert sum(counted.values()) == len(brute.minima(tin.points, tin.triangles))
            assert result.triangles == len(tin.triangles) == sum(result.order_histogram)
            assert result.k == k and (k == math.inf or isinstance(result.k, int))


def test_rows_stay_vertices(rng):
    points = rng.random((500, 3))
    tin = hodt.triangulate(points, 2).tin
    assert np.array_equal(tin.points, points) and not tin.points.flags.writeable
    assert np.array_equal(tin.xy, points[:, :2]) and np.array_equal(tin.z, points[:, 2])


def test_as_the_command(command, tmp_path):
    points = hodt.sample("jacksboro", 2000)
    csv, ply, report = (tmp_path / name for name in ("p.csv", "t.ply", "r.json"))
    np.savetxt(csv, points, delimiter=",", fmt="%.17g")
    for k, objective in ((4, "min-local-minima"), (1, "min-max-angle"), (2, "max-sum-small-angle")):
        subprocess.run([command, "triangulate", csv, "-o", ply, "-k", str(k), "--objective", objective,
                        "--json", report], check=True, stdout=subprocess.DEVNULL)
        result = hodt.triangulate(points, k, objective)
        result.tin.write(tmp_path / "own.ply")
        assert (tmp_path / "own.ply").read_bytes() == ply.read_bytes()
        told = json.loads(report.read_text())
        of_files = {"columns", "files", "crs", "duplicate_rule"}
        for name in set(told) - of_files - {"seconds"}:
            assert result.report[name] == told[name], name
        assert set(told) - of_files == set(result.report)
        assert set(result.seconds) < set(told["seconds"])


def test_attributes_and_pictures_of_a_result():
    result = hodt.triangulate(hodt.sample("jacksboro", 500), 4)
    assert result.order == result.report["order"] and "order" in dir(result)
    with pytest.raises(AttributeError, match="has no 'colour'; it has tin, report"):
        _ = result.colour
    assert "min-local-minima" in repr(result) and "bound" in repr(result)
    html = result._repr_html_()
    assert "data:image/png;base64," in html and "local minima" in html and len(html) < 300_000
    flat = hodt.triangulate(np.random.default_rng(1).random((50, 2)), 2, "min-max-angle")
    assert flat.local_minima is None and "data:image/png" in flat._repr_html_()
    import copy
    import pickle
    assert copy.copy(result).order == result.order
    assert pickle.loads(pickle.dumps(result)).tin == result.tin


def test_constraints():
    square = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 2], [3, 2.1], [2, 1], [2, 3]], float)
    points = np.column_stack([square, np.arange(8)])
    road = hodt.Constraints(breaklines=[[[0, 0, 0], [4, 4, 2]]])
    result = hodt.triangulate(points, constraints=road)
    edges = {tuple(sorted(e)) for t in result.tin.triangles.tolist() for e in (t[:2], t[1:], t[::2])}
    assert (0, 2) in edges and result.constraints["edges"] == 1
    by_rows = hodt.triangulate(points, constraints=hodt.Constraints(edges=[[0, 2]]))
    assert np.array_equal(by_rows.tin.triangles, result.tin.triangles)
    hole = hodt.Constraints(outline=[[[0, 0], [4, 0], [4, 4], [0, 4]],
                                     [[1.5, 1.5], [2.5, 1.5], [2.5, 2.5], [1.5, 2.5]]])
    tin = hodt.triangulate(points, constraints=hole).tin
    assert tin.area().sum() == 15
    assert np.isnan(tin.interpolate([2, 2])) and not np.isnan(tin.interpolate([1, 1]))
    ring = hodt.Constraints(boundary=[[0, 1], [1, 2], [2, 0]])
    assert hodt.triangulate(points, constraints=ring).tin.area().sum() == 8
    short = hodt.triangulate(points, constraints=hodt.Constraints(max_edge=3.9))
    assert short.constraints["triangles_too_long"] > 0


@pytest.mark.parametrize("make, error, says", [
    (lambda: dict(breaklines=[[[0, 0], [4, 4]], [[0, 4], [4, 0]]]), hodt.InputError,
     "cross near x 2, y 2.*split_crossings=True"),
    (lambda: dict(edges=[[0, 9]]), hodt.ParameterError, "row 9"),
    (lambda: dict(edges=[[0, -1]]), hodt.ParameterError, "edges"),
    (lambda: dict(edges=[[0, 1.5]]), hodt.ParameterError, "integers"),
    (lambda: dict(breaklines=[[[0, 0], [np.nan, 4]]]), hodt.InputError, "not finite"),
    (lambda: dict(breaklines=[[[100, 100], [101, 101]]]), hodt.InputError, "coordinate system"),
    (lambda: dict(outline=[[[0, 0], [1, 1]]], boundary=[[0, 1]]), hodt.ParameterError, "both"),
    (lambda: dict(snap=1), hodt.ParameterError, "for lines"),
    (lambda: dict(max_edge=-1), hodt.ParameterError, "max_edge"),
])
def test_constraints_that_cannot_be(make, error, says):
    points = np.array([[0, 0, 0], [4, 0, 1], [4, 4, 2], [0, 4, 3], [1, 2, 4]], float)
    with pytest.raises(error, match=says):
        hodt.triangulate(points, constraints=hodt.Constraints(**make()))


def test_crossing_lines_get_a_vertex_on_demand():
    points = np.array([[0, 0, 0], [4, 0, 1], [4, 4, 2], [0, 4, 3]], float)
    lines = hodt.Constraints(breaklines=[[[0, 0], [4, 4]], [[0, 4], [4, 0]]], split_crossings=True)
    result = hodt.triangulate(points, constraints=lines)
    assert [2, 2] in result.tin.xy.tolist() and result.constraints["vertices_at_crossings"] == 1


def test_a_mesh_is_improved():
    points = hodt.sample("valley", 800)
    before = hodt.triangulate(points, objective="none").tin
    after = hodt.triangulate(before, 8, "min-max-angle")
    assert after.value["result"] <= after.value["input"]
    assert after.input["order"] == 0 and after.tin.area().sum() == pytest.approx(before.area().sum())
    with pytest.raises(hodt.ParameterError, match="outline"):
        hodt.triangulate(before, constraints=hodt.Constraints())
    overlapping = hodt.Tin([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [0, 1, 3]])
    with pytest.raises(hodt.InputError):
        hodt.triangulate(overlapping, objective="min-max-angle")


def test_pits_to_keep():
    points = hodt.sample("jacksboro", 3000)
    free, some = hodt.triangulate(points, 8), hodt.triangulate(points, 8, min_pit_depth=5)
    assert some.kept > 0 and some.value["result"] > free.value["result"]
    vertices, depths = hodt.triangulate(points, objective="none").tin.pits()
    assert some.kept == (depths >= 5).sum()
    deepest = points[vertices[np.argmax(depths)], :2]
    assert hodt.triangulate(points, 8, keep=[deepest]).kept == 1
    box = deepest + np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    assert hodt.triangulate(points, 8, keep=hodt.Places(polygons=[[box]])).kept == 1
    with pytest.raises(hodt.InputError, match="keep"):
        hodt.triangulate(points, 8, keep=[[1e9, 1e9]])
    with pytest.raises(hodt.ParameterError, match="objectives that remove minima"):
        hodt.triangulate(points, 8, "min-max-angle", min_pit_depth=5)


def test_vertices_are_the_points_in_their_order_and_those_that_lines_added():
    points = hodt.sample("jacksboro", 40)
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    line = [[*low + (high - low) * share, 100] for share in ([0.1, 0.2], [0.9, 0.3])]
    twice = np.vstack([points[:5], points])
    lines = hodt.Constraints(breaklines=[line])
    tin = hodt.triangulate(twice, 2, constraints=lines).tin
    assert np.array_equal(tin.points, np.vstack([points, line]))
    assert hodt.useful_edges(twice, 2, constraints=lines)[:, :2].max() == len(twice) + 1
    ring = [[*low + (high - low) * share, 100] for share in ([0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9])]
    tin = hodt.triangulate(points, 2, constraints=hodt.Constraints(outline=[ring])).tin
    inside = ((points[:, :2] > ring[0][:2]) & (points[:, :2] < ring[2][:2])).all(axis=1)
    assert np.array_equal(tin.points, np.vstack([points[inside], ring])) and not inside.all()


def test_objectives_in_order():
    points = terrain(3, n=60)
    both = hodt.triangulate(points, 1, "min-local-minima,min-sum-abn")
    first = hodt.triangulate(points, 1, "min-local-minima")
    assert both.value == first.value and first.then == []
    [then] = both.then
    assert then["objective"] == "min-sum-abn"
    assert then["value"]["bound_in_order"] and then["value"]["optimal"]
    assert "min-sum-abn" in repr(both)


def test_terrain_stands_for_a_list_and_its_order():
    points = terrain(3, n=60)
    usual = hodt.triangulate(points, objective="terrain")
    assert usual.k == 8
    listed = hodt.triangulate(points, 8, "min-local-minima,min-sum-abn")
    assert np.array_equal(usual.tin.triangles, listed.tin.triangles) and usual.then == listed.then
    assert hodt.triangulate(points, 2, "terrain").k == 2
    assert hodt.triangulate(points).k == 4


def area(a, b, c):
    return np.abs((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])) / 2


@pytest.mark.parametrize("k", [1, 3, 20])
def test_a_measure_of_ones_own_is_as_good_as_a_built_in_one(k, rng):
    points = rng.random((60, 2))
    for direction, aggregate in (("min", "max"), ("max", "min")):
        built_in = hodt.triangulate(points, k, f"{direction}-{aggregate}-area")
        own = hodt.triangulate(points, k, hodt.Measure(area, aggregate, direction, name="mine"))
        assert own.value["result"] == pytest.approx(built_in.value["result"])
        assert own.value["bound"] == pytest.approx(built_in.value["bound"])
        assert own.objective == f"{direction}-{aggregate}-mine"


def test_triangles_of_a_measure_are_counter_clockwise_and_many_at_once(rng):
    points, calls = rng.random((300, 3)), []

    def flatness(a, b, c):
        turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        assert (turn > 0).all()
        calls.append(len(a))
        return np.ptp(np.stack([a[:, 2], b[:, 2], c[:, 2]]), axis=0)

    result = hodt.triangulate(points, 2, hodt.Measure(flatness, "sum", needs_heights=True))
    assert result.value["result"] < result.value["delaunay"]
    z = result.tin.z[result.tin.triangles]
    assert np.ptp(z, axis=1).sum() == pytest.approx(result.value["result"])
    assert max(calls) > sum(calls) / 2  # the rest, with an edge that is not useful, by themselves
    with pytest.raises(hodt.ParameterError, match="height"):
        hodt.triangulate(points[:, :2], 2, hodt.Measure(flatness, needs_heights=True))


def test_a_measure_across_edges(rng):
    points = rng.random((40, 2))

    def length(a, b, left, right):
        return np.hypot(*(b - a)[:, :2].T)

    own = hodt.triangulate(points, 1, hodt.Measure(length, "sum", "min", across_edges=True))
    total = hodt.triangulate(points, 1, "min-sum-length")
    boundary = total.tin.xy[total.tin.boundary()]
    outside = np.hypot(*(boundary[:, 0] - boundary[:, 1]).T).sum()
    assert own.value["result"] + outside == pytest.approx(total.value["result"])


def rounded_by_the_number_of_rows(a, b, left, right):
    return np.abs((a + b - left - right) @ np.array([0.3, 0.7, 0.11]))


@pytest.mark.parametrize("direction, aggregate", [("min", "max"), ("max", "min"), ("max", "sum")])
@pytest.mark.parametrize("k", [1, 3])
def test_last_bits_of_a_measure_across_edges_may_depend_on_the_number_of_rows(direction, aggregate, k):
    points = hodt.sample("jacksboro", 150)
    measure = hodt.Measure(rounded_by_the_number_of_rows, aggregate, direction, across_edges=True)
    value = hodt.triangulate(points, k, measure, threads=2).value
    one_by_one = hodt.Measure(lambda *corners: [rounded_by_the_number_of_rows(*row)[0] for row in zip(
        *(corner[:, None] for corner in corners))], aggregate, direction, across_edges=True)
    expected = hodt.triangulate(points, k, one_by_one).value
    for name in ("delaunay", "result", "bound"):
        assert value[name] == pytest.approx(expected[name])


@pytest.mark.parametrize("aggregate", ["min", "max", "sum"])
def test_each_edge_is_asked_for_once(aggregate, rng):
    asked = []

    def of(*corners):
        asked.extend(map(tuple, np.column_stack(corners).tolist()))
        return rng.random(len(corners[0]))  # so it ends also where answers change

    hodt.triangulate(rng.random((150, 3)), 3, hodt.Measure(of, aggregate, "max", across_edges=True),
                     threads=1)
    assert len(asked) == len(set(asked)) > 400


@pytest.mark.parametrize("across_edges", [False, True])
def test_a_measure_may_get_another_function_meanwhile(across_edges, rng):
    def once(*corners):
        measure.of = None
        return np.ones(len(corners[0]))

    measure = hodt.Measure(lambda *corners: once(*corners), "sum", across_edges=across_edges)
    result = hodt.triangulate(rng.random((60, 2)), 20, measure)
    assert result.value["result"] == result.value["delaunay"] > 100 and measure.of is None


@pytest.mark.parametrize("of, says", [
    (lambda a, b, c: -np.ones(len(a)), "own|lambda"),
    (lambda a, b, c: np.full(len(a), np.nan), "own|lambda"),
    (lambda a, b, c: np.ones(3), "array of .* numbers"),
    (lambda a, b, c: 1.0, "array of .* numbers"),
])
def test_measures_that_are_none(of, says, rng):
    with pytest.raises(hodt.ParameterError, match=says):
        hodt.triangulate(rng.random((30, 2)), 2, hodt.Measure(of))


def test_errors_of_a_measure_come_through(rng):
    def of(a, b, c):
        raise RuntimeError("from the measure")

    for k in (2, 30):
        with pytest.raises(RuntimeError, match="from the measure"):
            hodt.triangulate(rng.random((30, 2)), k, hodt.Measure(of))


@pytest.mark.parametrize("arguments, says", [
    (dict(objective="min-max-beauty"), "min-max-beauty"),
    (dict(objective=3), "objective"),
    (dict(objective="min-sum-abn,min-sum-abn"), "twice"),
    (dict(method="magic"), "magic"),
    (dict(method="greedy", objective="min-max-angle"), "greedy"),
    (dict(time_limit=-1), "time_limit"),
    (dict(time_limit="soon"), "time_limit"),
    (dict(min_pit_depth=math.inf), "min_pit_depth"),
    (dict(threads=0), "threads"),
    (dict(threads=-2), "threads"),
    (dict(progress=3), "progress"),
    (dict(constraints=[[0, 1]]), "Constraints"),
])
def test_arguments_that_cannot_be(arguments, says):
    with pytest.raises(hodt.ParameterError, match=says):
        hodt.triangulate(terrain(1), **arguments)


def test_heights_are_needed():
    with pytest.raises(hodt.ParameterError, match="height"):
        hodt.triangulate(terrain(1)[:, :2])


def test_compare_as_the_command(command, tmp_path):
    points = hodt.sample("jacksboro", 1500)
    csv, report, truth = (tmp_path / name for name in ("p.csv", "r.json", "t.csv"))
    known = hodt.sample("jacksboro", 300, 5)
    np.savetxt(csv, points, delimiter=",", fmt="%.17g")
    np.savetxt(truth, known, delimiter=",", fmt="%.17g")
    subprocess.run([command, "compare", csv, "--orders", "0-2", "--objective", "min-local-minima",
                    "--objective", "max-sum-small-angle", "--truth", truth, "--json", report],
                   check=True, stdout=subprocess.DEVNULL)
    told = json.loads(report.read_text())
    ours = hodt.compare(points, range(3), ["min-local-minima", "max-sum-small-angle"], truth=known)
    for name in ("columns", "files", "crs", "duplicate_rule"):
        told.pop(name, None)
    assert told["constraints"] is None and told["input"] is None
    for each in (told, ours):
        for objective in each["objectives"]:
            for row in objective["rows"]:
                del row["seconds"]
    assert ours == told
    with pytest.raises(hodt.ParameterError):
        hodt.compare(points, range(2), ["none"])
    with pytest.raises(hodt.ParameterError, match="remove minima"):
        hodt.compare(points, 1, "min-max-angle", min_pit_depth=1)
    with pytest.raises(hodt.ParameterError, match="height"):
        hodt.compare(points[:, :2], 1)


def test_compare_with_files_of_truth(command, tmp_path):
    corners = [[0, 0, 5], [12, 0, 5], [12, 12, 5], [0, 12, 5]]
    listed, land = tmp_path / "t.csv", tmp_path / "land.asc"
    listed.write_text("x,y,z\n1,1,6\n3,3,5\n")
    told = hodt.compare(corners, 0, truth=listed)
    assert told == {**hodt.compare(corners, 0, truth=[[1, 1, 6], [3, 3, 5]]), "objectives": told["objectives"]}
    assert told["truth"]["delaunay_rmse"] == pytest.approx(0.5**0.5) and told["truth"]["delaunay_land"] is None
    with pytest.raises(hodt.FileError):
        hodt.compare(corners, 0, truth=tmp_path / "none.csv")
    if "GDAL: it is there" not in subprocess.run([command, "formats"], capture_output=True, text=True).stdout:
        pytest.skip("rasters are read by GDAL")
    cells = np.full((6, 6), 5)
    cells[2, 2] = 2
    rows = "\n".join(" ".join(map(str, row)) for row in cells)
    land.write_text(f"ncols 6\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 2\n{rows}\n")
    told = hodt.compare(corners, 0, "terrain", truth=str(land))
    assert told["truth"]["land_fill_volume"] == 12
    [row] = told["objectives"][0]["rows"]
    assert row["land"] == told["truth"]["delaunay_land"] and row["land"]["fill_volume"] == 0
    assert row["land"]["slope_error"] == pytest.approx(np.degrees(np.arctan(0.75)) / 2)


def test_compare_is_triangulate_for_every_order():
    points = hodt.sample("jacksboro", 300)
    lines = hodt.Constraints(edges=[[0, 299]])
    tin = hodt.triangulate(points, 3, "max-sum-length").tin
    for given, wishes in ((points, {}), (points, {"constraints": lines}), (tin, {})):
        told = hodt.compare(given, [1, 4], "min-local-minima+min-sum-abn", **wishes)
        (objective,) = told["objectives"]
        assert objective["objective"] == "min-local-minima" and objective["then"] == ["min-sum-abn"]
        for row in objective["rows"]:
            one = hodt.triangulate(given, row["k"], "min-local-minima,min-sum-abn", **wishes)
            assert (row["value"], row["bound"]) == (one.value["result"], one.value["bound"])
            (later,) = row["then"]
            assert later["value"] == one.then[0]["value"]["result"]
            assert told["constraints"] == one.constraints
        assert (objective["input"] is None) == (given is points)
    assert 1 <= told["input"]["order"] <= 3 and told["input"]["unused_vertices"] == 0
    with pytest.raises(hodt.ParameterError, match="outline"):
        hodt.compare(tin, 1, constraints=lines)
