// A library that is loaded when it is needed, and may be missing.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <initializer_list>
#include <string>

#include <dlfcn.h>

namespace hodt {

class SharedLibrary {
 public:
  /// Is told why something cannot be loaded, and throws.
  using Refuse = void (*)(const std::string& why);

  /// The first of these that is there. It stays loaded.
  SharedLibrary(std::initializer_list<const char*> names, Refuse refuse) : refuse_(refuse) {
    for (const char* const name : names)
      if ((handle_ = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) != nullptr) return;
    fail();
  }
  /// Of the library, or of one that it needs.
  template <class F>
  void find(const char* name, F& function) const {
    function = reinterpret_cast<F>(dlsym(handle_, name));
    if (!function) fail();
  }

 private:
  void fail() const {
    const char* const error = dlerror();
    refuse_(error ? error : "unknown error");
  }

  Refuse refuse_;
  void* handle_ = nullptr;
};

}  // namespace hodt
