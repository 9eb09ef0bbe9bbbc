#!/usr/bin/env python3
"""Collects the texts that lupdate does not find by itself, for the context "core": those marked with TR(), those of
the shipped presets, and the sentences of errors, whose values are {}.

    collect_core.py ROOT OUT.cpp SENTENCES.txt   writes a C++ file for lupdate, and the sentences with values, one a line
    collect_core.py ROOT --check SENTENCES.txt   fails if the sentences are not those of the sources
"""
import json
import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\]|\\.)*"'
LITERALS = r"\s*((?:" + LITERAL + r"\s*)+)"
MARKED = re.compile(r"\bTR\(" + LITERALS + r"\)")
SENTENCE = re.compile(r"\b(?:fail|failUsage|fmt::format)\(" + LITERALS)


def sources(root):
    for top in ("core", "ui"):
        for path in sorted((root / top).rglob("*.*")):
            if path.suffix in (".cpp", ".h", ".in"):
                yield path.read_text(encoding="utf-8")


def texts(pattern, root):
    for source in sources(root):
        for match in pattern.finditer(source):
            yield "".join(literal[1:-1] for literal in re.findall(LITERAL, match.group(1)))


def sentences(root):
    """Whole ones only: they begin with a capital or a value and end with a full stop."""
    return {text for text in texts(SENTENCE, root)
            if re.match(r"[A-Z{“]", text) and text.endswith(".") and len(re.findall(r"[a-z]{2,}", text)) > 1}


def shipped(root):
    for path in sorted((root / "resources/presets").glob("*.json")):
        preset = json.loads(path.read_text(encoding="utf-8"))
        for key in ("title", "summary"):
            yield json.dumps(preset[key], ensure_ascii=False)[1:-1]


def main():
    root, out, listed = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    with_values = "".join(text + "\n" for text in sorted(sentences(root)) if "{" in text)
    if out == "--check":
        if listed.read_text(encoding="utf-8") != with_values:
            sys.exit(f"{listed} is not up to date; run resources/translations/update.sh")
        return
    found = sorted({*texts(MARKED, root), *shipped(root), *sentences(root)} - {"text"})
    lines = [f'    QT_TRANSLATE_NOOP("core", "{text}"),' for text in found]
    pathlib.Path(out).write_text(
        "static const char* const texts[] = {\n" + "\n".join(lines) + "\n};\n", encoding="utf-8")
    listed.write_text(with_values, encoding="utf-8")


main()
