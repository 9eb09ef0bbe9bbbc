#!/usr/bin/env python3
"""Fails unless figures.md names every shipped batch, and nothing that is not there."""
import pathlib
import re
import sys

DOCS = pathlib.Path(__file__).resolve().parent
named = set(re.findall(r"`([a-z-]+)`", (DOCS / "figures.md").read_text()))
shipped = {file.stem for file in (DOCS.parent / "resources/batches").glob("*.json")}
for name in sorted(named ^ shipped):
    print(f"docs/figures.md: {name} {'is not in resources/batches' if name in named else 'is missing'}")
sys.exit(1 if named != shipped else 0)
