#!/usr/bin/env python3
"""Times texloom-cli beside another program on the same task, turn by turn, and prints medians and the median of the
ratios pair by pair. CPU time is user plus system of the whole process less that of the program merely starting.

    tests/bench/pairs.py build/release/bin/texloom-cli                      quilting and PatchMatch beside G'MIC's
    tests/bench/pairs.py build/release/bin/texloom-cli --ipol PATH          quilting beside the IPOL 171 reference
    tests/bench/pairs.py build/release/bin/texloom-cli --rivals FOLDER      pixel by pixel beside IPOL 59 and Resynthesizer
    tests/bench/pairs.py build/release/bin/texloom-cli --tolerance 2        exact patch assignment beside that with ε

rivals/build.sh builds what FOLDER holds.
"""
import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

EXEMPLARS = os.path.join(os.path.dirname(__file__), "..", "..", "resources", "exemplars")
TASKS = [(128, 512, 32), (256, 1024, 40)]  # exemplar, output, patch


def cpu_seconds(command):
    """CPU and wall seconds of one run, output thrown away."""
    environment = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def startup(command):
    return statistics.median(cpu_seconds(command)[0] for _ in range(5))


def compare(name, ours, our_start, theirs, their_start, runs):
    cpu_seconds(ours)
    cpu_seconds(theirs)
    pairs = [(cpu_seconds(ours)[0] - our_start, cpu_seconds(theirs)[0] - their_start) for _ in range(runs)]
    own = statistics.median(p[0] for p in pairs)
    other = statistics.median(p[1] for p in pairs)
    ratio = statistics.median(p[1] / max(p[0], 1e-3) for p in pairs)
    print(f"{name}: texloom {own:.3f} s, other {other:.3f} s, other / texloom {ratio:.1f} (medians of {runs} pairs)")


def tolerance(cli, epsilon, runs):
    """Wall time on two threads, and the mean cost of a patch at the end, of patch assignment with and without ε."""
    times, energies = [], []
    with tempfile.TemporaryDirectory() as folder:
        crop, out, report = (os.path.join(folder, name) for name in ("crop.png", "out.png", "report.json"))

        def last(epsilon, seed):
            wall = cpu_seconds([cli, "synth", "patch-assignment", crop, "-o", out, "--size", "192", "--seed", str(seed),
                                "--set", f"epsilon={epsilon}", "--threads", "2", "--no-sidecar", "--quiet",
                                "--report", report])[1]
            with open(report, encoding="utf-8") as file:
                return wall, json.load(file)["curves"]["Mean cost of a patch"][-1]

        for name in ("soil_clods.png", "gravel_gray.png", "crazy_paving.png", "plank_wall_dark.png", "railway_ballast.png",
                     "sand_ripples.png", "solar_cells_blue.jpg", "grass_dry_gray.png"):
            subprocess.run(["oiiotool", os.path.join(EXEMPLARS, name), "--cut", "192x192+16+16", "-o", crop], check=True)
            pairs = [(last(0, seed), last(epsilon, seed)) for seed in range(runs)]
            time_ratios = [exact[0] / near[0] for exact, near in pairs]
            energy_ratios = [near[1] / exact[1] for exact, near in pairs]
            times += time_ratios
            energies += energy_ratios
            print(f"{name}: exact {statistics.median(p[0][0] for p in pairs):.1f} s, "
                  f"exact / ε {statistics.median(time_ratios):.1f}, cost ε / exact {statistics.mean(energy_ratios):.3f}",
                  flush=True)
    print(f"all: exact / ε {statistics.median(times):.1f} (median; least {min(times):.1f}), "
          f"cost ε / exact {statistics.mean(energies):.3f} (mean)")


def cut(exemplar, side, file):
    """Writes the top left square of an exemplar; the ending of the file's name says in which format."""
    subprocess.run(["oiiotool", exemplar, "--cut", f"{side}x{side}+0+0", "-d", "uint8", "-o", file], check=True)
    return file


