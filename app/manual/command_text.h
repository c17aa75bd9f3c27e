// What --help tells, as parts: pages, completions and the reference are made of these and can say
// nothing else.
// Tested by tests/app/check_manual.py.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace hodt::manual {

enum class Value {
  none,  ///< the option is a flag
  file,
  other,
};

/// An option, or an argument that stands by itself.
struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; none of an argument
  std::string value_name;          ///< "OUTPUT"; empty of a flag
  Value value = Value::none;
  std::vector<std::string>
      choices;                 ///< all words that the value can be; empty if it is no such word
  bool takes_several = false;  ///< of the choices, with commas between
  bool is_required = false;
  bool is_list = false;
  std::string description;  ///< may have several lines
};

/// hodt itself, or one of its subcommands.
struct CommandText {
  std::string name;  ///< "triangulate"; empty for hodt itself
  std::string summary;
  std::vector<OptionText> arguments;
  std::vector<OptionText> options;
  std::string notes;                  ///< lines
  std::vector<std::string> examples;  ///< command lines
};

struct ProgramText {
  CommandText itself;
  std::vector<CommandText> commands;
};

ProgramText program_text(const CLI::App& app);

/// "hodt triangulate [OPTIONS] INPUT...", as after Usage in --help.
std::string usage(const CommandText& command);

/// The text with its lines joined.
std::string one_line(std::string text);

}  // namespace hodt::manual
