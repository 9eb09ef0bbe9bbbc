#!/usr/bin/env bash
# Installs what Texloom needs, builds it with warnings as errors, and runs tests and style checks: all, or a part.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"

# Each part (cmake/parts.cmake) is tested with each sanitizer by --sanitizers. --turn goes through those that do without the
# methods: the others compile the whole core first, which takes longer than all else together may.
parts=(job math network match analysis io volume generator render tools session cli fuzz methods_{1..6})
turned=(job math network match analysis io volume)
presets=(asan tsan)
# Turns go to a share of clang-tidy and to a part with a sanitizer, one after the other.
shares=8
turns=$((2 * ${#turned[@]} * ${#presets[@]}))

usage() {
  echo "Usage: packaging/test.sh [--core | --method ID] [--quick] [--sanitizers | --turn]"
  echo "  --core        only the library and the command line, without the window"
  echo "  --method ID   only what tests this method, such as quilting; no style checks"
  echo "  --quick       leave out clang-tidy and the slow tests"
  echo "  --sanitizers  also build and test all but the window with each sanitizer"
  echo "  --turn        of what takes longest only one part: a share of clang-tidy, or a part of the core with one"
  echo "                sanitizer; another one each day, or number TEXLOOM_TURN of the $turns"
}

part=all
method=
quick=false
sanitizers=false
turn=false
while (($#)); do
  case $1 in
    --core) part=core ;;
    --method)
      part=method
      method=${2:-}
      shift ;;
    --quick) quick=true ;;
    --sanitizers) sanitizers=true ;;
    --turn) turn=true ;;
    -h | --help)
      usage
      exit ;;
    *)
      echo "packaging/test.sh: unknown option $1; see --help" >&2
      exit 2 ;;
  esac
  shift || true
done
if [[ $part == method && ! -d core/methods/${method//-/_} || $part == method && -z $method ]]; then
  echo "packaging/test.sh: --method needs the id of a method, such as quilting; there is no \"$method\"" >&2
  exit 2
fi

export OMP_WAIT_POLICY=passive QT_QPA_PLATFORM=offscreen
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
failed=()
times=()

# attempt NAME COMMAND...: goes on after a failure, so that one run shows everything that is wrong.
attempt() {
  local name=$1 begun=$SECONDS
  shift
  echo "== $name"
  "$@" || failed+=("$name")
  times+=("$name $((SECONDS - begun)) s")
}

# runTests PRESET [ARGUMENT...]: ctest on what was built.
runTests() {
  ctest --preset "$1" --no-tests=error --output-on-failure "${@:2}" </dev/null
}

# The thread sanitizer does not start where the kernel spreads addresses widely.
fixedAddresses=()
if setarch -R true 2>/dev/null; then
  fixedAddresses=(setarch -R)
fi

# sanitized PRESET [WRAPPER...]: builds and tests every part with one sanitizer.
sanitized() {
  local part broken=0
  for part in "${parts[@]}"; do
    sanitizedPart "$1" "$part" "${@:2}" || broken=1
  done
  return $broken
}

# sanitizedPart PRESET PART [WRAPPER...]: builds and tests one part with one sanitizer.
sanitizedPart() {
  local preset=$1 part=$2
  local -a wrapper=("${@:3}")
  # Damaged files meet one thread; the decoders' own are not ours to watch.
  [[ $preset-$part != tsan-fuzz ]] || return 0
  # What needs all layers shares them.
  local folder=build/$preset-$part
  case $part in
    tools | session | cli | fuzz | methods_*) folder=build/$preset-whole ;;
  esac
  # Optimised little: that compiles in half the time, and asserts stay in.
  quietly "Configuring $part with $preset" "configure_$preset-$part" cmake --preset "$preset" -B "$folder" \
    -D "TEXLOOM_PART=$part" -D "CMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1" &&
    quietly "Building $part with $preset" "build_$preset-$part" "${wrapper[@]}" cmake --build "$folder" &&
    LSAN_OPTIONS=suppressions=$root/tests/lsan_suppressions.txt:print_suppressions=0 \
      TSAN_OPTIONS=suppressions=$root/tests/tsan_suppressions.txt \
      "${wrapper[@]}" ctest --test-dir "$folder" --no-tests=error --output-on-failure -LE '^timed$' </dev/null
}

# takeTurn NUMBER: the share of clang-tidy, or the part with the sanitizer, whose turn it is.
takeTurn() {
  local own=$(($1 / 2))
  echo "Turn $(($1 % turns)) of $turns"
  if (($1 % 2 == 0)); then
    packaging/check_style.sh --part "$((own % shares + 1))/$shares"
    return
  fi
  local part=${turned[$own % ${#turned[@]}]} preset=${presets[$own / ${#turned[@]} % ${#presets[@]}]}
  local -a wrapper=()
  if [[ $preset == tsan ]]; then
    wrapper=("${fixedAddresses[@]}")
  fi
  sanitizedPart "$preset" "$part" "${wrapper[@]}"
}

targets=all
chosen=()
# Many sources at a time, which takes a quarter of the time from scratch, but longer after an edit.
preset=check
if $quick || [[ $part != all ]]; then
  preset=dev
fi
case $part in
  core)
    targets=core_tests
    chosen=(-L '^core$') ;;
  method)
    targets=test_$method
    chosen=(-L "^$method\$") ;;
esac
if $quick; then
  chosen+=(-LE '^slow$')
fi

# Each needs the one before.
attempt "packages" installPackages
((${#failed[@]})) || attempt "configure" configurePreset $preset
((${#failed[@]})) || attempt "build" buildTargets $preset "$targets"
((${#failed[@]})) || attempt "tests" runTests $preset "${chosen[@]}"
if [[ $part != method ]]; then
  if $quick || $turn; then
    attempt "style" packaging/check_style.sh --format-only
  else
    attempt "style" packaging/check_style.sh
  fi
fi
if $sanitizers; then
  attempt "address sanitizer" sanitized asan
  attempt "thread sanitizer" sanitized tsan "${fixedAddresses[@]}"
fi
if $turn; then
  attempt "turn" takeTurn "${TEXLOOM_TURN:-$(($(date +%s) / 86400))}"
fi
if [[ $part == all ]]; then
  attempt "desktop entry" desktop-file-validate packaging/texloom.desktop
  attempt "application metadata" quietly "Validating" metainfo \
    appstreamcli validate --no-net packaging/io.github.texloom.Texloom.metainfo.xml
fi

printf -v list '%s, ' "${times[@]}"
echo "Times: ${list%, }; together $SECONDS s."
if ((${#failed[@]})); then
  printf -v list '%s, ' "${failed[@]}"
  echo "Failed: ${list%, }."
  exit 1
fi
case $part-$quick in
  all-false) echo "All checks passed." ;;
  all-true) echo "All quick checks passed." ;;
  core-*) echo "All checks of the core passed." ;;
  *) echo "All tests of $method passed." ;;
esac
