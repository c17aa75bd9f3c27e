#!/usr/bin/env bash
# Installs the Debian packages that a goal needs, if any is missing; says nothing and asks nobody
# if all are there.
#
#   scripts/dependencies.sh [build|test|bench]
set -eu

goal=${1:-build}
packages="g++ cmake ninja-build make libtbb-dev libcli11-dev libfmt-dev nlohmann-json3-dev zlib1g-dev pkg-config coinor-libclp-dev"
case $goal in
  build) ;;
  test) packages="$packages libgtest-dev librapidcheck-dev libgmp-dev libcgal-dev" ;;
  bench) packages="$packages libbenchmark-dev libcgal-dev" ;;
  *)
    echo "usage: $0 [build|test|bench]" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query > /dev/null; then
  echo "No dpkg here, so what is installed is not checked. Needed, by Debian's names: $packages" >&2
  exit 0
fi

missing=""
for package in $packages; do
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
  exit 2
fi
echo "Installing:$missing" >&2
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update
# shellcheck disable=SC2086  # a list of words
$as_root $install
