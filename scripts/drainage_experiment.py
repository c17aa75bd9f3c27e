#!/usr/bin/env python3
"""How true a TIN of some cells of a raster is, and how it drains: heights, pits, streams, catchments.

    scripts/drainage_experiment.py --data DIR --out RUNS.csv [--settings none@0 min-sum-abn@8 ...]

Draws samples of the rasters in DIR, triangulates each for every setting, an objective and its k, puts the
surface on the raster's cells, lets water flow, and compares with the raster itself. Adds a row to RUNS.csv
for each TIN, and leaves out what is there already. scripts/drainage_tables.py makes tables of it.

Needs the packages of scripts/drainage/requirements.txt, and hodt's own: see docs/drainage.md.
"""

import argparse
import pathlib
import time

import numpy as np

import hodt
from drainage import measures, samples, terrains
from drainage.candidates import objective_of
from drainage.flow import Whitebox
from drainage.records import Records

SETTINGS = ("none@0", "min-local-minima@8", "min-sum-abn@4", "min-sum-abn@8")
SHARES = ("0.01", "0.03", "0.1")


def parsed_setting(text):
    objective, _, k = text.rpartition("@")
    if not objective or not k.isdecimal():
        raise argparse.ArgumentTypeError(f"{text!r} is not OBJECTIVE@K")
    return objective, int(k)


def triangulated(points, row):
    start = time.perf_counter()
    result = hodt.triangulate(points, row["k"], objective_of(row["objective"]), threads=1)
    row.update(points=len(points), seconds=round(time.perf_counter() - start, 3),
               minima=sum(result.local_minima["result"].values()))
    return result.tin


class Truth:
    """A raster and where its water goes."""

    def __init__(self, raster, tools):
        self.raster, self.tools = raster, tools
        self.flow = tools.flow(raster.z, raster.dx, raster.dy)

    def measured(self, tin):
        """A TIN against the raster. Where the TIN has no surface, the raster's own is taken."""
        raster = self.raster
        z = tin.interpolate(raster.places(), threads=1).reshape(raster.z.shape)
        z = np.where(np.isnan(z), raster.z, z)
        flow = self.tools.flow(z, raster.dx, raster.dy)
        size = raster.dx, raster.dy
        return (measures.height_measures(z, raster.z, *size) | measures.fill_measures(z, flow, *size)
                | measures.flow_measures(flow, self.flow))


def withheld(points, share, seed):
    """Some of the points, and the others."""
    order = np.random.default_rng([seed, round(1e6 * share)]).permutation(len(points))
    count = round(share * len(points))
    return points[np.sort(order[:count])], points[order[count:]]


def measured_at(tin, points):
    error = tin.interpolate(points[:, :2], threads=1) - points[:, 2]
    error = error[~np.isnan(error)]
    return {"rmse": measures.root_mean_square(error), "largest_error": float(np.abs(error).max())}


def missing(arguments, records, sample):
    """The settings that are not known yet for a sample."""
    rows = [sample | {"objective": objective, "k": k} for objective, k in arguments.settings]
    return [row for row in rows if row not in records]


def run(rows, points, measure, records):
    for row in rows:
        tin = triangulated(points, row)
        records.add(row | {name: float(f"{value:.8g}") for name, value in measure(tin).items()})


def raster_samples(arguments):
    for seed in range(1, arguments.seeds + 1):
        for share in arguments.shares:
            for kind in arguments.kinds:
                yield {"kind": kind, "share": share, "seed": seed}


def run_raster(name, arguments, records, tools):
    truth = None
    for sample in raster_samples(arguments):
        if rows := missing(arguments, records, {"terrain": name} | sample):
            truth = truth or Truth(terrains.read_raster(arguments.data, name), tools)
            points, _ = samples.draw(truth.raster, sample["kind"], float(sample["share"]), sample["seed"])
            run(rows, points, truth.measured, records)
            print(name, *sample.values(), len(points), "points", flush=True)


def run_contours(arguments, records, tools):
    if rows := missing(arguments, records, {"terrain": "bigtujunga", "kind": "contours", "share": "", "seed": 1}):
        truth = Truth(terrains.read_raster(arguments.data, "bigtujunga"), tools)
        run(rows, terrains.read_contours(arguments.data), truth.measured, records)


def run_points(name, arguments, records):
    for seed in range(1, arguments.seeds + 1):
        for share in arguments.shares:
            if rows := missing(arguments, records, {"terrain": name, "kind": "withheld", "share": share, "seed": seed}):
                some, others = withheld(terrains.read_points(arguments.data, name), float(share), seed)
                run(rows, some, lambda tin: measured_at(tin, others), records)
                print(name, share, seed, len(some), "points", flush=True)


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--data", type=pathlib.Path, required=True, help="folder of the terrains")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="CSV file, added to")
    parser.add_argument("--settings", nargs="+", type=parsed_setting, default=[parsed_setting(s) for s in SETTINGS],
                        metavar="OBJECTIVE@K", help="any objective, also a list, or own:NAME of drainage/candidates.py")
    parser.add_argument("--terrains", nargs="+", default=list(terrains.RASTERS),
                        choices=[*terrains.RASTERS, *terrains.POINTS, "contours"])
    parser.add_argument("--kinds", nargs="+", default=list(samples.KINDS), choices=list(samples.KINDS))
    parser.add_argument("--shares", nargs="+", default=list(SHARES), help="of the cells, or points, that are drawn")
    parser.add_argument("--seeds", type=int, default=5, help="how many")
    return parser.parse_args()


def main():
    arguments = arguments_of()
    records = Records(arguments.out)
    with Whitebox() as tools:
        for name in arguments.terrains:
            if name in terrains.RASTERS:
                run_raster(name, arguments, records, tools)
            elif name == "contours":
                run_contours(arguments, records, tools)
            else:
                run_points(name, arguments, records)


if __name__ == "__main__":
    main()
