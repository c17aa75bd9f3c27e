#!/usr/bin/env python3
"""Prints the tables of docs/experiments.md about contours as breaklines and about meshes.

    scripts/constraint_tables.py --data DIR [--hodt build/release/hodt]
"""

import argparse
import csv
import gzip
import json
import math
import pathlib
import tempfile

from run_hodt import triangulated

MESHES = ["mesh_merimbula", "mesh_japan_sea", "mesh_shinnecock"]


def glacier_lines(data):
    """Its points come in the order of the lines: one ends where the level changes or there is a gap."""
    gap = 0.3
    rows = [tuple(map(float, row[:3]))
            for row in list(csv.reader((data / "glacier_contours/points.csv").open()))[1:]]
    lines, line = [], []
    for row in rows:
        if line and (row[2] != line[-1][2] or math.dist(row[:2], line[-1][:2]) > gap):
            lines.append(line)
            line = []
        line.append(row)
    return [line for line in lines + [line] if len(line) > 1]


def raster_window(data):
    """Heights of a window of the raster, by column and row of its cells."""
    cell, left, low, size = 30.0, 12015.0, 6015.0, 300
    heights = {}
    with gzip.open(data / "bigtujunga/full.csv.gz", "rt") as cells:
        for x, y, z in list(csv.reader(cells))[1:]:
            column, row = round((float(x) - left) / cell), round((float(y) - low) / cell)
            if 0 <= column <= size and 0 <= row <= size:
                heights[column, row] = float(z)
    return heights, cell


def cuts_of_cell(heights, corner, level):
    """The pieces of a level set in a square of four cell centres, as pairs of its sides."""
    x, y = corner
    around = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
    if any(c not in heights for c in around):
        return []
    cut = []
    for a, b in zip(around, around[1:] + around[:1]):
        if (heights[a] < level) != (heights[b] < level):
            cut.append((min(a, b), max(a, b)))
    if len(cut) == 4 and heights[around[0]] < level:  # a saddle: the high corners are joined
        cut = cut[1:] + cut[:1]
    return [tuple(cut[k:k + 2]) for k in range(0, len(cut), 2)]


def joined(pieces):
    """The pieces as chains of their ends."""
    beside = {}
    for a, b in pieces:
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    chains = []
    for start in sorted(beside, key=lambda end: (len(beside[end]), end)):
        while beside[start]:
            chain = [start]
            while beside[chain[-1]]:
                following = beside[chain[-1]].pop()
                beside[following].remove(chain[-1])
                chain.append(following)
            chains.append(chain)
    return chains


def bigtujunga_lines(data):
    """Level sets of a window of the raster, 40 m apart; heights are whole metres, levels are not."""
    heights, cell = raster_window(data)

    def place(side, level):
        (x, y), (v, w) = side
        part = (level - heights[x, y]) / (heights[v, w] - heights[x, y])
        return (cell * (x + part * (v - x)), cell * (y + part * (w - y)), level)

    lines = []
    lowest, highest = min(heights.values()), max(heights.values())
    level = 40 * math.ceil(lowest / 40) + 0.5
    while level < highest:
        pieces = [p for corner in sorted(heights) for p in cuts_of_cell(heights, corner, level)]
        lines += [[place(side, level) for side in chain] for chain in joined(pieces)]
        level += 40
    return lines


def contours(hodt, data, folder):
    print("| contours | points | edges of lines | k | flat area, Delaunay | result | bound | |")
    print("|---|---|---|---|---|---|---|---|")
    for name, lines in [("bigtujunga", bigtujunga_lines(data)), ("glacier", glacier_lines(data))]:
        points, file = folder / "points.csv", folder / "lines.geojson"
        with points.open("w") as table:
            table.write("x,y,z\n")
            for vertex in sorted({vertex for line in lines for vertex in line}):
                table.write("%r,%r,%r\n" % vertex)
        file.write_text(json.dumps({"type": "MultiLineString", "coordinates": lines}))
        for order in [1, 4, 8]:
            report = triangulated(hodt, points, folder, "-k", order, "--breaklines", file,
                                 "--split-crossings", "--objective", "min-sum-flat-area")
            value = report["value"]
            print("| %s | %d | %d | %d | %.6g | %.6g | %.6g | %s |" % (
                name, report["points"], report["constraints"]["edges_kept"], order,
                value["delaunay"], value["result"], value["bound"],
                "optimal" if value["optimal"] else ""), flush=True)


def write_mesh(folder_of_mesh, path):
    with open(folder_of_mesh / "nodes.csv") as nodes, path.open("w") as mesh:
        for row in list(csv.reader(nodes))[1:]:
            mesh.write("v %s %s %s\n" % tuple((row + ["0"])[:3]))
        with gzip.open(folder_of_mesh / "triangles.csv.gz", "rt") as triangles:
            for row in list(csv.reader(triangles))[1:]:
                mesh.write("f %d %d %d\n" % tuple(int(corner) + 1 for corner in row))


def meshes(hodt, data, folder):
    print("| mesh | triangles | its order | objective | the mesh | Delaunay | k = 4 | bound | |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name in MESHES:
        mesh = folder / "mesh.obj"
        write_mesh(data / name, mesh)
        for objective in ["min-max-angle", "min-sum-length"]:
            report = triangulated(hodt, mesh, folder, "-k", 4, "--objective", objective)
            value = report["value"]
            print("| %s | %d | %d | %s | %.9g | %.9g | %.9g | %.9g | %s |" % (
                name, report["triangles"], report["input"]["order"], objective, value["input"],
                value["delaunay"], value["result"], value["bound"],
                "optimal" if value["optimal"] else ""), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--hodt", default="build/release/hodt")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        contours(arguments.hodt, arguments.data, folder)
        print()
        meshes(arguments.hodt, arguments.data, folder)


if __name__ == "__main__":
    main()
