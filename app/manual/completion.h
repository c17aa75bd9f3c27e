// Scripts that complete the command's line in a shell.
// Tested by tests/app/check_manual.py.
#pragma once

#include <string>

#include "app/manual/command_text.h"

namespace hodt::manual {

std::string bash_completion(const ProgramText& program);
std::string zsh_completion(const ProgramText& program);
std::string fish_completion(const ProgramText& program);

}  // namespace hodt::manual
