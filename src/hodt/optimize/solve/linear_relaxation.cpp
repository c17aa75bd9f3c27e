#include "hodt/optimize/solve/linear_relaxation.h"

#include <algorithm>
#include <cmath>

#include <Clp_C_Interface.h>

namespace hodt {

namespace {

constexpr int kMostIterations = 1'000'000;  // of one program

/// Clp_initialSolve, but signals stay the program's: that takes SIGINT for itself meanwhile, ends
/// early on it, and with several threads forgets to give it back.
void solve_at_first(Clp_Simplex* model) {
  const std::unique_ptr<Clp_Solve, void (*)(Clp_Solve*)> options(ClpSolve_new(), ClpSolve_delete);
  constexpr int kSignals = 2, kAreLeft = 1;
  ClpSolve_setSpecialOption(options.get(), kSignals, kAreLeft, -1);
  Clp_initialSolveWithOptions(model, options.get());
}

}  // namespace

LinearRelaxation::LinearRelaxation(BinaryRows rows, std::size_t most_ones, const Deadline& deadline)
    : rows_(std::move(rows)),
      most_ones_(most_ones),
      deadline_(deadline),
      model_(Clp_newModel(), Clp_deleteModel) {}

void LinearRelaxation::set_costs(const std::vector<double>& costs) {
  costs_ = costs;
  is_begun_ = !low_.empty();
  if (is_begun_) {
    std::copy(costs.begin(), costs.end(), Clp_objective(model_.get()));
    return;
  }
  const std::vector<CoinBigIndex> first(rows_.first.begin(), rows_.first.end());
  low_.assign(costs.size(), 0);
  high_.assign(costs.size(), 1);
  Clp_setLogLevel(model_.get(), 0);
  Clp_loadProblem(model_.get(), int(costs.size()), int(rows_.low.size()), first.data(),
                  rows_.row.data(), rows_.factor.data(), low_.data(), high_.data(), costs.data(),
                  rows_.low.data(), rows_.high.data());
  Clp_setMaximumIterations(model_.get(), kMostIterations);
  // What the duals lack, the bound lacks many times.
  Clp_setDualTolerance(model_.get(), 1e-11);
}

void LinearRelaxation::solve(const std::vector<std::pair<Index, bool>>& fixed) {
  std::fill(low_.begin(), low_.end(), 0);
  std::fill(high_.begin(), high_.end(), 1);
  for (const auto& [i, is_in] : fixed) (is_in ? low_ : high_)[i] = is_in;
  std::copy(low_.begin(), low_.end(), Clp_columnLower(model_.get()));
  std::copy(high_.begin(), high_.end(), Clp_columnUpper(model_.get()));
  if (deadline_.is_limited()) Clp_setMaximumSeconds(model_.get(), deadline_.seconds_left());
  if (fixed.empty() && is_begun_)
    Clp_primal(model_.get(), 0);  // from the last optimum
  else if (fixed.empty())
    solve_at_first(model_.get());
  else
    Clp_dual(model_.get(), 0);
}

/// For any y, x costs y·(rows' sums) and what the costs exceed y's part by. The first is least
/// where every row is at its low limit if its y is positive, at its high limit if negative; an
/// infinite limit asks for y = 0 there. Of the second, x takes what its limits let it.
double LinearRelaxation::bound(const std::vector<double>& costs, const double* y) const {
  std::vector<double> duals(y, y + rows_.low.size());
  double sum = 0, size = 0;
  for (std::size_t row = 0; row < duals.size(); ++row) {
    const double limit = duals[row] > 0 ? rows_.low[row] : rows_.high[row];
    if (!std::isfinite(limit)) duals[row] = 0;
    if (duals[row] == 0) continue;
    sum += limit * duals[row];
    size += std::fabs(limit * duals[row]);
  }
  double least = 0, below = 0, above = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    double reduced = costs[i], magnitude = std::fabs(costs[i]);
    for (std::size_t e = rows_.first[i]; e < rows_.first[i + 1]; ++e) {
      const double part = rows_.factor[e] * duals[std::size_t(rows_.row[e])];
      reduced -= part;
      magnitude += std::fabs(part);
    }
    const double roundings = 2 + 2 * double(rows_.first[i + 1] - rows_.first[i]);
    reduced -= roundings * 0x1p-53 * magnitude;
    if (reduced > 0) {
      above += reduced * low_[i];
    } else {
      below += reduced * high_[i];
      if (high_[i] > 0) least = std::min(least, reduced);
    }
  }
  below = std::max(below, double(most_ones_) * least);
  const double terms = double(rows_.low.size() + costs.size());
  return sum + below + above - terms * 0x1p-52 * (size - below + above);
}

double LinearRelaxation::bound() const {
  if (is_proven_infeasible()) return BinaryRows::kInfinite;
  return bound(costs_, Clp_dualRowSolution(model_.get()));
}

/// If even no costs at all come to more than 0, by the multipliers that Clp has for it (Farkas).
bool LinearRelaxation::is_proven_infeasible() const {
  if (!Clp_isProvenPrimalInfeasible(model_.get())) return false;
  const auto free_ray = [this](double* ray) { Clp_freeRay(model_.get(), ray); };
  const std::unique_ptr<double, decltype(free_ray)> ray(Clp_infeasibilityRay(model_.get()),
                                                        free_ray);
  if (!ray) return false;
  std::vector<double> y(ray.get(), ray.get() + rows_.low.size());
  const std::vector<double> nothing(costs_.size(), 0);
  if (bound(nothing, y.data()) > 0) return true;
  for (double& multiplier : y) multiplier = -multiplier;
  return bound(nothing, y.data()) > 0;
}

std::vector<double> LinearRelaxation::values() const {
  const double* x = Clp_getColSolution(model_.get());
  return {x, x + costs_.size()};
}

std::vector<double> LinearRelaxation::reduced_costs() const {
  const double* reduced = Clp_getReducedCost(model_.get());
  return {reduced, reduced + costs_.size()};
}

Index LinearRelaxation::largest_fraction() const {
  const double* x = Clp_getColSolution(model_.get());
  Index largest = kNone;
  for (Index i = 0; i < low_.size(); ++i)
    if (low_[i] < high_[i] && x[i] > 1e-6 && x[i] < 1 - 1e-6 &&
        (largest == kNone || x[i] > x[largest]))
      largest = i;
  return largest;
}

std::vector<Index> LinearRelaxation::rounded() const {
  const double* x = Clp_getColSolution(model_.get());
  std::vector<Index> ones;
  for (Index i = 0; i < low_.size(); ++i)
    if (x[i] > 0.5) ones.push_back(i);
  if (!is_solution(ones)) ones.clear();
  return ones;
}

bool LinearRelaxation::is_solution(const std::vector<Index>& ones) const {
  std::vector<double> sums(rows_.low.size(), 0);
  for (const Index i : ones)
    for (std::size_t e = rows_.first[i]; e < rows_.first[i + 1]; ++e)
      sums[std::size_t(rows_.row[e])] += rows_.factor[e];
  for (std::size_t row = 0; row < sums.size(); ++row)
    if (sums[row] < rows_.low[row] || sums[row] > rows_.high[row]) return false;
  return ones.size() <= most_ones_;
}

}  // namespace hodt
