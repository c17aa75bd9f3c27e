// CGAL as a second oracle, for sets that are too large for the first.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "convert.h"
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace support {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalVertex = CGAL::Triangulation_vertex_base_with_info_2<int, CgalKernel>;
using CgalDelaunay =
    CGAL::Delaunay_triangulation_2<CgalKernel, CGAL::Triangulation_data_structure_2<CgalVertex>>;
using CgalConstrained = CGAL::Constrained_Delaunay_triangulation_2<
    CgalKernel, CGAL::Triangulation_data_structure_2<
                    CgalVertex, CGAL::Constrained_triangulation_face_base_2<CgalKernel>>>;

template <class Triangulation>
oracle::Triangles cgal_triangles(const Triangulation& triangulation) {
  oracle::Triangles triangles;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    triangles.push_back(
        canonical({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}));
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// The Delaunay triangulation by CGAL, which breaks ties by the same perturbation. The points must
/// be distinct.
inline oracle::Triangles cgal_delaunay(std::span<const hodt::Point> points) {
  std::vector<std::pair<CgalKernel::Point_2, int>> sites;
  for (const hodt::Point& p : points)
    sites.emplace_back(CgalKernel::Point_2(p.x, p.y), static_cast<int>(sites.size()));
  return cgal_triangles(CgalDelaunay(sites.begin(), sites.end()));
}

/// The constrained Delaunay triangulation by CGAL. No ties: there it is free to choose.
inline oracle::Triangles cgal_constrained(std::span<const hodt::Point> points,
                                          const std::vector<std::pair<int, int>>& edges) {
  CgalConstrained triangulation;
  std::vector<CgalConstrained::Vertex_handle> handles;
  for (const hodt::Point& p : points) {
    const auto near = handles.empty() ? CgalConstrained::Face_handle() : handles.back()->face();
    handles.push_back(triangulation.insert(CgalKernel::Point_2(p.x, p.y), near));
    handles.back()->info() = static_cast<int>(handles.size()) - 1;
  }
  for (const auto& [a, b] : edges) triangulation.insert_constraint(handles[a], handles[b]);
  return cgal_triangles(triangulation);
}

}  // namespace support
