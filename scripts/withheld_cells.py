#!/usr/bin/env python3
"""Writes cells of a raster that a sample of it left out, for `hodt compare --truth`.

    scripts/withheld_cells.py DIR/NAME > truth.csv

DIR/NAME holds full.csv.gz, all cells of the raster, and sample10000.csv; both with columns x, y, z.
Draws 100,000 cells at random, always the same.
"""

import csv
import gzip
import random
import sys


def rows(file):
    reader = csv.reader(file)
    next(reader)
    return [tuple(map(float, row[:3])) for row in reader]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with gzip.open(f"{sys.argv[1]}/full.csv.gz", "rt") as file:
        cells = rows(file)
    with open(f"{sys.argv[1]}/sample10000.csv") as file:
        sampled = {row[:2] for row in rows(file)}
    withheld = [cell for cell in cells if cell[:2] not in sampled]
    random.Random(1).shuffle(withheld)
    print("x,y,z")
    for x, y, z in withheld[:100_000]:
        print(f"{x!r},{y!r},{z!r}")


if __name__ == "__main__":
    main()
