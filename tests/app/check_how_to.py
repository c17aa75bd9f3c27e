#!/usr/bin/env python3
"""Runs the commands of docs/how-to.md, one after the other, in one empty folder.

check_how_to.py COMMAND PAGE     exit code 77: skipped, as hodt was built without GDAL"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

command, page = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
if "GeoTIFF" not in subprocess.run([command, "formats"], capture_output=True, text=True, check=True).stdout:
    print("Skipped: without GDAL")
    sys.exit(77)

blocks = re.findall(r"^```sh\n(.*?)^```", page.read_text(), re.M | re.S)
assert len(blocks) >= 10, "the page has lost its commands"
path = f"{command.parent}{os.pathsep}{os.environ['PATH']}"
with tempfile.TemporaryDirectory() as folder:
    for block in blocks:
        result = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", block], cwd=folder, env={**os.environ, "PATH": path}
        )
        if result.returncode:
            sys.exit(f"Exit code {result.returncode} of:\n{block}")
print(f"{len(blocks)} blocks of commands ran.")
