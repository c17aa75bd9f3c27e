"""What the drainage experiment measures, on rasters where the values are known."""

import pathlib
import sys

import numpy as np
import pytest

ndimage = pytest.importorskip("scipy.ndimage")
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from drainage import measures, terrains  # noqa: E402


def mask(*cells):
    result = np.zeros((9, 9), dtype=bool)
    for cell in cells:
        result[cell] = True
    return result


def test_agreement_of_streams():
    stream = mask((4, 1), (4, 2), (4, 3), (4, 4))
    assert measures.agreement(stream, stream, 1) == 1
    assert measures.agreement(mask((5, 1), (5, 2), (5, 3), (5, 4)), stream, 1) == 1
    assert measures.agreement(mask((6, 1), (6, 2)), stream, 1) == 0
    # All of what is found is right, and of the four cells three are near it: 2 * 1 * 0.75 / 1.75.
    assert measures.agreement(mask((4, 1), (4, 2)), stream, 1) == pytest.approx(6 / 7)
    assert measures.agreement(mask(), mask(), 1) == 1 and measures.agreement(mask(), stream, 1) == 0


def test_agreement_of_basins():
    true = np.repeat([[1] * 6 + [2] * 4], 10, axis=0)
    found = np.repeat([[7] * 8 + [9] * 2], 10, axis=0)
    assert measures.basin_agreement(true, true) == 1
    assert measures.basin_agreement(found, true) == pytest.approx((60 / 80 + 20 / 40) / 2)


def test_heights_and_slopes():
    x, y = np.meshgrid(np.arange(12) * 5.0, np.arange(9) * 10.0)
    plane = x * np.tan(np.radians(30))
    assert measures.slope(plane, 5, 10) == pytest.approx(30)
    known = measures.height_measures(plane + 2, plane, 5, 10)
    assert known["rmse"] == pytest.approx(2) and known["largest_error"] == pytest.approx(2)
    assert known["slope_error"] == pytest.approx(0, abs=1e-9)


def test_cells_of_a_raster_in_any_order():
    z = np.arange(12.0).reshape(3, 4)
    x, y = np.meshgrid(np.arange(4) * 2.0, np.arange(3)[::-1] * 5.0)
    cells = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    raster = terrains.raster_of_cells(cells[np.random.default_rng(1).permutation(12)])
    assert np.array_equal(raster.z, z) and (raster.dx, raster.dy) == (2, 5)
    assert np.array_equal(raster.places(), cells[:, :2])


def flow_of(z, dx=10.0, dy=10.0):
    pytest.importorskip("whitebox_workflows")
    from drainage.flow import Whitebox

    with Whitebox() as tools:
        return tools.flow(z, dx, dy)


def filled_by_relaxing(z):
    """The lowest surface, no lower than z, from which water leaves: by its definition, over and over."""
    filled = np.full_like(z, z.max())
    border = np.ones(z.shape, dtype=bool)
    border[1:-1, 1:-1] = False
    filled[border] = z[border]
    while True:
        lowest = ndimage.minimum_filter(filled, size=3, mode="nearest")
        lower = np.where(border, z, np.maximum(z, lowest))
        if np.array_equal(lower, filled):
            return filled
        filled = lower


@pytest.mark.parametrize("seed", range(4))
def test_filling_lets_water_leave_anywhere_on_the_border(seed):
    rough = np.random.default_rng(seed).random((40, 50))
    z = np.round(1000 * ndimage.gaussian_filter(rough, 3), 1)
    flow = flow_of(z)
    assert flow.filled == pytest.approx(filled_by_relaxing(z), abs=1e-5)
    # All water leaves: the basins are those of outlets at the border, and together are all cells.
    border = np.ones(z.shape, dtype=bool)
    border[1:-1, 1:-1] = False
    outlets = [flow.upstream[(flow.basin == basin) & border].max() for basin in np.unique(flow.basin)]
    assert sum(outlets) == z.size


def test_water_that_fills_a_pit():
    z = np.repeat(100.0 + np.arange(20)[:, None], 25, axis=1)
    z[8:11, 5:9] = 90  # spills at 107, in the row to the north
    z[9, 6] = 80
    flow = flow_of(z, 10, 20)
    known = measures.fill_measures(z, flow, 10, 20)
    assert known["fill_volume"] == pytest.approx((12 * 17 + 10) * 10 * 20, abs=1)
    assert known["fill_depth"] == pytest.approx(27, abs=1e-3) and known["fill_cells"] == 12
    same = measures.flow_measures(flow, flow)
    assert all(value == 1 for value in same.values())
