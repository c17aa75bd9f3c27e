#!/usr/bin/env bash
# Lists the C++ sources of the project, one a line, from wherever it is called.
set -eu
cd "$(dirname "$0")/.."
find app bench python src tests \( -name '*.cpp' -o -name '*.h' \) -printf "$PWD/%p\n" | LC_ALL=C sort
