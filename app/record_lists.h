// What `edges` and `triangles` share: points in, a CSV list of vertex numbers and an order out.
// Tested by tests/app/lists_test.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "app/common.h"
#include "app/constraints_input.h"
#include "app/points_input.h"

#include "hodt/io/atomic_write.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/numbering.h"

namespace hodt::app {

struct ListArguments {
  PointsInput input;
  ConstraintArguments constraints;
  std::string output;
  std::string order = "4";
  std::string list_class;
  std::string threads;
};

/// The options of such a command; `classes` describes those of --class, the default is already set.
void add_list_options(CLI::App& command, ListArguments& arguments, const std::string& classes);

/// Lines of numbers, written in pieces.
class CsvLines {
 public:
  CsvLines(OutputFile& file, std::string_view header);
  void add(std::span<const Index> numbers);
  void flush();
  std::size_t count() const { return count_; }

 private:
  OutputFile& file_;
  std::string text_;
  std::size_t count_ = 0;
};

/// Reads the points, has `produce` write the lines, and says how many `things` there are.
using ProduceLines =
    std::function<void(const DelaunayGraph&, Index k, const Numbering&, CsvLines&)>;
int write_list(const ListArguments& arguments, std::string_view header, std::string_view things,
               const ProduceLines& produce);

}  // namespace hodt::app
