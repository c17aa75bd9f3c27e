"""What a triangulation has to keep to, and measures of one's own."""

import math

import numpy as np

from . import _hodt
from ._arguments import (
    as_amount,
    as_list,
    as_name,
    as_path,
    as_places,
    as_points,
    as_rows,
    finite,
    is_infinite,
)
from ._errors import ParameterError


def _line(line, name):
    """(xy, z or None) of one line."""
    points = finite(as_points(line, name), name)
    if len(points) == 0:
        raise ParameterError(f"{name}: a line without a vertex")
    xy = np.ascontiguousarray(points[:, :2])
    return xy, np.ascontiguousarray(points[:, 2]) if points.shape[1] == 3 else None


def _lines(lines, name):
    return [_line(line, f"{name}[{i}]") for i, line in enumerate(as_list(lines, name))]


def _is_path(value):
    return isinstance(value, str) or hasattr(value, "__fspath__")


class Constraints:
    """What a triangulation has to keep to: breaklines, an outline, edges.

    breaklines: lines that no triangle crosses, each an array of vertices, (n, 2) or (n, 3); or a
        GeoJSON file of them. Heights of lines replace those of points at the same place; vertices
        without take theirs from the surface.
    outline: rings that bound the triangulation and its holes, likewise. What is inside an odd
        number of rings is triangulated.
    edges: pairs of rows of the points, (m, 2), that are to be edges.
    boundary: pairs of rows that bound the domain, in place of an outline.
    max_edge: triangles at the border with a longer edge there are taken away.
    snap: vertices of lines move to the nearest point if it is no further than this.
    split_crossings: a vertex is added where lines cross, which is an error otherwise.
    """

    def __init__(self, breaklines=(), outline=(), *, edges=(), boundary=(), max_edge=math.inf,
                 snap=0.0, split_crossings=False):
        if _is_path(breaklines):
            self.breaklines = list(_hodt.read_lines(as_path(breaklines)))
        else:
            self.breaklines = _lines(breaklines, "breaklines")
        if _is_path(outline):
            self.outline = list(_hodt.read_outline(as_path(outline)))
        else:
            self.outline = _lines(outline, "outline")
        self.edges = as_rows(edges, 2, 2**31 - 1, "edges")
        self.boundary = as_rows(boundary, 2, 2**31 - 1, "boundary")
        if self.outline and len(self.boundary):
            raise ParameterError("outline and boundary both bound the domain; leave one out")
        self.max_edge = math.inf if is_infinite(max_edge) else as_amount(max_edge, "max_edge")
        self.snap = as_amount(snap, "snap")
        self.split_crossings = bool(split_crossings)
        if (self.snap or self.split_crossings) and not (self.breaklines or self.outline):
            raise ParameterError("snap and split_crossings are for lines, and there are none")

    def _native(self):
        native = _hodt.ConstraintInput()
        for xy, z in self.breaklines:
            native.add_breakline(xy, z)
        for xy, z in self.outline:
            native.add_ring(xy, z)
        native.add_edges(self.edges)
        native.add_boundary(self.boundary)
        native.max_edge = self.max_edge
        native.snap = self.snap
        native.split_crossings = self.split_crossings
        return native


def native_constraints(constraints):
    if constraints is None:
        return _hodt.ConstraintInput()
    if not isinstance(constraints, Constraints):
        raise ParameterError(f"constraints are to be hodt.Constraints, not {constraints!r}")
    return constraints._native()


class Places:
    """Real pits that stay: the local minima that these places drain to, or that polygons hold.

    points: an array, (n, 2).
    polygons: of each a list of rings, arrays (n, 2): the outline first, then the holes.
    """

    def __init__(self, points=(), polygons=()):
        self.points = as_places(points, "points")
        self.polygons = [
            [as_places(ring, f"polygons[{i}][{j}]")
             for j, ring in enumerate(as_list(rings, f"polygons[{i}]"))]
            for i, rings in enumerate(as_list(polygons, "polygons"))
        ]


def as_keep(keep):
    """None or Places, from these, an array of places, or a file of places."""
    if keep is None or isinstance(keep, Places):
        return keep
    if _is_path(keep):
        return Places(*_hodt.read_places(as_path(keep)))
    return Places(as_places(keep, "keep"))


class Measure:
    """An objective of one's own: a function of triangles, or of pairs of triangles across an edge.

    of: of triangles a function of three arrays of corners, each (m, 3) with columns x, y, z (z is 0
        where points have no heights), counter-clockwise; with across_edges=True, of four arrays: the
        ends a and b of the edges, and the corners left and right of them. It returns m numbers that
        are finite and not negative, the same for the same corners.
    aggregate: "sum", "max" or "min" over all triangles (over all inner edges).
    direction: "min" or "max": what to make of that.

    Functions of triangles are asked for all valid triangles at once, up to order 16, and for others
    that bounds need one at a time; functions across edges for about a hundred pairs at most, as
    the search comes to them. Each answer is kept for the rest of the call. That takes far longer than
    a built-in measure does.
    """

    def __init__(self, of, aggregate="sum", direction="min", *, name=None, across_edges=False,
                 needs_heights=False):
        if not callable(of):
            raise ParameterError(f"of is to be a function of arrays, not {of!r}")
        if aggregate not in ("sum", "max", "min"):
            raise ParameterError(f"aggregate is to be sum, max or min, not {aggregate!r}")
        if direction not in ("min", "max"):
            raise ParameterError(f"direction is to be min or max, not {direction!r}")
        self.of = lambda *corners: np.ascontiguousarray(of(*corners), dtype=np.float64)
        self.name = as_name(str(name or getattr(of, "__name__", "own")), "name")
        self.aggregate, self.direction = aggregate, direction
        self.across_edges, self.needs_heights = bool(across_edges), bool(needs_heights)


def as_objective(objective):
    if objective is None:
        return "none"
    if not isinstance(objective, (str, Measure)):
        raise ParameterError(f"objective is to be a name or a hodt.Measure, not {objective!r}")
    return objective if isinstance(objective, Measure) else as_name(objective, "objective")
