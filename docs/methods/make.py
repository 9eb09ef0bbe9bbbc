#!/usr/bin/env python3
"""Makes the pages of the methods and the pictures that are missing, or checks that they are as the program says.

    make.py TEXLOOM-CLI            writes the pages, and a picture for each method that has none
    make.py TEXLOOM-CLI --check    fails where a page says something else, or a picture is missing

To make a picture anew, delete it first. Pictures that show what a method was given beside what it made are put together
by oiiotool.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXEMPLARS = HERE.parent.parent / "resources/exemplars"
# What shows a method at its best; all others are shown on soil_clods.png.
SHOWN_ON = {
    "analogy": "crazy_paving.png",
    "anamorphosis": "plank_wall_dark.png",
    "ashikhmin": "grass_dry_gray.png",
    "fourier-mask": "solar_cells_blue.jpg",
    "gaussian-patches": "crazy_paving.png",
    "graph-cut": "railway_ballast.png",
    "heeger-bergen": "grass_dry_gray.png",
    "midway-quilting": "plank_wall_dark.png",
    "near-regular": "solar_cells_blue.jpg",
    "patchmatch": "railway_ballast.png",
    "quilting": "crazy_paving.png",
    "random-mosaic": "plank_wall_dark.png",
    "random-phase": "sand_ripples.png",
    "regular-tile": "solar_cells_blue.jpg",
    "sparse": "brick_pavement_gray.png",
    "texture-network": "crazy_paving.png",
    "texture-optimization": "crazy_paving.png",
}
# Methods that are given pictures by ports of their own are shown with them, two by two: A and the exemplar A', B and the
# result B'. The pictures fit SHOWN_ON's exemplar and have the size of the result.
GUIDED = {"analogy": {"guide": "crazy_paving_a.png", "output-guide": "crazy_paving_b.png"}}
GUIDED_SIDE = 256
# Methods that need a target follow a texture of this exemplar.
TARGETS = {"texture-transfer": "crazy_paving.png"}
# Methods that optimise or train for long are shown smaller, and after fewer steps.
BRIEFER = {"gram-cnn": (256, []), "solid-optimise": (192, ["--set", "side=96"]), "solid-texture": (256, ["--set", "iterations=200"]),
           "texture-network": (256, ["--set", "iterations=800"])}
SIDE = 384
BATCHES = HERE.parent.parent / "resources/batches"
EXAMPLE = HERE.parent.parent / "tests/methods/examples/mirror_tile.cpp"
GUIDE = HERE.parent.parent / "CONTRIBUTING.md"


def write_pages(cli, folder):
    subprocess.run([cli, "methods", "--markdown", folder], check=True)


def takes_exemplar(cli, method):
    listed = subprocess.run([cli, "methods", method, "--json"], check=True, stdout=subprocess.PIPE).stdout
    return any(port["id"] == "exemplar" for port in json.loads(listed)[0]["takes"])


def synthesise(cli, method, exemplar, output, *options, side=SIDE):
    exemplars = [EXEMPLARS / exemplar] if takes_exemplar(cli, method) else []
    subprocess.run([cli, "synth", method, *exemplars, "--size", str(side), "--seed", "1", "--quiet",
                    "--no-sidecar", "-o", output, *options], check=True)


def two_by_two(pictures, output, side, gap=8):
    """Puts the top left of four pictures on white."""
    whole = 2 * side + gap
    # Otherwise the picture would keep this command with all its paths.
    command = ["oiiotool", "--nosoftwareattrib", "--pattern", "constant:color=1,1,1", f"{whole}x{whole}", "3"]
    for i, picture in enumerate(pictures):
        x, y = i % 2 * (side + gap), i // 2 * (side + gap)
        command += [picture, "--ch", "R,G,B", "--cut", f"{side}x{side}+0+0", "--swap", "--paste", f"+{x}+{y}"]
    subprocess.run([*command, "--eraseattrib", ".*", "-d", "uint8", "-o", output], check=True)


def make_guided(cli, method, folder, output):
    """The exemplar's top left with its picture A above picture B and what is made of it."""
    exemplar, made = SHOWN_ON[method], folder / "made.png"
    inputs = [BATCHES / name for name in GUIDED[method].values()]
    options = [f"--input={port}={BATCHES / name}" for port, name in GUIDED[method].items()]
    synthesise(cli, method, exemplar, made, "--edit", f"crop=0,0,{GUIDED_SIDE},{GUIDED_SIDE}", *options, side=GUIDED_SIDE)
    two_by_two([inputs[0], EXEMPLARS / exemplar, inputs[1], made], output, GUIDED_SIDE)


def make_picture(cli, method):
    output = HERE / "picture" / f"{method}.jpg"
    with tempfile.TemporaryDirectory() as folder:
        if method in GUIDED:
            make_guided(cli, method, pathlib.Path(folder), output)
            return
        options = []
        if method in TARGETS:
            target = pathlib.Path(folder) / "target.png"
            synthesise(cli, "quilting", TARGETS[method], target)
            options = ["--input", f"target={target}"]
        side, briefer = BRIEFER.get(method, (SIDE, []))
        synthesise(cli, method, SHOWN_ON.get(method, "soil_clods.png"), output, *options, *briefer, side=side)


def absent_pages(cli):
    """The pages that this build knows nothing of: those of methods that it lacks, and the list that would have them."""
    listed = subprocess.run([cli, "methods", "--json"], check=True, stdout=subprocess.PIPE).stdout
    pages = {f"{method['id']}.md" for method in json.loads(listed) if "absent" in method}
    return pages | {"README.md"} if pages else pages


def check(cli):
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        write_pages(cli, folder)
        wanted = {page.name: page.read_text(encoding="utf-8") for page in pathlib.Path(folder).glob("*.md")}
    for name in sorted((wanted.keys() | {page.name for page in HERE.glob("*.md")}) - absent_pages(cli)):
        page = HERE / name
        if name not in wanted:
            wrong.append(f"docs/methods/{name}: there is no such method")
        elif not page.is_file() or page.read_text(encoding="utf-8") != wanted[name]:
            wrong.append(f"docs/methods/{name}: not what the declaration says")
        elif name != "README.md" and not (HERE / "picture" / name).with_suffix(".jpg").is_file():
            wrong.append(f"docs/methods/picture/{pathlib.Path(name).stem}.jpg: missing")
    if f"```cpp\n{EXAMPLE.read_text(encoding='utf-8')}```\n" not in GUIDE.read_text(encoding="utf-8"):
        wrong.append("CONTRIBUTING.md: does not show tests/methods/examples/mirror_tile.cpp as it is")
    return wrong


def main():
    cli = sys.argv[1]
    if sys.argv[2:] == ["--check"]:
        wrong = check(cli)
        print("\n".join([*wrong, "docs/methods/make.py TEXLOOM-CLI writes pages and missing pictures."] if wrong else []))
        return 1 if wrong else 0
    write_pages(cli, HERE)
    (HERE / "picture").mkdir(exist_ok=True)
    for page in sorted(HERE.glob("*.md")):
        if page.name != "README.md" and not (HERE / "picture" / page.name).with_suffix(".jpg").is_file():
            make_picture(cli, page.stem)
    return 0


if __name__ == "__main__":
    sys.exit(main())
