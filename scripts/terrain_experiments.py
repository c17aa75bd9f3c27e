#!/usr/bin/env python3
"""What each order gains on eight terrains: the tables of docs/experiments.md, and its picture.

    scripts/terrain_experiments.py --data DIR --out OUT [--hodt build/release/hodt]

Runs `hodt compare` for each terrain, unless OUT/NAME.json is there from before, prints the tables
and writes OUT/gains.svg. DIR holds the points, as TERRAINS names them.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys

# Name, points, and all points that those were drawn from, if they were.
TERRAINS = [
    ("whitebox_dem", "sample10000.csv", "full.csv.gz"),
    ("jacksboro", "sample10000.csv", "full.csv.gz"),
    ("swiss_sic97", "sample10000.csv", "full.csv.gz"),
    ("olinda", "full.csv", None),
    ("lidar_quebec", "ground.csv", None),
    ("lidar_delft_east", "sample10000.csv", "ground.csv.gz"),
    ("baja_soundings", "sample10000.csv", "points.csv.gz"),
    ("glacier_contours", "points.csv", None),
]
OBJECTIVES = [
    "min-local-minima", "min-local-extrema", "min-sum-flat-area", "min-sum-abn", "min-sum-jnd",
    "min-sum-length", "max-sum-small-angle", "max-min-small-angle", "min-max-angle",
]

def compared(name, points, full, arguments):
    """What hodt compare says of a terrain, from OUT if it is there."""
    result = arguments.out / (name + ".json")
    if not result.exists():
        print("comparing", name, file=sys.stderr)
        points = arguments.data / name / points
        command = [arguments.hodt, "compare", points, "--orders", "0-8", "--objective",
                   ",".join(OBJECTIVES), "--json", result]
        if full:
            truth = arguments.out / (name + "_truth.csv")
            with open(truth, "w") as file:
                subprocess.run([pathlib.Path(__file__).parent / "withheld_cells.py",
                                arguments.data / name / full, points], stdout=file, check=True)
            command += ["--truth", truth]
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    return json.loads(result.read_text())


def rows_of(comparison, objective):
    return next(o["rows"] for o in comparison["objectives"] if o["objective"] == objective)


def change(after, before):
    """In percent; None of nothing."""
    return 100 * (after - before) / abs(before) if before else None


def percent(value):
    if value is None:
        return "–"
    text = "%.1f" % abs(value)
    return ("0" if float(text) == 0 else ("−" if value < 0 else "+") + text) + " %"


def table(headings, rows):
    print("\n| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(row) + " |")


def number(value):
    """With four digits, readable."""
    if value == 0 or 0.001 <= abs(value) < 1e5:
        return "%.4g" % value if abs(value) < 1e4 else "%.0f" % value
    digits, power = ("%.2e" % value).split("e")
    return "%se%d" % (digits, int(power))


def pit_table(results, objective, orders):
    """What an objective does to the pits: their number, depth and volume."""
    rows = []
    for name, comparison in results.items():
        before = comparison["delaunay_pits"]
        runs = rows_of(comparison, objective)
        row = [name]
        for total in ("interior_minima", "total_depth", "volume"):
            row.append(number(before[total]))
            row += [percent(change(runs[k]["pits"][total], before[total])) for k in orders]
        rows.append(row)
    at = ["k = %d" % k for k in orders]
    table(["`%s`" % objective, "interior minima"] + at + ["depth"] + at + ["volume"] + at, rows)


def gain(run):
    if run["optimal"]:
        return percent(run["change_percent"])
    gap = 100 * abs(run["value"] - run["bound"]) / abs(run["value"])
    return "%s (%.1f)" % (percent(run["change_percent"]), gap)


def gain_table(results):
    """Each objective's change at k = 1, 4 and 8; the gap in brackets where it is not proven best."""
    rows = []
    for objective in OBJECTIVES:
        row = ["`%s`" % objective]
        for comparison in results.values():
            runs = rows_of(comparison, objective)
            gains = [gain(runs[k]) for k in (1, 4, 8)]
            same = all(each == gains[0] for each in gains)
            row.append("–" if not runs[0]["value"] else gains[0] if same else "<br>".join(gains))
        rows.append(row)
    table(["k = 1, 4, 8"] + list(results), rows)


def least_order(runs, share):
    """The least k that gains that share of what k = 8 gains."""
    values = [run["value"] for run in runs]
    whole = values[8] - values[0]
    if abs(whole) <= 1e-9 * abs(values[0]):
        return "–"
    return str(next(k for k, value in enumerate(values) if (value - values[0]) / whole >= share))


def enough_table(results):
    rows = []
    for objective in OBJECTIVES:
        runs = [rows_of(comparison, objective) for comparison in results.values()]
        least = [[least_order(run, share) for share in (0.5, 0.9)] for run in runs]
        if any(half != "–" for half, _ in least):
            rows.append(["`%s`" % objective] + [", ".join(each) for each in least])
    table(["half, 90 % of k = 8"] + list(results), rows)


def truth_table(results):
    """The root mean square error at withheld points."""
    objectives = ("min-local-minima", "min-sum-abn", "min-sum-length", "max-sum-small-angle")
    rows = []
    for name, comparison in results.items():
        if not comparison["truth"]:
            continue
        before = comparison["truth"]["delaunay_rmse"]
        row = [name, number(before)]
        for objective in objectives:
            runs = rows_of(comparison, objective)
            row += [percent(change(runs[k]["rmse"], before)) for k in (2, 8)]
        rows.append(row)
    headings = [["`%s` k = 2" % objective, "k = 8"] for objective in objectives]
    table(["", "k = 0"] + sum(headings, []), rows)


