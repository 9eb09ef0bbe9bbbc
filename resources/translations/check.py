#!/usr/bin/env python3
"""Fails where a translation is missing or has other placeholders than its source.

    check.py FILE.ts...
"""
import re
import sys
import xml.etree.ElementTree as ElementTree

PLACEHOLDER = re.compile(r"%[0-9n]+|<[^>]+>|\\$[a-z]+|\{[^}]*\}")


def placeholders(text):
    """Those of sentences may be numbered in a translation, from 0, to change their order."""
    found = [re.sub(r"^\{.*", "{}", one) for one in PLACEHOLDER.findall(text)]
    return sorted(found)


def main():
    wrong, sources = [], []
    for file in sys.argv[1:]:
        known = set()
        for context in ElementTree.parse(file).getroot().iter("context"):
            for message in context.iter("message"):
                source, translation = message.findtext("source"), message.find("translation")
                known.add((context.findtext("name"), source))
                text = translation.text or ""
                if translation.get("type") == "unfinished" or not text:
                    wrong.append(f"{file}: no translation of {source!r}")
                elif placeholders(source) != placeholders(text):
                    wrong.append(f"{file}: other placeholders in {text!r} than in {source!r}")
        sources.append(known)
    if any(known != sources[0] for known in sources):
        wrong.append("the files hold different texts; run resources/translations/update.sh")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
