#!/usr/bin/env python3
"""Times texloom-cli beside another program on the same task, turn by turn, and prints medians and the median of the
ratios pair by pair. CPU time is user plus system of the whole process less that of the program merely starting.

    tests/bench/pairs.py build/release/bin/texloom-cli                      quilting and PatchMatch beside G'MIC's
    tests/bench/pairs.py build/release/bin/texloom-cli --ipol PATH          quilting beside the IPOL 171 reference
    tests/bench/pairs.py build/release/bin/texloom-cli --tolerance 2        exact patch assignment beside that with ε
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("texloom_cli")
    parser.add_argument("--ipol", help="the IPOL 171 program `quilting`, to compare with in place of G'MIC")
    parser.add_argument("--exemplar", default=os.path.join(EXEMPLARS, "soil_clods.png"))
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--tolerance", type=float, metavar="ε", help="times patch assignment with and without ε instead")
    options = parser.parse_args()
    if options.tolerance is not None:
        return tolerance(options.texloom_cli, options.tolerance, options.runs)
    if not options.ipol and not shutil.which("gmic"):
        sys.exit("pairs.py: gmic is not installed (Debian's package gmic), and no --ipol program was named.")

    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.png")
        for side, output, patch in TASKS:
            crop = os.path.join(folder, f"crop{side}.png")
            subprocess.run(["oiiotool", options.exemplar, "--crop", f"{side}x{side}+0+0", "--fullpixels", "-o", crop],
                           check=True)
            def ours(method, *settings):
                return [options.texloom_cli, "synth", method, crop, "-o", out, "--size", str(output), "--seed", "1",
                        *settings, "--threads", "1", "--no-sidecar", "--quiet"]

            own_start = startup([options.texloom_cli, "--version"])
            quilting = ours("quilting", "--set", f"patch={patch}")
            if options.ipol:
                maps = [os.path.join(folder, "map1.png"), os.path.join(folder, "map2.png")]
                theirs = [options.ipol, "-p", str(patch), "-r", str(output // side), "-t", "0.1", "-o", "0.25", "-s", "1",
                          crop, out, *maps]
                their_start = 0.0
            else:
                theirs = ["gmic", "-v", "-", crop, "srand", "1", "syntexturize_matchpatch", f"{output},{output}", "o", out]
                their_start = startup(["gmic", "-v", "-", "1"])
            compare(f"quilting {side} to {output}", quilting, own_start, theirs, their_start, options.runs)
            if not options.ipol:
                compare(f"patchmatch {side} to {output}", ours("patchmatch"), own_start, theirs, their_start,
                        options.runs)


if __name__ == "__main__":
    main()
