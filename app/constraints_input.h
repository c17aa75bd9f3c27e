// The options --breaklines, --outline and their like: what a triangulation has to keep to.
// Tested by tests/app/constraints_test.cpp.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/common.h"
#include "app/common_system.h"

#include "hodt/pipeline.h"
#include "hodt/pipeline/join_lines.h"

namespace hodt::app {

struct ConstraintArguments {
  std::vector<std::string> breaklines;
  std::string outline;
  std::string keep_edges;
  std::string max_edge;
  std::string snap;
  bool split_crossings = false;

  bool any() const {
    return !breaklines.empty() || !outline.empty() || !keep_edges.empty() || !max_edge.empty();
  }
};

void add_constraints(CLI::App& command, ConstraintArguments& arguments);

/// Throws ParameterError for what can be refused before a file is read.
void check_constraints(const ConstraintArguments& arguments, const std::string& input,
                       const std::string& output, const std::string& json);

/// Reads the files and joins them with the points, whose file is `input`, and whose system theirs
/// has to be. Of a mesh, `numbers` says which of the points each vertex is; kNone of those of no
/// triangle; `surface` are its triangles.
Joined read_constraints(const ConstraintArguments& arguments, const std::string& input,
                        CommonSystem& system, PointSet points, std::span<const Index> numbers = {},
                        std::span<const std::array<Index, 3>> surface = {});

/// Says on standard error what may be wrong with the lines. For the end of a run.
void print_warnings(const Joined& joined);

/// Adds what an existing mesh, read from `input`, has to keep to. Throws ParameterError for options
/// that do not go with a mesh.
void add_given(Constraints& given, const std::string& input, Joined& joined);

/// f(), whose errors name the input, or the lines that cross.
void naming_lines(const std::string& input, const Joined& joined, const std::function<void()>& f);

/// triangulate(), with errors like these.
TriangulateResult triangulate_joined(const std::string& input, const Joined& joined,
                                     const TriangulateOptions& options);

/// The (constrained) Delaunay triangulation, with errors like these, and what is known of it.
struct JoinedDelaunay {
  Delaunay triangulation;
  std::size_t duplicates = 0;
  ConstraintReport constraints;
};
JoinedDelaunay delaunay_of_joined(const std::string& input, const Joined& joined);

/// The lines of a summary, and the part of a report, that tell of constraints; empty and null if
/// there are none.
std::string constraints_text(const JoinReport& joined, const ConstraintReport& report,
                             int indent = 13);
Json constraints_json(const JoinReport& joined, const ConstraintReport& report);

}  // namespace hodt::app
