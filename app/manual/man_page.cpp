#include "app/manual/man_page.h"

#include <string_view>

#include <fmt/format.h>

namespace hodt::manual {

namespace {

/// A character as roff prints it: what it takes for typography or for a command has a name.
std::string escaped(char c) {
  switch (c) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {c};
  }
}

/// Lines of text; a dot at the beginning of one is no command.
std::string escaped(std::string_view text) {
  std::string out;
  bool is_start = true;
  for (const char c : text) {
    if (is_start && c == '.') out += "\\&";
    out += escaped(c);
    is_start = c == '\n';
  }
  return out;
}

std::string bold(std::string_view text) {
  return "\\fB" + escaped(text) + "\\fR";
}
std::string italic(std::string_view text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string start(const std::string& name, const std::string& summary, const std::string& version) {
  std::string upper = name;
  for (char& c : upper)
    if ('a' <= c && c <= 'z') c += 'A' - 'a';
  return fmt::format(".TH {} 1 \"\" \"hodt {}\" \"hodt\"\n.SH NAME\n{} \\- {}\n", escaped(upper),
                     escaped(version), escaped(name), escaped(summary));
}

/// Words in capitals stand for something else.
std::string synopsis(const CommandText& command) {
  const std::string line = usage(command);
  const std::size_t bare = line.find(" [OPTIONS]");
  std::string rest;
  for (const char c : line.substr(bare))
    rest += 'A' <= c && c <= 'Z' ? "\\fI" + std::string{c} + "\\fR" : escaped(c);
  for (std::size_t at; (at = rest.find("\\fR\\fI")) != rest.npos;) rest.erase(at, 6);
  return ".SH SYNOPSIS\n" + bold(line.substr(0, bare)) + rest + "\n";
}

std::string entry(const OptionText& option) {
  std::string term;
  for (const std::string& name : option.names) term += (term.empty() ? "" : ", ") + bold(name);
  if (!option.value_name.empty())
    term += (term.empty() ? "" : " ") + italic(option.value_name) + (option.is_list ? " ..." : "");
  if (option.is_required) term += " (required)";
  return ".TP\n" + term + "\n" + escaped(option.description) + "\n";
}

std::string entries(std::string_view title, const std::vector<OptionText>& options) {
  if (options.empty()) return {};
  std::string text = fmt::format(".SH {}\n", title);
  for (const OptionText& option : options) text += entry(option);
  return text;
}

std::string notes(const CommandText& command) {
  if (command.notes.empty()) return {};
  return ".SH NOTES\n" + escaped(command.notes) + (command.notes.ends_with('\n') ? "" : "\n");
}

std::string examples(const CommandText& command) {
  if (command.examples.empty()) return {};
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& line : command.examples) text += escaped(line) + "\n";
  return text + ".fi\n";
}

std::string reference(const CommandText& command) {
  return bold("hodt-" + command.name) + "(1)";
}

}  // namespace

std::string man_page(const ProgramText& program, const std::string& version) {
  const CommandText& hodt = program.itself;
  std::string text = start("hodt", hodt.summary, version) + synopsis(hodt) + ".SH SUBCOMMANDS\n";
  for (const CommandText& command : program.commands)
    text += ".TP\n" + reference(command) + "\n" + escaped(command.summary) + "\n";
  return text + entries("OPTIONS", hodt.options) + notes(hodt) +
         ".SH EXIT STATUS\n"
         "0 if all went well, 2 for bad input or usage: then one line on standard error says what "
         "is\n"
         "wrong, where, and what to do, and there is no output file. 1 if " +
         bold("hodt-check") + "(1) finds that a mesh is not as required.\n";
}

std::string man_page(const CommandText& command, const std::string& version) {
  return start("hodt-" + command.name, command.summary, version) + synopsis(command) +
         entries("ARGUMENTS", command.arguments) + entries("OPTIONS", command.options) +
         notes(command) + examples(command) + ".SH SEE ALSO\n" + bold("hodt") + "(1)\n";
}

}  // namespace hodt::manual
