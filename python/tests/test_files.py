"""Files of points and meshes, and the built-in terrains."""

import errno
import gzip
import os
import pathlib
import pickle

import numpy as np
import pytest

import hodt


def test_points_come_back(tmp_path, rng):
    points = rng.random((50, 3))
    for name, delimiter in (("p.csv", ","), ("p.xyz", " "), ("p.csv.gz", ",")):
        np.savetxt(tmp_path / name, points, delimiter=delimiter, fmt="%.17g")
        assert np.array_equal(hodt.read_points(tmp_path / name), points)
        assert np.array_equal(hodt.read_points(str(tmp_path / name), threads=1), points)
    (tmp_path / "flat.csv").write_text("x,y\n1,2\n3,4\n")
    assert hodt.read_points(tmp_path / "flat.csv").tolist() == [[1, 2], [3, 4]]


def test_columns_are_chosen(tmp_path):
    path = tmp_path / "p.csv"
    path.write_text("id,north,east,height\n1,2,3,4\n5,6,7,8\n")
    chosen = hodt.read_points(path, {"x": "east", "y": 2, "z": "height"})
    assert chosen.tolist() == [[3, 2, 4], [7, 6, 8]]
    with pytest.raises(hodt.ParameterError, match="w"):
        hodt.read_points(path, {"w": 1})
    with pytest.raises(hodt.ParameterError):
        hodt.read_points(path, {"x": "west", "y": 2})


def test_doubts_are_warnings(tmp_path):
    path = tmp_path / "swapped.csv"
    path.write_text("x,y,z\n" + "".join(f"{i % 7},{i % 5},-9999\n" if i % 2 else f"{i % 7},{i % 5},{i}\n"
                                        for i in range(60)))
    try:
        with pytest.warns(UserWarning):
            hodt.read_points(path)
    except pytest.fail.Exception:
        pytest.skip("no doubt about these")


def test_meshes_come_back(tmp_path, rng):
    tin = hodt.triangulate(rng.random((100, 3)), 2).tin
    for name in ("t.ply", "t.obj", pathlib.Path("u.ply")):
        hodt.write_tin(tin, tmp_path / name)
        assert hodt.read_tin(tmp_path / name) == tin
    packed = tmp_path / "t.obj.gz"
    packed.write_bytes(gzip.compress((tmp_path / "t.obj").read_bytes()))
    assert hodt.read_tin(packed) == tin


def test_the_reference_system_is_written(tmp_path):
    points = hodt.sample("jacksboro", 50)
    tin = hodt.Tin(points, hodt.delaunay(points), "EPSG:25832")
    for name in ("t.ply", "t.obj"):
        tin.write(tmp_path / name)
        assert hodt.read_tin(tmp_path / name) == tin
        again = hodt.triangulate(hodt.read_tin(tmp_path / name), 1, "none").tin
        hodt.write_tin(again, tmp_path / name)
        assert hodt.read_tin(tmp_path / name).crs == "EPSG:25832"
    for name in ("t.xml", "t.geojson", "t.gpkg"):
        tin.write(tmp_path / name)
        assert b"25832" in (tmp_path / name).read_bytes(), name
    tin.crs = None
    tin.write(tmp_path / "none.ply")
    assert hodt.read_tin(tmp_path / "none.ply").crs is None
    for crs in (25832, "", "EPSG:25832\nv 1 2 3", "EPSG:\0", "\ud800"):
        tin.crs = crs
        for make in (lambda: tin.write(tmp_path / "bad.obj"), lambda: hodt.Tin(tin.points, tin.triangles, crs)):
            with pytest.raises(hodt.ParameterError, match="crs"):
                make()
    assert not (tmp_path / "bad.obj").exists()


def test_errors_of_files(tmp_path):
    for read in (hodt.read_points, hodt.read_tin):
        with pytest.raises(hodt.FileError, match="nowhere") as caught:
            read(tmp_path / "nowhere.ply")
        assert isinstance(caught.value, (OSError, hodt.Error))
        with pytest.raises(hodt.ParameterError, match="path"):
            read(3)
    (tmp_path / "bad.csv").write_text("x,y,z\n1,2,3\n1,two,3\n")
    with pytest.raises(hodt.InputError, match="line 3"):
        hodt.read_points(tmp_path / "bad.csv")
    tin = hodt.Tin(np.eye(3), [[0, 1, 2]])
    with pytest.raises(hodt.ParameterError, match="txt"):
        hodt.write_tin(tin, tmp_path / "t.txt")
    with pytest.raises(hodt.FileError):
        hodt.write_tin(tin, tmp_path / "no" / "t.ply")
    assert not list(tmp_path.glob("t.*"))


def test_errors_of_files_say_what_the_system_said(tmp_path):
    tin = hodt.Tin(np.eye(3), [[0, 1, 2]])
    no_name = os.fsdecode(os.fsencode(tmp_path) + b"/n\xff.ply")
    for call, path, number, kind in (
            (hodt.read_points, tmp_path / "no.csv", errno.ENOENT, FileNotFoundError),
            (hodt.read_tin, no_name, errno.ENOENT, FileNotFoundError),
            (hodt.Constraints, tmp_path / "no.geojson", errno.ENOENT, FileNotFoundError),
            (hodt.read_points, tmp_path, errno.EISDIR, IsADirectoryError),
            (tin.write, tmp_path / "no" / "t.ply", errno.ENOENT, FileNotFoundError)):
        with pytest.raises(kind) as caught:
            call(path)
        error = caught.value
        assert isinstance(error, hodt.FileError)
        assert (error.errno, error.filename) == (number, str(path))
        assert str(error).startswith("cannot ") and "Errno" not in str(error)
        again = pickle.loads(pickle.dumps(error))
        assert (type(again), str(again), again.filename) == (type(error), str(error), str(path))
    assert str(hodt.FileError("the disk is full")) == "the disk is full"


def test_lines_and_places_from_files(tmp_path):
    road = tmp_path / "road.geojson"
    road.write_text('{"type": "LineString", "coordinates": [[0, 0], [4, 4]]}')
    area = tmp_path / "area.geojson"
    area.write_text('{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}')
    points = np.array([[0, 0, 0], [4, 0, 1], [4, 4, 2], [0, 4, 3], [1, 2, 4]], float)
    result = hodt.triangulate(points, constraints=hodt.Constraints(road, area))
    assert result.constraints["edges"] == 5 and result.triangles == 4
    low = np.array([[2, 2, -1], *points])
    assert hodt.triangulate(low, keep=area).kept >= 1
    with pytest.raises(hodt.FileError):
        hodt.Constraints(tmp_path / "nowhere.geojson")


def test_built_in_terrains():
    assert set(hodt.terrains()) >= {"jacksboro", "valley"}
    points = hodt.sample("valley", 1000, 3)
    assert points.shape == (1000, 3) and np.array_equal(points, hodt.sample("valley", 1000, 3, threads=1))
    assert not np.array_equal(points, hodt.sample("valley", 1000, 4))
    for arguments in (("moon",), ("valley", 0), ("valley", -1), ("jacksboro", 10**7), (3,)):
        with pytest.raises(hodt.ParameterError):
            hodt.sample(*arguments)
