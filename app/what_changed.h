// The options --pits and --changed: what an objective did, as files of features.
#pragma once

#include <span>
#include <string>

#include "app/common.h"
#include "app/outputs.h"

#include "hodt/pipeline.h"

namespace hodt::app {

struct ChangesArguments {
  std::string pits;
  std::string changed;

  bool any() const { return !pits.empty() || !changed.empty(); }
};

void add_changes(CLI::App& command, ChangesArguments& arguments);

/// Throws if a file cannot be written, its format is not known, or it is one of the others: of
/// those that are read, or that are written.
void check_changes(const ChangesArguments& arguments, std::span<const std::string> read,
                   std::span<const std::string> written);

/// Writes what the arguments name.
void write_changes(const ChangesArguments& arguments, const TriangulateResult& result,
                   Outputs& outputs);

}  // namespace hodt::app
