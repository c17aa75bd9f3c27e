#include "app/outputs.h"

#include <algorithm>

namespace hodt::app {

OutputFile& Outputs::open(const std::filesystem::path& path) {
  if (!files_.empty()) files_.back()->finish();
  return *files_.emplace_back(std::make_unique<OutputFile>(path));
}

void Outputs::write_json(const Json& json, const std::filesystem::path& path) {
  if (path.empty()) return;
  // Names of files and columns can be any bytes; JSON cannot.
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  OutputFile& file = open(path);
  try {
    file.write(text);
  } catch (const BrokenPipeError&) {
    // `hodt ... | head` has seen enough.
  }
}

void Outputs::commit(std::string_view report) {
  for (const auto& file : files_) file->finish();
  const bool is_taken = std::any_of(files_.begin(), files_.end(), [](const auto& file) {
    return is_standard_output(file->path());
  });
  if (!is_taken) print(report);
  commit_together(files_);
}

}  // namespace hodt::app
