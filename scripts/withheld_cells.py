#!/usr/bin/env python3
"""Writes points that a sample left out, for `hodt compare --truth`.

    scripts/withheld_cells.py FULL.csv.gz SAMPLE.csv > truth.csv

FULL holds all points, SAMPLE some of them; both with columns x, y, z. Draws at most 100,000 of the
others at random, always the same.
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
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with gzip.open(sys.argv[1], "rt") as file:
        cells = rows(file)
    with open(sys.argv[2]) as file:
        sampled = {row[:2] for row in rows(file)}
    withheld = [cell for cell in cells if cell[:2] not in sampled]
    random.Random(1).shuffle(withheld)
    print("x,y,z")
    for x, y, z in withheld[:100_000]:
        print(f"{x!r},{y!r},{z!r}")


if __name__ == "__main__":
    main()
