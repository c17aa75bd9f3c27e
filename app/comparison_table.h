// A comparison as tables of text, for the terminal and for the page alike.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "app/comparison.h"

namespace hodt::app {

struct Table {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;
};

/// One row an order. Columns that no row has anything for are left out.
Table table_of(const Comparison& comparison, const ObjectiveComparison& objective);

/// By one of the objectives after the first, what can differ: a row an order.
Table later_table(const ObjectiveComparison& objective, std::size_t later);

/// What a mesh that was there already has, if there was one: ", of the input 12".
std::string given_text(const ObjectiveComparison& objective);

/// One row for each objective that changes: what it gains at best.
Table summary_table(const Comparison& comparison);

/// Columns flush right, two spaces apart.
std::string aligned(const Table& table);

/// The points and the truth, a line each: name and text.
struct Fact {
  std::string name;
  std::string text;
};
std::vector<Fact> facts_of(const Comparison& comparison);

}  // namespace hodt::app
