#!/usr/bin/env python3
"""Writes a C++ file that names every text of core marked with TR() and of the shipped presets, so that lupdate,
which knows neither, finds them in the context "core".

    collect_core.py ROOT OUT
"""
import json
import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\]|\\.)*"'
MARKED = re.compile(r"\bTR\(\s*((?:" + LITERAL + r"\s*)+)\)")


def marked(root):
    for top in ("core", "ui"):
        for path in sorted((root / top).rglob("*.*")):
            if path.suffix in (".cpp", ".h", ".in"):
                for match in MARKED.finditer(path.read_text(encoding="utf-8")):
                    yield "".join(literal[1:-1] for literal in re.findall(LITERAL, match.group(1)))


def shipped(root):
    for path in sorted((root / "resources/presets").glob("*.json")):
        preset = json.loads(path.read_text(encoding="utf-8"))
        for key in ("title", "summary"):
            yield json.dumps(preset[key], ensure_ascii=False)[1:-1]


def main():
    root, out = map(pathlib.Path, sys.argv[1:])
    texts = sorted({*marked(root), *shipped(root)} - {"text"})
    lines = [f'    QT_TRANSLATE_NOOP("core", "{text}"),' for text in texts]
    out.write_text("static const char* const texts[] = {\n" + "\n".join(lines) + "\n};\n", encoding="utf-8")


main()
