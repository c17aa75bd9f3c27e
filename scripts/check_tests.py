#!/usr/bin/env python3
"""Each source has a test of its name, or a line "// Tested by tests/...", and that test exists.

A source is a header with its .cpp, or either alone. The line is in the comment that the header
begins with (of a .cpp alone, there)."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("src/hodt", "app")
LINE = re.compile(r"^// Tested by (\S+)\.$", re.MULTILINE)


def problems(root):
    tests = {path.name for path in root.glob("tests/**/*_test.cpp")}
    sources = {
        path.with_suffix("")
        for folder in FOLDERS
        for path in (root / folder).rglob("*")
        if path.suffix in (".h", ".cpp")
    }
    for source in sorted(sources):
        if f"{source.name}_test.cpp" in tests:
            continue
        files = [file for file in (source.with_suffix(".h"), source.with_suffix(".cpp")) if file.exists()]
        named = [test for file in files for test in LINE.findall(file.read_text())]
        name = source.relative_to(root)
        if not named:
            yield f'{name} has no test of its name and no line "// Tested by tests/..."'
        for test in named:
            if not (root / test).is_file():
                yield f"{name} is said to be tested by {test}, which is not there"


if __name__ == "__main__":
    found = list(problems(ROOT))
    print("\n".join(found) if found else "Each source has its test.")
    sys.exit(1 if found else 0)
