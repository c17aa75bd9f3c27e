#!/usr/bin/env python3
"""Checks that each layer includes only what it may, and two smaller house rules.

    scripts/check_layers.py              check the sources
    scripts/check_layers.py --self-test  check that the check can fail

A layer may include itself and the layers that it links in src/hodt/CMakeLists.txt, directly or
through others. A room, which is a folder of a layer, may include of that layer only itself and what
its line there names. Only io names zlib, only its room gdal GDAL. No file tells where it was written: an absolute path into
somebody's home or workplace is of no use to anyone else.

Prints each violation as file:line: what is wrong, and exits 1 if there is any.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LAYER = re.compile(r"^\s*hodt_layer\(\s*(\w+)([^)]*)\)", re.MULTILINE)
ROOM = re.compile(r"^\s*hodt_room\(\s*(\w+)/(\w+)([^)]*)\)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
ABSOLUTE = re.compile(r"(?<![\w./$}~])/(?:home|root|work|workspace|Users|mnt)/\w")
ZLIB_ONLY_IN = {"io"}
GDAL_HEADER = re.compile(r"(gdal|ogr|cpl)_?\w*\.h")
GDAL_ONLY_IN = ("io", "gdal")

# The folders of src/hodt that are no layers, and files directly in it (the pipeline), may include
# everything; so may programs and tests.
SOURCE_SUFFIXES = {".h", ".cpp", ".inc", ".in"}


def allowed_layers(cmake):
    """Layer -> the layers that it may include, from the hodt_layer lines of a CMake file."""
    links = {}
    for name, rest in LAYER.findall(cmake):
        links[name] = re.findall(r"\bhodt_(\w+)", rest)
    allowed = {}
    for name in links:  # a layer links only layers above it, so those are complete
        allowed[name] = {name}
        for link in links[name]:
            allowed[name] |= allowed.get(link, set())
    return allowed


def check_order(cmake):
    """A layer links only layers that were named before it."""
    seen = set()
    for match in LAYER.finditer(cmake):
        for link in re.findall(r"\bhodt_(\w+)", match.group(2)):
            if link not in seen:
                line = cmake.count("\n", 0, match.start()) + 1
                yield line, f"layer {match.group(1)} links {link}, which is not above it"
        seen.add(match.group(1))


def allowed_rooms(cmake):
    """(layer, room) -> the rooms and headers of the layer that it may include."""
    rooms = {}
    for layer, room, rest in ROOM.findall(cmake):
        rooms[layer, room] = {room, *re.sub(r"^\s*MAY\b", "", rest).split()}
    return rooms


def check_room_order(cmake):
    """A room names, of the rooms of its layer, only those that stand before it."""
    rooms = allowed_rooms(cmake)
    seen = set()
    for match in ROOM.finditer(cmake):
        layer, room = match.group(1), match.group(2)
        for name in rooms[layer, room] - {room}:
            if (layer, name) in rooms and (layer, name) not in seen:
                line = cmake.count("\n", 0, match.start()) + 1
                yield line, f"room {layer}/{room} names {name}, which is not above it"
        seen.add((layer, room))


def layer_of(path):
    """The folder of src/hodt that a path is in, or None."""
    parts = pathlib.PurePosixPath(path).parts
    return parts[2] if len(parts) > 3 and parts[:2] == ("src", "hodt") else None


def room_of(path):
    """The folder of a layer that a path is in, or None."""
    parts = pathlib.PurePosixPath(path).parts
    return parts[3] if len(parts) > 4 and parts[:2] == ("src", "hodt") else None


def check_source(path, text, allowed, rooms):
    """Yields (line, message) for what a file of a layer includes and must not."""
    layer, room = layer_of(path), room_of(path)
    if layer not in allowed:
        if layer is not None:
            yield 1, f"folder {layer} is no layer of src/hodt/CMakeLists.txt"
        return
    if room is not None and (layer, room) not in rooms:
        yield 1, f"folder {layer}/{room} is no room of src/hodt/CMakeLists.txt"
        return
    for number, line in enumerate(text.splitlines(), start=1):
        include = INCLUDE.match(line)
        if not include:
            continue
        target = include.group(2)
        if target == "zlib.h" and layer not in ZLIB_ONLY_IN:
            yield number, f"layer {layer} names zlib; only {', '.join(ZLIB_ONLY_IN)} does"
        if GDAL_HEADER.fullmatch(target) and (layer, room) != GDAL_ONLY_IN:
            yield number, f"{layer} names GDAL; only {'/'.join(GDAL_ONLY_IN)} does"
        if target.startswith(("app/", "tests/", "bench/")):
            yield number, f"layer {layer} includes {target}, which is no part of the library"
        if not target.startswith("hodt/"):
            continue
        rest = target[len("hodt/") :]
        other = rest.split("/")[0] if "/" in rest else rest.removesuffix(".h")
        if other not in allowed[layer]:
            known = ", ".join(sorted(allowed[layer]))
            yield number, f"layer {layer} includes {target}, but may include only: {known}"
        if room is not None and other == layer:
            name = rest.split("/")[1].removesuffix(".h")
            if name not in rooms[layer, room]:
                known = ", ".join(sorted(rooms[layer, room]))
                yield number, f"room {layer}/{room} includes {target}, but may include only: {known}"


def check_paths(text):
    """Yields (line, message) for absolute paths of one machine."""
    for number, line in enumerate(text.splitlines(), start=1):
        found = ABSOLUTE.search(line)
        if found:
            yield number, f"absolute path of one machine: {line[found.start():].split()[0]}"


def tracked_files():
    """What is, or would be, in the repository."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
    )
    if listed.returncode == 0:
        names = listed.stdout.decode().split("\0")
    else:  # an unpacked archive
        folders = [ROOT / name for name in ("src", "app", "tests", "bench", "scripts")]
        names = [str(p.relative_to(ROOT)) for folder in folders for p in folder.rglob("*")]
    return sorted(name for name in names if name and (ROOT / name).is_file())


