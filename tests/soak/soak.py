#!/usr/bin/env python3
"""Runs random recipes, kills, full disks and cancels, and holds Texloom to its promises: the same bits with any number
of threads and again from the recipe, position maps that give the result where they say so, an end in one sentence,
nothing half-written and nothing lost.

    soak.py PROGRAM --doors PROGRAM --fault LIBRARY --saves PROGRAM [--runs N] [--kills N] [--full N] [--cancels N]
            [--thorough] [--seed S] [--minutes M] [--exemplar FILE]…

Runs go through all methods in an order that the seed gives; one in five has a batch or a join of two pictures besides. Kills come at each named moment (faults.py) and at every write, sync and rename. A failure names the seed and the
number of what failed, and keeps its folder; the others go on. Each kind is tried as often as is asked, or until the minutes
are over. The last line has the figures.
"""
import argparse
import collections
import json
import os
import pathlib
import pty
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import calls
from calls import ports
from faults import Faults
from pictures import Pixels, made_up

LONGEST = 3600  # seconds that a run may take, whatever else the machine does
REFUSED = (1, 2)
CANCELLED = 130
OWN = ("exemplar.png", "second.png", "mask.png", "region.png", "call.json", "batch.json")
THREADS = (1, 2, 7)
STAGES = 4  # how many of a method's stages interrupts are sent in
MOST_PROBLEMS = 10
# What a refusal is about, by words in its sentence.
REFUSALS = [("memory", r"memory"), ("mask", r"mask|region|hidden"), ("edit", r"--edit|crop|rectif|turn"),
            ("setting", r"goes from|is one of|needs|whole number"), ("size", r"px|size|small|large|wide"),
            ("wrap", r"wrap|tile"), ("input", r"input|exemplar|picture")]


class Broken(Exception):
    """A promise that was not kept."""


def kind_of(sentence):
    return next((kind for kind, words in REFUSALS if re.search(words, sentence, re.IGNORECASE)), "other")


def left_over(folder):
    return [entry.name for entry in folder.iterdir() if entry.name not in OWN]


