#!/usr/bin/env bash
# Builds the site of the documentation into build/docs/html, and checks its links. Sphinx comes from PyPI,
# into build/docs-venv.
#
#   scripts/docs.sh COMMAND_REFERENCE    what hodt_manual wrote as command.md
set -euo pipefail
cd "$(dirname "$0")/.."
reference=$1
venv=build/docs-venv
site=build/docs

if ! cmp -s docs/site/requirements.txt $venv/made_of; then
  rm -rf $venv
  python3 -m venv $venv
  $venv/bin/pip install -q --disable-pip-version-check -r docs/site/requirements.txt
  cp docs/site/requirements.txt $venv/made_of
fi

rm -rf $site
mkdir -p $site/source/extra $site/source/static
PYTHONDONTWRITEBYTECODE=1 $venv/bin/python docs/site/stage.py "$reference" $site/source
cp docs/site/conf.py $site/source
cp docs/site/site.css $site/source/static
(cat docs/site/doxygen.conf && echo "OUTPUT_DIRECTORY = $site/source/extra") | doxygen -
$venv/bin/sphinx-build -q -W --keep-going -j auto -b html $site/source $site/html
$venv/bin/python docs/site/check_links.py $site/html
echo "The documentation is $PWD/$site/html/index.html"
