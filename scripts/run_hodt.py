"""Runs the command for the scripts that make tables."""

import json
import subprocess


def triangulated(hodt, points, folder, *options):
    """The report of one run of hodt triangulate. Leaves its mesh and its report in the folder."""
    report = folder / "report.json"
    command = [hodt, "triangulate", points, "-o", folder / "tin.ply", "--json", report, *options]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    return json.loads(report.read_text())
