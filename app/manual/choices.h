// The words that an option's value can be, where it is a word.
// Tested by tests/app/check_manual.py.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hodt::manual {

/// Of an option ("--method") or an argument ("NAME") of a subcommand; empty if it takes anything
/// else.
std::vector<std::string> choices_of(std::string_view command, std::string_view option);

/// Whether the value can be several of the words, with commas between.
bool takes_several(std::string_view option);

}  // namespace hodt::manual
