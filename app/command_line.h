// The command line of hodt: its subcommands and their options.
// Tested by tests/app/command_test.cpp.
#pragma once

#include <memory>

#include "app/common.h"

namespace hodt::app {

/// Parsing with it sets the action, which has to stay where it is.
std::unique_ptr<CLI::App> command_line(Action& action);

}  // namespace hodt::app
