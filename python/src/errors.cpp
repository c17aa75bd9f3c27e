// The library's exceptions as those of hodt/_errors.py.
#include <exception>
#include <string_view>

#include "sections.h"

#include "hodt/base/error.h"

namespace hodt::python {

namespace {

namespace nb = nanobind;

/// Names of files may be any bytes.
void raise(const char* name, std::string_view what) {
  const nb::object type = nb::module_::import_("hodt._errors").attr(name);
  const nb::object text =
      nb::steal(PyUnicode_DecodeUTF8(what.data(), Py_ssize_t(what.size()), "backslashreplace"));
  PyErr_SetObject(type.ptr(), text.ptr());
}

void translate(const std::exception_ptr& error, void*) {
  try {
    std::rethrow_exception(error);
  } catch (const InputError& e) {
    raise("InputError", e.what());
  } catch (const ParameterError& e) {
    raise("ParameterError", e.what());
  } catch (const FileError& e) {
    raise("FileError", e.what());
  } catch (const Error& e) {
    raise("Error", e.what());
  }
}

}  // namespace

void add_errors(nb::module_&) {
  nb::register_exception_translator(translate);
}

}  // namespace hodt::python
