// The useful edges of a vertex for small orders: a walk over the triangles that segments from it
// can cross.
#pragma once

#include <cstdint>
#include <vector>

#include "hodt/order/delaunay_graph.h"
#include "hodt/order/near_points.h"

namespace hodt {

/// Where to look for the other ends of edges.
enum class Towards { all, larger };  // larger: lexicographically larger vertices

/// Walks outward from u, from triangle to triangle, with the window of directions still in sight,
/// and ends where too many points are surely inside the circles of Lemma 4 of every vertex that
/// could follow. docs/design/useful-edges.md proves it. Knows at most NearPoints::kMost points
/// around u, and gives up where that is not enough. Holds scratch memory for one thread.
class WindowWalk {
 public:
  explicit WindowWalk(const DelaunayGraph& graph) : graph_(graph), places_(graph.xy.size(), 0) {}

  /// Starts at u. The candidates to come hold all other ends of useful edges of order 1 to k. False
  /// if it gives up.
  bool begin(VertexId u, Index k, Towards towards);
  /// Goes on to the next candidate. False if there is none, or if it gives up.
  bool find_next();
  bool gave_up() const { return is_full_; }
  VertexId candidate() const { return candidate_.vertex; }
  /// The useful order of the edge to the candidate, k + 1 if it is larger; kNone if it gives up.
  Index useful_order();

 private:
  /// What can be seen from u through a Delaunay edge, between two rays. All ends are places.
  struct Window {
    HalfEdgeId beyond;  // in the triangle across the edge, which is not looked at yet
    Index left, right;  // the ends of the edge
    Index left_ray, right_ray;
    PlaceSet beyond_left, within, beyond_right;  // surely outside on that side, or seen
    // Surely inside the circle of Lemma 4 through the first point on the other side, whatever is
    // seen through the window.
    PlaceSet inside_left, inside_right;
  };
  /// The Delaunay edge that the segment crosses last has its ends on the left and right of it.
  struct Candidate {
    VertexId vertex;
    Index place, left, right;
    NearPoints::Split ray;  // what is on its left and right
  };
  enum class Side { left, right };

  template <Index N>
  void begin_at(VertexId u);
  template <Index N>
  void open_first_windows();
  void open(const Window& window);
  int side_of(const Window& window, Index place) const;
  template <Index N>
  void pass(const Window& window);
  template <Index N, Side side>
  Index count_across(Index first);
  Index place_of(VertexId v);
  void expand(Index place);
  bool is_sought(Index place) const {
    return (towards_ == Towards::all) | points_.is_larger(place);
  }
  template <Index N>
  void take_up();
  const Point& point(Index place) const { return graph_.point(vertices_[place]); }

  const DelaunayGraph& graph_;
  Index k_ = 0;
  Towards towards_ = Towards::all;
  NearPoints points_;
  std::array<VertexId, NearPoints::kMost> vertices_;  // parallel to the points
  PlaceSet expanded_ = 0;                             // whose neighbours all have places
  Index size_ = 0;                                    // of these
  bool is_full_ = false;                              // some vertex got no place
  std::vector<Window> open_;
  std::size_t open_count_ = 0;
  Candidate candidate_;
  // Of every vertex the round in which it got its place, and the place in the low bits.
  Buffer<std::uint32_t> places_;
  std::uint32_t round_ = 0;
};

}  // namespace hodt
