// Any command line: an argument a line. It runs in a folder of its own, on tiny files.
#include "app/command.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "input.h"
#include <fcntl.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

constexpr const char* kPoints =
    "x,y,z\n0,0,4\n0,1,0\n1,0,2\n1,1.1,3\n2,0,5\n2,1,1\n0,0,9\n0.4,0.5,2\n";
constexpr const char* kMesh = "v 0 0 4\nv 1 0 2\nv 0 1 0\nv 1 1 3\nf 1 2 3\nf 2 4 3\n";
constexpr const char* kPlaces = R"({"type": "Point", "coordinates": [0.4, 0.5]})";

/// A new folder, made the current one, that goes with the process.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "hodt-fuzz-XXXXXX").string();
    hodt::fuzz::require(mkdtemp(name.data()) != nullptr);
    path_ = name;
    fs::current_path(path_);
    // Reports and CSV would drown what the fuzzer says.
    const int nowhere = ::open("/dev/null", O_RDWR);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(nowhere, STDOUT_FILENO);
    fill();
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  /// A run that fails leaves no file; one that succeeds leaves no temporary one.
  void check(int exit_code) {
    std::size_t entries = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      ++entries;
      // As those are called that atomic_write.cpp opens.
      const std::string name = entry.path().filename().string();
      const std::string mark = "." + std::to_string(::getpid()) + "-";
      hodt::fuzz::require(!name.ends_with(".tmp") || name.find(mark) == name.npos);
    }
    hodt::fuzz::require(exit_code != 2 || entries == kFiles);
    if (exit_code == 2) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) fs::remove(entry.path());
    fill();
  }

 private:
  static constexpr std::size_t kFiles = 3;

  static void fill() {
    std::ofstream("points.csv") << kPoints;
    std::ofstream("mesh.obj") << kMesh;
    std::ofstream("places.geojson") << kPlaces;
  }

  fs::path path_;
};

std::vector<std::string> arguments_in(std::string text) {
  // Nothing outside the folder is to be named.
  for (char& c : text)
    if (c == '/' || c == '\0') c = '_';
  std::vector<std::string> arguments{"hodt"};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    arguments.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return arguments;
}

/// Whether it may ask for so many points or threads that running it says nothing but "slow".
bool takes_long(const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    const std::size_t digits = std::min(argument.find_first_of("0123456789"), argument.size());
    std::uint32_t number = 0;
    const char* const end = argument.data() + argument.size();
    const bool fits = std::from_chars(argument.data() + digits, end, number).ec == std::errc();
    if (fits && number > 64 && (arguments[1] == "sample" || number <= 4096)) return true;
  }
  // Without -n a terrain has its own number of points.
  return arguments.size() > 1 && arguments[1] == "sample" &&
         std::none_of(arguments.begin(), arguments.end(),
                      [](const std::string& argument) { return argument.starts_with("-n"); });
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Folder folder;
  const std::vector<std::string> arguments =
      arguments_in({reinterpret_cast<const char*>(data), size});
  if (takes_long(arguments)) return 0;
  std::vector<const char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  const int exit_code = hodt::app::run(static_cast<int>(pointers.size()), pointers.data());
  hodt::fuzz::require(0 <= exit_code && exit_code <= 2);
  folder.check(exit_code);
  return 0;
}
