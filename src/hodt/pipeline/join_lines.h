// Points and lines on one map: what a triangulation with breaklines and an outline begins with.
// Tested by tests/exhaustive/join_lines_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hodt/geometry/constraints.h"
#include "hodt/geometry/lines.h"
#include "hodt/geometry/point_set.h"
#include "hodt/order/constrained/constrained_delaunay.h"

namespace hodt {

struct JoinOptions {
  /// Lines that cross get a vertex there. If not, that is an error, not of join_lines() but of who
  /// triangulates.
  bool split_crossings = false;
  /// Vertices of lines that are no further than this from a point move to the nearest one.
  double snap = 0;
  /// Triangles on the points, embedded: the surface that vertices without heights take theirs from,
  /// if it is not the Delaunay triangulation's.
  std::span<const std::array<Index, 3>> surface = {};
};

struct JoinReport {
  std::size_t added = 0;      ///< vertices of lines that became points
  std::size_t at_points = 0;  ///< vertices of lines at the place of a point
  std::size_t snapped = 0;    ///< of these, vertices that moved there
  std::size_t collapsed = 0;  ///< pieces of lines whose ends moved to the same point
  std::size_t soft = 0;       ///< of those added, vertices whose height is the surface's
  /// Places whose point had another height than a line gives it, and the largest difference.
  std::size_t heights_replaced = 0;
  double largest_replacement = 0;
  /// Places that lines give different heights, where the first one's counts, likewise.
  std::size_t heights_in_conflict = 0;
  double largest_conflict = 0;
  /// Points that lines with heights pass through between their vertices at other heights, which
  /// stay, and the largest difference.
  std::size_t heights_passed = 0;
  double largest_passed = 0;
  /// Vertices added where lines cross, and the largest difference of the two lines' heights there.
  std::size_t crossings = 0;
  double largest_crossing_difference = 0;
};

/// The points, followed by the vertices of lines that were none.
struct Joined {
  PointSet points;
  Constraints constraints;
  JoinReport report;
  /// Of every edge of the constraints, those of the boundary after the others, which piece of which
  /// line it is: "roads.geojson, feature 3, between x 1, y 2 and x 3, y 4".
  std::string place_of(Index edge) const;

  // By source and line.
  struct Origin {
    Index source, line, segment;
  };
  std::vector<Origin> origins;
  std::vector<Lines> sources;
};

/// Joins the points with lines, whose pieces become edges of the constraints, and with an outline,
/// whose pieces become the boundary. Of a vertex at the place of a point the height of the line, if
/// it has one, becomes the point's. Vertices without heights that are at no point take theirs from
/// the Delaunay triangulation of the points and the vertices with heights, constrained to the lines
/// with heights. Where a line with heights crosses one without, the height is that of the first. If
/// the points have no heights, those of lines do not count.
///
/// Throws InputError if all lines of a source are beside the points, so that they are of another
/// coordinate system; naming the line and the vertex, if such a vertex is outside of that
/// triangulation; and, with split_crossings, if after very many vertices lines still cross.
Joined join_lines(const PointSet& points, std::span<const Lines> lines,
                  const std::optional<Outline>& outline, const JoinOptions& options = {});

/// What CrossingError says, by the lines' names.
std::string crossing_text(const Joined& joined, const CrossingEdges& crossing);

}  // namespace hodt
