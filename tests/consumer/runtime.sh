#!/usr/bin/env bash
# Installs the command from a build folder, and looks at what came with it.
#
#   runtime.sh BUILD PREFIX
set -eu
rm -rf "$2"
cmake --install "$1" --component runtime --prefix "$2"
cd "$2"
bin/hodt --version
for command in $(bin/hodt --help | sed -n '/^Subcommands:/,$s/^  \([a-z]*\) .*/\1/p'); do
  ls "share/man/man1/hodt-$command.1"
done
ls share/man/man1/hodt.1 share/bash-completion/completions/hodt share/zsh/site-functions/_hodt \
  share/fish/vendor_completions.d/hodt.fish
