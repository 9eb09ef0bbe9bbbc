#!/usr/bin/env bash
# Checks the layout of all sources with clang-format, and core, ui and app with clang-tidy (needs build/dev).
# --format-only leaves out clang-tidy; --fix lays the sources out instead of checking anything.
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

# Prints "STAMP<tab>FILE" for every source that clang-tidy has not passed as it stands, and writes a
# compile_commands.json that clang understands to build/dev/tidy. A stamp's name is a hash of the source, the
# project's headers that it includes, its command and .clang-tidy.
pendingFiles() {
  python3 - "$root" <<'PYTHON'
import hashlib, json, pathlib, shlex, subprocess, sys

root = pathlib.Path(sys.argv[1]).resolve()
build, tidy = root / "build/dev", root / "build/dev/tidy"
tidy.mkdir(exist_ok=True)
headers = sorted(h for top in ("core", "ui", "app") for h in (root / top).rglob("*.h"))
gcc_only = ("-Winvalid-pch", "-Werror", "-fpch-preprocess", "-mno-direct-extern-access")


def for_clang(command):
    """The command without precompiled headers and without flags that only g++ knows."""
    words, kept = iter(shlex.split(command)), []
    for word in words:
        if word == "-include":
            header = next(words)
            kept += [] if "cmake_pch" in header else [word, header]
        elif not word.startswith(gcc_only):
            kept.append(word)
    return kept + ["-Wno-unknown-warning-option"]


def included():
    """For each object file, the project's files that went into it at the last build."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout
    found, current = {}, []
    for line in listing.splitlines():
        if line and not line[0].isspace():
            current = found.setdefault(line.split(":")[0], [])
        elif "cmake_pch" not in line and (not line.strip().startswith("/") or str(root) in line):
            current.append((build / line.strip()).resolve())
    return found


def stamp(entry):
    arguments = entry["arguments"]
    parts = deps.get(arguments[arguments.index("-o") + 1], headers)
    digest = hashlib.sha256(json.dumps(arguments).encode())
    for path in [root / ".clang-tidy", pathlib.Path(entry["file"]), *sorted(set(parts))]:
        digest.update(path.read_bytes() if path.is_file() else b"")
    return digest.hexdigest()[:32]


deps, entries = included(), []
for entry in json.loads((build / "compile_commands.json").read_text()):
    file = pathlib.Path(entry["file"])
    if file.suffix == ".cpp" and any(file.is_relative_to(root / top) for top in ("core", "ui", "app")):
        entry["arguments"] = for_clang(entry.pop("command"))
        entries.append(entry)
(tidy / "compile_commands.json").write_text(json.dumps(entries, indent=1))

stamps = {entry["file"]: stamp(entry) for entry in entries}
for old in tidy.glob("*.stamp"):
    if old.stem not in stamps.values():
        old.unlink()
for file, name in sorted(stamps.items()):
    if not (tidy / f"{name}.stamp").exists():
        print(name, file, sep="\t")
PYTHON
}

# tidyFile STAMP FILE: prints what clang-tidy has against a file, or remembers that it has nothing.
# shellcheck disable=SC2317 # xargs calls it
tidyFile() {
  local output
  if output=$("$clangTidy" --quiet -p build/dev/tidy "$2" 2>&1); then
    touch "build/dev/tidy/$1.stamp"
  else
    output=$(grep -v -e '^[0-9]* warnings\? .*generated' -e '^[0-9]* warnings\? treated' <<<"$output")
    printf '%s\n' "${output:-clang-tidy failed on $2}"
    return 1
  fi
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

checkTidy() {
  if [[ ! -f build/dev/compile_commands.json ]]; then
    echo "clang-tidy needs a build first: packaging/test.sh --quick, or --format-only here" >&2
    return 1
  fi
  local pending
  pending=$(pendingFiles) || return
  [[ -n $pending ]] || return 0
  echo "clang-tidy: $(wc -l <<<"$pending") files"
  tr '\t\n' '\0\0' <<<"$pending" | xargs -0 -r -n 2 -P "$(nproc)" bash -c 'tidyFile "$@"' bash
}

clangFormat=$(tool clang-format)
clangTidy=$(tool clang-tidy)
export clangFormat clangTidy
export -f formatFile tidyFile

status=0
case ${1:-} in
  --fix) sources | xargs -0 -r "$clangFormat" -i --style=file ;;
  --format-only) checkFormat || status=1 ;;
  "") checkFormat || status=1; checkTidy || status=1 ;;
  *) echo "Usage: packaging/check_style.sh [--format-only | --fix]" >&2; status=2 ;;
esac
exit $status
