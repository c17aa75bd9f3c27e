#!/usr/bin/env python3
"""Tables of what scripts/drainage_experiment.py measured, as Markdown.

    scripts/drainage_tables.py RUNS.csv [--share 0.1]

For each terrain and setting the means over all samples, compared with the Delaunay triangulation (none@0) of
the same sample: change of the error of heights and of the volume that fills the pits in %, and of the
agreement of streams; behind each the standard deviation.
"""

import argparse
import collections
import pathlib

import numpy as np

from drainage import records, terrains

# The name of a measure, its column, and whether it is compared as a ratio.
MEASURES = (("RMSE", "rmse", True), ("fill volume", "fill_volume", True), ("streams", "f1_50_1", False),
            ("slope error", "slope_error", True), ("basins", "basins", False))


CONTOURS = "bigtujunga, contours"
# Of the largest there is.
NOTHING = 1e-6


def name_of(row):
    return CONTOURS if row["kind"] == "contours" else row["terrain"]


def changes(rows):
    """(terrain, setting) -> measure -> change for each sample."""
    def sample(row):
        return tuple(row[name] for name in ("terrain", "kind", "share", "seed"))

    plain = {sample(row): row for row in rows if row["objective"] == "none"}
    largest = collections.defaultdict(float)
    for row in plain.values():
        for _, column, _ in MEASURES:
            largest[row["terrain"], column] = max(largest[row["terrain"], column], row[column] or 0)
    found = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        before = plain.get(sample(row))
        if before is None or row["objective"] == "none":
            continue
        setting = f"{row['objective']}@{int(row['k'])}"
        for _, column, is_ratio in MEASURES:
            now, then = row[column], before[column]
            if now is None or then is None:
                continue
            if is_ratio and then <= NOTHING * largest[row["terrain"], column]:
                continue  # no water to fill but for rounding: to be compared with nothing
            found[name_of(row), setting][column].append(100 * (now / then - 1) if is_ratio else now - then)
    return found


def cell(values, is_ratio):
    if not values:
        return "–"
    mean, spread = np.mean(values), np.std(values)
    return f"{mean:+.1f} % ± {spread:.1f}" if is_ratio else f"{mean:+.3f} ± {spread:.3f}"


def table(found, names):
    """Of these terrains, then of all of them alike."""
    settings = list(dict.fromkeys(setting for _, setting in found))
    print("| terrain | setting | " + " | ".join(name for name, _, _ in MEASURES) + " | samples |")
    print("|---|---|" + "---|" * (len(MEASURES) + 1))
    for setting in settings:
        known = [name for name in names if (name, setting) in found]
        for name in known:
            row = found[name, setting]
            cells = [cell(row[column], is_ratio) for _, column, is_ratio in MEASURES]
            print(f"| {name} | `{setting}` | " + " | ".join(cells) + f" | {len(row['rmse'])} |")
        if len(known) > 1:
            means = {column: [np.mean(found[name, setting][column]) for name in known if found[name, setting][column]]
                     for _, column, _ in MEASURES}
            cells = [cell(means[column], is_ratio) for _, column, is_ratio in MEASURES]
            print(f"| **all** | `{setting}` | " + " | ".join(cells) + " | |")
    print()


def points_table(found):
    """Of points, heights alone are known: a row for each set."""
    settings = list(dict.fromkeys(setting for name, setting in found if name in terrains.POINTS))
    print("| RMSE | " + " | ".join(f"`{setting}`" for setting in settings) + " |")
    print("|---|" + "---|" * len(settings))
    for name in terrains.POINTS:
        if any(key[0] == name for key in found):
            cells = [cell(found[name, setting]["rmse"], True) for setting in settings]
            print(f"| {name} | " + " | ".join(cells) + " |")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("runs", type=pathlib.Path, metavar="RUNS.csv")
    parser.add_argument("--share", help="only samples of so much of the cells")
    arguments = parser.parse_args()
    rows = [row for row in records.read(arguments.runs).values() if arguments.share in (None, row["share"])]
    found = changes(rows)
    for title, names in (("Where the setting was chosen", terrains.CHOOSING), ("Where it is shown", terrains.SHOWING),
                         ("Contours of a raster", (CONTOURS,))):
        if any(name in names for name, _ in found):
            print(f"### {title}\n")
            table(found, names)
    if any(name in terrains.POINTS for name, _ in found):
        print("### Points, compared with the others of their set\n")
        points_table(found)


if __name__ == "__main__":
    main()
