// A problem of selection as a program in zeros and ones.
// Tested by tests/optimize/edge_selection_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/optimize/solve/edge_selection.h"
#include "hodt/optimize/solve/linear_relaxation.h"

namespace hodt {

/// The variables are the edges, and then the targets, which are one if
/// they go without. One edge of a clique at most makes for a better relaxation than pairs do.
/// Throws TimeIsUp if the deadline passes.
BinaryRows rows_of(const SelectionProblem& problem, const Deadline& deadline);

}  // namespace hodt
