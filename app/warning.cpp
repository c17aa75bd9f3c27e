#include "app/warning.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "hodt/base/printable.h"
#include "hodt/io/formats.h"
#include "hodt/io/input_text.h"
#include "hodt/io/local_frame.h"

namespace hodt::app {

void print_warning(const std::filesystem::path& file, const std::string& warning) {
  // The line of progress, which is only on a terminal, makes way.
  const char* const clear = isatty(STDERR_FILENO) ? "\r\033[K" : "";
  const std::string text = fmt::format("hodt: warning: {}: {}", display_name(file), warning);
  std::fputs(fmt::format("{}{}\n", clear, printable(text)).c_str(), stderr);
}

void warn_of_rounding(const std::filesystem::path& file, const Tin& tin) {
  const Format& format = format_for(file, Use::write_tin);
  if (format.keeps.heights) return;
  const LocalFrame frame(tin);
  if (frame.largest_error() == 0) return;
  const auto& [x, y, z] = frame.origin();
  print_warning(file,
                fmt::format("{} has numbers of single precision: coordinates are rounded by up to "
                            "{:.2g}, from an origin at x {}, y {}, z {}; .ply and others keep all",
                            format.name, frame.largest_error(), x, y, z));
}

}  // namespace hodt::app
