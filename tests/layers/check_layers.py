#!/usr/bin/env python3
"""Holds the source tree to its layers: who may include whom, and what every folder and header has.

    check_layers.py ROOT          prints each offence as file:line: what, and fails if there is one
    check_layers.py --self-test   plants one offence of each kind and fails if it is not found
"""
import pathlib
import re
import sys
import tempfile

CORE = ["base", "image", "color", "job", "io", "math", "network", "match", "analysis", "volume", "generator", "render", "tools", "methods", "session"]
# From the cellar to the roof: a folder of ui/ knows only those before it.
UI = [
    "common", "picture", "runs", "viewers", "paint", "exemplar", "inspector", "ports", "jobs", "scene", "results", "log", "maps", "export",
    "compare", "lattice", "blend", "plots", "volume", "material", "session", "window",
]
ORDERS = {"core": CORE, "ui": UI}
TOPS = {
    "core": ["core"],
    "ui": ["core", "ui"],
    "app/gui": ["core", "ui", "app/gui"],
    "app/cli": ["core", "app/cli"],
}
# What may be included where; a header of such a library anywhere else is an offence.
LIBRARIES = {
    "OpenImageIO": (r"<OpenImageIO/", ["core/io/"]),
    "OpenColorIO": (r"<OpenColorIO/", ["core/color/"]),
    "FFTW": (r"<fftw3", ["core/math/"]),
    "oneTBB": (r"<(tbb|oneapi)/", ["core/job/"]),
    "zlib": (r"<zlib\.h", ["core/io/"]),
    "Qt": (r"<(Q[A-Za-z]|q[a-z]+\.h|Qt[A-Z])", ["ui/", "app/gui/"]),
}
FIRST_LEVEL = ["core", "ui", "app", "resources", "tests", "packaging"]
LONGEST_README = 15
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"][^>"]+[>"])')


def top_of(path):
    """The entry of TOPS that a path lies in, or None."""
    return next((top for top in TOPS if path.startswith(top + "/")), None)


def method_of(path):
    """The method's or tool's folder that a path lies in, or None for the files directly in core/methods or tools."""
    parts = path.split("/")
    return "/".join(parts[1:3]) if parts[:2] in (["core", "methods"], ["core", "tools"]) and len(parts) > 3 else None


def library_offence(path, include):
    for library, (pattern, allowed) in LIBRARIES.items():
        if re.match(pattern, include) and not any(path.startswith(folder) for folder in allowed):
            return f"{include}: {library} belongs only in {' and '.join(allowed)}"
    return None


def include_offence(path, include):
    """What is wrong with one #include in one file, or None."""
    if include.startswith("<"):
        return library_offence(path, include)
    target = include.strip('"')
    top, target_top = top_of(path), top_of(target)
    if target_top is None:
        return f"{include}: write it as a path from the project's top, such as \"core/base/text.h\""
    if target_top not in TOPS[top]:
        return f"{include}: {top} must not know {target_top}"
    if top == target_top and top in ORDERS:
        layer, target_layer, order = path.split("/")[1], target.split("/")[1], ORDERS[top]
        if layer not in order or target_layer not in order:
            return f"{include}: a folder of {top} that is not in the list of layers"
        if order.index(target_layer) > order.index(layer):
            return f"{include}: {top}/{layer} comes before {top}/{target_layer} and must not know it"
        if method_of(target) and method_of(path) != method_of(target):
            return f"{include}: what is shared with a method or tool belongs in match, math or analysis"
    return None


def unit_of(path):
    """A header and the source beside it count as one."""
    return re.sub(r"\.(h|cpp|cpp\.in)$", "", path)


def units(root, top):
    """What each header with its source includes of the same top folder: {unit: {unit: "file:line"}}."""
    graph = {}
    for file in sorted((root / top).rglob("*")):
        if file.suffix not in (".h", ".cpp", ".in") or file.name == "CMakeLists.txt":
            continue
        path = file.relative_to(root).as_posix()
        known = graph.setdefault(unit_of(path), {})
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = INCLUDE.match(line)
            target = unit_of(found.group(1).strip('"')) if found else ""
            if target.startswith(top + "/") and target != unit_of(path):
                known.setdefault(target, f"{path}:{number}")
    return graph


def way_back(graph, start):
    """The shortest way along includes from a unit to itself, without the start; None if there is none."""
    ways, seen = [[unit] for unit in graph[start]], set()
    for way in ways:
        if way[-1] == start:
            return way
        if way[-1] not in seen:
            seen.add(way[-1])
            ways += [way + [unit] for unit in graph.get(way[-1], {})]
    return None


def circle_offences(root):
    """Files that include each other, directly or by way of others; each circle is told once."""
    for top in ORDERS:
        graph, told = units(root, top), set()
        for unit in graph:
            way = None if unit in told else way_back(graph, unit)
            if way:
                told.update(way)
                yield f"{graph[unit][way[0]]}: a circle of files that include each other: {', '.join(way)}"


def source_offences(root):
    for folder in ("core", "ui", "app"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".in") or file.name == "CMakeLists.txt":
                continue
            path = file.relative_to(root).as_posix()
            lines = file.read_text(encoding="utf-8").splitlines()
            if file.suffix == ".h" and "#pragma once" not in lines:
                yield f"{path}:1: a header without #pragma once"
            for number, line in enumerate(lines, 1):
                found = INCLUDE.match(line)
                offence = include_offence(path, found.group(1)) if found else None
                if offence:
                    yield f"{path}:{number}: {offence}"


def header_offences(root):
    for file in sorted((root / "tests").rglob("*.h")):
        if "#pragma once" not in file.read_text(encoding="utf-8").splitlines():
            yield f"{file.relative_to(root).as_posix()}:1: a header without #pragma once"


def readme_offences(root):
    for folder in FIRST_LEVEL:
        readme = root / folder / "README.md"
        if not readme.is_file():
            yield f"{folder}/README.md:1: missing"
            continue
        lines = len(readme.read_text(encoding="utf-8").splitlines())
        if lines > LONGEST_README:
            yield f"{folder}/README.md:{LONGEST_README + 1}: {lines} lines; at most {LONGEST_README}"


def offences(root):
    yield from source_offences(root)
    yield from circle_offences(root)
    yield from header_offences(root)
    yield from readme_offences(root)


# Each offence with the line that plants it; the tree is clean but for that one.
PLANTS = {
    "core/base/a.cpp": '#include "core/image/image.h"',
    "core/math/b.h": '#pragma once\n#  include "core/match/c.h"',
    "core/io/c.cpp": '#include "ui/window/w.h"',
    "core/session/d.cpp": "#include <QString>",
    "core/session/e.cpp": "#include <OpenImageIO/imageio.h>",
    "core/io/f.cpp": "#include <OpenColorIO/OpenColorIO.h>",
    "core/match/g.cpp": "#include <fftw3.h>",
    "core/math/h.h": "#pragma once\n#include <tbb/task_group.h>",
    "core/methods/one/i.cpp": '#include "core/methods/two/settings.h"',
    "core/methods/j.cpp": '#include "core/methods/two/settings.h"',
    "core/session/k.cpp": '#include "core/methods/two/settings.h"',
    "core/session/u.cpp": '#include "core/tools/one/settings.h"',
    "core/tools/one/v.cpp": '#include "core/tools/two/settings.h"',
    "core/tools/one/w.cpp": '#include "core/methods/method.h"',
    "core/extra/l.cpp": '#include "core/base/text.h"',
    "core/base/m.h": "struct M {};",
    "ui/exemplar/n.h": '#pragma once\n#include "ui/window/w.h"',
    "ui/viewers/n.cpp": '#include "ui/exemplar/e.h"',
    "ui/extra/n.cpp": '#include "ui/common/text.h"',
    "ui/window/n.cpp": '#include "app/gui/main.h"',
    "ui/window/o.cpp": '#include "o.h"',
    "ui/jobs/p.cpp": "#include <tbb/task_group.h>",
    "app/cli/q.cpp": '#include "ui/window/w.h"',
    "app/cli/r.cpp": "#include <QtCore/QString>",
    "app/gui/s.cpp": '#include "app/cli/console.h"',
    "tests/support/t.h": "struct T {};",
    "ui/README.md": "line\n" * 16,
}
ALLOWED = {
    "core/session/ok.cpp": '#include "core/methods/method.h"\n#include "core/base/text.h"\n#include <vector>',
    "core/methods/one/ok.h": '#pragma once\n#include "core/methods/one/settings.h"\n#include "core/match/c.h"',
    "core/io/ok.cpp": "#include <OpenImageIO/imageio.h>\n// #include <QString> is only spoken of here",
    "core/job/ok.cpp": "#include <tbb/task_group.h>",
    "core/math/ok.cpp": "#include <fftw3.h>",
    "core/color/ok.cpp": "#include <OpenColorIO/OpenColorIO.h>",
    "ui/runs/ok.cpp": '#include "ui/common/text.h"\n#include "ui/runs/j.h"',
    "ui/window/ok.cpp": '#include "ui/jobs/j.h"\n#include "core/io/recipe.h"\n#include <QString>',
    "app/gui/ok.cpp": '#include "ui/window/w.h"\n#include "core/base/text.h"\n#include <QApplication>',
    "app/cli/ok.cpp": '#include "app/cli/console.h"\n#include "core/base/text.h"\n#include <CLI/CLI.hpp>',
}

# Circles take more than one line; the first file of each is the one that is named.
CIRCLES = [
    {"core/math/u.h": '#pragma once\n#include "core/math/v.h"', "core/math/v.h": '#pragma once\n#include "core/math/u.h"'},
    {"core/math/u.cpp": '#include "core/math/v.h"', "core/math/v.cpp": '#include "core/math/u.h"'},
    {
        "core/match/u.h": '#pragma once\n#include "core/match/v.h"',
        "core/match/v.cpp": '#include "core/match/w.h"',
        "core/match/w.h": '#pragma once\n#include "core/match/u.h"',
    },
    {"core/job/u.cpp.in": '#include "core/job/v.h"', "core/job/v.cpp": '#include "core/job/u.h"'},
    {"ui/window/u.h": '#pragma once\n#include "ui/window/v.h"', "ui/window/v.cpp": '#include "ui/window/u.h"'},
]


def write(root, path, text):
    file = root / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text + "\n", encoding="utf-8")


def found_in(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in FIRST_LEVEL:
            write(root, f"{name}/README.md", "What is here.")
        for path, text in files.items():
            write(root, path, text)
        return list(offences(root))


def self_test():
    wrong = [f"found in a clean tree: {line}" for line in found_in(ALLOWED)]
    for path, text in PLANTS.items():
        found = found_in({**ALLOWED, path: text})
        if len(found) != 1 or not re.match(re.escape(path) + r":\d+: ", found[0]):
            wrong.append(f"planted {path}, found {found}")
    for circle in CIRCLES:
        found = found_in({**ALLOWED, **circle})
        if len(found) != 1 or not found[0].startswith(next(iter(circle)) + ":") or "circle" not in found[0]:
            wrong.append(f"planted {circle}, found {found}")
    for line in found_in({"core/math/b.h": PLANTS["core/math/b.h"]}):
        if not line.startswith("core/math/b.h:2: "):
            wrong.append(f"wrong line number: {line}")
    return wrong


def main():
    lines = self_test() if sys.argv[1:] == ["--self-test"] else list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(lines))
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
