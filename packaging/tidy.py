#!/usr/bin/env python3
"""Runs clang-tidy over core, ui and app, and remembers what passed; packaging/check_style.sh calls it.

    tidy.py CLANG_TIDY [I/N]    of all sources, or the I-th of N parts of them

Most of clang-tidy's time goes into headers. So sources of one room are looked at together, as one text; where
that text has a flaw, or names that clash, each half is looked at again, down to single files, whose flaws are shown.
"""
import collections
import concurrent.futures
import hashlib
import itertools
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/dev"
TIDY = BUILD / "tidy"
GROUP = 24
SMALL = 8
GCC_ONLY = ("-Winvalid-pch", "-Werror", "-fpch-preprocess", "-mno-direct-extern-access")
Source = collections.namedtuple("Source", "path arguments stamp")


def for_clang(command):
    """The command without precompiled headers and without flags that only g++ knows."""
    words, kept = iter(shlex.split(command)), []
    for word in words:
        if word == "-include":
            header = next(words)
            kept += [] if "cmake_pch" in header else [word, header]
        elif not word.startswith(GCC_ONLY):
            kept.append(word)
    return kept + ["-Wno-unknown-warning-option"]


def included():
    """For each object file, the project's files that went into it at the last build."""
    listing = subprocess.run(["ninja", "-C", BUILD, "-t", "deps"], capture_output=True, text=True).stdout
    found, current = {}, []
    for line in listing.splitlines():
        if line and not line[0].isspace():
            current = found.setdefault(line.split(":")[0], [])
        elif "cmake_pch" not in line and (not line.strip().startswith("/") or str(ROOT) in line):
            current.append((BUILD / line.strip()).resolve())
    return found


def sources():
    """All sources of core, ui and app. A stamp is a hash of all that clang-tidy's verdict depends on."""
    headers = sorted(h for top in ("core", "ui", "app") for h in (ROOT / top).rglob("*.h"))
    deps, found = included(), []
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        if path.suffix != ".cpp" or not any(path.is_relative_to(ROOT / top) for top in ("core", "ui", "app")):
            continue
        arguments = for_clang(entry["command"])
        parts = deps.get(arguments[arguments.index("-o") + 1], headers)
        digest = hashlib.sha256(json.dumps(arguments).encode())
        for part in [ROOT / ".clang-tidy", path, *sorted(set(parts))]:
            digest.update(part.read_bytes() if part.is_file() else b"")
        found.append(Source(path, arguments, TIDY / f"{digest.hexdigest()[:32]}.stamp"))
    return sorted(found)


def groups(pending):
    """Sources of one room that are compiled alike, at most GROUP together; small rooms of one storey share a group."""
    rooms = collections.Counter(source.path.relative_to(ROOT).parts[:2] for source in pending)

    def alike(source):
        own = source.arguments.index("-o") + 1
        storey, room = source.path.relative_to(ROOT).parts[:2]
        flags = [word for i, word in enumerate(source.arguments) if i != own and word != str(source.path)]
        return storey, "" if rooms[storey, room] <= SMALL else room, flags
    for _, room in itertools.groupby(sorted(pending, key=alike), key=alike):
        members = list(room)
        count = -(-len(members) // GROUP)
        for i in range(count):
            yield members[len(members) * i // count:len(members) * (i + 1) // count]


def flaws(clang_tidy, members):
    """What clang-tidy has against sources that follow one another in one text; empty for nothing."""
    first = members[0]
    with tempfile.TemporaryDirectory() as folder:
        text = first.path
        if len(members) > 1:
            text = pathlib.Path(folder) / "group.cpp"
            text.write_text("".join(f'#line 1 "{m.path}"\n{m.path.read_text()}\n' for m in members))
        command = [str(text) if word == str(first.path) else word for word in first.arguments]
        (pathlib.Path(folder) / "compile_commands.json").write_text(
            json.dumps([{"directory": str(BUILD), "file": str(text), "arguments": command}]))
        run = subprocess.run([clang_tidy, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", "-p", folder, text],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if run.returncode == 0:
        return ""
    return "\n".join(line for line in run.stdout.splitlines() if "warnings" not in line.split(" ")[1:2]) \
        or f"clang-tidy failed on {text}"


def check(clang_tidy, members):
    """Stamps what passes. Returns what does not."""
    found = flaws(clang_tidy, members)
    if not found:
        for member in members:
            member.stamp.touch()
        return ""
    if len(members) == 1:
        return found
    half = len(members) // 2
    return "\n".join(filter(None, (check(clang_tidy, part) for part in (members[:half], members[half:]))))


def part_of(everything, part):
    """The sources of every N-th group, from the I-th on, for a part "I/N"."""
    index, count = map(int, part.split("/"))
    return [source for group in list(groups(everything))[index - 1::count] for source in group]


def main(clang_tidy, part="1/1"):
    TIDY.mkdir(exist_ok=True)
    everything = sources()
    stamps = {source.stamp for source in everything}
    for old in TIDY.glob("*.stamp"):
        if old not in stamps:
            old.unlink()
    pending = [source for source in part_of(everything, part) if not source.stamp.exists()]
    if pending:
        print(f"clang-tidy: {len(pending)} files", flush=True)
    failed = False
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for output in pool.map(lambda members: check(clang_tidy, members), list(groups(pending))):
            if output:
                print(output, flush=True)
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
