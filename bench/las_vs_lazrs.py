#!/usr/bin/env python3
"""Time that hodt needs to read LAZ, beside lazrs on all cores (laspy's fastest backend).

    bench/las_vs_lazrs.py READ_BENCH FILE.laz [--times 5]

READ_BENCH is the program las_seconds of the preset bench. Both read the file in turn, in processes of
their own: hodt to points, lazrs to the bytes of uncompressed points, which are no coordinates yet.
Prints the medians of time and of processor time, and their ratios. Needs laspy with lazrs.
"""
import argparse
import statistics
import subprocess
import sys

LAZRS = """
import sys, time, laspy, lazrs, numpy
file = open(sys.argv[1], "rb")
header = laspy.LasHeader.read_from(file)
record = header.vlrs.get("LasZipVlr")[0].record_data
points = numpy.empty(header.point_count * header.point_format.size, numpy.uint8)
cpu, start = time.process_time(), time.perf_counter()
with open(sys.argv[1], "rb") as file:
    file.seek(header.offset_to_point_data)
    lazrs.ParLasZipDecompressor(file, record).decompress_many(points)
print(time.perf_counter() - start, time.process_time() - cpu)
"""


def run(command):
    """Seconds that pass, and seconds of all processors."""
    return [float(word) for word in subprocess.check_output(command, text=True).split()]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bench")
    parser.add_argument("file")
    parser.add_argument("--times", type=int, default=5)
    arguments = parser.parse_args()
    ours, theirs = [], []
    for _ in range(arguments.times):
        ours.append(run([arguments.bench, arguments.file]))
        theirs.append(run([sys.executable, "-c", LAZRS, arguments.file]))
    for what, i in (("time", 0), ("processor time", 1)):
        a, b = (statistics.median(run[i] for run in runs) for runs in (ours, theirs))
        print(f"{what}: hodt {a:.2f} s, lazrs {b:.2f} s, ratio {a / b:.2f}")


if __name__ == "__main__":
    main()
