#!/usr/bin/env bash
# Installs the Debian packages that a goal needs, if any is missing; says nothing and asks nobody
# if all are there.
#
#   scripts/dependencies.sh GOAL         as root, or with sudo
#   scripts/dependencies.sh GOAL FOLDER  as anybody: unpacks the libraries into the folder, where they
#                                        serve whoever sources FOLDER/use
#
# GOAL: build (the default), test, python, deb, docs, bench, clang or fuzz.
set -euo pipefail
export LC_ALL=C

goal=${1:-build}
folder=${2:-}
tools="g++ cmake ninja-build make pkg-config"
packages="libtbb-dev libcli11-dev libfmt-dev nlohmann-json3-dev zlib1g-dev libsqlite3-dev coinor-libclp-dev"
case $goal in
  build) ;;
  test)
    packages="$packages libgtest-dev librapidcheck-dev libgmp-dev libcgal-dev libgdal-dev gdal-bin librsvg2-2"
    packages="$packages python3-venv python3-dev"
    ;;
  python) packages="$packages python3-venv python3-dev" ;;
  deb)
    tools="$tools dpkg-dev file lintian mmdebstrap"
    packages="$packages libgdal-dev python3-venv python3-dev"
    ;;
  docs)
    tools="$tools doxygen"
    packages="$packages python3-venv"
    ;;
  bench) packages="$packages libbenchmark-dev libcgal-dev" ;;
  clang) tools="$tools clang" ;;
  fuzz)
    tools="$tools clang libclang-rt-14-dev"
    packages="$packages libgmp-dev"
    ;;
  *)
    echo "usage: $0 [build|test|python|deb|docs|bench|clang|fuzz] [FOLDER]" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query > /dev/null; then
  echo "No dpkg here, so what is installed is not checked. Needed, by Debian's names: $tools $packages" >&2
  exit 0
fi

# The given packages and all that these need, one a line, whatever is installed.
needed() {
  apt-get install -s -o Dir::State::status=/dev/null --no-install-recommends "$@" |
    sed -n 's/^Inst \([^ ]*\) .*/\1/p' | sort
}

# Downloads the packages and what they need beyond the C++ library, and lets them be found where they
# are unpacked.
unpack() {
  mkdir -p "$folder"
  cd "$folder"
  needed libc6-dev libstdc++6 > there
  # shellcheck disable=SC2086  # a list of words
  needed $packages | comm -23 - there | xargs apt-get download
  for file in *.deb; do dpkg -x "$file" .; done
  rm -f -- there *.deb
  libraries=$PWD/usr/lib/$(gcc -print-multiarch)
  ln -sf "$libraries"/lapack/*.so* "$libraries"/blas/*.so* "$libraries" # as their installation does
  sed -i "s|^prefix=/usr|prefix=$PWD/usr|" "$libraries"/pkgconfig/*.pc
  cat > use << END
export HODT_UNPACKED="$PWD"
export CMAKE_PREFIX_PATH="$PWD/usr\${CMAKE_PREFIX_PATH:+:\$CMAKE_PREFIX_PATH}"
export PKG_CONFIG_PATH="$libraries/pkgconfig\${PKG_CONFIG_PATH:+:\$PKG_CONFIG_PATH}"
export LD_LIBRARY_PATH="$libraries\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}"
END
  echo "Before hodt is built, and before it runs:  . $PWD/use" >&2
}

if [ -n "$folder" ]; then
  unpack
  exit 0
fi
[ -z "${HODT_UNPACKED:-}" ] || exit 0 # dpkg-query does not know of those

missing=""
for package in $tools $packages; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2> /dev/null || true)
  [ "$status" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

install="apt-get install -y --no-install-recommends$missing"
if [ "$(id -u)" = 0 ]; then
  as_root=""
elif command -v sudo > /dev/null && { sudo -n true 2> /dev/null || [ -t 0 ]; }; then
  as_root="sudo"
else
  echo "Some packages are missing. As root, run:" >&2
  echo "$install" >&2
  echo "Without root, if $tools are there: scripts/dependencies.sh $goal FOLDER" >&2
  exit 2
fi
echo "Installing:$missing" >&2
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update
# shellcheck disable=SC2086  # a list of words
$as_root $install
