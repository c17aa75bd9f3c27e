#!/usr/bin/env python3
"""Compares what hodt reads from LAS and LAZ files with what laspy reads, on every point format, and
from files that lazrs, LASzip and, where node has it, laz-perf write or read.

    tests/io/check_las.py HODT [--points N] [FILE...]

HODT is the command. FILEs are compared too. Needs numpy and laspy with lazrs; without them it says
so and exits with 77. laspy's other backend, laszip, is used if it is there; laz-perf if
NODE_PATH leads to it. Prints a line for each file, and exits 1 if any differs.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import laspy
    import lazrs  # noqa: F401
    import numpy as np

    import make_las_fixtures as fixtures
except ImportError as error:
    print(f"skipped: {error}", file=sys.stderr)
    sys.exit(77)

CHOICES = [(None, None), ("all", None), ("2,5", "last"), ("all", "first")]

LAZ_PERF = """
const { createLazPerf } = require('laz-perf');
const fs = require('fs');
(async () => {
  const lib = await createLazPerf();
  const file = fs.readFileSync(process.argv[2]);
  const from = lib._malloc(file.byteLength);
  lib.HEAPU8.set(file, from);
  const zip = new lib.LASZip();
  zip.open(from, file.byteLength);
  const size = zip.getPointLength(), count = zip.getCount();
  const to = lib._malloc(size);
  const points = Buffer.alloc(size * count);
  for (let i = 0; i < count; ++i) {
    zip.getPoint(to);
    points.set(lib.HEAPU8.subarray(to, to + size), i * size);
  }
  fs.writeFileSync(process.argv[3], points);
})();
"""


def wanted(las, classes, returns):
    """x, y and z of the points that should be taken, by the definitions."""
    kind = np.asarray(las.classification)
    number, count = np.asarray(las.return_number), np.asarray(las.number_of_returns)
    taken = ~np.asarray(las.withheld, bool)
    if classes is None and (taken & (kind == 2)).any():
        taken &= kind == 2
    elif classes not in (None, "all"):
        taken &= np.isin(kind, [int(c) for c in classes.split(",")])
    if returns == "last":
        taken &= number == count
    if returns == "first":
        taken &= number <= 1
    scales, offsets = las.header.scales, las.header.offsets
    stored = (las.X, las.Y, las.Z)
    return np.stack([np.asarray(a)[taken] * s + o for a, s, o in zip(stored, scales, offsets)], 1)


def without_duplicates(points):
    """What a triangulation keeps: the first of the lowest at each place, in their order."""
    order = np.lexsort((np.arange(len(points)), points[:, 2], points[:, 1], points[:, 0]))
    at = points[order]
    first = np.r_[True, (at[1:, :2] != at[:-1, :2]).any(1)]
    return points[np.sort(order[first])]


def read_by_hodt(hodt, file, classes, returns, folder):
    """The vertices of a mesh of the points."""
    mesh = folder / "mesh.ply"
    command = [hodt, "triangulate", file, "-o", mesh, "-k", "0", "--objective", "none"]
    command += ["--las-class", classes] if classes else []
    command += ["--las-return", returns] if returns else []
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return done.stderr.strip()
    content = mesh.read_bytes()
    header, body = content.split(b"end_header\n", 1)
    count = int(header.split(b"element vertex ")[1].split()[0])
    return np.frombuffer(body, "<f8", 3 * count).reshape(-1, 3)


def difference(hodt, file, las, folder):
    for classes, returns in CHOICES:
        want = without_duplicates(wanted(las, classes, returns))
        got = read_by_hodt(hodt, file, classes, returns, folder)
        if isinstance(got, str):
            return f"{classes} {returns}: {got}"
        if got.shape != want.shape or not (got == want).all():
            return f"{classes} {returns}: {len(got)} points, not the {len(want)} expected"
    return ""


def laz_perf_differs(file, las, folder):
    """Whether laz-perf reads other bytes from the file than laspy wrote; None without laz-perf."""
    if shutil.which("node") is None or "NODE_PATH" not in os.environ:
        return None
    script, raw = folder / "read.js", folder / "raw"
    script.write_text(LAZ_PERF)
    done = subprocess.run(["node", script, file, raw], capture_output=True, text=True)
    if done.returncode != 0:
        return done.stderr.strip().splitlines()[-1]
    got = np.frombuffer(raw.read_bytes(), las.points.array.dtype)
    return "" if all((got[axis] == las.points.array[axis]).all() for axis in "XYZ") else "differs"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hodt")
    parser.add_argument("--points", type=int, default=30000)
    parser.add_argument("files", nargs="*")
    arguments = parser.parse_args()
    failed = 0

    def tell(name, problem):
        nonlocal failed
        failed += bool(problem)
        print(f"{name}: {problem or 'the same'}", flush=True)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for point_format in range(11):
            las = fixtures.points_of(point_format, arguments.points)
            files = {"las": folder / f"{point_format}.las"}
            las.write(files["las"])
            for backend in laspy.LazBackend.detect_available():
                file = files[backend.name] = folder / f"{point_format}_{backend.name}.laz"
                las.write(file, do_compress=True, laz_backend=backend)
            chunks = [1, 7, arguments.points // 2, arguments.points - arguments.points // 2 - 8]
            if point_format not in (9, 10):
                files["variable"] = folder / f"{point_format}_variable.laz"
                record = fixtures.laszip_record(las, 0xFFFFFFFF)
                files["variable"].write_bytes(fixtures.compressed(las, record, chunks))
            for kind, file in files.items():
                tell(f"format {point_format}, {kind}", difference(arguments.hodt, file, las, folder))
            peer = laz_perf_differs(files.get("Laszip", files["Lazrs"]), las, folder)
            if peer is not None and point_format in (0, 1, 2, 3, 6, 7, 8):
                tell(f"format {point_format}, laz-perf and laspy", peer)
        for file in arguments.files:
            las = laspy.read(file)
            tell(file, difference(arguments.hodt, file, las, folder))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
