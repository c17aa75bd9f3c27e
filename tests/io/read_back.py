#!/usr/bin/env python3
"""Reads the meshes that read_back_test wrote, by a program of others, and compares.

usage: read_back.py READER FOLDER

Ends with 77 if the reader is not installed.
"""
import array
import json
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as xml


class Expected:
    """A mesh as read_back_test says that it is."""

    def __init__(self, folder):
        self.folder = folder
        self.name = folder.name
        xy = self.numbers("xy", "d")
        self.z = self.numbers("z", "d")
        self.has_heights = bool(self.z)
        heights = self.z or [0.0] * (len(xy) // 2)
        self.points = [(xy[2 * i], xy[2 * i + 1], heights[i]) for i in range(len(heights))]
        corners = self.numbers("triangles", "I")
        self.triangles = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
        self.order = self.numbers("order", "I")
        self.changed = [int(order > 0) for order in self.order]
        self.crs = (folder / "crs").read_text(encoding="utf-8")

    def numbers(self, name, kind):
        numbers = array.array(kind)
        numbers.frombytes((self.folder / name).read_bytes())
        return list(numbers)

    def file(self, extension):
        return str(self.folder / ("terr\u00e4n 1" + extension))


def same(what, found, expected):
    found = [tuple(row) if hasattr(row, "__len__") else row for row in found]
    if found != expected:
        differing = [pair for pair in zip(found, expected) if pair[0] != pair[1]][:3]
        sys.exit(f"{what}: {len(found)} of {len(expected)}, differing {differing}")


def near(what, found, expected, most):
    if len(found) != len(expected):
        sys.exit(f"{what}: {len(found)} of {len(expected)}")
    for a, b in zip(found, expected):
        if any(abs(x - y) > most for x, y in zip(a, b)):
            sys.exit(f"{what}: {a} is not {b}")


def require(condition, what):
    if not condition:
        sys.exit(what)


def read_meshio(mesh):
    import meshio
    for extension in (".vtu", ".ply", ".obj"):
        got = meshio.read(mesh.file(extension))
        same(extension + " points", got.points.tolist(), mesh.points)
        same(extension + " triangles", got.cells_dict["triangle"].tolist(), mesh.triangles)
    got = meshio.read(mesh.file(".vtu"))
    if mesh.has_heights:
        same(".vtu z", got.point_data["z"].tolist(), mesh.z)
    if mesh.order:
        same(".vtu order", got.cell_data["order"][0].tolist(), mesh.order)
        same(".vtu changed", got.cell_data["changed"][0].tolist(), mesh.changed)
    if mesh.crs:
        require(bytes(got.field_data["crs"].astype("uint8")).decode() == mesh.crs, ".vtu crs")
    got = meshio.read(mesh.file(".stl"))
    require(len(got.cells_dict["triangle"]) == len(mesh.triangles), ".stl triangles")


def read_vtk(mesh):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(mesh.file(".vtu"))
    reader.Update()
    grid = reader.GetOutput()
    same("points", vtk_to_numpy(grid.GetPoints().GetData()).tolist(), mesh.points)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 3).tolist()
    same("triangles", cells, mesh.triangles)
    require(set(vtk_to_numpy(grid.GetCellTypesArray()).tolist() if hasattr(grid, "GetCellTypesArray")
                else [5]) == {5}, "types")
    if mesh.has_heights:
        same("z", vtk_to_numpy(grid.GetPointData().GetArray("z")).tolist(), mesh.z)
    for name, expected in (("order", mesh.order), ("changed", mesh.changed)):
        if expected:
            same(name, vtk_to_numpy(grid.GetCellData().GetArray(name)).tolist(), expected)
    if mesh.crs:
        text = bytes(vtk_to_numpy(grid.GetFieldData().GetArray("crs")).tolist()).decode()
        require(text == mesh.crs, "crs")
    for kind, extension in ((vtk.vtkSTLReader, ".stl"), (vtk.vtkOBJReader, ".obj")):
        reader = kind()
        reader.SetFileName(mesh.file(extension))
        reader.Update()
        require(reader.GetOutput().GetNumberOfCells() == len(mesh.triangles), extension)


