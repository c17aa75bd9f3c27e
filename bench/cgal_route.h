// CGAL's best route from coordinates to flat arrays: spatial_sort of point-index pairs, insertion
// with the last face as hint, then the arrays read off the finite faces.
#pragma once

#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include "hodt/geometry/point.h"

namespace cgal_route {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<unsigned, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<unsigned, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel,
                                   CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

struct Arrays {
  std::vector<unsigned> triangles, neighbours;
};

inline Arrays triangulate(const std::vector<hodt::Point>& points) {
  using Pair = std::pair<Kernel::Point_2, unsigned>;
  std::vector<Pair> pairs;
  pairs.reserve(points.size());
  for (unsigned i = 0; i < points.size(); ++i)
    pairs.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
  CGAL::spatial_sort(
      pairs.begin(), pairs.end(),
      CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Pair>>());
  Triangulation t;
  Triangulation::Face_handle hint;
  for (const Pair& p : pairs) {
    const auto v = t.insert(p.first, hint);
    v->info() = p.second;
    hint = v->face();
  }
  Arrays arrays;
  unsigned count = 0;
  for (auto f = t.all_faces_begin(); f != t.all_faces_end(); ++f)
    f->info() = t.is_infinite(f) ? ~0u : count++;
  arrays.triangles.resize(3 * count);
  arrays.neighbours.resize(3 * count);
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    for (unsigned i = 0; i < 3; ++i) {
      arrays.triangles[3 * f->info() + i] = f->vertex(i)->info();
      arrays.neighbours[3 * f->info() + i] = f->neighbor(i)->info();
    }
  return arrays;
}

}  // namespace cgal_route
