// Files of points and meshes, the built-in terrains, and the picture of a comparison.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "arrays.h"
#include "job.h"
#include "sections.h"
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "hodt/io/line_file.h"
#include "hodt/io/places_file.h"
#include "hodt/io/png.h"
#include "hodt/io/point_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/picture/picture.h"
#include "hodt/terrain/terrain.h"

namespace hodt::python {

namespace {

using Path = std::filesystem::path;

/// (n, 3), or (n, 2) without heights.
nb::object point_array(PointSet points) {
  if (!points.has_heights()) return places(std::move(points.xy));
  std::vector<std::array<double, 3>> rows(points.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = {points.xy[i].x, points.xy[i].y, points.z[i]};
  const std::size_t size = rows.size();
  return owned<double>(std::move(rows), {size, 3});
}

nb::tuple read_points(const Path& path, const std::array<std::string, 3>& columns,
                      std::size_t threads) {
  PointTable table =
      result_of({threads}, [&](const Progress&) { return read_point_table(path, {columns}); });
  return nb::make_tuple(point_array(std::move(table.points)), nb::cast(table.warnings));
}

nb::tuple read_mesh(const Path& path) {
  Tin tin = result_of({}, [&](const Progress&) { return read_tin(path); });
  const nb::object crs = tin.crs.empty() ? nb::none() : nb::cast(tin.crs);
  return nb::make_tuple(tin_arrays(std::move(tin)), crs);
}

void write_mesh(const PlaceArray& xy, const std::optional<HeightArray>& z,
                const IntegerArray& triangles, const std::string& crs, const Path& path) {
  check_output_extension(path);
  result_of({}, [&](const Progress&) {
    Tin tin = tin_of(xy, z, triangles);
    tin.crs = crs;
    return write_tin(tin, path), 0;
  });
}

nb::object sample(const std::string& name, std::size_t n, std::uint64_t seed, std::size_t threads) {
  return point_array(
      result_of({threads}, [&](const Progress&) { return sample_terrain(name, n, seed); }));
}

nb::dict terrains() {
  nb::dict dict;
  for (const TerrainInfo& terrain : built_in_terrains())
    dict[nb::str(terrain.name.data(), terrain.name.size())] =
        nb::str(terrain.description.data(), terrain.description.size());
  return dict;
}

std::string picture(const PlaceArray& xy, const HeightArray& z, const IntegerArray& before,
                    const IntegerArray& after, const std::string& title) {
  return result_of({}, [&](const Progress&) {
    PictureOptions options;
    options.title = title;
    options.pack = png_of;
    return comparison_picture(tin_of(xy, z, before), tin_of(xy, z, after), options).svg;
  });
}

nb::list line_list(const std::vector<Line>& lines) {
  nb::list list;
  for (const Line& line : lines) {
    nb::object z = nb::none();
    if (line.has_heights()) z = doubles(line.z);
    list.append(nb::make_tuple(places(line.xy), z));
  }
  return list;
}

nb::list read_line_file(const Path& path) {
  return line_list(read_lines(path).lines);
}
nb::list read_outline_file(const Path& path) {
  return line_list(read_outline(path).rings);
}

nb::tuple read_keep_file(const Path& path) {
  Places keep = read_places(path);
  nb::list polygons;
  for (Polygon& polygon : keep.polygons) {
    nb::list rings;
    for (std::vector<Point>& ring : polygon.rings) rings.append(places(std::move(ring)));
    polygons.append(rings);
  }
  return nb::make_tuple(places(std::move(keep.points)), polygons);
}

}  // namespace

void add_files(nb::module_& module) {
  module.def("read_points", read_points, nb::arg("path"), nb::arg("columns"), nb::arg("threads"));
  module.def("read_tin", read_mesh, nb::arg("path"));
  module.def("write_tin", write_mesh, nb::arg("xy"), nb::arg("z").none(), nb::arg("triangles"),
             nb::arg("crs"), nb::arg("path"));
  module.def("read_lines", read_line_file, nb::arg("path"));
  module.def("read_outline", read_outline_file, nb::arg("path"));
  module.def("read_places", read_keep_file, nb::arg("path"));
  module.def("sample", sample, nb::arg("name"), nb::arg("n"), nb::arg("seed"), nb::arg("threads"));
  module.def("terrains", terrains);
  module.def("picture", picture, nb::arg("xy"), nb::arg("z"), nb::arg("before"), nb::arg("after"),
             nb::arg("title"));
}

}  // namespace hodt::python