def read_netcdf4(mesh):
    import netCDF4
    with netCDF4.Dataset(mesh.file(".nc")) as file:
        file.set_auto_mask(False)
        topology = file["mesh"]
        require(topology.cf_role == "mesh_topology" and topology.topology_dimension == 2, "topology")
        x, y = (file[name][:].tolist() for name in topology.node_coordinates.split())
        z = file["mesh_node_z"][:].tolist() if mesh.has_heights else [0.0] * len(x)
        same("points", list(zip(x, y, z)), mesh.points)
        faces = file[topology.face_node_connectivity]
        same("triangles", (faces[:] - faces.start_index).tolist(), mesh.triangles)
        for name, expected in (("order", mesh.order), ("changed", mesh.changed)):
            if expected:
                require(file[name].mesh == "mesh" and file[name].location == "face", name)
                same(name, file[name][:].tolist(), expected)
        if mesh.crs:
            mapping = file[file["mesh_node_z"].grid_mapping]
            require(mapping.spatial_ref == mesh.crs, "crs")
            require(mapping.epsg == 25832, "epsg")
            if mesh.crs.startswith("EPSG"):
                require(mapping.EPSG_code == mesh.crs, "EPSG_code")
            else:
                require(mapping.crs_wkt == mesh.crs and mapping.wkt == mesh.crs, "wkt")


def read_xarray(mesh):
    import xarray
    with xarray.open_dataset(mesh.file(".nc")) as file:
        same("x", file["mesh_node_x"].values.tolist(), [p[0] for p in mesh.points])
        same("triangles", file["mesh_face_nodes"].values.astype(int).tolist(), mesh.triangles)
        if mesh.order:
            same("order", file["order"].values.tolist(), mesh.order)


def read_plyfile(mesh):
    import plyfile
    file = plyfile.PlyData.read(mesh.file(".ply"))
    vertices, faces = file["vertex"], file["face"]
    same("points", list(zip(*(vertices[k].tolist() for k in "xyz"))), mesh.points)
    same("triangles", [row.tolist() for row in faces["vertex_indices"]], mesh.triangles)
    require(len(file.comments) == bool(mesh.crs), "crs")
    if mesh.crs.startswith("EPSG"):
        require(file.comments == ["crs: " + mesh.crs], "crs")


def read_trimesh(mesh):
    import trimesh
    got = trimesh.load(mesh.file(".glb"), force="scene").to_mesh()
    turned = [(x, -z, y) for x, y, z in got.vertices.tolist()]
    near(".glb points", turned, mesh.points, 1e-4)
    same(".glb triangles", got.faces.tolist(), mesh.triangles)
    got = trimesh.load(mesh.file(".stl"), force="mesh", process=False)
    require(len(got.faces) == len(mesh.triangles), ".stl triangles")
    header = pathlib.Path(mesh.file(".stl")).read_bytes()[:80].decode()
    origin = [float(word) for word in header.split("from")[1].split()]
    corners = [mesh.points[v] for t in mesh.triangles for v in t]
    vertices = got.vertices[got.faces].reshape(-1, 3) + origin
    near(".stl corners", vertices.tolist(), corners, 1e-4)
    require((got.face_normals[:, 2] > 0).all(), ".stl normals")


def read_landxml(mesh):
    """By structure: what the schema of LandXML 1.2 requires of what is there."""
    space = "{http://www.landxml.org/schema/LandXML-1.2}"
    root = xml.parse(mesh.file(".xml")).getroot()
    require(root.tag == space + "LandXML", "root")
    require(all(name in root.attrib for name in ("version", "date", "time")), "attributes")
    metric = root.find(f"{space}Units/{space}Metric")
    require(all(name + "Unit" in metric.attrib
                for name in ("area", "linear", "volume", "temperature", "pressure")), "units")
    surface, = root.findall(f"{space}Surfaces/{space}Surface")
    definition = surface.find(space + "Definition")
    require(surface.get("name") and definition.get("surfType") == "TIN", "surface")
    points = {}
    for point in definition.find(space + "Pnts"):
        north, east, up = map(float, point.text.split())
        points[int(point.get("id"))] = (east, north, up)
    require(len(points) == len(mesh.points) and min(points) > 0, "numbers of points")
    numbers = sorted(points)
    same("points", [points[n] for n in numbers], mesh.points)
    place = {number: i for i, number in enumerate(numbers)}
    same("triangles", [tuple(place[int(word)] for word in face.text.split())
                       for face in definition.find(space + "Faces")], mesh.triangles)
    system = root.find(space + "CoordinateSystem")
    require((system is not None) == bool(mesh.crs), "crs")
    if mesh.crs:
        require(system.get("epsgCode") == "25832", "epsgCode")
        wkt = mesh.crs if "[" in mesh.crs else None
        require(system.get("ogcWktCode") == wkt, "ogcWktCode")


def read_gltf(mesh):
    folder = os.environ.get("HODT_GLTF_VALIDATOR")
    if not folder:
        raise ImportError("HODT_GLTF_VALIDATOR names no folder of npm")
    script = """
      const validator = require(process.argv[1] + '/node_modules/gltf-validator');
      validator.validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[2])))
        .then(report => console.log(JSON.stringify(report)));"""
    run = subprocess.run(["node", "-e", script, folder, mesh.file(".glb")], check=True,
                         capture_output=True)
    report = json.loads(run.stdout)
    found = report["issues"]
    require(found["numErrors"] + found["numWarnings"] + found["numInfos"] == 0, json.dumps(found))
    require(report["info"]["totalTriangleCount"] == len(mesh.triangles), "triangles")
    require(report["info"]["totalVertexCount"] == len(mesh.points), "vertices")


