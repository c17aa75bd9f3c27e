// The useful edges of a vertex for small orders: a walk over the triangles that segments from it
// can cross.
// Tested by tests/order/useful_edges_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/near_points.h"
#include "hodt/order/search/search_policy.h"

namespace hodt {

/// Walks outward from u, from triangle to triangle, with the window of directions still in sector,
/// and ends where too many points are surely inside the circles of Lemma 4 of every vertex that
/// could follow. docs/design/useful-edges.md proves it. Knows at most 64 kWords points around u, or
/// around each of its triangles if it has very many neighbours, and gives up where that is not
/// enough. Holds scratch memory for one thread.
template <Index kWords>
class WindowWalk {
 public:
  explicit WindowWalk(const DelaunayGraph& graph) : graph_(graph) {}
  /// From then on find_next() throws TimeIsUp, if u has very many neighbours.
  void end_at(const Deadline& deadline) { deadline_ = deadline; }

  /// Starts at u. The candidates to come hold all other ends of useful edges of order 1 to k, each
  /// once.
  void begin(VertexId u, Index k, Towards towards);
  /// Goes on to the next candidate. False if there is none, or if it gives up.
  bool find_next();
  bool gave_up() const { return is_full_; }

  /// The Delaunay edge that the segment to the candidate crosses last has an end on the left of it
  /// and one on the right.
  VertexId candidate() const { return candidate_.vertex; }
  VertexId on_left() const { return vertices_[candidate_.left]; }
  VertexId on_right() const { return vertices_[candidate_.right]; }
  /// The useful order of the edge to the candidate, k + 1 if it is larger. kNone if more points
  /// than it knows would have to be looked at.
  Index useful_order();

 private:
  using Points = NearPoints<kWords>;
  using Set = typename Points::Set;
  using Split = typename Points::Split;

  struct Ray {  // from u
    Index place;
    Split sides;  // its left and right
  };
  /// What is visible from u between two rays, which end at places.
  struct Sector {
    Index left_ray, right_ray;
    Set beyond_left, within, beyond_right;  // surely outside on that side, or inside
  };
  /// A Delaunay edge and what can be seen through it.
  struct Window {
    HalfEdgeId beyond;  // in the triangle across the edge, which is not looked at yet
    Index left, right;  // the ends of the edge
    Sector sector;      // the directions in which u sees through it
    // Surely inside the circle of Lemma 4 through the first point on the other side, whatever is
    // seen through the window.
    Set inside_left, inside_right;
  };
  struct Candidate {
    VertexId vertex;
    Index place, left, right;
    Index known;                      // as many points as the splits are of
    Split left_circle, right_circle;  // through it and the ends of the edge
    Split ray;                        // what is on its left and right
  };
  enum class Side { left, right };

  void look_at_the_time() const;
  void forget();
  template <Index N>
  HODT_INLINE void begin_at_all();
  template <Index N>
  HODT_INLINE void begin_at_next();
  template <Index N>
  HODT_INLINE Ray ray_to(Index place) const {
    return {place, points_.template split<N>(points_.left_of(place))};
  }
  HODT_INLINE void add_first_window(HalfEdgeId h, const Ray& right, const Ray& left);
  void make_room();
  HODT_INLINE void add_window(const Window& window);
  void look_closer(Window& window, const Split& circle) const;
  HODT_INLINE int side_of(const Sector& sector, Index place) const;
  template <Index N>
  HODT_INLINE void look_through(const Window& window);
  template <Index N, Side side>
  HODT_INLINE Index count_in_first_circle(Index first, Split circle);
  Index place_of(VertexId v);
  bool expand(Index place);
  template <Index N>
  HODT_INLINE void add_new_points();
  bool is_sought(Index place) const { return sought_.has(place); }
  const Point& point(Index place) const { return graph_.point(vertices_[place]); }

  const DelaunayGraph& graph_;
  Deadline deadline_;
  VertexId u_;
  Index k_ = 0;
  Towards towards_ = Towards::all;
  double nearest_ = 1;
  HalfEdgeId next_;  // from u: where to begin next; kNone if all is begun
  Points points_;
  Set sought_;                                     // those of them that could be the other end
  std::array<VertexId, Set::kMost + 1> vertices_;  // parallel to the points, and room for one more
  Index size_ = 0;                                 // of the points
  Set expanded_;                                   // whose neighbours all have places
  bool is_full_ = false;                           // some vertex got no place
  // The first `opened_`, `passed_` of them done with. First come, first served: so a processor can
  // go on to the next one before it knows what the last one led to.
  std::vector<Window> windows_;
  std::size_t passed_ = 0, opened_ = 0;
  Candidate candidate_;
  // Of a vertex that has a place, first_place_ plus that. Of all others more than could be a place:
  // numbers go down from walk to walk.
  static constexpr std::uint32_t kPlaces = Set::kMost + 1;
  Buffer<std::uint32_t> places_;  // from the first walk on
  std::uint32_t first_place_ = 0;
};

extern template class WindowWalk<1>;
extern template class WindowWalk<4>;
extern template class WindowWalk<16>;

}  // namespace hodt
