#include "app/manual/command_text.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "app/manual/choices.h"

namespace hodt::manual {

namespace {

/// Whether an option takes a file, by the name of its value. There is no other place that says it,
/// so a new name has to be entered here.
Value value_of(const std::string& name) {
  constexpr auto files = std::to_array<std::string_view>(
      {"FILE", "INPUT", "OUT", "OUTPUT", "RASTER", "REPORT", "TIN"});
  constexpr auto others = std::to_array<std::string_view>(
      {"B", "BOX", "CLASS", "CLASSES", "COLUMNS", "CRS",     "D",    "FIELD", "K", "LENGTH", "LIST",
       "M", "N",   "NAME",  "OBJ",     "R",       "RETURNS", "RULE", "S",     "T", "Z"});
  if (name.empty()) return Value::none;
  if (std::find(files.begin(), files.end(), name) != files.end()) return Value::file;
  if (std::find(others.begin(), others.end(), name) != others.end()) return Value::other;
  throw std::logic_error("app/manual/command_text.cpp does not say whether " + name + " is a file");
}

OptionText option_text(const std::string& command, const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  const bool takes_value = option.get_type_size() != 0;
  text.value_name = text.names.empty() ? option.get_single_name()
                    : takes_value      ? option.get_type_name()
                                       : "";
  text.value = value_of(text.value_name);
  text.choices = choices_of(command, text.names.empty() ? text.value_name : text.names.back());
  text.takes_several = !text.names.empty() && takes_several(text.names.back());
  text.is_required = option.get_required();
  text.is_list = text.names.empty() && option.get_expected_max() > 1;
  text.description = option.get_description();
  return text;
}

/// The footer is notes, and then examples.
void split_footer(const std::string& footer, CommandText& text) {
  constexpr std::string_view title = "Examples:\n";
  const std::size_t at = footer.find(title);
  text.notes = footer.substr(0, at);
  if (at == footer.npos) return;
  for (std::size_t begin = at + title.size(); begin < footer.size();) {
    const std::size_t end = std::min(footer.find('\n', begin), footer.size());
    const std::string line = footer.substr(begin, end - begin);
    text.examples.push_back(line.substr(line.find_first_not_of(' ')));
    begin = end + 1;
  }
}

CommandText command_text(const std::string& name, const CLI::App& app) {
  CommandText text;
  text.name = name;
  text.summary = app.get_description();
  for (const CLI::Option* option : app.get_options()) {
    OptionText one = option_text(name, *option);
    (one.names.empty() ? text.arguments : text.options).push_back(std::move(one));
  }
  split_footer(app.get_footer(), text);
  return text;
}

}  // namespace

ProgramText program_text(const CLI::App& app) {
  ProgramText text{command_text("", app), {}};
  for (const CLI::App* command : app.get_subcommands({}))
    text.commands.push_back(command_text(command->get_name(), *command));
  return text;
}

std::string usage(const CommandText& command) {
  if (command.name.empty()) return "hodt [OPTIONS] SUBCOMMAND";
  std::string text = "hodt " + command.name + " [OPTIONS]";
  for (const OptionText& argument : command.arguments) {
    const std::string name = argument.value_name + (argument.is_list ? "..." : "");
    text += argument.is_required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace hodt::manual
