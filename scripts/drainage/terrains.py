"""The terrains of the experiment: rasters, and sets of points, in a folder with one for each."""

import dataclasses
import functools
import pathlib

import numpy as np


@dataclasses.dataclass(frozen=True)
class Raster:
    """Heights of cells: row 0 is in the north, z[r, c] at x = c * dx and y = (rows - 1 - r) * dy."""

    z: np.ndarray
    dx: float
    dy: float

    def places(self):
        """The centres of the cells, row by row: (n, 2)."""
        rows, columns = self.z.shape
        x, y = np.meshgrid(np.arange(columns) * self.dx, np.arange(rows)[::-1] * self.dy)
        return np.column_stack([x.ravel(), y.ravel()])


def read_table(path):
    """The columns x, y, z of a CSV file, also gzipped: (n, 3)."""
    return np.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1, 2))


def raster_of_cells(cells):
    """The raster that these cells are all of, in whatever order. One that was turned a little, by a
    change of coordinates, has to come row by row from the north, and is turned back."""
    columns, rows = (np.unique(cells[:, i]) for i in (0, 1))
    if len(columns) * len(rows) == len(cells):
        order = np.lexsort((cells[:, 0], -cells[:, 1]))
        z = cells[order, 2].reshape(len(rows), len(columns))
        return Raster(z, np.diff(columns).mean(), np.diff(rows).mean())
    width = int(np.flatnonzero(np.diff(cells[:, 0]) < 0)[0]) + 1
    if len(cells) % width:
        raise ValueError("the cells are not a raster")
    grid = cells.reshape(-1, width, 3)
    dx, dy = (np.linalg.norm(np.diff(grid[..., :2], axis=axis), axis=-1).mean() for axis in (1, 0))
    return Raster(grid[..., 2], dx, dy)


def full_cells(folder):
    return read_table(next(path for path in (folder / "full.csv.gz", folder / "full.csv") if path.exists()))


def whole(folder):
    return raster_of_cells(full_cells(folder))


# The part of bigtujunga that its file of contours is of.
WINDOW_ROWS, WINDOW_COLUMNS = slice(150, 450), slice(400, 700)
WINDOW_ORIGIN = (376313.655 + 15 + 400 * 30, 3788627.828 + 19275 - 449 * 30)


def window(folder):
    raster = whole(folder)
    return Raster(raster.z[WINDOW_ROWS, WINDOW_COLUMNS], raster.dx, raster.dy)


# In the order of the alphabet; the setting is chosen on every other one, and shown on those between.
RASTERS = {
    "bigtujunga": window,
    "jacksboro": whole,
    "olinda": whole,
    "swiss_sic97": whole,
    "volcano": whole,
    "whitebox_dem": whole,
}
CHOOSING = tuple(RASTERS)[0::2]
SHOWING = tuple(RASTERS)[1::2]

# Sets of points whose truth is known where they lie only.
POINTS = {
    "lidar_quebec": "ground.csv",
    "lidar_delft_east": "ground.csv.gz",
    "baja_soundings": "points.csv.gz",
    "glacier_contours": "points.csv",
    "meuse_alt": "points.csv",
    "mesh_merimbula": "nodes.csv",
}


@functools.lru_cache(maxsize=1)
def read_raster(data, name):
    return RASTERS[name](pathlib.Path(data) / name)


@functools.lru_cache(maxsize=1)
def read_points(data, name):
    """The points moved to their middle, one of each place."""
    points = read_table(pathlib.Path(data) / name / POINTS[name])
    _, first = np.unique(points[:, :2], axis=0, return_index=True)
    points = points[np.sort(first)]
    points[:, :2] -= points[:, :2].mean(axis=0).round()
    return points


def read_contours(data):
    """The contours of bigtujunga's window in the coordinates of its raster."""
    points = read_table(pathlib.Path(data) / "bigtujunga" / "contour_40m.csv")
    points[:, :2] -= WINDOW_ORIGIN
    return points