def check_tree():
    violations = []  # (file, line, message)
    cmake_path = "src/hodt/CMakeLists.txt"
    cmake = (ROOT / cmake_path).read_text()
    violations += [(cmake_path, *found) for found in check_order(cmake)]
    violations += [(cmake_path, *found) for found in check_room_order(cmake)]
    allowed, rooms = allowed_layers(cmake), allowed_rooms(cmake)
    for name in tracked_files():
        try:
            text = (ROOT / name).read_text()
        except UnicodeDecodeError:
            continue
        if name != "scripts/check_layers.py":
            violations += [(name, *found) for found in check_paths(text)]
        if pathlib.PurePosixPath(name).suffix in SOURCE_SUFFIXES:
            violations += [(name, *found) for found in check_source(name, text, allowed, rooms)]
    for name, line, message in violations:
        print(f"{name}:{line}: {message}")
    return 1 if violations else 0


def self_test():
    cmake = """
hodt_layer(base LINK TBB::tbb)
hodt_layer(geometry LINK hodt_base)
hodt_layer(delaunay LINK hodt_geometry)
hodt_room(delaunay/sort)
hodt_room(delaunay/join MAY sort view)
hodt_layer(io LINK hodt_base ZLIB::ZLIB)
hodt_room(io/gdal)
"""
    allowed = allowed_layers(cmake)
    assert allowed["delaunay"] == {"base", "geometry", "delaunay"}, allowed
    assert allowed["io"] == {"base", "io"}, allowed
    assert list(check_order(cmake)) == []
    upward = cmake + "hodt_layer(a LINK hodt_b)\nhodt_layer(b)\n"
    assert [line for line, _ in check_order(upward)] == [9]

    rooms = allowed_rooms(cmake)
    assert rooms["delaunay", "join"] == {"join", "sort", "view"}, rooms
    assert list(check_room_order(cmake)) == []
    upward = "hodt_room(a/b MAY c)\nhodt_room(a/c)\n"
    assert [line for line, _ in check_room_order(upward)] == [1]

    def lines(path, text):
        return [line for line, _ in check_source(path, text, allowed, rooms)]

    fine = '#include <vector>\n#include "hodt/base/ids.h"\n#include "hodt/delaunay/x.h"\n'
    assert lines("src/hodt/delaunay/x.cpp", fine) == []
    assert lines("src/hodt/geometry/x.cpp", fine) == [3]
    assert lines("src/hodt/io/gzip.cpp", "#include <zlib.h>\n") == []
    assert lines("src/hodt/base/x.h", "\n#include <zlib.h>\n") == [2]
    assert lines("src/hodt/io/gdal/x.h", "#include <gdal.h>\n") == []
    assert lines("src/hodt/io/x.h", "#include <ogr_api.h>\n") == [1]
    assert lines("src/hodt/base/x.h", '#include "hodt/pipeline.h"\n') == [1]
    assert lines("src/hodt/base/x.h", '#include "app/common.h"\n') == [1]
    assert lines("src/hodt/new/x.h", "") == [1]
    inside = '#include "hodt/delaunay/sort/x.h"\n#include "hodt/delaunay/view.h"\n'
    assert lines("src/hodt/delaunay/join/x.h", inside) == []
    assert lines("src/hodt/delaunay/sort/x.h", inside) == [2]
    assert lines("src/hodt/delaunay/x.h", inside) == []
    assert lines("src/hodt/delaunay/new/x.h", "") == [1]
    assert lines("src/hodt/pipeline.cpp", '#include "hodt/io/x.h"\n') == []
    assert lines("tests/io/x_test.cpp", '#include "hodt/io/x.h"\n') == []

    assert [line for line, _ in check_paths("a\nsee /home/me/x\n")] == [2]
    assert list(check_paths("$HOME/home/x ~/work/x https://a.org/work/x a/tmp/x\n")) == []
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if "--self-test" in sys.argv[1:] else check_tree())
