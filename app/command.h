// The hodt command, but for what belongs to its process: see main.cpp.
#pragma once

namespace hodt::app {

/// Does what the command line says; returns the exit code. Says on standard error what is wrong.
int run(int argc, const char* const* argv);

}  // namespace hodt::app
