#!/usr/bin/env bash
# Makes build/venv, the virtual environment that the Python package is built and tested in, with the
# packages of python/tests/requirements.txt. Says nothing if it is there. Where they cannot be had, it
# says so and goes on: the rest of hodt is built and tested without.
set -eu
cd "$(dirname "$0")/.."
venv=build/venv
wanted=$(python3 --version && cat python/tests/requirements.txt)
if [ "$(cat $venv/made_of 2> /dev/null)" = "$wanted" ]; then exit 0; fi

rm -rf $venv
mkdir -p build
echo "Making $venv: packages from PyPI for the tests of the Python package" >&2
if python3 -m venv $venv &&
  $venv/bin/pip install -q --disable-pip-version-check --retries 2 --timeout 30 --only-binary :all: \
    -r python/tests/requirements.txt; then
  echo "$wanted" > $venv/made_of
else
  rm -rf $venv
  echo "No packages from PyPI: the Python package is NOT tested" >&2
fi