def read_gdal(mesh):
    from osgeo import gdal
    gdal.UseExceptions()
    if not gdal.GetDriverByName("netCDF"):
        raise ImportError("GDAL has no driver for netCDF here")
    group = gdal.OpenEx(mesh.file(".nc"), gdal.OF_MULTIDIM_RASTER).GetRootGroup()
    x = array.array("d", bytes(group.OpenMDArray("mesh_node_x").Read())).tolist()
    same("x", x, [p[0] for p in mesh.points])
    if mesh.order:
        order = array.array("i", bytes(group.OpenMDArray("order").Read())).tolist()
        same("order", order, mesh.order)


def qgis():
    """Starts QGIS, which shows no window."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    from qgis import core
    if not core.QgsApplication.instance():
        qgis.application = core.QgsApplication([], False)
        qgis.application.initQgis()
    return core


def read_qgis(mesh):
    """The layers of meshes."""
    core = qgis()
    for extension in (".nc", ".2dm", ".ply"):
        if extension == ".nc" and not mesh.has_heights and not mesh.order:
            continue  # it has no data, which QGIS wants
        layer = core.QgsMeshLayer(mesh.file(extension), "mesh", "mdal")
        require(layer.isValid(), extension + " is not valid")
        provider = layer.dataProvider()
        require(provider.vertexCount() == len(mesh.points), extension + " vertices")
        require(provider.faceCount() == len(mesh.triangles), extension + " faces")
        native = core.QgsMesh()
        provider.populateMesh(native)
        near(extension + " points",
             [(p.x(), p.y(), p.z()) for p in (native.vertex(i) for i in range(len(mesh.points)))],
             mesh.points, 0)
        same(extension + " triangles", [native.face(i) for i in range(len(mesh.triangles))],
             mesh.triangles)
        if mesh.crs.startswith("EPSG") and extension == ".nc":
            require(provider.crs().authid() == mesh.crs, f"{extension} {provider.crs().authid()}")
        names = {provider.datasetGroupMetadata(i).name(): i
                 for i in range(provider.datasetGroupCount())}
        for name, expected in (("order", mesh.order), ("changed", mesh.changed)):
            if expected and extension == ".nc":
                block = provider.datasetValues(core.QgsMeshDatasetIndex(names[name], 0), 0,
                                               len(expected))
                same(extension + name, [int(block.value(i).scalar()) for i in range(len(expected))],
                     expected)


def read_qgis_vector(mesh):
    """The layers of features: a polygon a triangle."""
    core = qgis()
    corners = sorted(sorted(mesh.points[v] for v in triangle) for triangle in mesh.triangles)
    for extension in (".gpkg", ".fgb", ".shp", ".geojson"):
        if not os.path.exists(mesh.file(extension)):
            continue  # hodt was built without GDAL
        layer = core.QgsVectorLayer(mesh.file(extension), "triangles", "ogr")
        require(layer.isValid(), extension + " is not valid")
        require(layer.featureCount() == len(mesh.triangles), extension + " features")
        require(layer.geometryType() == core.QgsWkbTypes.PolygonGeometry, extension + " polygons")
        require(core.QgsWkbTypes.hasZ(layer.wkbType()) == mesh.has_heights, extension + " z")
        found, orders = [], []
        for feature in layer.getFeatures():
            ring = list(feature.geometry().vertices())
            require(len(ring) == 4 and ring[0] == ring[3], extension + " ring")
            found.append(sorted((p.x(), p.y(), p.z() if mesh.has_heights else 0.0)
                                for p in ring[:3]))
            if mesh.order:
                orders.append((feature["order"], feature["changed"]))
        require(sorted(found) == corners, extension + " corners")
        require(sorted(orders) == sorted(zip(mesh.order, mesh.changed)), extension + " orders")
        if mesh.crs.startswith("EPSG"):
            require(layer.crs().authid() == mesh.crs, f"{extension} {layer.crs().authid()}")
        elif mesh.crs:
            require(layer.crs().isValid(), extension + " crs")


def main():
    reader, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    for name in ("survey", "wkt", "plain"):
        mesh = Expected(folder / name)
        try:
            globals()["read_" + reader](mesh)
        except ImportError as error:
            print(f"skipped: {error}")
            os._exit(77)
        except SystemExit as error:
            print(f"{name}: {error}")
            os._exit(1)
    sys.stdout.flush()
    os._exit(0)  # QGIS does not end quietly


main()
