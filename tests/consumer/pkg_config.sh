#!/usr/bin/env bash
# Builds and runs terrain.cpp with what pkg-config says about an installed hodt, and nothing else.
#
#   pkg_config.sh FOLDER_OF_HODT_PC COMPILER [OPTION...]
set -eu
export PKG_CONFIG_PATH=$1${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
shift
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck disable=SC2046  # lists of words
"$@" -std=c++20 $(pkg-config --cflags hodt) -c "$here/terrain.cpp" -o terrain.o
for static in "" --static; do
  # shellcheck disable=SC2046,SC2086
  "$@" terrain.o -o terrain $(pkg-config $static --libs hodt)
  ./terrain mesh.ply
done
