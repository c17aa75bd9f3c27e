#!/usr/bin/env python3
"""How near to the second objective alone objectives in order come: a table of docs/experiments.md.

    scripts/in_order_table.py --data DIR [--hodt build/release/hodt] [--then min-sum-abn]

For each terrain and order k: local minima of the Delaunay triangulation, of `min-local-minima`, and
of the second objective alone; and how much worse, in percent, the second objective's value is in
order than alone.
"""

import argparse
import pathlib
import tempfile

from run_hodt import triangulated

TERRAINS = [
    ("whitebox_dem", "sample10000.csv"),
    ("jacksboro", "sample10000.csv"),
    ("bigtujunga", "sample10000.csv"),
    ("swiss_sic97", "sample10000.csv"),
    ("olinda", "full.csv"),
    ("lidar_quebec", "ground.csv"),
    ("lidar_delft_east", "sample10000.csv"),
    ("baja_soundings", "sample10000.csv"),
    ("glacier_contours", "points.csv"),
]
FIRST = "min-local-minima"


def minima(report, stage):
    return sum(report["local_minima"][stage].values())


def table(arguments, folder):
    def report(points, k, objective):
        return triangulated(arguments.hodt, points, folder, "-k", k, "--objective", objective)

    print(f"| | k | minima: Delaunay | in order | `{arguments.then}` alone | "
          f"`{arguments.then}`: Delaunay | alone | in order | distance |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, file in TERRAINS:
        points = arguments.data / name / file
        for k in map(int, arguments.orders.split(",")):
            alone = report(points, k, arguments.then)
            both = report(points, k, f"{FIRST},{arguments.then}")
            ordered, second = both["then"][0]["value"], alone["value"]
            distance = 100 * (ordered["result"] / second["result"] - 1)
            proven = " (proven best)" if ordered["optimal"] else ""
            print(f"| {name} | {k} | {minima(both, 'delaunay')} | {minima(both, 'result')} | "
                  f"{minima(alone, 'result')} | {second['delaunay']:.0f} | "
                  f"{second['result']:.0f} | {ordered['result']:.0f} | {distance:.2f} %{proven} |",
                  flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--hodt", default="build/release/hodt")
    parser.add_argument("--then", default="min-sum-abn")
    parser.add_argument("--orders", default="1,4,8")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        table(arguments, pathlib.Path(folder))


if __name__ == "__main__":
    main()
