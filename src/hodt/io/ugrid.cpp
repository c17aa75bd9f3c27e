#include "hodt/io/ugrid.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hodt/io/bytes.h"
#include "hodt/io/crs_name.h"
#include "hodt/io/netcdf.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

using Attributes = std::vector<NetcdfAttribute>;

// Their places among the dimensions.
constexpr std::size_t kNodes = 0, kFaces = 1, kCorners = 2;
/// Readers look for the grid mapping by this name if there are no heights that name it.
constexpr const char* kGridMapping = "projected_coordinate_system";

char* put_nothing(std::size_t, char* to) {
  return put_big(to, std::int32_t{0});
}

NetcdfVariable topology() {
  return {"mesh",
          NetcdfType::int32,
          {},
          {{"cf_role", "mesh_topology"},
           {"long_name", "triangulated terrain"},
           {"topology_dimension", 2},
           {"node_coordinates", "mesh_node_x mesh_node_y"},
           {"node_dimension", "mesh_nodes"},
           {"face_node_connectivity", "mesh_face_nodes"},
           {"face_dimension", "mesh_faces"}},
          put_nothing};
}

/// GDAL and xarray ask for crs_wkt or spatial_ref; QGIS for wkt, EPSG_code or epsg.
NetcdfVariable grid_mapping(const std::string& crs) {
  Attributes attributes = {{"spatial_ref", crs}};
  if (is_wkt(crs)) {
    attributes.push_back({"crs_wkt", crs});
    attributes.push_back({"wkt", crs});
  } else {
    attributes.push_back({"EPSG_code", crs});
  }
  if (const auto code = epsg_code(crs)) attributes.push_back({"epsg", *code});
  return {kGridMapping, NetcdfType::int32, {}, attributes, put_nothing};
}

/// Attributes of data on nodes or faces.
Attributes located(const Tin& tin, const char* location, Attributes attributes) {
  attributes.push_back({"mesh", "mesh"});
  attributes.push_back({"location", location});
  if (!tin.crs.empty()) attributes.push_back({"grid_mapping", kGridMapping});
  return attributes;
}

void add_nodes(const Tin& tin, NetcdfContent& content) {
  const PointSet& points = tin.points;
  const auto add = [&](const char* name, Attributes attributes, auto value) {
    content.variables.push_back(
        {name,
         NetcdfType::float64,
         {kNodes},
         std::move(attributes),
         [&points, value](std::size_t i, char* to) { return put_big(to, value(points, i)); }});
  };
  add("mesh_node_x", {{"standard_name", "projection_x_coordinate"}, {"long_name", "x of nodes"}},
      [](const PointSet& all, std::size_t i) { return all.xy[i].x; });
  add("mesh_node_y", {{"standard_name", "projection_y_coordinate"}, {"long_name", "y of nodes"}},
      [](const PointSet& all, std::size_t i) { return all.xy[i].y; });
  if (points.has_heights())
    add("mesh_node_z",
        located(tin, "node",
                {{"standard_name", "altitude"},
                 {"long_name", "height"},
                 {"positive", "up"},
                 {"coordinates", "mesh_node_x mesh_node_y"}}),
        [](const PointSet& all, std::size_t i) { return all.z[i]; });
}

void add_faces(const Tin& tin, NetcdfContent& content) {
  content.variables.push_back({"mesh_face_nodes",
                               NetcdfType::int32,
                               {kFaces, kCorners},
                               {{"cf_role", "face_node_connectivity"},
                                {"long_name", "nodes of faces, counter-clockwise"},
                                {"start_index", 0},
                                {"_FillValue", -1}},
                               [&tin](std::size_t t, char* to) {
                                 for (const Index corner : tin.triangles[t])
                                   to = put_big(to, corner);
                                 return to;
                               }});
  if (tin.order.empty()) return;
  content.variables.push_back(
      {"order",
       NetcdfType::int32,
       {kFaces},
       located(tin, "face", {{"long_name", "order"}}),
       [&tin](std::size_t t, char* to) { return put_big(to, tin.order[t]); }});
  // Not a byte: QGIS takes none as data of faces.
  content.variables.push_back({"changed",
                               NetcdfType::int32,
                               {kFaces},
                               located(tin, "face", {{"long_name", "changed"}}),
                               [&tin](std::size_t t, char* to) {
                                 return put_big(to, static_cast<std::int32_t>(tin.is_changed(t)));
                               }});
}

}  // namespace

void write_ugrid(const Tin& tin, OutputFile& file) {
  NetcdfContent content;
  content.dimensions = {
      {"mesh_nodes", tin.points.size()}, {"mesh_faces", tin.triangles.size()}, {"three", 3}};
  content.attributes = {{"Conventions", "CF-1.8 UGRID-1.0"}, {"source", "hodt"}};
  content.variables.push_back(topology());
  if (!tin.crs.empty()) content.variables.push_back(grid_mapping(tin.crs));
  add_nodes(tin, content);
  add_faces(tin, content);
  write_netcdf(content, file);
}

}  // namespace hodt
