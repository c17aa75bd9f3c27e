#include "app/manual/completion.h"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace hodt::manual {

namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> names_of(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> names_of(const std::vector<CommandText>& commands) {
  std::vector<std::string> names;
  for (const CommandText& command : commands) names.push_back(command.name);
  return names;
}

// --- bash ---

/// What the function does where a value of the option, or the argument, stands.
std::string bash_action(const OptionText& option) {
  if (!option.choices.empty())
    return fmt::format("words='{}'{}", joined(option.choices),
                       option.takes_several ? " before=${current%\"${current##*,}\"}" : "");
  return option.value == Value::file ? "files=1" : ":";
}

/// The branches of one subcommand: values of its options first, then whatever else it takes.
std::string bash_branches(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.value == Value::none) continue;
    std::string patterns;
    for (const std::string& name : option.names)
      patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", command.name, name);
    text += fmt::format("    {}) {} ;;\n", patterns, bash_action(option));
  }
  const std::string argument =
      command.arguments.empty() ? "" : bash_action(command.arguments.front()) + "; ";
  return text + fmt::format("    '{} '*) {}options='{}' ;;\n", command.name, argument,
                            joined(names_of(command)));
}

// --- zsh ---

/// Inside of single quotes, where _arguments reads brackets and colons.
std::string zsh_text(const std::string& text) {
  std::string out = replaced(one_line(text), "\\", "\\\\");
  for (const std::string_view c : {"[", "]", ":"}) out = replaced(out, c, "\\" + std::string(c));
  return replaced(out, "'", "'\\''");
}

std::string zsh_value(const OptionText& option) {
  if (option.value == Value::none) return {};
  const std::string action = option.takes_several ? "_sequence compadd - " + joined(option.choices)
                             : !option.choices.empty()     ? "(" + joined(option.choices) + ")"
                             : option.value == Value::file ? "_files"
                                                           : " ";
  return ":" + option.value_name + ":" + action;
}

std::string zsh_option(const OptionText& option) {
  std::vector<std::string> names = option.names;
  if (option.value != Value::none)  // the value may follow in the same word
    for (std::string& name : names) name += name.starts_with("--") ? "=" : "+";
  const std::string spelled =
      names.size() == 1 ? names.front()
                        : fmt::format("({})'{{{}}}'", joined(option.names), fmt::join(names, ","));
  return fmt::format("'{}[{}]{}'", spelled, zsh_text(option.description), zsh_value(option));
}

std::string zsh_arguments(const CommandText& command) {
  std::string text = "_arguments -s";
  for (const OptionText& option : command.options) text += " \\\n        " + zsh_option(option);
  for (const OptionText& argument : command.arguments)
    text += fmt::format(" \\\n        '{}{}'", argument.is_list ? "*" : "1", zsh_value(argument));
  return text;
}

// --- fish ---

std::string fish_text(const std::string& text) {
  return replaced(replaced(one_line(text), "\\", "\\\\"), "'", "\\'");
}

std::string fish_value(const OptionText& option) {
  const std::string words = joined(option.choices);
  if (option.takes_several) return fmt::format(" -x -a '(__fish_append , {})'", words);
  if (!words.empty()) return fmt::format(" -x -a '{}'", words);
  if (option.value == Value::none) return {};
  return option.value == Value::file ? " -r -F" : " -x";
}

std::string fish_option(std::string_view when, const OptionText& option) {
  std::string text = fmt::format("complete -c hodt -n '{}'", when);
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text + fish_value(option) + fmt::format(" -d '{}'\n", fish_text(option.description));
}

std::string fish_argument(std::string_view when, const OptionText& argument) {
  const std::string what =
      argument.choices.empty() ? "-F" : fmt::format("-a '{}'", joined(argument.choices));
  return fmt::format("complete -c hodt -n '{}' {}\n", when, what);
}

}  // namespace

std::string bash_completion(const ProgramText& program) {
  std::string branches;
  for (const CommandText& command : program.commands) branches += bash_branches(command);
  return fmt::format(
      R"(# Completion of hodt in bash, made from its options.
_hodt() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local words= options= files= before= # what of the word stays
  # Readline takes --option=value for three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]]; then
    previous=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    words='{}' options='{}'
  else
    case "${{COMP_WORDS[1]}} $previous" in
{}    esac
  fi
  if [[ $current == -* ]]; then
    words=$options files= before=
  fi
  if [[ $files ]]; then
    compopt -o default # the names of files
  else
    mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${{current#"$before"}}")
  fi
}}
complete -F _hodt hodt
)",
      joined(names_of(program.commands)), joined(names_of(program.itself)), branches);
}

std::string zsh_completion(const ProgramText& program) {
  std::string commands, branches;
  for (const CommandText& command : program.commands) {
    commands += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.summary));
    branches += fmt::format("      {})\n        {}\n        ;;\n", command.name,
                            replaced(zsh_arguments(command), "\n", "\n  "));
  }
  std::string options;
  for (const OptionText& option : program.itself.options)
    options += " \\\n    " + zsh_option(option);
  return fmt::format(
      R"(#compdef hodt
# Completion of hodt in zsh, made from its options.
_hodt() {{
  local curcontext=$curcontext state line
  local -a commands
  commands=(
{})
  _arguments -C{} \
    '1: :->command' '*:: :->rest'
  case $state in
    command) _describe command commands ;;
    rest)
      case $words[1] in
{}      esac
      ;;
  esac
}}
_hodt "$@"
)",
      commands, options, branches);
}

std::string fish_completion(const ProgramText& program) {
  std::string text =
      "# Completion of hodt in fish, made from its options.\n"
      "complete -c hodt -f\n";
  for (const OptionText& option : program.itself.options)
    text += fish_option("__fish_use_subcommand", option);
  for (const CommandText& command : program.commands) {
    text += fmt::format("complete -c hodt -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                        fish_text(command.summary));
    const std::string when = "__fish_seen_subcommand_from " + command.name;
    for (const OptionText& option : command.options) text += fish_option(when, option);
    for (const OptionText& argument : command.arguments) text += fish_argument(when, argument);
  }
  return text;
}

}  // namespace hodt::manual
