#!/usr/bin/env bash
# Runs the fuzz targets of build/fuzz, FUZZ_SECONDS (default: an hour) each, or those named as
# arguments. Each starts from its corpus in tests/fuzz/corpus; what it finds on the way stays in
# build/fuzz/found, and an input that breaks something is build/fuzz/TARGET-crash-... or the like.
set -eu
cd "$(dirname "$0")/.."
seconds=${FUZZ_SECONDS:-3600}
[ $# -gt 0 ] || set -- points ply obj places lines gzip las command objectives

for target in "$@"; do
  found=build/fuzz/found/$target
  mkdir -p "$found"
  words=$PWD/tests/fuzz/words/$target
  # The command's own messages are no news.
  quiet=$([ "$target" = command ] && echo 3 || echo 0)
  echo "$target: $seconds seconds"
  build/fuzz/tests/fuzz/fuzz_"$target" "$PWD/$found" "$PWD/tests/fuzz/corpus/$target" \
    -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 \
    -close_fd_mask="$quiet" -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$PWD/build/fuzz/$target-" \
    ${words:+$([ -f "$words" ] && echo "-dict=$words")}
done
