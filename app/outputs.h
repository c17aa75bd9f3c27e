// What a subcommand leaves behind: files and a report, all of it or nothing.
// Tested by tests/app/faults_test.cpp.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "app/common.h"

#include "hodt/io/atomic_write.h"

namespace hodt::app {

class Outputs {
 public:
  /// A file to fill. It is finished when the next one is opened, and appears with the others.
  OutputFile& open(const std::filesystem::path& path);

  /// Nothing for an empty path.
  void write_json(const Json& json, const std::filesystem::path& path);

  /// Prints the report, unless something else goes to standard output; then the files appear.
  void commit(std::string_view report);

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace hodt::app
