#!/usr/bin/env bash
# Checks the layers, that each source has its test, the format and clang-tidy's rules. Tools that are not installed are skipped,
# and named; so is clang-tidy with --quick.
set -eu
cd "$(dirname "$0")/.."
failed=0

scripts/check_layers.py --self-test || failed=1
scripts/check_layers.py || failed=1
scripts/check_tests.py || failed=1

if command -v clang-format > /dev/null; then
  scripts/sources.sh | xargs clang-format --dry-run -Werror || failed=1
else
  echo "clang-format is not installed: format not checked" >&2
fi

[ "${1:-}" = "--quick" ] && exit $failed

if command -v clang-tidy > /dev/null; then
  scripts/dependencies.sh test
  # Without headers that GCC precompiled, which clang cannot read.
  cmake --preset release -B build/lint -DHODT_BUILD_TESTS=ON > /dev/null
  scripts/sources.sh | grep -E '/(src|app)/.*\.cpp$' |
    xargs -P 2 -n 4 clang-tidy -p build/lint --quiet || failed=1
else
  echo "clang-tidy is not installed: names and likely bugs not checked" >&2
fi
exit $failed