class Soak:
    Broken = Broken

    def __init__(self, options):
        self.program, self.doors, self.fault, self.saves = (
            str(pathlib.Path(getattr(options, name)).resolve()) for name in ("program", "doors", "fault", "saves"))
        self.exemplars = options.exemplar
        self.methods = [method for method in self.listed("methods") if "absent" not in method]
        random.Random(f"{options.seed} methods").shuffle(self.methods)
        self.joins = [tool for tool in self.listed("tools") if tool["actsOn"] == "two-images"]
        self.refusals = collections.Counter()
        self.done = collections.Counter()
        self.differing = self.maps = 0
        self.waits = []
        self.faults = Faults(self, options.thorough)

    def listed(self, what):
        return json.loads(subprocess.run([self.program, what, "--json"], capture_output=True, check=True).stdout)

    def call(self, program, words, folder, fault=None, lines=1):
        """Runs a program to its end. @param lines that it may say where it refuses. @return its exit status, negative
        where a signal ended it."""
        environment = dict(os.environ, OMP_WAIT_POLICY="passive")
        if fault:
            environment.update(TEXLOOM_FAULT=fault, LD_PRELOAD=self.fault)
        done = subprocess.run([program, *map(str, words)], cwd=folder, capture_output=True, timeout=LONGEST,
                              env=environment)
        killed = fault is not None and fault.startswith("kill") and done.returncode == -signal.SIGKILL
        if done.returncode not in (0, *REFUSED) and not killed:
            raise Broken(f"status {done.returncode}: {words}: {done.stderr[-500:]}")
        if done.returncode in REFUSED:
            self.said = done.stderr.decode(errors="replace")
            if not 1 <= self.said.count("\n") <= lines:
                raise Broken(f"not one line: {words}: {self.said!r}")
        return done.returncode

    def expect_alike(self, first, second, what):
        bits = Pixels(first).differing_bits(Pixels(second))
        self.differing += bits
        if bits:
            raise Broken(f"{what}: {first.name} and {second.name} differ in {bits} bits")

    def refused(self, folder):
        self.refusals[kind_of(self.said)] += 1
        if left_over(folder):
            raise Broken(f"refused, but left {left_over(folder)}")

    def prepared(self, folder, rng, words_for):
        """@return the exemplar and the words of a call, which are kept in the folder, too."""
        exemplar = made_up(folder, rng)
        if self.exemplars and rng.random() < 0.5:
            exemplar = rng.choice(self.exemplars)
        words = words_for(exemplar)
        (folder / "call.json").write_text(json.dumps([str(word) for word in words]))
        return exemplar, words

    def run(self, number, rng, folder):
        """One recipe of a method, which all have their turn; every fifth time a join or a batch besides."""
        method = self.methods[number % len(self.methods)]
        self.synth(method, rng, folder)
        besides = folder / "besides"
        besides.mkdir()
        if number % 10 == 2:
            self.join(self.joins[number // 10 % len(self.joins)], rng, besides)
        elif number % 10 == 4:
            self.batch([method, rng.choice(self.methods)][:rng.randint(1, 2)], rng, besides)

    def synth(self, method, rng, folder):
        """With 1, 2 and 7 threads, a part of it, again from its sidecar and from its image, and by its map."""
        then = rng.choice(self.methods) if rng.random() < 0.1 else None
        exemplar, words = self.prepared(
            folder, rng, lambda file: calls.synth(method, then, file, file == "exemplar.png", rng))
        maps = ["--map", "map.exr"] if "map" in ports(then or method, "gives") else []
        first = [*words, "-o", "1.png", "--report", "report.json", "--threads", 1, "--quiet", *maps]
        if self.call(self.program, first, folder) != 0:
            return self.refused(folder)
        for threads in THREADS[1:]:
            self.call(self.program, [*words, "-o", f"{threads}.png", "--threads", threads, "--quiet"], folder)
            self.expect_alike(folder / "1.png", folder / f"{threads}.png", "threads")
        for source in ("1.json", "1.png"):
            self.call(self.program, ["run", source, "-o", "again.png", "--quiet"], folder)
            self.expect_alike(folder / "1.png", folder / "again.png", f"recipe in {source}")
        self.region(words, rng, folder)
        if json.loads((folder / "report.json").read_text())["map"] == "exact" and "--edit" not in words:
            self.maps += 1
            self.call(self.program, ["apply", "map.exr", exemplar, "-o", "applied.png", "--quiet"], folder)
            self.expect_alike(folder / "1.png", folder / "applied.png", "map")

    def region(self, words, rng, folder):
        """A part equals that part of the whole, where the method makes parts."""
        whole = Pixels(folder / "1.png")
        width, height = rng.randint(1, whole.width), rng.randint(1, whole.height)
        x, y = rng.randint(0, whole.width - width), rng.randint(0, whole.height - height)
        box = ["--region", f"{x},{y},{width},{height}"]
        if rng.random() < 0.3 and self.call(self.program, [*words, *box, "-o", "part.png", "--quiet"], folder) == 0:
            self.done["regions"] += 1
            if Pixels(folder / "part.png").rows != whole.part(x, y, width, height):
                raise Broken(f"region {box[1]} is not that part of the whole")

    def join(self, tool, rng, folder):
        """Two pictures joined: the same bits each time, on one processor and on all."""
        _, words = self.prepared(folder, rng, lambda file: calls.join(tool, rng))
        if self.call(self.program, [*words, "-o", "1.png", "--quiet"], folder) != 0:
            return self.refused(folder)
        self.done["joins"] += 1
        for name, program in (("again", [self.program]), ("alone", ["taskset", "-c", "0", self.program])):
            self.call(program[0], [*program[1:], *words, "-o", f"{name}.png", "--quiet"], folder)
            self.expect_alike(folder / "1.png", folder / f"{name}.png", "join")

    def batch(self, methods, rng, folder):
        """A sweep with 1, 2 and 7 threads, and each result again from its recipe."""
        made_up(folder, rng)
        (folder / "batch.json").write_text(calls.batch(methods, rng))
        for threads in THREADS:
            (folder / f"to{threads}").mkdir()
            words = ["batch", "batch.json", "--threads", threads, "--to", f"to{threads}", "--quiet"]
            if self.call(self.program, words, folder, lines=20) != 0:
                self.refusals["batch"] += 1
        self.done["batches"] += 1
        names = [sorted(entry.name for entry in (folder / f"to{threads}").iterdir()) for threads in THREADS]
        if names[0] != names[1] or names[0] != names[2]:
            raise Broken(f"batches with other threads made other files: {names}")
        for image in (folder / "to1").glob("*.png"):
            for threads in THREADS[1:]:
                self.expect_alike(image, folder / f"to{threads}" / image.name, "batch")
            self.call(self.program, ["run", image.with_suffix(".json"), "-o", "again.png", "--quiet"], folder)
            self.expect_alike(image, folder / "again.png", "recipe of a batch")

    def cancel(self, number, rng, folder):
        """An interrupt inside each of the first stages of each method; it ends soon, says so, and leaves nothing."""
        method = self.methods[number % len(self.methods)]
        wanted = number // len(self.methods) % STAGES
        _, words = self.prepared(folder, rng, lambda file: calls.synth(method, None, file, file == "exemplar.png", rng))
        words[words.index("--size") + 1] = "512"
        ours, theirs = pty.openpty()  # stages are shown where someone looks
        process = subprocess.Popen([self.program, *map(str, words), "-o", "one.png"], cwd=folder, stderr=theirs,
                                   stdout=subprocess.DEVNULL)
        os.close(theirs)
        said = wait_for_stage(process, ours, wanted, rng)
        asked = time.monotonic()
        process.send_signal(signal.SIGINT)
        said += drained(ours)
        process.wait(timeout=60)
        os.close(ours)
        if process.returncode == CANCELLED:
            self.waits.append(1000 * (time.monotonic() - asked))
        if process.returncode not in (0, CANCELLED, *REFUSED):
            raise Broken(f"status {process.returncode} after an interrupt: {said[-300:]}")
        left = [name for name in left_over(folder) if not name.endswith(".checkpoint")]
        if left and process.returncode != 0:
            raise Broken(f"cancelled, but left {left}")

    def figures(self, problems, seconds):
        kinds = ", ".join(f"{kind} {count}" for kind, count in sorted(self.refusals.items())) or "none"
        waits = sorted(self.waits)
        slow = f" (the slowest ended after {waits[-1]:.0f} ms, half of them after {waits[len(waits) // 2]:.0f})" \
            if waits else ""
        return (f"{self.done['run']} runs ({self.done['joins']} joins, {self.done['batches']} batches, "
                f"{self.done['regions']} regions, {self.maps} maps), {self.differing} differing bits, refusals: {kinds}; "
                f"{self.faults.kills} kills, {self.faults.full_disks} full disks, {self.faults.lost} lost files; "
                f"{len(waits)} cancels{slow}; {problems} broken promises; {seconds:.0f} s")


def wait_for_stage(process, terminal, wanted, rng):
    """Reads the bar until so many stages have begun and a while more, or the end. @return what was shown."""
    said, seen = "", []
    while process.poll() is None:
        said += drained(terminal, once=True)
        for stage in re.findall(r" %  ([^\r\x1b]*?)  ", said[-4000:]):
            if stage and stage not in seen:
                seen.append(stage)
        if len(seen) > wanted:
            time.sleep(rng.uniform(0, 0.3))
            break
    return said


def drained(terminal, once=False):
    """What a terminal shows, to its end or for now."""
    said = b""
    try:
        while block := os.read(terminal, 65536):
            said += block
            if once:
                break
    except OSError:  # nobody writes to it any more
        pass
    return said.decode(errors="replace")


def attempts(runner, options):
    """What is tried, in order: its kind, and whether there is enough of it."""
    yield "run", runner.run, lambda done: done >= options.runs
    yield "kill", runner.faults.kill, lambda done: runner.faults.kills >= options.kills
    yield "full", runner.faults.full, lambda done: done >= options.full
    yield "cancel", runner.cancel, lambda done: done >= options.cancels


def soak(options):
    runner, begun, problems = Soak(options), time.monotonic(), 0
    print(f"seed {options.seed}, {len(runner.methods)} methods", flush=True)
    for kind, attempt, enough in attempts(runner, options):
        number, until = 0, time.monotonic() + 60 * options.minutes
        while not enough(number) and problems < MOST_PROBLEMS and not (options.minutes and time.monotonic() > until):
            folder = pathlib.Path(tempfile.mkdtemp(prefix="texloom-soak-"))
            try:
                attempt(number, random.Random(f"{options.seed} {kind} {number}"), folder)
                shutil.rmtree(folder)
            except Exception as problem:  # whatever it was, its folder says what ran
                problems += 1
                print(f"seed {options.seed}, {kind} {number}, kept in {folder}: {problem}", flush=True)
            number += 1
            runner.done[kind] = number
    print(runner.figures(problems, time.monotonic() - begun))
    return problems == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    for name in ("doors", "fault", "saves"):
        parser.add_argument(f"--{name}", required=True)
    for name, count, what in (("runs", 33, "random recipes"), ("kills", 60, "deaths"), ("full", 7, "kinds of files"),
                              ("cancels", 33, "interrupts")):
        parser.add_argument(f"--{name}", type=int, default=count, help=f"{what}; {count} if not given")
    parser.add_argument("--minutes", type=float, default=0, help="for each kind; no limit if 0")
    parser.add_argument("--thorough", action="store_true", help="at every write, not at some")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--exemplar", action="append", default=[], type=lambda name: str(pathlib.Path(name).resolve()))
    sys.exit(0 if soak(parser.parse_args()) else 1)


main()
