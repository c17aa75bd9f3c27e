#!/usr/bin/env python3
"""Prints the table of docs/experiments.md: local minima for growing orders.

    scripts/minima_table.py --data DIR [--hodt build/release/hodt] [NAME ...]

DIR holds NAME/sample10000.csv, 10,000 points each. Without DIR, the built-in terrains.
"""

import argparse
import pathlib
import subprocess
import tempfile

from run_hodt import triangulated

ORDERS = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 48, 96]


def row(report):
    value = report["value"]
    interior = report["local_minima"]["result"]["interior"]
    seconds = report["seconds"]["delaunay"] + report["seconds"]["optimize"]
    delaunay_triangles = report["order_histogram"][0] / report["triangles"]
    proof = "optimal" if value["optimal"] else "gap %d" % (value["result"] - value["bound"])
    return "| %d | %d | %d | %d | %s | %d | %.1f %% | %.3f |" % (
        report["k"], value["result"], interior, value["bound"], proof, report["order"],
        100 * delaunay_triangles, seconds)


def table(hodt, name, points, folder):
    print("\n### %s\n" % name)
    print("| k | minima | interior | bound | | largest order | triangles of order 0 | seconds |")
    print("|---|---|---|---|---|---|---|---|")
    for order in ORDERS:
        print(row(triangulated(hodt, points, folder, "-k", order)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", help="folders of DIR, or built-in terrains")
    parser.add_argument("--data", type=pathlib.Path)
    parser.add_argument("--hodt", default="build/release/hodt")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for name in arguments.names or ["jacksboro", "valley"]:
            if arguments.data:
                points = arguments.data / name / "sample10000.csv"
            else:
                points = folder / (name + ".csv")
                subprocess.run([arguments.hodt, "sample", name, "-o", str(points)], check=True)
            table(arguments.hodt, name, points, folder)


if __name__ == "__main__":
    main()
