"""Where water goes on a raster: filling, D8 directions and basins, all by WhiteboxTools (the package
whitebox-workflows)."""

import dataclasses
import pathlib
import tempfile

import numpy as np
import whitebox_workflows

HEADER = """ENVI
samples = {columns}
lines = {rows}
bands = 1
header offset = 0
file type = ENVI Standard
data type = 5
interleave = bsq
byte order = 0
map info = {{Arbitrary, 1, 1, 0, {top}, {dx}, {dy}, 0, units=Meters}}
"""


@dataclasses.dataclass(frozen=True)
class Flow:
    filled: np.ndarray  # heights with all pits filled to where they spill
    upstream: np.ndarray  # cells whose water passes here, this one included
    basin: np.ndarray  # a number for each outlet at the border


class Whitebox:
    """Tools that read a raster from a folder of their own. To be used in a with statement."""

    def __init__(self):
        self._tools = whitebox_workflows.WbEnvironment()
        self._tools.max_procs = 1
        self._tools.verbose = False

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="drainage")
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def _read(self, z, dx, dy):
        rows, columns = z.shape
        path = pathlib.Path(self._folder.name) / "heights.dat"
        z.astype("<f8").tofile(path)
        text = HEADER.format(rows=rows, columns=columns, top=rows * dy, dx=dx, dy=dy)
        path.with_suffix(".hdr").write_text(text)
        return self._tools.read_raster(str(path))

    def flow(self, z, dx, dy):
        """Of heights z, row 0 in the north, in cells of dx by dy."""
        hydrology = self._tools.hydrology
        dem = self._read(z, dx, dy)
        # By Wang and Liu: "fill_depressions" takes what leaves the raster through its border for pits.
        # Filled flats rise by a millionth of a metre, so that they drain.
        filled = hydrology.fill_depressions_wang_and_liu(dem=dem, fix_flats=True)
        pointer = hydrology.d8_pointer(dem=filled)
        upstream = hydrology.d8_flow_accum(input=pointer, out_type="cells", input_is_pointer=True)
        basin = hydrology.basins(d8_pntr=pointer)
        return Flow(*(raster.to_numpy(dtype="float64").reshape(z.shape) for raster in (filled, upstream, basin)))
