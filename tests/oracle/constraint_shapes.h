// Constraints of every shape, for the points of an Instance: paths, stars, closed rings, outlines
// with holes and islands, and edges at random. The same seed gives the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "constrained.h"
#include "families.h"

namespace oracle {

/// The points and constraints, so that a failure can become a test of its own.
std::string describe(const Constrained& constrained);

/// The segment passes through no third point and crosses none of the edges.
bool fits(const Instance& instance, const std::vector<Edge>& edges, int u, int v);

/// A path that turns at random and may come back to where it has been.
std::vector<Edge> random_path(const Instance& instance, families::Random& random);
std::vector<Edge> random_star(const Instance& instance, families::Random& random);

/// Some triangles of a triangulation, and what bounds them.
struct Domain {
  Rings rings;
  std::vector<Edge> edges;  ///< of the rings
  Triangles inside, outside;
};

/// The domain that consists of the triangles of one triangulation that are inside.
Domain domain_of(const Triangles& inside, const Triangles& outside);
/// A random set of triangles of a random triangulation: outlines, holes, islands and rings that
/// touch.
Domain random_domain(const Instance& instance, families::Random& random);

/// Of one of these shapes.
std::vector<Edge> random_edges(const Instance& instance, std::uint64_t seed);

/// Points on one circle, far inside a triangle: only so can a path go around a point on a circle.
Points ring_within(int n, std::uint64_t seed);
/// All families of points, and this one.
std::vector<families::Family> families_for_constraints();

}  // namespace oracle
