#!/usr/bin/env python3
"""Collects the texts that lupdate does not find by itself, for the context "core": those marked with TR(), the patterns
of messages and errors, whose values are {}, the texts of the shipped presets and batches, and why methods are missing.

    collect_core.py ROOT OUT.cpp      writes them as a C++ file for lupdate
    collect_core.py ROOT --patterns   prints the patterns of messages as a JSON list
"""
import ast
import json
import pathlib
import re
import sys

MESSAGES = {"message", "fail", "failUsage"}
# Calls that take a text for the user in any place, which must therefore be marked with TR() or be a message.
TAKE_MARKED = {"stage", "wrong"}

TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)
      | R"(?P<fence>[^(\s]*)\((?P<raw>.*?)\)(?P=fence)"
      | (?P<literal>"(?:[^"\\\n]|\\.)*")
      | '(?:[^'\\\n]|\\.)+'
      | (?P<word>[A-Za-z_]\w*)
      | (?P<other>[0-9][\w.']*|\S)""",
    re.VERBOSE | re.DOTALL)


class Text(str):
    """The value of a string literal, or of several that stand side by side."""


def tokens(source):
    """Words and signs as str, strings as Text, without comments."""
    found = []
    for match in TOKEN.finditer(source):
        if match["comment"]:
            continue
        if match["raw"] is not None:
            text = Text(match["raw"])
        elif match["literal"]:
            text = Text(ast.literal_eval(match["literal"]))
        else:
            found.append(match[0])
            continue
        if found and isinstance(found[-1], Text):
            text = Text(found.pop() + text)
        found.append(text)
    return found


def arguments(found, begin):
    """The tokens of a call's arguments, each with its depth in brackets, from the one behind "(" on."""
    depth = 0
    for token in found[begin:]:
        if not isinstance(token, Text):
            depth += (token in "([{") - (token in ")]}")
        if depth < 0:
            return
        yield depth, token


def calls(found, names):
    """The place behind "(" of each call of one of these functions."""
    for i, token in enumerate(found[:-1]):
        if token in names and not isinstance(token, Text) and found[i + 1] == "(":
            yield i + 2


def first_texts(found, names):
    return {str(found[i]) for i in calls(found, names) if i < len(found) and isinstance(found[i], Text)}


def sources(root):
    for top in ("core", "ui"):
        for path in sorted((root / top).rglob("*.*")):
            if path.suffix in (".cpp", ".h", ".in"):
                yield path, tokens(path.read_text(encoding="utf-8"))


def patterns(root):
    return set().union(*(first_texts(found, MESSAGES) for _, found in sources(root)))


def shipped(root):
    for folder in ("presets", "batches"):
        for path in sorted((root / "resources" / folder).glob("*.json")):
            file = json.loads(path.read_text(encoding="utf-8"))
            yield from (file["title"], file["summary"])
            yield from (run["title"] for run in file.get("runs", []) if "title" in run)


def reasons(root):
    """Why a method can be missing in a build."""
    for path in sorted([*(root / "cmake").glob("*.cmake"), *(root / "core").rglob("component.cmake")]):
        yield from re.findall(r'set\(COMPONENT_ABSENT "([^"]+)"\)', path.read_text(encoding="utf-8"))


def texts(root):
    """Every text of the context "core"."""
    marked = set().union(*(first_texts(found, {"TR"}) for _, found in sources(root)))
    return marked | patterns(root) | set(shipped(root)) | set(reasons(root))


def unmarked_in(found):
    for begin in calls(found, TAKE_MARKED):
        for depth, token in arguments(found, begin):
            if depth == 0 and isinstance(token, Text):
                yield str(token)


def unmarked(root):
    """Texts for the user that nothing translates, with the file that they are in."""
    for path, found in sources(root):
        for text in unmarked_in(found):
            yield path.relative_to(root), text


def main():
    root, out = pathlib.Path(sys.argv[1]), sys.argv[2]
    if out == "--patterns":
        print(json.dumps(sorted(patterns(root))))
        return
    lines = [f'    QT_TRANSLATE_NOOP("core", {json.dumps(text, ensure_ascii=False)}),' for text in sorted(texts(root))]
    pathlib.Path(out).write_text(
        "static const char* const texts[] = {\n" + "\n".join(lines) + "\n};\n", encoding="utf-8")


if __name__ == "__main__":
    main()
