#!/usr/bin/env python3
"""Fails where a translation is missing or has other places for values than its source, where core or the presets have a
text that the files do not hold, and where a text for the user is not marked as one.

    check.py ROOT FILE.ts...
    check.py --self-test
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True
import collect_core

PLACE = re.compile(r"%[0-9n]+|<[^>]+>|\\$[a-z]+")
VALUE = re.compile(r"\{([^}:]*)[^}]*\}")


def values(text):
    """The numbers of the values in a pattern, sorted: they are counted, or have numbers to stand in another order.
    None if some have numbers and others do not."""
    found = VALUE.findall(text)
    numbered = [one for one in found if one.isdigit()]
    if numbered and len(numbered) < len(found):
        return None
    return sorted(map(int, numbered)) if numbered else list(range(len(found)))


def problem(source, text):
    """What is wrong with a translation; None if nothing is."""
    if sorted(PLACE.findall(source)) != sorted(PLACE.findall(text)) or values(source) != values(text):
        return f"other places for values in {text!r} than in {source!r}"
    return None


def read(file):
    """Of each message its context, source, translation and whether it is finished."""
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]
            finished = translation.get("type") != "unfinished" and all(forms)
            yield context.findtext("name"), message.findtext("source"), forms, finished


def wrong_in(file, wanted):
    core = set()
    for context, source, forms, finished in read(file):
        if context == "core":
            core.add(source)
        if not finished:
            yield f"no translation of {source!r}"
        else:
            yield from filter(None, (problem(source, form) for form in forms))
    yield from (f"{text!r} is not there; run resources/translations/update.sh" for text in sorted(wanted - core))
    yield from (f"{text!r} is used no more; run resources/translations/update.sh" for text in sorted(core - wanted))


def self_test():
    assert problem("{} of {:.1f}", "{1} von {0}") is None
    assert problem("{} of {}", "{} von {}") is None
    for text in ("{} von", "{0} von {0}", "{0} von {2}", "{0} von {}", "von {} {} {}"):
        assert problem("{} of {}", text), text
    assert problem("%1 of %2", "%2 von %1") is None
    assert problem("%1 of %2", "%1 von %1")
    source = """fail("a {} \\"b\\" " // "c"
        "d.", 'x', f("e")); /* TR("f") */ TR(R"(g "h")");
        stage(1, "i"); stage(1, TR("j")); notes(message("k"));"""
    found = collect_core.tokens(source)
    assert collect_core.first_texts(found, collect_core.MESSAGES) == {'a {} "b" d.', "k"}
    assert collect_core.first_texts(found, {"TR"}) == {'g "h"', "j"}
    assert list(collect_core.unmarked_in(found)) == ["i"]


def main():
    if sys.argv[1] == "--self-test":
        self_test()
        return
    root = pathlib.Path(sys.argv[1])
    wanted = collect_core.texts(root)
    wrong = [f"{file}: {text!r} is not marked with TR()" for file, text in collect_core.unmarked(root)]
    known = [{(context, source) for context, source, _, _ in read(file)} for file in sys.argv[2:]]
    for file in sys.argv[2:]:
        wrong += [f"{file}: {what}" for what in wrong_in(file, wanted)]
    if any(texts != known[0] for texts in known):
        wrong.append("the files hold different texts; run resources/translations/update.sh")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
