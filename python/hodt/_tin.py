"""A triangulated irregular network: the surface that is linear on each triangle."""

import math
from functools import cached_property

import numpy as np

from . import _hodt
from ._arguments import (
    as_amount,
    as_crs,
    as_grid_of_places,
    as_path,
    as_points,
    as_rows,
    as_threads,
    finite,
    frozen,
)
from ._errors import InputError, ParameterError
from ._optional import optional

MOST_CELLS = 10_000_000_000  # of a raster, as `hodt raster` has it


class Tin:
    """Vertices and triangles, with or without heights.

    points: (n, 2) or (n, 3), finite; the third column is the height.
    triangles: (m, 3), integers: rows of points, in either direction.
    crs: the coordinate reference system ("EPSG:25832"), or None.

    xy (n, 2), z (n,) or None, and triangles (m, 3) int32 are its arrays; they cannot be changed.
    Raises ParameterError for arrays of other shapes and corners that are no vertices, InputError for
    coordinates that are not finite.
    """

    def __init__(self, points, triangles, crs=None):
        array = finite(as_points(points), "points")
        self.xy = frozen(np.array(array[:, :2], order="C"))
        self.z = frozen(array[:, 2].copy()) if array.shape[1] == 3 else None
        self.triangles = frozen(as_rows(triangles, 3, len(array), "triangles").copy())
        self.crs = as_crs(crs)
        self._is_mesh = False

    @classmethod
    def _made(cls, arrays, crs=None, is_mesh=True):
        """Of arrays that the library made."""
        tin = cls.__new__(cls)
        xy, z, triangles = arrays
        tin.xy, tin.triangles = frozen(xy), frozen(triangles)
        tin.z = None if z is None else frozen(z)
        tin.crs, tin._is_mesh = crs, is_mesh
        return tin

    def __reduce__(self):
        """Copies and pickles are made of the arrays alone, and know nothing of them yet."""
        return type(self), (self.points, self.triangles, self.crs)

    def __repr__(self):
        heights = "with" if self.has_heights else "without"
        return f"<hodt.Tin: {len(self.xy)} points {heights} heights, {len(self.triangles)} triangles>"

    def __eq__(self, other):
        if not isinstance(other, Tin):
            return NotImplemented
        return (np.array_equal(self.xy, other.xy) and np.array_equal(self.triangles, other.triangles)
                and self.has_heights == other.has_heights
                and (self.z is None or np.array_equal(self.z, other.z)) and self.crs == other.crs)

    __hash__ = None

    @property
    def has_heights(self):
        """Whether the vertices have heights."""
        return self.z is not None

    @cached_property
    def points(self):
        """The vertices, (n, 3), or (n, 2) without heights."""
        return self.xy if self.z is None else frozen(np.column_stack([self.xy, self.z]))

    def _heights(self, what):
        if self.z is None:
            raise ParameterError(f"{what} needs heights, and the TIN has none")
        return self.z

    def _require_triangles(self, what):
        if len(self.triangles) == 0:
            raise ParameterError(f"{what} needs triangles, and the TIN has none")

    def _require_mesh(self, what):
        if self._is_mesh:
            return
        problem = _hodt.problem_of(self.xy, self.triangles)
        if problem:
            raise InputError(f"{what} needs triangles that do not overlap: {problem}")
        self._is_mesh = True

    # Between the vertices

    def interpolate(self, xy, *, threads=None):
        """The heights of the surface at places (..., 2), as float64 (...); NaN where there is none.

        At a vertex it is the vertex's height. Raises InputError if triangles overlap.
        """
        z = self._heights("interpolate")
        self._require_mesh("interpolate")
        flat, shape = as_grid_of_places(xy, "xy")
        finite(flat, "xy")
        return _hodt.interpolate(self.xy, z, self.triangles, flat, as_threads(threads)).reshape(shape)

    def find_triangle(self, xy, *, threads=None):
        """A triangle at each place (..., 2), its border included, as int32 (...); -1 for none."""
        self._require_mesh("find_triangle")
        flat, shape = as_grid_of_places(xy, "xy")
        finite(flat, "xy")
        return _hodt.triangles_at(self.xy, self.triangles, flat, as_threads(threads)).reshape(shape)

    # Triangles

    @cached_property
    def gradient(self):
        """The slope of each triangle in x and y, float64 (m, 2); NaN of triangles without an area."""
        z = self._heights("gradient")
        a, b, c = self.triangles.T
        (ux, uy), (vx, vy) = (self.xy[b] - self.xy[a]).T, (self.xy[c] - self.xy[a]).T
        uz, vz = z[b] - z[a], z[c] - z[a]
        with np.errstate(divide="ignore", invalid="ignore"):
            area = ux * vy - uy * vx
            slopes = np.stack([(uz * vy - vz * uy) / area, (vz * ux - uz * vx) / area], axis=1)
        slopes[area == 0] = np.nan
        return frozen(slopes)

    def slope(self):
        """The steepness of each triangle in degrees, float64 (m,): 0 is level. Heights and places
        have to be in the same unit."""
        return np.degrees(np.arctan(np.hypot(*self.gradient.T)))

    def aspect(self):
        """Where each triangle faces, downhill: degrees clockwise from the y axis (north), 0 to 360,
        float64 (m,); NaN of level ones."""
        x, y = -self.gradient.T
        degrees = np.degrees(np.arctan2(x, y)) % 360
        degrees[degrees == 360] = 0
        degrees[(x == 0) & (y == 0)] = np.nan
        return degrees

    def area(self):
        """The planar area of each triangle, float64 (m,)."""
        a, b, c = self.triangles.T
        (ux, uy), (vx, vy) = (self.xy[b] - self.xy[a]).T, (self.xy[c] - self.xy[a]).T
        return np.abs(ux * vy - uy * vx) / 2

    # Vertices

    def minima(self):
        """The vertices without a lower neighbour, int32, ascending: u is lower than v if (z, x, y)
        is lexicographically smaller. Vertices of no triangle are none."""
        return self._extrema("minima", lower=True)

    def maxima(self):
        """The vertices without a higher neighbour, likewise."""
        return self._extrema("maxima", lower=False)

    def _extrema(self, what, lower):
        z, (x, y) = self._heights(what), self.xy.T
        is_extremum = np.zeros(len(self.xy), bool)
        is_extremum[self.triangles] = True
        for i, j in ((0, 1), (1, 2), (2, 0)):
            u, v = self.triangles[:, i], self.triangles[:, j]
            is_lower = (z[u] < z[v]) | (z[u] == z[v]) & ((x[u] < x[v]) | (x[u] == x[v]) & (y[u] < y[v]))
            is_extremum[np.where(is_lower == lower, v, u)] = False
        return np.nonzero(is_extremum)[0].astype(np.int32)

    def boundary(self):
        """The edges with one triangle, (b, 2) int32, in that triangle's direction."""
        edges = np.concatenate([self.triangles[:, [0, 1]], self.triangles[:, [1, 2]],
                                self.triangles[:, [2, 0]]]).astype(np.int64)
        codes = np.sort(edges, axis=1) @ np.array([len(self.xy), 1])
        _, first, counts = np.unique(codes, return_index=True, return_counts=True)
        return edges[np.sort(first[counts == 1])].astype(np.int32)

    def pits(self):
        """(vertices, depths): the local minima, int32, and how deep they are, float64: from the
        bottom to where water would flow over, 0 at the border. Raises InputError if triangles
        overlap, or the border touches itself."""
        z = self._heights("pits")
        self._require_mesh("pits")
        return _hodt.pits(self.xy, z, self.triangles)

    def contours(self, levels=None, *, interval=None, base=0.0):
        """The contour lines, a list of (level, xy) with xy float64 (p, 2), sorted by level. Higher
        ground is on a line's left; a closed line repeats its first position.

        levels: heights, ascending; or, in their place, `interval`: the levels are base and whole
            multiples of it away from that, as far as the surface reaches.
        """
        z = self._heights("contours")
        if (levels is None) == (interval is None):
            raise ParameterError("contours are of levels, or of an interval: give one of them")
        self._require_mesh("contours")
        try:
            chosen = None if levels is None else [float(level) for level in np.atleast_1d(levels)]
            step, origin = 0.0 if interval is None else float(interval), float(base)
        except (TypeError, ValueError):
            raise ParameterError("levels, interval and base are to be numbers") from None
        return _hodt.contours(self.xy, z, self.triangles, chosen, step, origin)

    # The whole

    def check(self, edges=(), *, threads=None):
        """What `hodt check` tells of a mesh, as a dictionary: whether it is embedded, its order, the
        shapes of the triangles, extrema. Orders are counted from the coordinates alone. `edges`,
        (e, 2), are edges that no circle counts points beyond."""
        walls = as_rows(edges, 2, len(self.xy), "edges")
        return _hodt.check(self.xy, self.z, self.triangles, walls, as_threads(threads))

    def order(self, edges=(), *, plain=False, threads=None):
        """The largest number of points in a circumcircle. Points on a circle count by hodt's rule
        for ties, or as outside, if plain. Raises InputError if triangles overlap."""
        findings = self.check(edges, threads=threads)
        if not findings["embedded"]:
            raise InputError(f"the order needs triangles that do not overlap: {findings['problem']}")
        if findings["missing_edges"]:
            raise InputError(f"edges: {findings['missing_edges']} are no edges of the mesh")
        return findings["order_plain" if plain else "order"]

    def write(self, path):
        """Writes a mesh file, as hodt.write_tin does."""
        crs = as_crs(self.crs) or ""
        _hodt.write_tin(self.xy, self.z, self.triangles, crs, as_path(path))

    # For other packages

    def plot(self, ax=None, *, edges=True, **options):
        """Draws the triangles, coloured by height if there are heights, with matplotlib; returns the
        axes. Options go to matplotlib's tripcolor (triplot without heights)."""
        pyplot = optional("matplotlib.pyplot", "plot")
        self._require_triangles("plot")
        if ax is None:
            ax = pyplot.figure().add_subplot()
        x, y = self.xy.T
        if self.z is None:
            ax.triplot(x, y, self.triangles, **{"linewidth": 0.5, **options})
        else:
            look = {"cmap": "terrain", "edgecolors": "#0003" if edges else "none", "linewidth": 0.3}
            ax.tripcolor(x, y, self.triangles, facecolors=self.z[self.triangles].mean(axis=1),
                         **{**look, **options})
        ax.set_aspect("equal")
        return ax

    def to_meshio(self):
        """A meshio.Mesh; vertices without heights have z = 0."""
        meshio = optional("meshio", "mesh")
        return meshio.Mesh(self._spatial(), [("triangle", self.triangles.astype(np.int64))])

    def to_pyvista(self):
        """A pyvista.PolyData; vertices without heights have z = 0."""
        pyvista = optional("pyvista", "mesh")
        faces = np.column_stack([np.full(len(self.triangles), 3, np.int64), self.triangles])
        mesh = pyvista.PolyData(self._spatial(), faces.ravel())
        if self.z is not None:
            mesh["height"] = self.z
        return mesh

    def to_geodataframe(self):
        """A geopandas.GeoDataFrame of the triangles as polygons, with their slopes and aspects."""
        geopandas, shapely = optional("geopandas", "geo"), optional("shapely", "geo")
        rings = self.points[self.triangles[:, [0, 1, 2, 0]]]
        columns = {}
        if self.z is not None:
            columns = {"slope": self.slope(), "aspect": self.aspect()}
        return geopandas.GeoDataFrame(columns, geometry=shapely.polygons(rings), crs=self.crs)

    def to_xarray(self, resolution):
        """An xarray.DataArray of the heights on a grid with cells of that size, at their middles; NaN
        outside. The first row is the northernmost, as in most rasters."""
        xarray = optional("xarray", "grid")
        self._require_triangles("to_xarray")
        step = as_amount(resolution, "resolution")
        if step == 0:
            raise ParameterError("resolution is to be more than 0")
        (left, low), (right, high) = self.xy.min(axis=0).tolist(), self.xy.max(axis=0).tolist()
        columns, rows = (max(1.0, size / step) for size in (right - left, high - low))
        if columns * rows > MOST_CELLS:
            raise ParameterError(f"a resolution of {step:g} makes more than {MOST_CELLS:,} cells; "
                                 "choose a larger one")
        columns, rows = math.ceil(columns), math.ceil(rows)
        x = left + (np.arange(columns) + 0.5) * step
        y = high - (np.arange(rows) + 0.5) * step
        heights = self.interpolate(np.stack(np.meshgrid(x, y), axis=-1))
        attributes = {} if self.crs is None else {"crs": self.crs}
        return xarray.DataArray(heights, {"y": y, "x": x}, ("y", "x"), name="height",
                                attrs=attributes)

    def _spatial(self):
        return self.points if self.z is not None else np.column_stack([self.xy, np.zeros(len(self.xy))])
