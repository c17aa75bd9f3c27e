#include "hodt/tin/embedding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

using Points = std::vector<Point>;
using Triangle = std::array<Index, 3>;
using Triangles = std::vector<Triangle>;

// --- The definition, pair by pair, in rational arithmetic on small whole coordinates. ---

struct Fraction {
  long num = 0, den = 1;  // den > 0
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.num * b.den < b.num * a.den;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.num * b.den == b.num * a.den;
  }
};
using Spot = std::array<Fraction, 2>;

long cross(const Point& a, const Point& b, const Point& c) {
  return std::lround((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

bool in_triangle(const Points& p, const Triangle& t, const Point& q) {
  const long u = cross(p[t[0]], p[t[1]], q), v = cross(p[t[1]], p[t[2]], q),
             w = cross(p[t[2]], p[t[0]], q);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

Spot spot(const Point& p) {
  return {{{std::lround(p.x), 1}, {std::lround(p.y), 1}}};
}

/// The corners of the intersection of two triangles (a convex polygon): every one is a corner of
/// one triangle inside the other, or a crossing of two edges that are not parallel.
std::vector<Spot> intersection_corners(const Points& p, const Triangle& s, const Triangle& t) {
  std::vector<Spot> corners;
  const auto add = [&](const Spot& c) {
    if (std::find(corners.begin(), corners.end(), c) == corners.end()) corners.push_back(c);
  };
  for (const Index v : s) {
    if (in_triangle(p, t, p[v])) add(spot(p[v]));
  }
  for (const Index v : t) {
    if (in_triangle(p, s, p[v])) add(spot(p[v]));
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Point &a = p[s[i]], &b = p[s[(i + 1) % 3]], &c = p[t[j]], &d = p[t[(j + 1) % 3]];
      const long ca = cross(c, d, a), cb = cross(c, d, b);
      const long ac = cross(a, b, c), ad = cross(a, b, d);
      if (ca == cb || ca * cb > 0 || ac * ad > 0) continue;
      // a + (b - a) ca / (ca - cb)
      long den = ca - cb, num = ca;
      if (den < 0) den = -den, num = -num;
      const auto along = [&](double from, double to) {
        return Fraction{std::lround(from) * den + std::lround(to - from) * num, den};
      };
      add({along(a.x, b.x), along(a.y, b.y)});
    }
  }
  return corners;
}

/// Whether two triangles with an inside meet in nothing, a shared corner or a shared edge.
bool meet_properly(const Points& p, const Triangle& s, const Triangle& t) {
  std::vector<Spot> shared;
  for (const Index v : s) {
    if (std::find(t.begin(), t.end(), v) != t.end()) shared.push_back(spot(p[v]));
  }
  const auto corners = intersection_corners(p, s, t);
  if (corners.size() != shared.size() || corners.size() == 3) return false;
  return std::all_of(corners.begin(), corners.end(), [&](const Spot& c) {
    return std::find(shared.begin(), shared.end(), c) != shared.end();
  });
}

bool embedded_by_definition(const Points& p, const Triangles& triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    if (cross(p[a], p[b], p[c]) == 0) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (!meet_properly(p, triangles[j], triangles[i])) return false;
    }
  }
  return true;
}

/// Embedded, and twice its area is twice the hull's.
bool covers_hull_by_definition(const Points& p, const Triangles& triangles) {
  if (!embedded_by_definition(p, triangles)) return false;
  long area = 0;
  for (const auto& [a, b, c] : triangles) area += std::abs(cross(p[a], p[b], p[c]));
  Points sorted = p;
  std::sort(sorted.begin(), sorted.end(), lexicographically_less);
  long hull = 0;
  for (const int direction : {1, -1}) {
    Points chain;
    for (const Point& q : sorted) {
      while (chain.size() > 1 && direction * cross(chain[chain.size() - 2], chain.back(), q) <= 0) {
        chain.pop_back();
      }
      chain.push_back(q);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      hull += direction * cross({0, 0}, chain[i], chain[i + 1]);
    }
  }
  return area == hull;
}

void expect_as_defined(const Points& points, const Triangles& triangles) {
  const Embedding found = check_embedding(points, triangles);
  ASSERT_EQ(found.embedded, embedded_by_definition(points, triangles))
      << found.problem << " of " << testing::PrintToString(triangles);
  ASSERT_EQ(found.covers_hull, covers_hull_by_definition(points, triangles));
  ASSERT_EQ(found.embedded, found.problem.empty());
}

Points lattice(int side) {
  Points points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) points.push_back({double(x), double(y)});
  }
  return points;
}

TEST(Embedding, AgreesWithTheDefinitionOnRandomTriangles) {
  std::mt19937 random(1);
  for (int round = 0; round < 30000; ++round) {
    const Points points = lattice(3 + round % 3);
    Triangles triangles(1 + random() % 4);
    for (auto& triangle : triangles) {
      for (Index& v : triangle) v = static_cast<Index>(random() % points.size());
    }
    ASSERT_NO_FATAL_FAILURE(expect_as_defined(points, triangles)) << "round " << round;
  }
}

/// Grows a mesh by random triangles as long as the definition holds, so that many are embedded.
TEST(Embedding, AgreesWithTheDefinitionOnGrownMeshes) {
  std::mt19937 random(2);
  int embedded = 0;
  for (int round = 0; round < 400; ++round) {
    Points points = lattice(4);
    if (round % 2) points.push_back(points[random() % points.size()]);
    Triangles triangles;
    for (int attempt = 0; attempt < 150; ++attempt) {
      Triangles more = triangles;
      Triangle triangle;
      for (Index& v : triangle) v = static_cast<Index>(random() % points.size());
      more.push_back(triangle);
      ASSERT_NO_FATAL_FAILURE(expect_as_defined(points, more)) << "round " << round;
      if (check_embedding(points, more).embedded) triangles = more;
    }
    embedded += check_embedding(points, triangles).covers_hull;
  }
  EXPECT_GT(embedded, 0);
}

