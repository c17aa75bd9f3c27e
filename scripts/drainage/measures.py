"""How well one raster knows another: heights, slopes, pits, streams and catchments."""

import numpy as np
from scipy import ndimage

STREAMS = (50, 200)  # cells upstream that make a stream
TOLERANCES = (1, 2)  # cells that it may be off
BASINS = 10
FILLED = 1e-4  # metres of water that make a pit: flats are made to drain by far less


def slope(z, dx, dy):
    """In degrees."""
    return np.degrees(np.arctan(np.hypot(*np.gradient(z, dy, dx))))


def root_mean_square(x):
    return float(np.sqrt(np.mean(np.square(x))))


def agreement(found, true, tolerance):
    """F1 of two masks: a cell is right if the other mask has one at most so many cells away, in rows
    and in columns. 1 if both are empty, 0 if one is."""
    if not found.any() or not true.any():
        return float(found.any() == true.any())
    square = np.ones((2 * tolerance + 1,) * 2, dtype=bool)
    precision = ndimage.binary_dilation(true, square)[found].mean()
    recall = ndimage.binary_dilation(found, square)[true].mean()
    return float(2 * precision * recall / (precision + recall)) if precision + recall else 0.0


def basin_agreement(found, true, count=BASINS):
    """The largest basins of the truth, each with the basin found that fits it best: shared cells by
    cells of either. Their mean."""
    found, found_size = np.unique(found, return_inverse=True, return_counts=True)[1:]
    true, true_size = np.unique(true, return_inverse=True, return_counts=True)[1:]
    fits = []
    for basin in np.argsort(-true_size, kind="stable")[:count]:
        shared = np.bincount(found.ravel()[true.ravel() == basin], minlength=len(found_size))
        fits.append((shared / (true_size[basin] + found_size - shared)).max())
    return float(np.mean(fits))


def height_measures(z, truth, dx, dy):
    error = z - truth
    return {
        "rmse": root_mean_square(error),
        "largest_error": float(np.abs(error).max()),
        "slope_error": root_mean_square(slope(z, dx, dy) - slope(truth, dx, dy)),
    }


def fill_measures(z, flow, dx, dy):
    depth = flow.filled - z
    return {
        "fill_volume": float(depth.sum() * dx * dy),
        "fill_depth": float(depth.max()),
        "fill_cells": int((depth > FILLED).sum()),
    }


def flow_measures(flow, true):
    result = {}
    for upstream in STREAMS:
        for tolerance in TOLERANCES:
            result[f"f1_{upstream}_{tolerance}"] = agreement(
                flow.upstream > upstream, true.upstream > upstream, tolerance)
    result["basins"] = basin_agreement(flow.basin, true.basin)
    return result
