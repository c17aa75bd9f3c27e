"""The functions of the package."""

import math
import os
import warnings

import numpy as np

from . import _hodt
from ._arguments import (
    as_amount,
    as_list,
    as_name,
    as_order,
    as_path,
    as_points,
    as_progress,
    as_threads,
    finite,
)
from ._errors import ParameterError
from ._inputs import Measure, as_keep, as_objective, native_constraints
from ._result import Result
from ._tin import Tin
from ._voronoi import Voronoi


def delaunay(points, *, threads=None):
    """The Delaunay triangulation: the triangles, int32 (m, 3), counter-clockwise, by rows of points.

    points: (n, 2) or (n, 3). Of points at one place the lowest, or the first, is a corner, and the
        others are none.

    It is unique: points on one circle are decided by one rule. hodt.Delaunay knows neighbours, too.
    Raises InputError if there is no triangle (fewer than three distinct points, or all on a line) or
    a coordinate is not finite.
    """
    return _hodt.delaunay(as_points(points), as_threads(threads))


def triangulate(points, k=None, objective="min-local-minima", *, constraints=None, method="auto",
                time_limit=0, min_pit_depth=0, keep=None, threads=None, progress=None):
    """A triangulation of order k, as good for the objective as hodt can, and a proven bound.

    points: (n, 3), or (n, 2) for objectives that need no heights; or a hodt.Tin to improve, whose
        vertices, outline and holes stay.
    k: no circumcircle holds more points than this; math.inf is without limit. By default 4, for
        "terrain" 8.
    objective: "min-local-minima", "min-local-maxima", "min-local-extrema", "min-max-degree", "none",
        or "<min|max>-<sum|max|min>-MEASURE" with MEASURE one of area, angle, small-angle,
        circumradius, enclosing-radius, inradius, length, flat-area, abn, jnd, wabn (angles in
        degrees, the others in units of the points); or a hodt.Measure. Of names with commas between,
        two or three, each counts among the triangulations that are as good for those before it;
        result.then has the values of those after the first. "terrain" stands for
        "min-local-minima,min-sum-abn", a surface that drains and is near to the land.
    constraints: hodt.Constraints, for points.
    method: "auto", "greedy" (for extrema), "flip" or "exact".
    time_limit: seconds that searching may take; 0 is a fixed amount of work.
    min_pit_depth, keep: real pits that stay: deeper ones, or those at hodt.Places, an array (p, 2)
        or a file of places.
    progress: a function that is called with what is going on, and how much of it is done, from 0
        to 1, or None.

    Returns a hodt.Result. Raises InputError for points or constraints that cannot be used and
    ParameterError for arguments that cannot.
    """
    objective = as_objective(objective)
    if k is None:
        k = _hodt.usual_order(objective) if isinstance(objective, str) else 4
    wishes = {
        "k": as_order(k),
        "objective": objective,
        "method": as_name(method, "method"),
        "time_limit": as_amount(time_limit, "time_limit"),
        "min_pit_depth": as_amount(min_pit_depth, "min_pit_depth"),
        "keep": as_keep(keep),
        "threads": as_threads(threads),
        "progress": as_progress(progress),
    }
    if isinstance(points, Tin):
        if constraints is not None:
            raise ParameterError("the outline of a Tin stays; constraints are for points")
        arrays, report = _hodt.triangulate_tin(points.xy, points.z, points.triangles, wishes)
        return Result(Tin._made(arrays, points.crs), _with_order(report, k))
    arrays, report = _hodt.triangulate_points(as_points(points), wishes, native_constraints(constraints))
    return Result(Tin._made(arrays), _with_order(report, k))


def _with_order(report, k):
    report["k"] = k if k == math.inf else int(k)
    return report


def _edges(points, k, edge_class, constraints, threads):
    return _hodt.edges(as_points(points), as_order(k), edge_class, native_constraints(constraints),
                       as_threads(threads))


