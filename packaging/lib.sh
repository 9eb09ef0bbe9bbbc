# Shared by the scripts of this folder, which source it: installs packages, builds presets.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros} # else precompiled headers defeat ccache

# quietly MESSAGE NAME COMMAND...: runs a command with its output in build/log/NAME.log, and shows the log's
# end only when the command fails.
quietly() {
  local message=$1 name=$2
  shift 2
  local log=$root/build/log/$name.log
  mkdir -p "${log%/*}"
  echo "$message (log: build/log/$name.log)"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    echo "Failed: ${message,}." >&2
    return 1
  fi
}

# Prints the packages of the list that are not installed, one a line.
missingPackages() {
  local wanted
  wanted=$(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/packaging/debian-packages.txt" | sort -u)
  # shellcheck disable=SC2086
  comm -23 <(echo "$wanted") <(
    dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null | sed -n 's/ installed$//p' | sort -u)
}

# Installs what is missing of packaging/debian-packages.txt; says nothing when all is there.
installPackages() {
  local -a missing asRoot=()
  if ! command -v dpkg-query >/dev/null; then
    echo "This is not Debian: install the equivalents of packaging/debian-packages.txt yourself." >&2
    return 0
  fi
  mapfile -t missing < <(missingPackages)
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Missing packages and neither root nor sudo: as root, apt-get install ${missing[*]}" >&2
      return 1
    fi
    asRoot=(sudo)
  fi
  asRoot+=(env DEBIAN_FRONTEND=noninteractive)
  quietly "Updating the package lists" packages_update "${asRoot[@]}" apt-get update &&
    quietly "Installing missing packages" packages \
      "${asRoot[@]}" apt-get install --yes --no-install-recommends "${missing[@]}"
}

# configurePreset NAME [OPTION...]: configures a preset of CMakePresets.json in build/NAME, with options of CMake.
configurePreset() {
  quietly "Configuring preset $1" "configure_$1" cmake --preset "$1" "${@:2}"
}

# buildTargets NAME TARGET [WRAPPER...]: builds one target of a configured preset.
buildTargets() {
  quietly "Building preset $1" "build_$1" "${@:3}" cmake --build --preset "$1" --target "$2"
}

# buildPreset NAME [OPTION...]: configures and builds all of a preset.
buildPreset() {
  cd "$root" || return
  configurePreset "$@" && buildTargets "$1" all
}
