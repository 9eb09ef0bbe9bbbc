#!/usr/bin/env bash
# Checks the layout of all sources with clang-format, and core, ui and app with clang-tidy.
# --format-only leaves out clang-tidy; --part I/N asks clang-tidy alone, about the I-th of N parts; --fix lays the
# sources out instead of checking anything.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
cd "$root"

# tool NAME: the command of clang's tool NAME in version 14; other versions lay out and warn differently.
tool() {
  local candidate
  for candidate in "$1-14" "$1"; do
    if "$candidate" --version 2>/dev/null | grep -q 'version 14\.'; then
      echo "$candidate"
      return
    fi
  done
  echo "$1 14 is not installed" >&2
  return 1
}

# Prints all sources of the project, each ended by a zero byte.
sources() {
  git -c safe.directory="$root" ls-files -z --cached --others --exclude-standard -- \
    {core,ui,app,tests}/'*.h' {core,ui,app,tests}/'*.cpp' |
    while IFS= read -r -d '' file; do [[ ! -f $file ]] || printf '%s\0' "$file"; done
}

# formatFile FILE: names a file that clang-format would change.
# shellcheck disable=SC2317 # xargs calls it
formatFile() {
  "$clangFormat" --dry-run -Werror --style=file "$1" >/dev/null 2>&1 || {
    echo "$1: not laid out as .clang-format says; packaging/check_style.sh --fix does it"
    return 1
  }
}

checkFormat() {
  sources | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'formatFile "$@"' bash
}

# checkTidy [I/N]
checkTidy() {
  # Its commands, file by file, are all that is needed; nothing has to be built.
  [[ -f build/dev/compile_commands.json ]] || configurePreset dev || return
  packaging/tidy.py "$clangTidy" "$@"
}

clangFormat=$(tool clang-format)
clangTidy=$(tool clang-tidy)
export clangFormat
export -f formatFile

status=0
case ${1:-} in
  --fix) sources | xargs -0 -r "$clangFormat" -i --style=file ;;
  --format-only) checkFormat || status=1 ;;
  "") checkFormat || status=1; checkTidy || status=1 ;;
  --part) checkTidy "${2:?the part, such as 1/3}" || status=1 ;;
  *) echo "Usage: packaging/check_style.sh [--format-only | --part I/N | --fix]" >&2; status=2 ;;
esac
exit $status
