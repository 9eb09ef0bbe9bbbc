#!/bin/bash
# Fuzzes every reader of files by coverage (libFuzzer, with AddressSanitizer) and keeps the inputs that reach new code:
#   tests/fuzz/hour.sh [minutes for each reader] [reader…]
# An input that ends the program stays in build/fuzz/READER/ as crash-… or timeout-…; run fuzz_guided on it to see it again.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/fuzz
minutes=${1:-5}
shift || true
readers=("$@")
[ ${#readers[@]} -gt 0 ] || readers=(png jpeg tiff exr hdr map volume obj ply gltf recipe model)
[ -x "$(command -v clang++)" ] || { echo "clang++ is missing: apt-get install clang"; exit 1; }

mkdir -p "$root/build"
cmake -S "$root" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=RelWithDebInfo -D CMAKE_CXX_COMPILER=clang++ \
  -D CMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -D CMAKE_UNITY_BUILD=ON -D TEXLOOM_PART=volume \
  -D TEXLOOM_SANITIZE=fuzzer-no-link,address -D TEXLOOM_WERROR=OFF > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }
cmake --build "$build" --target fuzz_guided

failed=0
for reader in "${readers[@]}"; do
  corpus=$root/tests/fuzz/corpus/$reader work=$build/$reader
  mkdir -p "$corpus" "$work/new"
  export TEXLOOM_FUZZ_READER=$reader ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
  echo "== $reader"
  "$build/bin/fuzz_guided" "$work/new" "$corpus" -artifact_prefix="$work/" -max_total_time=$((60 * minutes)) \
    -max_len=16384 -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 2> "$work/log" || failed=1
  grep -E 'stat::number_of_executed_units|SUMMARY' "$work/log" || tail -3 "$work/log"
  # What is kept is the least that reaches the same code, as long as it is little.
  rm -rf "$work/least"
  mkdir -p "$work/least"
  "$build/bin/fuzz_guided" -merge=1 -max_len=16384 "$work/least" "$corpus" "$work/new" > /dev/null 2>&1 || continue
  if [ "$(du -sb "$work/least" | cut -f1)" -lt $((160 << 10)) ]; then
    find "$corpus" -type f -delete
    cp "$work"/least/* "$corpus"/
  fi
done
[ "$failed" = 0 ] && echo "Every input was read or refused." || echo "Some reader broke: see $build/*/log."
du -sh "$root/tests/fuzz/corpus"
exit $failed
