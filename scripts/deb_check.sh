#!/usr/bin/env bash
# Goes through the Debian packages as a new user: in a minimal root of this machine's Debian, from the
# mirror that apt is set up with here. Needs to be root.
#
#   scripts/deb_check.sh FOLDER    the folder with the packages
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
packages=$(cd "$1" && pwd)
work=$(mktemp -d)
root=$work/root
trap 'rm -rf --one-file-system "$work"' EXIT

say() { printf '\n%s\n' "$*" >&2; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "$1"; }
quietly() { "$@" > "$work/log" 2>&1 || {
  cat "$work/log" >&2
  return 1
}; }
install() { quietly inside "apt-get install -qq -y --no-install-recommends $*"; }

# shellcheck disable=SC1091
. /etc/os-release
apt-get indextargets --format 'deb $(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' |
  sort -u > "$work/sources.list"
apt-config dump Acquire | grep -v '""' > "$work/apt.conf" || true
say "A minimal root of $PRETTY_NAME"
quietly mmdebstrap --mode=root --variant=minbase --aptopt="$work/apt.conf" --aptopt='Acquire::Retries "3"' \
  "$VERSION_CODENAME" "$root" "$work/sources.list"
cp -L /etc/resolv.conf "$root/etc/resolv.conf" 2> /dev/null || true
echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # it is thrown away
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r "$here/tests/consumer" "$root/consumer"
inside 'apt-get update -qq'

say "hodt: the command"
install '/packages/hodt_*.deb'
inside '
  cd /tmp
  hodt --version
  hodt sample valley -n 2000 | hodt triangulate - -o terrain.ply -k 4
  hodt check terrain.ply -k 4
  for page in hodt hodt-triangulate hodt-check; do test -e /usr/share/doc/hodt/copyright; dpkg -L hodt | grep -q "/man1/$page.1.gz"; done
  bash -c "source /usr/share/bash-completion/completions/hodt && complete -p hodt"
  hodt formats | grep -q "GDAL: .*cannot be loaded"
  if hodt raster terrain.ply --resolution 5 -o dem.tif; then exit 1; fi  # says that GDAL is not there
  test ! -e dem.tif'
say "With what hodt recommends"
install "$(dpkg-deb -f "$packages"/hodt_*.deb Recommends | tr -d ,)"
inside 'cd /tmp && hodt formats | grep -q "GDAL: it is there" && hodt raster terrain.ply --resolution 5 -o dem.tif && hodt info dem.tif'

say "libhodt-dev: a project that uses CMake, and a program compiled with pkg-config"
install '/packages/libhodt-dev_*.deb g++ cmake make pkg-config'
inside '
  cmake -S /consumer -B /tmp/consumer > /tmp/consumer.log || { cat /tmp/consumer.log; exit 1; }
  cmake --build /tmp/consumer --target terrain > /tmp/consumer.log || { cat /tmp/consumer.log; exit 1; }
  /tmp/consumer/terrain /tmp/mesh.ply
  cd /tmp && /consumer/pkg_config.sh /usr/lib/$(gcc -print-multiarch)/pkgconfig g++'

if [ -e "$packages"/python3-hodt_*.deb ]; then
  say "python3-hodt: Debian's Python and numpy"
  install '/packages/python3-hodt_*.deb python3-pytest'
  inside '
    cd /tmp && python3 -c "
import importlib.metadata, hodt, numpy
assert importlib.metadata.version(\"hodt\") == hodt.__version__
result = hodt.triangulate(hodt.sample(\"valley\", 2000), k=4)
print(\"numpy\", numpy.__version__, result.value)
result.tin.write(\"python.ply\")"
    hodt check python.ply -k 4'
  mkdir -p "$root/sources/python"
  cp -r "$here/python/tests" "$root/sources/python"
  inside 'cd /tmp && python3 -m pytest -q -p no:cacheprovider /sources/python/tests/test_delaunay.py /sources/python/tests/test_tin.py'
fi

say "Removed again"
inside '
  dpkg -P $(dpkg-query -W -f "\${Package} " "*hodt*") > /dev/null
  left=$(find /usr /etc /var -iname "*hodt*" -not -path "/var/log/*")
  if [ "$left" ]; then echo "Left behind: $left"; exit 1; fi'
say "The packages are fine"