def useful_edges(points, k=4, *, constraints=None, threads=None):
    """The edges that triangulations of order k can have, int32 (e, 3): u, v and the useful order,
    u < v, sorted. Vertices are rows of points, here and in the functions below; with constraints
    those from len(points) on are vertices that lines added."""
    return _edges(points, k, _hodt.USEFUL, constraints, threads)


def kod_edges(points, k=4, *, constraints=None, threads=None):
    """The edges with a circle through both ends that holds at most k points, int32 (e, 3): u, v and
    the fewest points in one, u < v, sorted. With constraints only points that are reached count."""
    return _edges(points, k, _hodt.KOD, constraints, threads)


def fixed_edges(points, k=4, *, constraints=None, threads=None):
    """The edges of every triangulation of order k, int32 (e, 3): u, v and 0, u < v, sorted."""
    return _edges(points, k, _hodt.FIXED, constraints, threads)


def triangles(points, k=4, *, constraints=None, threads=None):
    """The valid triangles, which triangulations of order k can have, int32 (t, 4): a, b, c and the
    order, a < b < c, sorted. The order is the number of points in the circle, or the largest useful
    order of an edge, if that is more."""
    return _hodt.triangles(as_points(points), as_order(k), _hodt.VALID_TRIANGLES,
                           native_constraints(constraints), as_threads(threads))


def kod_triangles(points, k=4, *, constraints=None, threads=None):
    """Any three points whose circle holds at most k others, int32 (t, 4): a, b, c and that number,
    a < b < c, sorted. Other points may lie in the triangle. With constraints no line enters it, and
    only points that are reached count."""
    return _hodt.triangles(as_points(points), as_order(k), _hodt.KOD_TRIANGLES,
                           native_constraints(constraints), as_threads(threads))


def order(tin, edges=(), *, plain=False, threads=None):
    """The largest number of points in a circumcircle of the triangles: see Tin.order."""
    return _tin(tin).order(edges, plain=plain, threads=threads)


def check(tin, edges=(), *, threads=None):
    """What `hodt check` tells of a mesh, as a dictionary: see Tin.check."""
    return _tin(tin).check(edges, threads=threads)


def _tin(tin):
    if not isinstance(tin, Tin):
        raise ParameterError(f"a hodt.Tin is needed, not {type(tin).__name__}")
    return tin


def voronoi(points, m=1, *, box=None, threads=None):
    """The order-m Voronoi diagram, a hodt.Voronoi: which m points are the nearest, and where.

    box: (left, low, right, high), which polygons are clipped to; None is a tenth more than the
        points' own. Raises ParameterError unless m is at least 1 and below the number of distinct
        points, and the box has an area.
    """
    if box is not None:
        box = _as_box(box)
    return Voronoi(*_hodt.voronoi(as_points(points), as_order(m, "m"), box, as_threads(threads)))


def _as_box(box):
    try:
        left, low, right, high = map(float, box)
    except (TypeError, ValueError):
        raise ParameterError(f"box is to be left, low, right, high, not {box!r}") from None
    if not np.isfinite([left, low, right, high]).all() or not (left < right and low < high):
        raise ParameterError(f"box is to be left, low, right, high, not {box!r}")
    return [left, low, right, high]


