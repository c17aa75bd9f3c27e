#include "hodt/optimize/face_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <tuple>

#include <coin/Clp_C_Interface.h>

namespace hodt {

namespace {

constexpr int kMostIterations = 1'000'000;

/// An edge of one of the triangles, or a side of the face (triangle kNone).
struct Use {
  Index low, high;
  bool forward;  // from low to high
  Index triangle;
  auto key() const { return std::tuple(low, high); }
};

/// The matrix, by columns: every triangle has three entries.
struct Program {
  std::vector<int> row_of;  // of entry 3t + i
  std::vector<double> sign_of;
  std::vector<double> right_hand_side;
};

Use use_of(VertexId u, VertexId v, Index triangle) {
  return {std::min<Index>(u, v), std::max<Index>(u, v), u < v, triangle};
}

/// A row for every inner edge (left minus right is 0), and one for every side (the sum is 1).
Program program_of(const FaceProblem& face) {
  std::vector<std::pair<Use, int>> uses;  // with the entry
  for (Index t = 0; t < face.triangles.size(); ++t)
    for (Index i = 0; i < 3; ++i) {
      const auto& corners = face.triangles[t].corners;
      uses.emplace_back(use_of(corners[i], corners[(i + 1) % 3], t), int(3 * t + i));
    }
  for (const auto& [u, v] : face.sides) uses.emplace_back(use_of(u, v, kNone), -1);
  std::sort(uses.begin(), uses.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.key(), a.second) < std::tuple(b.first.key(), b.second);
  });
  Program program;
  program.row_of.resize(3 * face.triangles.size());
  program.sign_of.resize(3 * face.triangles.size());
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].first.key() == uses[first].first.key()) ++last;
    // Sides sort first. An edge with both sides on the face has two.
    const bool is_side = uses[first].second < 0;
    int rows[2];
    if (is_side) {
      for (int& row : rows) {
        row = int(program.right_hand_side.size());
        program.right_hand_side.push_back(0);
      }
    } else {
      rows[0] = rows[1] = int(program.right_hand_side.size());
      program.right_hand_side.push_back(0);
    }
    for (std::size_t i = first; i < last; ++i) {
      const auto& [use, entry] = uses[i];
      const int row = rows[use.forward ? 0 : 1];
      if (entry < 0) {
        program.right_hand_side[std::size_t(row)] = 1;
      } else {
        program.row_of[std::size_t(entry)] = row;
        program.sign_of[std::size_t(entry)] = is_side || use.forward ? 1 : -1;
      }
    }
  }
  return program;
}

/// For any y: the cost of x is y·b plus that of what the costs exceed y's part by, and x is between
/// 0 and 1, and all its entries together are the number of triangles.
double bound_from_duals(const FaceProblem& face, const Program& program,
                        const std::vector<double>& costs, const double* duals) {
  double bound = 0, size = 0;
  for (std::size_t row = 0; row < program.right_hand_side.size(); ++row) {
    bound += program.right_hand_side[row] * duals[row];
    size += program.right_hand_side[row] * std::fabs(duals[row]);
  }
  double least = 0;
  double all = 0;
  for (std::size_t t = 0; t < costs.size(); ++t) {
    double reduced = costs[t], magnitude = std::fabs(costs[t]);
    for (std::size_t e = 3 * t; e < 3 * t + 3; ++e) {
      const double part = program.sign_of[e] * duals[program.row_of[e]];
      reduced -= part;
      magnitude += std::fabs(part);
    }
    reduced -= 4 * 0x1p-52 * magnitude;
    least = std::min(least, reduced);
    all += std::min(0.0, reduced);
  }
  // Sums of so many terms.
  const double rounding = double(program.right_hand_side.size()) * 0x1p-52 * size;
  return bound - rounding + std::max(double(face.size) * least, all * (1 + 1e-9));
}

/// Whether the chosen triangles fit together: every side once, every inner edge from both sides.
bool is_triangulation(const FaceProblem& face, const std::vector<Index>& chosen) {
  if (chosen.size() != face.size) return false;
  std::vector<std::pair<VertexId, VertexId>> edges, expected(face.sides.begin(), face.sides.end());
  for (const Index t : chosen)
    for (Index i = 0; i < 3; ++i)
      edges.emplace_back(face.triangles[t].corners[i], face.triangles[t].corners[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::sort(expected.begin(), expected.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  if (!std::includes(edges.begin(), edges.end(), expected.begin(), expected.end())) return false;
  for (const auto& edge : edges)
    if (!std::binary_search(expected.begin(), expected.end(), edge) &&
        !std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first)))
      return false;
  return true;
}

}  // namespace

FaceSolution solve_face_program(const FaceProblem& face, const TriangleValues& values,
                                const Deadline& deadline) {
  const double sign = values.objective().direction == Direction::minimize ? 1 : -1;
  const Program program = program_of(face);
  const std::size_t columns = face.triangles.size(), rows = program.right_hand_side.size();
  std::vector<double> costs(columns);
  double largest = 0;
  for (std::size_t t = 0; t < columns; ++t)
    largest = std::max(largest, std::fabs(face.triangles[t].value));
  const double scale = largest > 0 ? 1 / largest : 1;
  for (std::size_t t = 0; t < columns; ++t) costs[t] = sign * scale * face.triangles[t].value;

  std::vector<CoinBigIndex> starts(columns + 1);
  for (std::size_t t = 0; t <= columns; ++t) starts[t] = CoinBigIndex(3 * t);
  const std::vector<double> low(columns, 0), high(columns, 1);
  const std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> model(Clp_newModel(), Clp_deleteModel);
  Clp_setLogLevel(model.get(), 0);
  Clp_loadProblem(model.get(), int(columns), int(rows), starts.data(), program.row_of.data(),
                  program.sign_of.data(), low.data(), high.data(), costs.data(),
                  program.right_hand_side.data(), program.right_hand_side.data());
  Clp_setMaximumIterations(model.get(), kMostIterations);
  if (deadline.is_limited()) Clp_setMaximumSeconds(model.get(), deadline.seconds_left());
  Clp_initialSolve(model.get());

  FaceSolution solution;
  solution.bound =
      sign / scale * bound_from_duals(face, program, costs, Clp_dualRowSolution(model.get()));
  const double* x = Clp_getColSolution(model.get());
  for (Index t = 0; t < columns; ++t)
    if (x[t] > 0.5) solution.chosen.push_back(t);
  if (!is_triangulation(face, solution.chosen)) solution.chosen.clear();
  return solution;
}

}  // namespace hodt
