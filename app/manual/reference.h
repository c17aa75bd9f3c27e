// The command's reference as a page of Markdown.
// Tested by tests/app/check_manual.py.
#pragma once

#include <string>

#include "app/manual/command_text.h"

namespace hodt::manual {

std::string reference(const ProgramText& program);

}  // namespace hodt::manual
