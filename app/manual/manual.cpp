// Writes the pages for man, the completion scripts and the reference of the command into a folder,
// from what --help tells. The build runs it.
// Tested by tests/app/check_manual.py.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "app/command_line.h"
#include "app/manual/command_text.h"
#include "app/manual/completion.h"
#include "app/manual/man_page.h"
#include "app/manual/reference.h"

namespace hodt::manual {

namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  if (!(file << text).flush()) throw std::runtime_error("cannot write " + path.string());
}

void write_all(const std::filesystem::path& folder) {
  app::Action action;
  const ProgramText program = program_text(*app::command_line(action));
  const std::string version = HODT_VERSION;
  write(folder / "man1/hodt.1", man_page(program, version));
  for (const CommandText& command : program.commands)
    write(folder / "man1" / ("hodt-" + command.name + ".1"), man_page(command, version));
  write(folder / "bash/hodt", bash_completion(program));
  write(folder / "zsh/_hodt", zsh_completion(program));
  write(folder / "fish/hodt.fish", fish_completion(program));
  write(folder / "command.md", reference(program));
}

}  // namespace

}  // namespace hodt::manual

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: hodt_manual FOLDER");
    hodt::manual::write_all(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hodt_manual: %s\n", error.what());
    return 1;
  }
}