class Ours:
    """Texloom's command lines, on one thread."""

    def __init__(self, cli, out):
        self.cli, self.out = cli, out
        self.start = startup([cli, "--version"])

    def __call__(self, method, exemplar, output, *settings):
        return [self.cli, "synth", method, exemplar, "-o", self.out, "--size", str(output), "--seed", "1", *settings,
                "--threads", "1", "--no-sidecar", "--quiet"]


def patches(ours, options, folder):
    """Quilting beside the IPOL reference, or quilting and PatchMatch beside G'MIC's."""
    their_out = os.path.join(folder, "theirs.png")  # no program overwrites the other's
    for side, output, patch in TASKS:
        crop = cut(options.exemplar, side, os.path.join(folder, f"crop{side}.png"))
        quilting = ours("quilting", crop, output, "--set", f"patch={patch}")
        if options.ipol:
            maps = [os.path.join(folder, "map1.png"), os.path.join(folder, "map2.png")]
            theirs = [options.ipol, "-p", str(patch), "-r", str(output // side), "-t", "0.1", "-o", "0.25", "-s", "1",
                      crop, their_out, *maps]
            compare(f"quilting {side} to {output}", quilting, ours.start, theirs, 0.0, options.runs)
            continue
        theirs = ["gmic", "-v", "-", crop, "srand", "1", "syntexturize_matchpatch", f"{output},{output}", "o", their_out]
        their_start = startup(["gmic", "-v", "-", "1"])
        for method, command in (("quilting", quilting), ("patchmatch", ours("patchmatch", crop, output))):
            compare(f"{method} {side} to {output}", command, ours.start, theirs, their_start, options.runs)


def pixels(ours, options, folder):
    """Efros–Leung beside IPOL 59's accelerated version, the fast ones beside Resynthesizer's engine."""
    crop, their_out = cut(options.exemplar, 128, os.path.join(folder, "crop.png")), os.path.join(folder, "theirs.png")
    rival = os.path.join(options.rivals, "efros_leung")
    maps = [os.path.join(folder, "map1.png"), os.path.join(folder, "map2.png")]
    theirs = [rival, "-p", "4", "-t", "0.1", "-s", "256", "-d", "20", crop, their_out, *maps]
    once = ["--set", "scales=1", "--set", "search=pca", "--set", "components=20"]
    for name, settings in (("from coarse to fine", []), ("on one scale, by components", once)):
        grown = ours("efros-leung", crop, 256, "--set", "window=9", *settings)
        compare(f"efros-leung 128 to 256, window 9, {name}", grown, ours.start, theirs, 0.0, options.runs)

    plain = cut(options.exemplar, 128, os.path.join(folder, "crop.ppm"))
    theirs = [os.path.join(options.rivals, "resynthesizer"), plain, "512", os.path.join(folder, "out.ppm")]
    for method in ("ashikhmin", "jump-map", "wei-levoy"):
        compare(f"{method} 128 to 512", ours(method, crop, 512), ours.start, theirs, 0.0, options.runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("texloom_cli")
    parser.add_argument("--ipol", help="the IPOL 171 program `quilting`, to compare with in place of G'MIC")
    parser.add_argument("--rivals", metavar="FOLDER", help="what rivals/build.sh built, to compare with in place of G'MIC")
    parser.add_argument("--exemplar", default=os.path.join(EXEMPLARS, "soil_clods.png"))
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--tolerance", type=float, metavar="ε", help="times patch assignment with and without ε instead")
    options = parser.parse_args()
    if options.tolerance is not None:
        return tolerance(options.texloom_cli, options.tolerance, options.runs)
    if not options.ipol and not options.rivals and not shutil.which("gmic"):
        sys.exit("pairs.py: gmic is not installed (Debian's package gmic), and neither --ipol nor --rivals was given.")

    with tempfile.TemporaryDirectory() as folder:
        ours = Ours(options.texloom_cli, os.path.join(folder, "out.png"))
        (pixels if options.rivals else patches)(ours, options, folder)


if __name__ == "__main__":
    main()
