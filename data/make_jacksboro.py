#!/usr/bin/env python3
"""Makes data/jacksboro.csv: 10,000 points of an SRTM grid, projected to UTM zone 16N.

Reads the sample that comes with matplotlib (Debian: python-matplotlib-data) and draws grid cells
with a fixed seed. Needs numpy. Without arguments it writes jacksboro.csv beside itself and prints
the sha256 of source and result; data/README.md says what they are.

    python3 data/make_jacksboro.py [SOURCE.npz [RESULT.csv]]
"""
import hashlib
import math
import pathlib
import sys

import numpy as np

SOURCE = "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"
POINTS = 10_000
SEED = 2002  # the year of the paper

# WGS 84, and UTM zone 16 north (EPSG:32616)
SEMI_MAJOR_AXIS = 6378137.0
FLATTENING = 1 / 298.257223563
SCALE = 0.9996
CENTRAL_MERIDIAN = -87.0
FALSE_EASTING = 500000.0


def transverse_mercator(longitude, latitude):
    """Krueger's series in the third flattening n, up to n^4: below a micrometre in a zone."""
    n = FLATTENING / (2 - FLATTENING)
    radius = SEMI_MAJOR_AXIS / (1 + n) * (1 + n**2 / 4 + n**4 / 64)
    series = (
        n / 2 - 2 * n**2 / 3 + 5 * n**3 / 16 + 41 * n**4 / 180,
        13 * n**2 / 48 - 3 * n**3 / 5 + 557 * n**4 / 1440,
        61 * n**3 / 240 - 103 * n**4 / 140,
        49561 * n**4 / 161280,
    )
    eccentricity = math.sqrt(FLATTENING * (2 - FLATTENING))
    phi = np.radians(latitude)
    lam = np.radians(longitude - CENTRAL_MERIDIAN)

    # The latitude on a sphere with the same angles, then that sphere's own transverse Mercator.
    sin_phi = np.sin(phi)
    t = np.sinh(np.arctanh(sin_phi) - eccentricity * np.arctanh(eccentricity * sin_phi))
    xi = np.arctan2(t, np.cos(lam))
    eta = np.arcsinh(np.sin(lam) / np.hypot(t, np.cos(lam)))

    east, north = eta, xi
    for j, a in enumerate(series, start=1):
        east = east + a * np.cos(2 * j * xi) * np.sinh(2 * j * eta)
        north = north + a * np.sin(2 * j * xi) * np.cosh(2 * j * eta)
    return FALSE_EASTING + SCALE * radius * east, SCALE * radius * north


def sample(source):
    with np.load(source) as file:
        z = file["elevation"]
        step = float(file["dx"])
        west = float(file["xmin"])
        # The file's ymin is the northern edge, and its first row the northernmost.
        north = max(float(file["ymin"]), float(file["ymax"]))
    # RandomState's stream is frozen by numpy's compatibility policy.
    cells = np.random.RandomState(SEED).permutation(z.size)[:POINTS]
    row, column = np.divmod(np.sort(cells), z.shape[1])
    x, y = transverse_mercator(west + (column + 0.5) * step, north - (row + 0.5) * step)
    return x, y, z[row, column]


def sha256(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def main(source=SOURCE, result=pathlib.Path(__file__).with_name("jacksboro.csv")):
    rows = [f"{x:.1f},{y:.1f},{z}\n" for x, y, z in zip(*sample(source))]
    pathlib.Path(result).write_text("x,y,z\n" + "".join(rows))
    print(f"{sha256(source)}  {source}\n{sha256(result)}  {result}")


if __name__ == "__main__":
    main(*sys.argv[1:])
