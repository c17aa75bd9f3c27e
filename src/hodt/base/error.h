// What the library throws. Every message says what is wrong, where, and what to do about it.
// Tested by tests/app/faults_test.cpp.
#pragma once

#include <stdexcept>

namespace hodt {

/// The root of all errors that hodt throws on purpose.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Input that cannot be used: malformed text, NaN, too few points, all points collinear.
class InputError : public Error {
  using Error::Error;
};

/// A parameter out of its range or an unknown name: a negative order, an unknown objective.
class ParameterError : public Error {
  using Error::Error;
};

/// The operating system refused: an unreadable path, a full disk.
class FileError : public Error {
  using Error::Error;
};

}  // namespace hodt