# The picture: a panel for each question, a line for each terrain.
PANELS = [
    ("min-local-minima", "min-local-minima", lambda row: row["value"]),
    ("min-local-minima: depth of the pits", "min-local-minima",
     lambda row: row["pits"]["total_depth"]),
    ("min-sum-flat-area", "min-sum-flat-area", lambda row: row["value"]),
    ("min-sum-abn", "min-sum-abn", lambda row: row["value"]),
    ("min-sum-length", "min-sum-length", lambda row: row["value"]),
    ("max-sum-small-angle", "max-sum-small-angle", lambda row: row["value"]),
]
COLOURS = ["#0f55a8", "#c2631f", "#2e7d4f", "#8e3b8a", "#b8961e", "#3aa3b5", "#c23b4e", "#6b6459"]
WIDTH, HEIGHT, LEFT, TOP, GAP_X, GAP_Y, COLUMNS = 220, 150, 52, 52, 76, 66, 3


def nice_step(span):
    power = 10 ** math.floor(math.log10(span / 4))
    return next(f * power for f in (1, 2, 5, 10) if f * power >= span / 4)


def panel(title, lines, left, top):
    """Change in percent against k; lines are (colour, [(percent, proven)])."""
    values = [value for _, points in lines for value, _ in points] + [0]
    step = nice_step(max(max(values) - min(values), 1e-9))
    low = step * math.floor(min(values) / step + 1e-9)
    high = step * math.ceil(max(values) / step - 1e-9)
    x = lambda k: left + WIDTH * k / 8
    y = lambda value: top + HEIGHT * (high - value) / (high - low)
    yield '<text x="%g" y="%g" class="title">%s</text>' % (left, top - 12, title)
    for i in range(round((high - low) / step) + 1):
        at = low + i * step
        yield '<path class="grid" d="M%g %.1fh%g"/>' % (left, y(at), WIDTH)
        text = ("%g %%" % round(at, 6)).replace("-", "−")
        yield '<text x="%g" y="%.1f" class="end">%s</text>' % (left - 6, y(at) + 4, text)
    for k in range(0, 9, 2):
        yield '<text x="%.1f" y="%g" class="middle">%s</text>' % (
            x(k), top + HEIGHT + 16, k or "k = 0")
    for colour, points in lines:
        path = "L".join("%.1f %.1f" % (x(k), y(value)) for k, (value, _) in enumerate(points))
        yield '<path d="M%s" fill="none" stroke="%s" stroke-width="1.8"/>' % (path, colour)
        for k, (value, proven) in enumerate(points):
            yield '<circle cx="%.1f" cy="%.1f" r="2.4" fill="%s" stroke="%s"/>' % (
                x(k), y(value), colour if proven else "#ffffff", colour)


def lines_of(results, objective, value_of):
    for colour, comparison in zip(COLOURS, results.values()):
        runs = rows_of(comparison, objective)
        before = value_of(runs[0])
        if before:
            yield colour, [(change(value_of(run), before), run["optimal"]) for run in runs]


def picture(results):
    width = LEFT + COLUMNS * (WIDTH + GAP_X) - GAP_X + 24
    height = TOP + -(-len(PANELS) // COLUMNS) * (HEIGHT + GAP_Y) + 44
    svg = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d">' %
           (width, height, width, height),
           "<title>What each order gains on eight terrains</title>",
           "<style>text { font: 12px Helvetica, Arial, 'DejaVu Sans', sans-serif; fill: #5d5952 }"
           " .title { font-weight: bold; fill: #2b2a28 } .end { text-anchor: end }"
           " .middle { text-anchor: middle } .grid { stroke: #e4e1db }</style>",
           '<rect width="%d" height="%d" fill="#fdfcf9"/>' % (width, height)]
    for i, (title, objective, value_of) in enumerate(PANELS):
        left = LEFT + i % COLUMNS * (WIDTH + GAP_X)
        top = TOP + i // COLUMNS * (HEIGHT + GAP_Y)
        svg += panel(title, list(lines_of(results, objective, value_of)), left, top)
    for i, (name, colour) in enumerate(zip(results, COLOURS)):
        left, top = LEFT + i % 4 * 150, height - 50 + i // 4 * 20
        svg.append('<path d="M%g %gh22" stroke="%s" stroke-width="3"/>' % (left, top, colour))
        svg.append('<text x="%g" y="%g">%s</text>' % (left + 28, top + 4, name))
    svg.append('<text x="%g" y="%g" class="end">change against k = 0</text>' %
               (width - 24, height - 46))
    svg.append('<text x="%g" y="%g" class="end">hollow: not proven best</text>' %
               (width - 24, height - 26))
    return "\n".join(svg + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--hodt", default="build/release/hodt")
    arguments = parser.parse_args()
    arguments.out.mkdir(exist_ok=True)
    results = {name: compared(name, points, full, arguments) for name, points, full in TERRAINS}
    pit_table(results, "min-local-minima", (1, 4, 8))
    pit_table(results, "min-sum-abn", (1, 8))
    gain_table(results)
    enough_table(results)
    truth_table(results)
    (arguments.out / "gains.svg").write_text(picture(results))


if __name__ == "__main__":
    main()
