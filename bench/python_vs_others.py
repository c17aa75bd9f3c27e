#!/usr/bin/env python3
"""Delaunay triangulations from Python: hodt against other packages, in one run.

    build/venv/bin/pip install startinpy triangle shapely   # those that are there are compared
    PYTHONPATH=build/release/python build/venv/bin/python bench/python_vs_others.py [N] [ROUNDS]

Each round lets every package triangulate the same points; what is told are medians, of seconds and of seconds
of processor, which count where others use the machine, too. First comes what Python adds to the library's own
call. (pydelatin is not among them: it approximates a raster, and takes no points.)
"""

import importlib.metadata
import statistics
import sys
import time

import numpy as np

import hodt


def packages():
    """name -> function of an array (n, 2) that returns the number of triangles."""
    found = {"hodt": lambda p: len(hodt.delaunay(p)),
             "hodt, one thread": lambda p: len(hodt.delaunay(p, threads=1))}
    try:
        from scipy.spatial import Delaunay
        found["scipy"] = lambda p: len(Delaunay(p).simplices)
    except ImportError:
        pass
    try:
        import triangle
        found["triangle"] = lambda p: len(triangle.delaunay(p))
    except ImportError:
        pass
    try:
        import startinpy

        def insert(p):
            dt = startinpy.DT()
            dt.snap_tolerance = 1e-12  # its own joins points that are nearer than a millimetre
            dt.insert(np.column_stack([p, np.zeros(len(p))]), insertionstrategy="BBox")
            return len(dt.triangles)

        found["startinpy"] = insert
    except ImportError:
        pass
    try:
        import matplotlib.tri
        found["matplotlib"] = lambda p: len(matplotlib.tri.Triangulation(*p.T).triangles)
    except ImportError:
        pass
    try:
        import shapely
        found["shapely"] = lambda p: len(shapely.delaunay_triangles(shapely.multipoints(p)).geoms)
    except ImportError:
        pass
    return found


def lattice(n):
    side = round(n**0.5)
    return np.stack(np.meshgrid(np.arange(side), np.arange(side)), -1).reshape(-1, 2).astype(float)


def seconds(f):
    """Of the clock and of processors, and what f returns."""
    start, processor = time.perf_counter(), time.process_time()
    result = f()
    return time.perf_counter() - start, time.process_time() - processor, result


def duel(points, rounds):
    found = packages()
    times = {name: [] for name in found}
    counts = {}
    for _ in range(rounds):
        for name, f in list(found.items()):
            took, processor, counts[name] = seconds(lambda: f(points))
            times[name].append((took, processor))
            if processor > 30:  # once is enough
                del found[name]
    return {name: [statistics.median(t) for t in zip(*took)] for name, took in times.items()}, counts


def overhead(points, rounds):
    """What hodt.delaunay takes more than the library's call, as a share of that: in turn."""
    inside, outside = [], []
    for _ in range(rounds):
        inside.append(hodt._hodt.seconds_of_delaunay(points))
        outside.append(seconds(lambda: hodt.delaunay(points))[0])
    return statistics.median(outside) / statistics.median(inside) - 1


def main():
    n, rounds = (int(a) for a in (sys.argv[1:] + ["1000000", "5"][len(sys.argv) - 1:]))
    rng = np.random.default_rng(1)
    plane = rng.random((n, 2))
    space = np.column_stack([plane, rng.random(n)])
    print("hodt.delaunay beside the same call in C++:")
    for name, array in (("(n, 2)", plane), ("(n, 3)", space), ("(n, 3) by columns", np.asfortranarray(space)),
                        ("(n, 2) of float32", plane.astype(np.float32))):
        print(f"  {name:18} {100 * overhead(array, 4 * rounds + 1):+.1f} %")
    sets = {"uniform": plane, "lattice": lattice(n)}
    for kind, points in sets.items():
        times, counts = duel(points, rounds)
        print(f"\n{kind}, {len(points):,} points, medians of {rounds}")
        least = times["hodt, one thread"][1]
        for name, (took, processor) in sorted(times.items(), key=lambda item: item[1][1]):
            version = ""
            try:
                version = importlib.metadata.version(name)
            except importlib.metadata.PackageNotFoundError:
                pass
            print(f"  {name:18} {version:12} {took:9.3f} s  {processor:9.3f} s of processor"
                  f"  {processor / least:8.1f} x  {counts[name]:,} triangles")


if __name__ == "__main__":
    main()
