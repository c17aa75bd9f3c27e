"""Which cells of a raster are measured: three ways to draw them, each from a seed.

Whatever is drawn inside, the border has a cell at every spacing and its corners, so that the TIN covers
the raster and every setting is judged by the same cells."""

import numpy as np


def border(shape, spacing):
    """Cells of the border, about so far apart, as a mask."""
    mask = np.zeros(shape, dtype=bool)
    for axis in (0, 1):
        along = np.linspace(0, shape[axis] - 1, max(2, round((shape[axis] - 1) / spacing) + 1)).round().astype(int)
        side = np.moveaxis(mask, axis, 0)
        side[along, 0] = side[along, -1] = True
    return mask


def random(shape, share, generator):
    """Inner cells, all with the same chance."""
    rows, columns = shape
    mask = np.zeros(shape, dtype=bool)
    inside = np.zeros((rows - 2) * (columns - 2), dtype=bool)
    inside[generator.choice(inside.size, round(share * inside.size), replace=False)] = True
    mask[1:-1, 1:-1] = inside.reshape(rows - 2, columns - 2)
    return mask


def jittered(shape, share, generator):
    """One cell anywhere in each square of a lattice."""
    mask = np.zeros(shape, dtype=bool)
    spacing = share**-0.5
    edges = [np.linspace(1, size - 1, round((size - 2) / spacing) + 1) for size in shape]
    row, column = np.meshgrid(edges[0][:-1], edges[1][:-1], indexing="ij")
    height, width = edges[0][1] - edges[0][0], edges[1][1] - edges[1][0]
    row = np.floor(row + height * generator.random(row.shape)).astype(int)
    column = np.floor(column + width * generator.random(column.shape)).astype(int)
    mask[np.minimum(row, shape[0] - 2), np.minimum(column, shape[1] - 2)] = True
    return mask


# Darts thrown at random cover so many discs of diameter 1 in a unit of area, when no other fits.
DISCS_THAT_FIT = 0.6966


def poisson(shape, share, generator):
    """As many cells as fit with none closer to another than a distance, taken in random order."""
    mask = np.zeros(shape, dtype=bool)
    distance = (DISCS_THAT_FIT / share) ** 0.5
    reach = int(distance)
    offset = np.arange(-reach, reach + 1)
    near = offset[:, None] ** 2 + offset**2 < distance**2
    taken = np.zeros((shape[0] + 2 * reach, shape[1] + 2 * reach), dtype=bool)
    inside = np.stack(np.meshgrid(*(np.arange(1, size - 1) for size in shape), indexing="ij"), -1).reshape(-1, 2)
    for row, column in generator.permutation(inside):
        if taken[row + reach, column + reach]:
            continue
        mask[row, column] = True
        taken[row : row + 2 * reach + 1, column : column + 2 * reach + 1] |= near
    return mask


KINDS = {"random": random, "jittered": jittered, "poisson": poisson}


def draw(raster, kind, share, seed):
    """Points (n, 3) at some of the cells, and which cells those are."""
    generator = np.random.default_rng([seed, round(1e6 * share), list(KINDS).index(kind)])
    mask = KINDS[kind](raster.z.shape, share, generator) | border(raster.z.shape, share**-0.5)
    places = raster.places()[mask.ravel()]
    return np.column_stack([places, raster.z[mask]]), mask
