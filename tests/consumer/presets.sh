#!/usr/bin/env bash
# What one configuration leaves in the cache, as `make demo` does, does not decide the next one's tests.
#
#   presets.sh SOURCES SCRATCH
set -eu
cd "$1"
scratch=$2
rm -rf "$scratch"

# expect some|no OPTION...: whether there are tests once the preset is configured with the options.
expect() {
  expected=$1
  shift
  cmake --preset release -B "$scratch" "$@" > /dev/null
  found=some
  if ctest --test-dir "$scratch" -N | grep -q '^Total Tests: 0$'; then found=no; fi
  echo "cmake --preset release $*: $found tests"
  [ "$found" = "$expected" ]
}

expect no -DHODT_BUILD_TESTS=OFF
expect some
expect some -DHODT_BUILD_TESTS=ON
expect some
