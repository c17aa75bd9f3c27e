#!/usr/bin/env bash
# Installs the library from a build folder, and moves what was installed to a prefix.
#
#   install.sh BUILD PREFIX
set -eu
rm -rf "$2" "$2.staged"
cmake --install "$1" --component development --prefix "$2.staged"
mv "$2.staged" "$2"
if [ -e "$2/bin" ]; then
  echo "The component development installed a program" >&2
  exit 1
fi
