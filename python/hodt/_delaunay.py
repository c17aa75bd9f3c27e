"""The Delaunay triangulation with most attributes of scipy.spatial.Delaunay."""

from functools import cached_property

import numpy as np

from . import _hodt
from ._arguments import as_grid_of_places, as_places, as_points, as_threads, frozen
from ._errors import ParameterError


class Delaunay:
    """The Delaunay triangulation of points in the plane, for programs that know scipy's.

    points: (n, 2), or (n, 3): heights only say which of points at one place stays, the lowest.
    threads: how many may compute; None is all cores.

    Attributes mean what those of scipy.spatial.Delaunay do, with indices as int32; those about
    Qhull's paraboloid, add_points and close are not there. Decisions are exact: points on a circle
    or a line are no trouble, and there are no options for Qhull. The triangles are
    counter-clockwise, and all points but duplicates are vertices.

    Raises InputError if there is no triangle or a coordinate is not finite.
    """

    ndim = 2

    def __init__(self, points, *, threads=None):
        array = as_points(points)
        threads = as_threads(threads)
        points = np.array(array[:, :2], order="C")  # a copy: the caller's may change
        self.__setstate__((points, *_hodt.adjacency(array, threads)))

    def __getstate__(self):
        """Copies and pickles have the arrays, and find out the rest anew."""
        return self.points, self.simplices, self.neighbors, self._vertex_of_row

    def __setstate__(self, arrays):
        self.points, self.simplices, self.neighbors, self._vertex_of_row = map(frozen, arrays)

    @property
    def npoints(self):
        """The number of points."""
        return len(self.points)

    @property
    def nsimplex(self):
        """The number of triangles."""
        return len(self.simplices)

    @cached_property
    def min_bound(self):
        """The least x and y, (2,)."""
        return self.points.min(axis=0)

    @cached_property
    def max_bound(self):
        """The largest x and y, (2,)."""
        return self.points.max(axis=0)

    @cached_property
    def convex_hull(self):
        """The edges of the hull by rows of points, (h, 2) int32."""
        triangle, corner = np.nonzero(self.neighbors < 0)
        ends = [self.simplices[triangle, (corner + i) % 3] for i in (1, 2)]
        return np.stack(ends, axis=1)

    @cached_property
    def vertex_to_simplex(self):
        """Of each point a triangle with it as a corner, (n,) int32; -1 for dropped duplicates."""
        of = np.full(self.npoints, -1, np.int32)
        of[self.simplices.ravel()] = np.repeat(np.arange(self.nsimplex, dtype=np.int32), 3)
        return of

    @cached_property
    def coplanar(self):
        """Of each point that is no vertex, as another one is at its place: its row, a triangle
        there and the vertex there, (c, 3) int32."""
        rows = np.nonzero(self._vertex_of_row != np.arange(self.npoints))[0].astype(np.int32)
        stand_ins = self._vertex_of_row[rows]
        return np.stack([rows, self.vertex_to_simplex[stand_ins], stand_ins], axis=1)

    @cached_property
    def vertex_neighbor_vertices(self):
        """(indptr, indices): the neighbours of point i are indices[indptr[i]:indptr[i + 1]]."""
        corners = self.simplices.astype(np.int64)
        edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
        codes = np.concatenate([edges[:, 0] * self.npoints + edges[:, 1],
                                edges[:, 1] * self.npoints + edges[:, 0]])
        codes = np.unique(codes)
        counts = np.bincount(codes // self.npoints, minlength=self.npoints)
        indptr = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
        return indptr, (codes % self.npoints).astype(np.int32)

    @cached_property
    def transform(self):
        """(m, 3, 2): barycentric coordinates b of x in triangle i are
        transform[i, :2] @ (x - transform[i, 2]), and the third is 1 - b.sum()."""
        a, b, c = (self.points[self.simplices[:, i]] for i in range(3))
        first, second = a - c, b - c
        determinant = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        out = np.full((self.nsimplex, 3, 2), np.nan)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            out[:, 0, 0] = second[:, 1] / determinant
            out[:, 0, 1] = -second[:, 0] / determinant
            out[:, 1, 0] = -first[:, 1] / determinant
            out[:, 1, 1] = first[:, 0] / determinant
        out[:, 2] = c
        out[determinant == 0] = np.nan  # too thin for doubles
        return out

    def find_simplex(self, xi, bruteforce=False, tol=None):
        """A triangle that contains each place, its border included; -1 where there is none, and for
        places that are not finite.

        xi: places, (..., 2). Returns int32, (...). bruteforce makes no difference, and tol has to
        be None or 0, as the answer is exact.
        """
        if tol not in (None, 0):
            raise ParameterError("find_simplex is exact; leave tol out")
        flat, shape = as_grid_of_places(xi, "xi")
        found = np.full(len(flat), -1, np.int32)
        there = np.isfinite(flat).all(axis=1)
        places = as_places(flat[there], "xi")
        found[there] = _hodt.triangles_at(self.points, self.simplices, places, 0)
        return found.reshape(shape)
