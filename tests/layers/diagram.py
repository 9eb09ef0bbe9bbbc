#!/usr/bin/env python3
"""Draws which folder includes which, for docs/architecture.md.

    diagram.py ROOT           prints the page with the diagram as the sources have it now
    diagram.py ROOT --write   puts it in the page
    diagram.py ROOT --check   fails if the page has another one

Arrows that follow from others are left out: a folder that includes match and image shows the arrow to match alone.
"""
import difflib
import pathlib
import re
import sys

from check_layers import CORE, INCLUDE

BEGIN, END = "<!-- diagram -->\n", "<!-- end of the diagram -->\n"


def room(path):
    """The folder that a path counts for: a layer of core, a folder of ui, or a program; None for other files."""
    parts = path.split("/")
    if len(parts) < 3 or parts[0] not in ("core", "ui", "app"):
        return None
    return "/".join(parts[:2])


def includes(root):
    """For each folder those that its files include."""
    known = {}
    for top in ("core", "ui", "app"):
        for file in sorted((root / top).rglob("*")):
            own = room(file.relative_to(root).as_posix())
            if own is None or file.suffix not in (".h", ".cpp"):
                continue
            known.setdefault(own, set())
            for line in file.read_text(encoding="utf-8").splitlines():
                found = INCLUDE.match(line)
                other = room(found.group(1).strip('"')) if found and found.group(1).startswith('"') else None
                if other and other != own:
                    known[own].add(other)
    return known


def reachable(known, start):
    seen, waiting = set(), list(known.get(start, ()))
    while waiting:
        one = waiting.pop()
        if one not in seen:
            seen.add(one)
            waiting.extend(known.get(one, ()))
    return seen


def reduced(known):
    """The arrows that do not follow from others; folders that include each other keep theirs."""
    for own in sorted(known):
        for other in sorted(known[own]):
            follows = any(other in reachable(known, step) and own not in reachable(known, step)
                          for step in known[own] - {other})
            if not follows:
                yield own, other


def name(folder):
    return folder.replace("/", "_")


def diagram(known):
    def order(folder):
        layer = folder.split("/")[1]
        return (CORE.index(layer) if folder.startswith("core/") and layer in CORE else len(CORE), folder)

    lines = ["```mermaid", "flowchart BT"]
    for top in ("core", "ui", "app"):
        lines.append(f"  subgraph {top}")
        lines += [f'    {name(f)}["{f.split("/")[1]}"]' for f in sorted(known, key=order) if f.startswith(top + "/")]
        lines.append("  end")
    lines += [f"  {name(own)} --> {name(other)}" for own, other in reduced(known)]
    return "\n".join(lines + ["```", ""])


def page(root):
    """The page as it is, and as it should be."""
    text = (root / "docs/architecture.md").read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    return text, before + BEGIN + diagram(includes(root)) + END + after


def main():
    root, mode = pathlib.Path(sys.argv[1]), (sys.argv[2:] or ["--print"])[0]
    now, wanted = page(root)
    if mode == "--write":
        (root / "docs/architecture.md").write_text(wanted, encoding="utf-8")
    elif mode == "--check" and now != wanted:
        print("docs/architecture.md shows other includes than there are; tests/layers/diagram.py . --write mends it:")
        print("\n".join(difflib.unified_diff(now.splitlines(), wanted.splitlines(), "the page", "the sources", lineterm="", n=0)))
        return 1
    elif mode == "--print":
        print(wanted, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
