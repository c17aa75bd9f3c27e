// The vertices around u that edges of order k at u can depend on.
// Tested by tests/order/useful_edges_test.cpp.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/round_marks.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/local_points.h"
#include "hodt/order/search/sector_levels.h"

namespace hodt {

class Pencil;

/// Gathers a set that holds at least all k-OD neighbours of u: the vertices v such that some circle
/// through u and v has at most k points inside. That is enough to answer exactly, without a look
/// at any other vertex,
///
///  - which edges at u are k-OD edges, or useful, and of what order;
///  - which triangles at u are k-OD triangles, and of what order.
///
/// docs/design/useful-edges.md proves it. Holds scratch memory for one thread.
class Neighbourhood {
 public:
  explicit Neighbourhood(const DelaunayGraph& graph);
  ~Neighbourhood();
  // The pencil refers to it.
  Neighbourhood(const Neighbourhood&) = delete;
  Neighbourhood& operator=(const Neighbourhood&) = delete;

  /// False if it took more than `effort` questions (one point against another); then the set is
  /// not complete.
  bool gather(VertexId u, Index k, std::size_t effort = std::numeric_limits<std::size_t>::max());

  /// From then on gather() throws TimeIsUp.
  void end_at(const Deadline& deadline) { deadline_ = deadline; }

  const DelaunayGraph& graph() const { return graph_; }
  VertexId centre() const { return centre_; }
  Index size() const { return size_; }
  VertexId vertex(Index i) const { return vertices_[i]; }
  const Point& point(Index i) const { return graph_.point(vertices_[i]); }
  /// The first so many are the Delaunay neighbours.
  Index degree() const { return degree_; }
  /// A proven lower bound of the order of the edge from u.
  Index least_order(Index i) const { return least_order_[i]; }
  const LocalPoints& points() const { return points_; }
  /// The circles through u and one of the others.
  Pencil& pencil() { return *pencil_; }

 private:
  void begin_at(VertexId u, Index k);
  template <class Search>
  void reach(const Search& search);
  void add_reached();
  bool bound_orders(Index first, Index last, Index k, std::size_t& effort);

  const DelaunayGraph& graph_;
  Deadline deadline_;
  VertexId centre_;
  Index size_ = 0, degree_ = 0;
  std::vector<VertexId> vertices_;
  LocalPoints points_;  // those reached last are still missing
  SectorLevels levels_;
  std::vector<Index> least_order_;
  std::unique_ptr<Pencil> pencil_;
  RoundMarks seen_;
};

}  // namespace hodt
