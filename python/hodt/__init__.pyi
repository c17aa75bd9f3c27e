import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Doubles = NDArray[np.float64]
_Integers = NDArray[np.int32]
_Path = str | os.PathLike[str]
_Progress = Callable[[str, float | None], object]
_Method = Literal["auto", "greedy", "flip", "exact"]

__version__: str
__all__: list[str]

class Error(Exception): ...
class InputError(Error, ValueError): ...
class ParameterError(Error, ValueError): ...
class FileError(Error, OSError): ...

class Constraints:
    breaklines: list[tuple[_Doubles, _Doubles | None]]
    outline: list[tuple[_Doubles, _Doubles | None]]
    edges: _Integers
    boundary: _Integers
    max_edge: float
    snap: float
    split_crossings: bool
    def __init__(
        self,
        breaklines: Iterable[ArrayLike] | _Path = (),
        outline: Iterable[ArrayLike] | _Path = (),
        *,
        edges: ArrayLike = (),
        boundary: ArrayLike = (),
        max_edge: float = ...,
        snap: float = 0.0,
        split_crossings: bool = False,
    ) -> None: ...

class Places:
    points: _Doubles
    polygons: list[list[_Doubles]]
    def __init__(
        self, points: ArrayLike = (), polygons: Iterable[Iterable[ArrayLike]] = ()
    ) -> None: ...

class Measure:
    of: Callable[..., _Doubles]
    name: str
    aggregate: str
    direction: str
    across_edges: bool
    needs_heights: bool
    def __init__(
        self,
        of: Callable[..., ArrayLike],
        aggregate: Literal["sum", "max", "min"] = "sum",
        direction: Literal["min", "max"] = "min",
        *,
        name: str | None = None,
        across_edges: bool = False,
        needs_heights: bool = False,
    ) -> None: ...

class Tin:
    xy: _Doubles
    z: _Doubles | None
    triangles: _Integers
    crs: str | None
    def __init__(self, points: ArrayLike, triangles: ArrayLike, crs: str | None = None) -> None: ...
    @property
    def has_heights(self) -> bool: ...
    @property
    def points(self) -> _Doubles: ...
    @property
    def gradient(self) -> _Doubles: ...
    def interpolate(self, xy: ArrayLike, *, threads: int | None = None) -> _Doubles: ...
    def find_triangle(self, xy: ArrayLike, *, threads: int | None = None) -> _Integers: ...
    def slope(self) -> _Doubles: ...
    def aspect(self) -> _Doubles: ...
    def area(self) -> _Doubles: ...
    def minima(self) -> _Integers: ...
    def maxima(self) -> _Integers: ...
    def boundary(self) -> _Integers: ...
    def contours(
        self,
        levels: ArrayLike | None = None,
        *,
        interval: float | None = None,
        base: float = 0.0,
    ) -> list[tuple[float, _Doubles]]: ...
    def pits(self) -> tuple[_Integers, _Doubles]: ...
    def check(self, edges: ArrayLike = (), *, threads: int | None = None) -> dict[str, Any]: ...
    def order(
        self, edges: ArrayLike = (), *, plain: bool = False, threads: int | None = None
    ) -> int: ...
    def write(self, path: _Path) -> None: ...
    def plot(self, ax: Any = None, *, edges: bool = True, **options: Any) -> Any: ...
    def to_meshio(self) -> Any: ...
    def to_pyvista(self) -> Any: ...
    def to_geodataframe(self) -> Any: ...
    def to_xarray(self, resolution: float) -> Any: ...

class Result:
    tin: Tin
    report: dict[str, Any]
    def __init__(self, tin: Tin, report: dict[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def _repr_html_(self) -> str: ...

class Delaunay:
    ndim: ClassVar[int]
    points: _Doubles
    simplices: _Integers
    neighbors: _Integers
    def __init__(self, points: ArrayLike, *, threads: int | None = None) -> None: ...
    @property
    def npoints(self) -> int: ...
    @property
    def nsimplex(self) -> int: ...
    @property
    def min_bound(self) -> _Doubles: ...
    @property
    def max_bound(self) -> _Doubles: ...
    @property
    def convex_hull(self) -> _Integers: ...
    @property
    def vertex_to_simplex(self) -> _Integers: ...
    @property
    def coplanar(self) -> _Integers: ...
    @property
    def vertex_neighbor_vertices(self) -> tuple[_Integers, _Integers]: ...
    @property
    def transform(self) -> _Doubles: ...
    def find_simplex(
        self, xi: ArrayLike, bruteforce: bool = False, tol: float | None = None
    ) -> _Integers: ...

class Voronoi:
    members: _Integers
    def __init__(self, members: _Integers, corners: _Doubles, first: NDArray[np.int64]) -> None: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[tuple[_Integers, _Doubles]]: ...
    def polygon(self, cell: int) -> _Doubles: ...

def delaunay(points: ArrayLike, *, threads: int | None = None) -> _Integers: ...
def triangulate(
    points: ArrayLike | Tin,
    k: float | None = None,
    objective: str | Measure = "min-local-minima",
    *,
    constraints: Constraints | None = None,
    method: _Method = "auto",
    time_limit: float = 0,
    min_pit_depth: float = 0,
    keep: ArrayLike | Places | _Path | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> Result: ...
def useful_edges(
    points: ArrayLike,
    k: float = 4,
    *,
    constraints: Constraints | None = None,
    threads: int | None = None,
) -> _Integers: ...
def kod_edges(
    points: ArrayLike,
    k: float = 4,
    *,
    constraints: Constraints | None = None,
    threads: int | None = None,
) -> _Integers: ...
def fixed_edges(
    points: ArrayLike,
    k: float = 4,
    *,
    constraints: Constraints | None = None,
    threads: int | None = None,
) -> _Integers: ...
def triangles(
    points: ArrayLike,
    k: float = 4,
    *,
    constraints: Constraints | None = None,
    threads: int | None = None,
) -> _Integers: ...
def kod_triangles(
    points: ArrayLike,
    k: float = 4,
    *,
    constraints: Constraints | None = None,
    threads: int | None = None,
) -> _Integers: ...
def order(
    tin: Tin, edges: ArrayLike = (), *, plain: bool = False, threads: int | None = None
) -> int: ...
def check(tin: Tin, edges: ArrayLike = (), *, threads: int | None = None) -> dict[str, Any]: ...
def voronoi(
    points: ArrayLike,
    m: int = 1,
    *,
    box: Sequence[float] | None = None,
    threads: int | None = None,
) -> Voronoi: ...
def compare(
    points: ArrayLike | Tin,
    orders: Iterable[int] | int = ...,
    objectives: str | Iterable[str] = "min-local-minima",
    *,
    constraints: Constraints | None = None,
    truth: ArrayLike | _Path | None = None,
    time_limit: float = 0,
    min_pit_depth: float = 0,
    keep: ArrayLike | Places | _Path | None = None,
    threads: int | None = None,
    progress: _Progress | None = None,
) -> dict[str, Any]: ...
def read_points(
    path: _Path, columns: Mapping[str, str | int] | None = None, *, threads: int | None = None
) -> _Doubles: ...
def read_tin(path: _Path) -> Tin: ...
def write_tin(tin: Tin, path: _Path) -> None: ...
def sample(
    name: str, n: int | None = None, seed: int = 1, *, threads: int | None = None
) -> _Doubles: ...
def terrains() -> dict[str, str]: ...
