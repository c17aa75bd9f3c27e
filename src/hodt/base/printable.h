// Text that others wrote (names of files, words of an input) made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace hodt {

/// The text with all that could do more than show itself written as \x1b: bytes that are no UTF-8,
/// control characters, and marks that break a line or turn the direction of what follows.
std::string printable(std::string_view text);

}  // namespace hodt