/// Two triangles a cell of a lattice with `side` points a side.
Triangles cells(Index side) {
  Triangles triangles;
  for (Index y = 0; y + 1 < side; ++y) {
    for (Index x = 0; x + 1 < side; ++x) {
      const Index a = y * side + x, c = a + side;
      triangles.push_back({a, a + 1, c + 1});
      triangles.push_back({a, c + 1, c});
    }
  }
  return triangles;
}

TEST(Embedding, DamageToALatticeIsFound) {
  std::mt19937 random(3);
  const Points points = lattice(6);
  for (int round = 0; round < 3000; ++round) {
    Triangles triangles = cells(6);
    std::shuffle(triangles.begin(), triangles.end(), random);
    triangles.resize(1 + random() % triangles.size());
    if (random() % 2) triangles[random() % triangles.size()][random() % 3] = random() % 36;
    if (random() % 4 == 0) triangles.push_back(triangles[random() % triangles.size()]);
    ASSERT_NO_FATAL_FAILURE(expect_as_defined(points, triangles)) << "round " << round;
  }
}

TEST(Embedding, DescribesAGoodMesh) {
  Points points = lattice(3);
  Triangles triangles = cells(3);
  Embedding found = check_embedding(points, triangles);
  EXPECT_TRUE(found.embedded);
  EXPECT_TRUE(found.covers_hull);
  EXPECT_EQ(found.components, 1u);
  EXPECT_EQ(found.boundary_edges, 8u);
  EXPECT_EQ(found.clockwise, 0u);

  std::swap(triangles[3][0], triangles[3][1]);
  points.push_back({1.5, 1.25});
  found = check_embedding(points, triangles);
  EXPECT_TRUE(found.covers_hull);
  EXPECT_EQ(found.clockwise, 1u);
  EXPECT_EQ(found.unused_vertices, 1u);

  points.push_back({2, 3});
  EXPECT_FALSE(check_embedding(points, triangles).covers_hull);
}

TEST(Embedding, CountsComponentsByEdges) {
  const Points points = lattice(3);
  const Embedding found = check_embedding(points, Triangles{{0, 1, 4}, {4, 5, 8}});
  EXPECT_TRUE(found.embedded);
  EXPECT_FALSE(found.covers_hull);
  EXPECT_EQ(found.components, 2u);
}

TEST(Embedding, AllowsHoles) {
  Triangles triangles = cells(4);
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == 5; });
  const Embedding found = check_embedding(lattice(4), triangles);
  EXPECT_TRUE(found.embedded);
  EXPECT_FALSE(found.covers_hull);
}

TEST(Embedding, NamesTheProblem) {
  struct Case {
    Triangles triangles;
    const char* problem;
  };
  Points points = lattice(3);
  points.push_back({0, 0});
  const Case cases[] = {
      {{{0, 1, 2}}, "triangle 0 (0, 1, 2) has no inside"},
      {{{0, 1, 4}, {3, 3, 4}}, "triangle 1 (3, 3, 4) has no inside"},
      {{{0, 1, 4}, {4, 0, 1}}, "same side of edge"},
      {{{0, 1, 4}, {1, 0, 4}, {4, 5, 8}}, "overlap"},
      {{{0, 2, 8}, {1, 0, 3}}, "vertex 1 of triangle 1 (1, 0, 3) lies within edge 0-2"},
      {{{0, 1, 4}, {9, 4, 3}}, "vertices 0 and 9 have the same coordinates"},
      {{{0, 2, 8}, {1, 5, 3}}, "edge"},
  };
  for (const Case& c : cases) {
    const Embedding found = check_embedding(points, c.triangles);
    EXPECT_FALSE(found.embedded);
    EXPECT_FALSE(found.covers_hull);
    EXPECT_NE(found.problem.find(c.problem), std::string::npos) << found.problem;
  }
}

/// A fan that goes around its centre twice: every local look is fine, the whole is not.
TEST(Embedding, FindsADoubleFan) {
  constexpr int steps = 10;
  Points points = {{0, 0}};
  Triangles triangles;
  for (int i = 0; i < steps; ++i) {
    const double angle = 4 * M_PI * i / steps, radius = 1 + 0.01 * i;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    triangles.push_back({0, Index(1 + i), Index(1 + (i + 1) % steps)});
  }
  const Embedding found = check_embedding(points, triangles);
  EXPECT_FALSE(found.embedded);
  EXPECT_FALSE(found.problem.empty());
}

/// An island on top of a mesh crosses no boundary.
TEST(Embedding, FindsATriangleOnTopOfAMesh) {
  Points points = lattice(4);
  const Index first = static_cast<Index>(points.size());
  points.insert(points.end(), {{1.25, 1.25}, {1.75, 1.25}, {1.5, 1.75}});
  Triangles triangles = cells(4);
  triangles.push_back({first, first + 1, first + 2});
  const Embedding found = check_embedding(points, triangles);
  EXPECT_FALSE(found.embedded);
  EXPECT_NE(found.problem.find("triangle 18"), std::string::npos) << found.problem;
}

}  // namespace
}  // namespace hodt