def compare(points, orders=range(9), objectives="min-local-minima", *, constraints=None, truth=None,
            time_limit=0, min_pit_depth=0, keep=None, threads=None, progress=None):
    """What every order gains, for one objective or several: a dictionary like the JSON of `hodt
    compare`.

    orders, objectives: numbers and names, or one. Of "A+B", B counts among the triangulations that
        are as good for A, as triangulate() has it with a comma; `then` of a row has its value.
    truth: points (t, 3) whose heights are known, or a file of them, to tell the errors; of a raster
        also how slopes and streams agree with its own, and what fills the pits: `land` of a row.
    The rest, and a Tin in place of points, is as in triangulate().
    """
    if isinstance(points, Tin) and constraints is not None:
        raise ParameterError("the outline of a Tin stays; constraints are for points")
    try:
        orders = sorted({as_order(k, "orders") for k in orders})
    except TypeError:
        orders = [as_order(orders, "orders")]
    names = [objectives] if isinstance(objectives, (str, Measure)) else as_list(objectives, "objectives")
    for name in names:
        if not isinstance(name, str) or as_name(name, "objectives") == "none":
            raise ParameterError(f"objectives are to be names of what can be compared, not {name!r}")
    keeps = keep is not None or as_amount(min_pit_depth, "min_pit_depth") > 0
    if keeps and not {"min-local-minima", "min-local-extrema", "terrain"} & {n.split("+")[0] for n in names}:
        raise ParameterError("minima to keep are for objectives that remove minima")
    known = None
    if isinstance(truth, (str, bytes, os.PathLike)):
        known = as_path(truth)
    elif truth is not None:
        known = finite(as_points(truth, "truth"), "truth")
        if known.shape[1] != 3:
            raise ParameterError("truth needs heights, shape (t, 3)")
    wishes = {
        "time_limit": as_amount(time_limit, "time_limit"),
        "min_pit_depth": as_amount(min_pit_depth, "min_pit_depth"),
        "keep": as_keep(keep),
        "threads": as_threads(threads),
        "progress": as_progress(progress),
    }
    if isinstance(points, Tin):
        return _hodt.compare_tin(points.xy, points.z, points.triangles, known, orders, names, wishes)
    return _hodt.compare_points(as_points(points), known, orders, names,
                                native_constraints(constraints), wishes)


def read_points(path, columns=None, *, threads=None):
    """The points of a file, float64 (n, 3), or (n, 2) without heights, in the order of its rows.

    path: CSV, TSV or XYZ, also gzipped.
    columns: which columns are x, y and z, as a dictionary with names or numbers from 1: {"x": 2,
        "z": "height"}; None is by the table itself.

    What may be wrong with points that could be read is a UserWarning. Raises FileError if the file
    cannot be read, InputError, naming the line, if it cannot be used.
    """
    points, doubts = _hodt.read_points(as_path(path), _as_columns(columns), as_threads(threads))
    for doubt in doubts:
        warnings.warn(doubt, stacklevel=2)
    return points


def _as_columns(columns):
    """The names, or the numbers as texts, of x, y and z; empty where nothing is chosen."""
    try:
        chosen = dict({} if columns is None else columns)
    except (TypeError, ValueError):
        raise ParameterError(f"columns is to be a dictionary, not {columns!r}") from None
    if not chosen.keys() <= {"x", "y", "z"}:
        raise ParameterError(f"columns are x, y and z, not {', '.join(map(str, chosen))}")
    return [_as_column(chosen[axis]) if axis in chosen else "" for axis in "xyz"]


def _as_column(column):
    return as_name(column, "columns") if isinstance(column, str) else str(as_order(column, "columns"))


def read_tin(path):
    """The hodt.Tin of a mesh file: OBJ or PLY, also gzipped. Raises FileError if it cannot be read,
    InputError if it cannot be used."""
    arrays, crs = _hodt.read_tin(as_path(path))
    return Tin._made(arrays, crs, is_mesh=False)


def write_tin(tin, path):
    """Writes a hodt.Tin, with its crs where the format can tell one, as .ply, .obj, .vtu, .gpkg,
    .geojson or another format of meshes: `hodt formats` lists them. Vertices without heights get
    z = 0 in formats that want three coordinates. The file appears complete or not at all. Raises
    FileError, or ParameterError for other extensions."""
    _tin(tin).write(path)


def sample(name, n=None, seed=1, *, threads=None):
    """Points (n, 3) of a built-in terrain: see terrains(). The same arguments give the same points."""
    count = 0 if n is None else as_order(n, "n")
    if n is not None and count == 0:
        raise ParameterError("n is to be 1 or more, not 0")
    return _hodt.sample(as_name(name, "the terrain"), count, as_order(seed, "seed"), as_threads(threads))


def terrains():
    """The names of the built-in terrains, with what they are."""
    return _hodt.terrains()
