#include "constraints.h"

#include <nanobind/stl/optional.h>

namespace hodt::python {

namespace {

Line line_of(const PlaceArray& xy, const std::optional<HeightArray>& z, std::size_t number) {
  Line line{copy_of(rows_of<Point>(xy)), {}, static_cast<Index>(number)};
  if (z) line.z.assign(z->data(), z->data() + z->shape(0));
  return line;
}

void add_breakline(ConstraintInput& input, const PlaceArray& xy,
                   const std::optional<HeightArray>& z) {
  input.breaklines.lines.push_back(line_of(xy, z, input.breaklines.lines.size() + 1));
}

void add_ring(ConstraintInput& input, const PlaceArray& xy, const std::optional<HeightArray>& z) {
  Line ring = line_of(xy, z, input.outline.rings.size() + 1);
  if (!ring.is_closed()) {
    ring.xy.push_back(ring.xy.front());
    if (ring.has_heights()) ring.z.push_back(ring.z.front());
  }
  input.outline.rings.push_back(std::move(ring));
}

/// Edges by rows as one more source of lines; where each of them comes from.
std::vector<Joined::Origin> add_source(const std::vector<Constraints::Edge>& edges,
                                       const std::string& source, Joined& joined) {
  std::vector<Joined::Origin> origins;
  Lines lines{{}, source, "row"};
  for (Index i = 0; i < edges.size(); ++i) {
    for (const Index row : edges[i])
      if (row >= joined.points.size())
        throw ParameterError(fmt::format("an edge ends at row {}, but there are {} points", row,
                                         joined.points.size()));
    const auto& [u, v] = edges[i];
    lines.lines.push_back({{joined.points.xy[u], joined.points.xy[v]}, {}, i});
    origins.push_back({static_cast<Index>(joined.sources.size()), i, 0});
  }
  joined.sources.push_back(std::move(lines));
  return origins;
}

}  // namespace

Joined ConstraintInput::join(PointSet points) const {
  Joined joined;
  const std::size_t rows = points.size();
  if (has_lines()) {
    std::optional<Outline> rings;
    if (!outline.rings.empty()) rings = outline;
    std::vector<Lines> lines;
    if (!breaklines.lines.empty()) lines.push_back(breaklines);
    joined = join_lines(points, lines, rings, options);
  } else {
    joined.points = std::move(points);
  }
  for (const auto& list : {edges, boundary})
    for (const Constraints::Edge& edge : list)
      for (const Index row : edge)
        if (row >= rows)
          throw ParameterError(fmt::format(
              "a constraint ends at row {}, counted from 0, but there are {} points", row, rows));
  if (has_lines()) {
    // After the breaklines, before the boundary: so the origins go.
    const std::vector<Joined::Origin> of_edges = add_source(edges, "edges", joined);
    joined.origins.insert(joined.origins.begin() + std::ptrdiff_t(joined.constraints.edges.size()),
                          of_edges.begin(), of_edges.end());
    const std::vector<Joined::Origin> of_boundary = add_source(boundary, "boundary", joined);
    joined.origins.insert(joined.origins.end(), of_boundary.begin(), of_boundary.end());
  }
  Constraints& constraints = joined.constraints;
  constraints.edges.insert(constraints.edges.end(), edges.begin(), edges.end());
  constraints.boundary.insert(constraints.boundary.end(), boundary.begin(), boundary.end());
  constraints.max_edge = max_edge;
  return joined;
}

void add_constraint_input(nb::module_& module) {
  const auto add_rows = [](std::vector<Constraints::Edge>& edges, const IntegerArray& rows) {
    const auto added = rows_of<Constraints::Edge>(rows);
    edges.insert(edges.end(), added.begin(), added.end());
  };
  nb::class_<ConstraintInput>(module, "ConstraintInput")
      .def(nb::init<>())
      .def("add_breakline", add_breakline, nb::arg("xy"), nb::arg("z").none())
      .def("add_ring", add_ring, nb::arg("xy"), nb::arg("z").none())
      .def(
          "add_edges",
          [=](ConstraintInput& input, const IntegerArray& rows) { add_rows(input.edges, rows); },
          nb::arg("rows"))
      .def(
          "add_boundary",
          [=](ConstraintInput& input, const IntegerArray& rows) { add_rows(input.boundary, rows); },
          nb::arg("rows"))
      .def_rw("max_edge", &ConstraintInput::max_edge)
      .def_prop_rw(
          "snap", [](const ConstraintInput& input) { return input.options.snap; },
          [](ConstraintInput& input, double snap) { input.options.snap = snap; })
      .def_prop_rw(
          "split_crossings",
          [](const ConstraintInput& input) { return input.options.split_crossings; },
          [](ConstraintInput& input, bool split) { input.options.split_crossings = split; });
}

Places keep_of(nb::handle keep) {
  Places places;
  if (keep.is_none()) return places;
  places.source = "keep";
  const auto at = nb::cast<PlaceArray>(keep.attr("points"));
  places.points = copy_of(rows_of<Point>(at));
  for (const nb::handle rings : keep.attr("polygons")) {
    Polygon polygon;
    for (const nb::handle ring : rings)
      polygon.rings.push_back(copy_of(rows_of<Point>(nb::cast<PlaceArray>(ring))));
    places.polygons.push_back(std::move(polygon));
  }
  places.part = "place";
  for (Index i = 0; i < places.points.size(); ++i) places.part_of_point.push_back(i);
  for (Index i = 0; i < places.polygons.size(); ++i) places.part_of_polygon.push_back(i);
  return places;
}

}  // namespace hodt::python
