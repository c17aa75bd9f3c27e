// Pages for man, in the language of roff: hodt(1), and hodt-triangulate(1) and so on.
// Tested by tests/app/check_manual.py.
#pragma once

#include <string>

#include "app/manual/command_text.h"

namespace hodt::manual {

/// The page of hodt itself, with all its subcommands.
std::string man_page(const ProgramText& program, const std::string& version);
/// The page of a subcommand.
std::string man_page(const CommandText& command, const std::string& version);

}  // namespace hodt::manual
