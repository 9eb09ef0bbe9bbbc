#!/bin/bash
# Fuzzes every reader of files by coverage (libFuzzer, with the address and undefined-behaviour sanitizers) and keeps the inputs that reach new code:
#   tests/fuzz/hour.sh [minutes for each reader, 3 if not given] [reader…]
# TEXLOOM_FUZZ_RUNS=100000 ends a reader after so many inputs, too. An input that ends the program stays in
# build/fuzz/READER/ as crash-… or timeout-…; run fuzz_guided on it to see it again.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/fuzz
minutes=${1:-3}
shift || true
readers=("$@")
if [ ${#readers[@]} -eq 0 ]; then
  readers=(archive batch checkpoint descriptor exr gltf hdr jpeg map model obj packed ply png preset recipe session tiff
    volume weights)
fi
most=$((80 << 10)) # bytes of the inputs that are kept for one reader; all together stay under 2 MB
[ -x "$(command -v clang++)" ] || { echo "clang++ is missing: apt-get install clang"; exit 1; }

mkdir -p "$root/build"
cmake -S "$root" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=RelWithDebInfo -D CMAKE_CXX_COMPILER=clang++ \
  -D CMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -D CMAKE_UNITY_BUILD=ON -D TEXLOOM_UI=OFF \
  -D TEXLOOM_SANITIZE=fuzzer-no-link,address,undefined -D TEXLOOM_WERROR=OFF > "$build.log" 2>&1 || { cat "$build.log"; exit 1; }
cmake --build "$build" --target fuzz_guided

# What readers write is synced to the disk; in memory that costs nothing.
[ -w /dev/shm ] && export TMPDIR=/dev/shm
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 OMP_WAIT_POLICY=passive
failed=()
for reader in "${readers[@]}"; do
  corpus=$root/tests/fuzz/corpus/$reader work=$build/$reader
  mkdir -p "$corpus" "$work/new"
  export TEXLOOM_FUZZ_READER=$reader
  "$build/bin/fuzz_guided" "$work/new" "$corpus" -artifact_prefix="$work/" -max_total_time=$((60 * minutes)) \
    -runs="${TEXLOOM_FUZZ_RUNS:--1}" -max_len=16384 -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 2> "$work/log" ||
    failed+=("$reader")
  echo "$reader: $(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log") inputs," \
    "$(grep -oE 'cov: [0-9]+' "$work/log" | tail -n 1)"
  grep -E 'SUMMARY|logic_error' "$work/log" || true
  # What is kept is the least that reaches the same code, as long as it is little.
  rm -rf "$work/least"
  mkdir -p "$work/least"
  "$build/bin/fuzz_guided" -set_cover_merge=1 -max_len=16384 "$work/least" "$corpus" "$work/new" > /dev/null 2>&1 || continue
  if [ "$(du -sb "$work/least" | cut -f1)" -lt "$most" ]; then
    find "$corpus" -type f -delete
    cp "$work"/least/* "$corpus"/
  fi
done
du -sb "$root/tests/fuzz/corpus"
if [ ${#failed[@]} -gt 0 ]; then
  echo "Some readers broke, and said so in $build/READER/log: ${failed[*]}."
  exit 1
fi
echo "Every input was read or refused."
