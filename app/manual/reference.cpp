#include "app/manual/reference.h"

#include <string_view>

#include <fmt/format.h>

namespace hodt::manual {

namespace {

/// Text in which nothing is Markdown or HTML.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string entry(const OptionText& option) {
  std::string term;
  for (const std::string& name : option.names)
    term += fmt::format("{}`{}`", term.empty() ? "" : ", ", name);
  if (!option.value_name.empty())
    term += fmt::format("{}*{}*{}", term.empty() ? "" : " ", escaped(option.value_name),
                        option.is_list ? " ..." : "");
  if (option.is_required) term += " (required)";
  return fmt::format("{}\n:   {}\n\n", term, escaped(one_line(option.description)));
}

std::string section(const CommandText& command) {
  std::string text = fmt::format("## hodt {}\n\n{}\n\n```text\n{}\n```\n\n", command.name,
                                 escaped(command.summary), usage(command));
  for (const OptionText& argument : command.arguments) text += entry(argument);
  for (const OptionText& option : command.options) text += entry(option);
  if (!command.notes.empty()) text += fmt::format("```text\n{}\n```\n\n", command.notes);
  if (command.examples.empty()) return text;
  text += "```sh\n";
  for (const std::string& line : command.examples) text += line + "\n";
  return text + "```\n\n";
}

}  // namespace

std::string reference(const ProgramText& program) {
  std::string text = fmt::format("# The command\n\n{}\n\n```text\n{}\n```\n\n",
                                 escaped(program.itself.summary), usage(program.itself));
  for (const CommandText& command : program.commands)
    text += fmt::format("- [hodt {0}](#hodt-{0}): {1}\n", command.name, escaped(command.summary));
  text += "\n";
  for (const OptionText& option : program.itself.options) text += entry(option);
  for (const CommandText& command : program.commands) text += section(command);
  return text;
}

}  // namespace hodt::manual
