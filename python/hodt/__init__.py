"""Higher order Delaunay triangulations: elevation points in, a TIN with fewer artificial dams out.

    import hodt
    points = hodt.read_points("points.csv")     # or any array of shape (n, 3)
    result = hodt.triangulate(points, k=8)
    result.tin.write("terrain.ply")

Arrays go in and come out: points are float64 (n, 2) or (n, 3), triangles int32 (m, 3), rows of the
points counted from 0. An array of points must not change while a function computes on it. Whatever
computes takes `threads` (None: all cores), lets other Python threads run, and ends by Ctrl-C. The
same input gives the same bytes on any number of threads.

The terms are those of J. Gudmundsson, M. Hammar and M. van Kreveld, Higher order Delaunay
triangulations, Computational Geometry 23 (2002).
"""

from ._delaunay import Delaunay
from ._errors import Error, FileError, InputError, ParameterError
from ._functions import (
    check,
    compare,
    delaunay,
    fixed_edges,
    kod_edges,
    kod_triangles,
    order,
    read_points,
    read_tin,
    sample,
    terrains,
    triangles,
    triangulate,
    useful_edges,
    voronoi,
    write_tin,
)
from ._hodt import __version__
from ._inputs import Constraints, Measure, Places
from ._result import Result
from ._tin import Tin
from ._voronoi import Voronoi

__all__ = [
    "Constraints",
    "Delaunay",
    "Error",
    "FileError",
    "InputError",
    "Measure",
    "ParameterError",
    "Places",
    "Result",
    "Tin",
    "Voronoi",
    "__version__",
    "check",
    "compare",
    "delaunay",
    "fixed_edges",
    "kod_edges",
    "kod_triangles",
    "order",
    "read_points",
    "read_tin",
    "sample",
    "terrains",
    "triangles",
    "triangulate",
    "useful_edges",
    "voronoi",
    "write_tin",
]
