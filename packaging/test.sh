#!/usr/bin/env bash
# Installs what Texloom needs, builds it with warnings as errors, and runs every test and style check.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"

quick=false
sanitizers=false
for argument in "$@"; do
  case $argument in
    --quick) quick=true ;;
    --sanitizers) sanitizers=true ;;
    -h | --help)
      echo "Usage: packaging/test.sh [--quick] [--sanitizers]"
      echo "  --quick       leave out clang-tidy"
      echo "  --sanitizers  also build and test the core with sanitizers"
      exit ;;
    *)
      echo "packaging/test.sh: unknown option $argument; see --help" >&2
      exit 2 ;;
  esac
done

export OMP_WAIT_POLICY=passive QT_QPA_PLATFORM=offscreen
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}
failed=()

# attempt NAME COMMAND...: goes on after a failure, so that one run shows everything that is wrong.
attempt() {
  local name=$1
  shift
  echo "== $name"
  "$@" || failed+=("$name")
}

# testPreset NAME [WRAPPER...]: builds a preset and runs its tests.
testPreset() {
  buildPreset "$@" && "${@:2}" ctest --preset "$1" --no-tests=error --output-on-failure </dev/null
}

# The thread sanitizer does not start where the kernel spreads addresses widely.
fixedAddresses=()
if setarch -R true 2>/dev/null; then
  fixedAddresses=(setarch -R)
fi

installPackages
attempt "tests" testPreset dev
if $quick; then
  attempt "style" packaging/check_style.sh --format-only
else
  attempt "style" packaging/check_style.sh
fi
if $sanitizers; then
  attempt "address sanitizer" testPreset asan
  attempt "thread sanitizer" testPreset tsan "${fixedAddresses[@]}"
fi
attempt "desktop entry" desktop-file-validate packaging/texloom.desktop
attempt "application metadata" quietly "Validating" metainfo \
  appstreamcli validate --no-net packaging/io.github.texloom.Texloom.metainfo.xml

if ((${#failed[@]})); then
  printf -v list '%s, ' "${failed[@]}"
  echo "Failed: ${list%, }."
  exit 1
fi
$quick && echo "All quick checks passed." || echo "All checks passed."
