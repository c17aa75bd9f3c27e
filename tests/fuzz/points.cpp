// Any bytes, read as a file of points of whatever format.
#include <string>

#include "input.h"
#include <sys/mman.h>
#include <unistd.h>

#include "hodt/base/error.h"
#include "hodt/io/point_file.h"

namespace {

/// A file without a place on the disk; its path is that of its descriptor.
class MemoryFile {
 public:
  MemoryFile(const void* data, std::size_t size) : descriptor_(::memfd_create("points", 0)) {
    hodt::fuzz::require(descriptor_ >= 0);
    hodt::fuzz::require(::write(descriptor_, data, size) == static_cast<ssize_t>(size));
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    const hodt::PointSet points = hodt::read_points(file.path());
    hodt::fuzz::require(points.size() > 0);
    hodt::fuzz::require_sound(points);
  } catch (const hodt::InputError&) {
    // What cannot be used is refused.
  }
  return 0;
}
