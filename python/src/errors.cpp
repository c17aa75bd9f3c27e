// The library's exceptions as those of hodt/_errors.py.
#include <exception>
#include <string_view>

#include "sections.h"

#include "hodt/base/error.h"
#include "hodt/io/system_file_error.h"

namespace hodt::python {

namespace {

namespace nb = nanobind;

nb::object errors(const char* name) {
  return nb::module_::import_("hodt._errors").attr(name);
}

/// Names of files may be any bytes.
nb::object text_of(std::string_view what) {
  return nb::steal(PyUnicode_DecodeUTF8(what.data(), Py_ssize_t(what.size()), "backslashreplace"));
}

void raise(const char* name, std::string_view what) {
  PyErr_SetObject(errors(name).ptr(), text_of(what).ptr());
}

void raise(const SystemFileError& e) {
  const nb::object file = nb::steal(PyUnicode_DecodeFSDefault(e.file().c_str()));
  const nb::object error = errors("file_error")(text_of(e.what()), e.number(), file);
  PyErr_SetObject(error.type().ptr(), error.ptr());
}

void translate(const std::exception_ptr& error, void*) {
  try {
    std::rethrow_exception(error);
  } catch (const InputError& e) {
    raise("InputError", e.what());
  } catch (const ParameterError& e) {
    raise("ParameterError", e.what());
  } catch (const SystemFileError& e) {
    raise(e);
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
