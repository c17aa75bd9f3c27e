#include "constraint_shapes.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

namespace oracle {

std::string describe(const Constrained& constrained) {
  std::ostringstream text;
  text.precision(17);
  text << "points";
  for (const auto& [x, y] : constrained.instance().points()) text << " (" << x << ", " << y << ')';
  text << " constraints";
  for (const Edge& e : constrained.edges()) text << ' ' << e[0] << '-' << e[1];
  return text.str();
}

bool fits(const Instance& instance, const std::vector<Edge>& edges, int u, int v) {
  return u != v && instance.is_segment_free(u, v) &&
         std::ranges::none_of(
             edges, [&](const Edge& e) { return instance.segments_cross(e[0], e[1], u, v); });
}

std::vector<Edge> random_path(const Instance& instance, families::Random& random) {
  std::vector<Edge> edges;
  int at = random.integer(0, instance.size() - 1);
  for (int tries = random.integer(2, 3 * instance.size()); tries > 0; --tries) {
    const int next = random.integer(0, instance.size() - 1);
    if (!fits(instance, edges, at, next)) continue;
    edges.push_back({at, next});
    at = next;
  }
  return edges;
}

std::vector<Edge> random_star(const Instance& instance, families::Random& random) {
  std::vector<Edge> edges;
  const int hub = random.integer(0, instance.size() - 1);
  for (int v = 0; v < instance.size(); ++v) {
    if (random.integer(0, 2) > 0 && fits(instance, edges, hub, v)) edges.push_back({hub, v});
  }
  return edges;
}

Domain domain_of(const Triangles& inside, const Triangles& outside) {
  Domain domain{{}, {}, inside, outside};
  std::multimap<int, int> next;
  const auto toggle = [&](int u, int v) {
    const auto [from, to] = next.equal_range(v);
    const auto twin = std::find_if(from, to, [&](const auto& e) { return e.second == u; });
    if (twin == to) {
      next.insert({u, v});
    } else {
      next.erase(twin);
    }
  };
  for (const Triangle& t : inside)
    for (int i = 0; i < 3; ++i) toggle(t[i], t[(i + 1) % 3]);
  for (const auto& [u, v] : next) domain.edges.push_back({u, v});
  while (!next.empty()) {
    std::vector<int> ring;
    for (auto e = next.begin(); e != next.end(); e = next.find(ring.back())) {
      ring.push_back(e->second);
      next.erase(e);
    }
    domain.rings.push_back(ring);
  }
  return domain;
}

Domain random_domain(const Instance& instance, families::Random& random) {
  const Constrained some(instance, random_constraints(instance, 99, random.bits()));
  Triangles inside, outside;
  const int share = random.integer(1, 3);
  for (const Triangle& t : some.some_triangulation())
    (random.integer(0, 3) <= share ? inside : outside).push_back(t);
  return domain_of(inside, outside);
}

std::vector<Edge> random_edges(const Instance& instance, std::uint64_t seed) {
  families::Random random(seed);
  switch (random.integer(0, 3)) {
    case 0:
      return random_path(instance, random);
    case 1:
      return random_star(instance, random);
    case 2:
      return random_domain(instance, random).edges;
    default:
      return random_constraints(instance, random.integer(1, instance.size() - 2), seed);
  }
}

Points ring_within(int n, std::uint64_t seed) {
  families::Random random(seed);
  Points points = families::ring(n - 3, seed, 25, random.integer(0, 3) == 0);
  for (const auto& [x, y] : {std::pair{-20, -21}, {23, -19}, {2, 24}}) {
    points.emplace_back(x + random.integer(-4, 4), y + random.integer(-4, 4));
  }
  return points;
}

std::vector<families::Family> families_for_constraints() {
  std::vector<families::Family> all = families::all();
  all.push_back(
      {"ring_within", [](int n, std::uint64_t seed) { return ring_within(std::max(n, 6), seed); }});
  return all;
}

}  // namespace oracle
