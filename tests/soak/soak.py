#!/usr/bin/env python3
"""Runs random recipes, kills, full disks and cancels, and holds Texloom to its promises: the same bits with any number
of threads and again from the recipe, position maps that give the result where they say so, an end in one sentence,
nothing half-written and nothing lost.

    soak.py PROGRAM --doors PROGRAM --fault LIBRARY --saves PROGRAM [--runs N] [--kills N] [--full N] [--cancels N]
            [--thorough] [--seed S] [--minutes M] [--exemplar FILE]…

A failure names the seed and the number of what failed, and keeps its folder. Each kind is tried as often as is asked, or
until the minutes are over; one attempt at a kill goes through every moment at which it may come.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

LONGEST = 900  # seconds that a run may take
REFUSED = (1, 2)
CANCELLED = 130
OWN = ("exemplar.png", "mask.png", "call.json")
PREFIX = ".texloom-"  # of temporary files


class Broken(Exception):
    """A promise that was not kept."""


def call(program, arguments, folder, fault=None, preload=None):
    """Runs a program to its end. @return its exit status, negative where a signal ended it."""
    environment = dict(os.environ, OMP_WAIT_POLICY="passive")
    if fault:
        environment.update(TEXLOOM_FAULT=fault, LD_PRELOAD=preload)
    done = subprocess.run([program, *map(str, arguments)], cwd=folder, capture_output=True, timeout=LONGEST,
                          env=environment)
    killed = fault is not None and fault.startswith("kill") and done.returncode == -signal.SIGKILL
    if done.returncode not in (0, *REFUSED) and not killed:
        raise Broken(f"status {done.returncode}: {arguments}: {done.stderr[-500:]}")
    if done.returncode in REFUSED and done.stderr.count(b"\n") != 1:
        raise Broken(f"not one line: {arguments}: {done.stderr!r}")
    return done.returncode


def unfiltered(row, kind, above, step):
    """One row of a PNG without its filter (RFC 2083, section 6)."""
    row = bytearray(row)
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 4:
            distances = [(abs(up - corner), 0, left), (abs(left - corner), 1, up),
                         (abs(left + up - 2 * corner), 2, corner)]
            guess = min(distances)[2]
        else:
            guess = (0, left, up, (left + up) // 2)[kind]
        row[i] = (value + guess) & 255
    return bytes(row)


def pixels(path):
    """Size and samples of a PNG; raises where it is not whole."""
    data = path.read_bytes()
    at, stream, head = 8, b"", None
    while data[at + 4:at + 8] != b"IEND":
        length = struct.unpack(">I", data[at:at + 4])[0]
        name, content = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        if zlib.crc32(name + content) != struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]:
            raise Broken(f"{path.name} is damaged")
        head = content if name == b"IHDR" else head
        stream += content if name == b"IDAT" else b""
        at += 12 + length
    width, height, depth, color = struct.unpack(">IIBB", head[:10])
    step = {0: 1, 2: 3, 4: 2, 6: 4}[color] * depth // 8
    flat, rows, above = zlib.decompress(stream), [], bytes(width * step)
    for y in range(height):
        first = y * (width * step + 1)
        above = unfiltered(flat[first + 1:first + 1 + width * step], flat[first], above, step)
        rows.append(above)
    return width, height, depth, b"".join(rows)


def write_png(path, width, height, samples, channels=3):
    """A grey or RGB PNG of 8 bits."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    rows = b"".join(b"\0" + samples[y * width * channels:(y + 1) * width * channels] for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) +
                     chunk(b"IEND", b""))


def made_up(folder, rng):
    """A small exemplar (grain, or grain over stripes or bricks, perhaps with a flat part), and a mask of its size."""
    width, height = rng.randint(40, 80), rng.randint(40, 80)
    kind, period, flat = rng.randrange(3), rng.randint(6, 14), rng.random() < 0.2
    samples = bytearray()
    for y in range(height):
        for x in range(width):
            course = y // period
            mortar = kind == 2 and (y % period == 0 or (x + course % 2 * period) % (2 * period) == 0)
            light = 90 + 60 * (kind == 1 and x % period < period // 2) - 50 * mortar
            grain = 0 if flat and x < width // 3 else rng.randrange(50)
            samples += bytes(min(255, light + grain + tint) for tint in (20, 0, 10))
    write_png(folder / "exemplar.png", width, height, bytes(samples))
    left = rng.randrange(width - 32)
    mask = bytes(255 if left <= x or y > height // 2 else 0 for y in range(height) for x in range(width))
    write_png(folder / "mask.png", width, height, mask, 1)
    return "exemplar.png"


def value_for(parameter, rng):
    if parameter["type"] == "toggle":
        return rng.choice(["on", "off"])
    if parameter["type"] == "choice":
        return rng.choice(parameter["choices"])["id"]
    low, high = parameter.get("range", (0, 100))
    high = min(high, low + 24)  # what is larger takes long or is refused
    return rng.randint(int(low), int(high)) if parameter["type"] == "integer" else round(rng.uniform(low, high), 3)


def ports(method, which):
    return {port["id"]: port for port in method[which]}


def arguments_for(method, exemplar, own, rng):
    """A call of `synth` with random settings. @param own whether the exemplar was made up, and has a mask."""
    size = f"{rng.randint(20, 96)}x{rng.randint(20, 96)}"
    arguments = ["synth", method["id"], exemplar, "--size", size, "--seed", rng.randint(0, 1 << 40)]
    if ports(method, "gives")["image"]["wraps"] and rng.random() < 0.4:
        arguments += ["--wrap", rng.choice(["x", "y", "xy"])]
    for name, port in ports(method, "takes").items():
        if own and name == "mask" and rng.random() < 0.3:
            arguments += ["--mask", "mask.png"]
        elif name not in ("exemplar", "mask") and port["kind"] == "image" and port["extent"] != "output" and \
                port["least"] > 0:
            arguments += ["--input", f"{name}={exemplar}"]
    for parameter in method["parameters"]:
        long = "iterations" in parameter["name"] or parameter["name"] in ("rounds", "pause")
        if not long and parameter["type"] in ("toggle", "choice", "integer", "real") and rng.random() < 0.3:
            arguments += ["--set", f"{parameter['name']}={value_for(parameter, rng)}"]
    return arguments


def expect_alike(first, second, what):
    if pixels(first) != pixels(second):
        raise Broken(f"{what}: {first.name} and {second.name} differ")


def left_over(folder):
    return [entry.name for entry in folder.iterdir() if entry.name not in OWN]


class Soak:
    def __init__(self, options):
        self.program = str(pathlib.Path(options.program).resolve())
        self.doors = str(pathlib.Path(options.doors).resolve())
        self.fault = str(pathlib.Path(options.fault).resolve())
        self.saves = str(pathlib.Path(options.saves).resolve())
        self.exemplars = options.exemplar
        self.thorough = options.thorough
        listed = subprocess.run([self.program, "methods", "--json"], capture_output=True, check=True).stdout
        self.methods = [method for method in json.loads(listed) if "absent" not in method]
        self.refused = self.maps = self.moments = 0

    def prepared(self, folder, rng, method):
        exemplar = made_up(folder, rng)
        if self.exemplars and rng.random() < 0.5:
            exemplar = rng.choice(self.exemplars)
        arguments = arguments_for(method, exemplar, exemplar == "exemplar.png", rng)
        (folder / "call.json").write_text(json.dumps([str(word) for word in arguments]))
        return exemplar, arguments

    def run(self, number, rng, folder):
        """One recipe, with 1, 2 and 7 threads, again from its sidecar and from its image, and by its map."""
        method = self.methods[number % len(self.methods)]
        exemplar, arguments = self.prepared(folder, rng, method)
        has_map = "map" in ports(method, "gives")
        maps = ["--map", "map.exr"] if has_map else []
        first = [*arguments, "-o", "one.png", "--report", "report.json", "--threads", 1, "--quiet", *maps]
        if call(self.program, first, folder) != 0:
            self.refused += 1
            if left_over(folder):
                raise Broken(f"refused, but left {left_over(folder)}")
            return
        for threads in (2, 7):
            call(self.program, [*arguments, "-o", f"{threads}.png", "--threads", threads, "--quiet"], folder)
            expect_alike(folder / "one.png", folder / f"{threads}.png", "threads")
        for source in ("one.json", "one.png"):
            call(self.program, ["run", source, "-o", "again.png", "--quiet"], folder)
            expect_alike(folder / "one.png", folder / "again.png", f"recipe in {source}")
        if json.loads((folder / "report.json").read_text())["map"] == "exact":
            self.maps += 1
            call(self.program, ["apply", "map.exr", exemplar, "-o", "applied.png", "--quiet"], folder)
            expect_alike(folder / "one.png", folder / "applied.png", "map")

    def whole(self, folder):
        """Everything that is there can be read, and every image can be made again from the recipe in it."""
        for image in folder.glob("out*.png"):
            pixels(image)
            call(self.program, ["run", image.name, "-o", "remade.png", "--quiet", "--overwrite"], folder)
            expect_alike(image, folder / "remade.png", "recipe of a killed run")
            for name in ("remade.png", "remade.json"):
                (folder / name).unlink()
        for name in folder.glob("*.json"):
            json.loads(name.read_text())

    def moments_of(self, program, arguments, folder, call_name, check):
        """Kills the program before each of its calls of one kind in turn, until it comes through."""
        for moment in range(1, 1000):
            status = call(program, arguments, folder, f"kill:{call_name}:{moment}", self.fault)
            check()
            if status == 0:
                break
            self.moments += 1
        old = time.time() - 3600
        for left in folder.rglob(PREFIX + "*"):
            os.utime(left, (old, old))
        call(program, arguments, folder)
        if list(folder.glob(PREFIX + "*")):
            raise Broken("temporary files of killed runs are still there")

    def kill(self, number, rng, folder):
        """Dies at every rename and every fsync, over earlier files."""
        call_name = ("rename", "fsync")[number // 3 % 2]
        if number % 3 == 0:
            made_up(folder, rng)
            arguments = ["synth", "quilting", "exemplar.png", "--size", 96, "--set", "patch=16", "-o", "out.png",
                         "--map", "map.png", "--report", "report.json", "--quiet"]
            call(self.program, arguments, folder)
            self.moments_of(self.program, [*arguments, "--seed", 7], folder, call_name, lambda: self.whole(folder))
        elif number % 3 == 1:
            self.kill_between_checkpoints(rng, folder, call_name)
        else:
            def check():
                call(self.saves, ["check", folder], folder)
            call(self.saves, ["save", folder, 1], folder)
            self.moments_of(self.saves, ["save", folder, 2], folder, call_name, check)

    def kill_between_checkpoints(self, rng, folder, call_name):
        made_up(folder, rng)
        arguments = ["synth", "slow-diffusion", "exemplar.png", "--size", 64, "--set", "rounds=5", "--quiet"]
        call(self.doors, [*arguments, "-o", "whole.png"], folder)
        for moment in range(1, 1000):
            killed = call(self.doors, [*arguments, "-o", "out.png", "--overwrite"], folder,
                          f"kill:{call_name}:{moment}", self.fault)
            if killed == 0:
                return
            self.moments += 1
            call(self.doors, [*arguments, "-o", "out.png", "--overwrite", "--resume"], folder)
            expect_alike(folder / "whole.png", folder / "out.png", f"gone on after a kill at {call_name} {moment}")
            if (folder / "out.png.checkpoint").exists():
                raise Broken("the checkpoint of a run that came to its end is still there")
            (folder / "out.png").unlink()

    def full(self, number, rng, folder):
        """The disk is full from every write on, over earlier files, which must stay as they were."""
        made_up(folder, rng)
        ending = ("png", "tif", "exr", "jpg", "hdr")[number % 5]
        arguments = ["synth", "quilting", "exemplar.png", "--size", 64, "--set", "patch=16", "-o", f"out.{ending}",
                     "--map", "map.exr", "--report", "report.json", "--quiet"]
        call(self.program, arguments, folder)
        for kind in ("pwrite", "fsync", "rename"):
            moment = 0
            while True:
                moment += 1 if self.thorough else 1 + moment // 2
                before = {entry.name: entry.read_bytes() for entry in folder.iterdir()}
                status = call(self.program, [*arguments, "--seed", moment], folder, f"full:{kind}:{moment}", self.fault)
                if status == 0:
                    break
                self.moments += 1
                for entry in folder.iterdir():
                    if entry.name.startswith(PREFIX):
                        raise Broken(f"{entry.name} was left by a run that found the disk full")
                    if entry.name not in before:
                        raise Broken(f"{entry.name} is new after a run that found the disk full")
                for name in before:
                    if not (folder / name).exists() or (folder / name).stat().st_size == 0:
                        raise Broken(f"{name} is lost")

    def cancel(self, number, rng, folder):
        """An interrupt somewhere in a run of each method in turn; it ends soon, says so, and leaves nothing."""
        method = self.methods[number % len(self.methods)]
        exemplar, arguments = self.prepared(folder, rng, method)
        arguments[arguments.index("--size") + 1] = "512"
        process = subprocess.Popen([self.program, *map(str, arguments), "-o", "one.png", "--quiet"], cwd=folder,
                                   stderr=subprocess.PIPE)
        while process.poll() is None and not listens(process.pid):
            time.sleep(0.02)
        time.sleep(rng.uniform(0, 4))
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        if process.returncode in (0, *REFUSED):
            return
        if process.returncode != CANCELLED:
            raise Broken(f"status {process.returncode} after an interrupt: {said[-300:]}")
        left = [name for name in left_over(folder) if not name.endswith(".checkpoint")]
        if left:
            raise Broken(f"cancelled, but left {left}")


def listens(process):
    """Whether a process has a handler for interrupts by now."""
    try:
        status = pathlib.Path(f"/proc/{process}/status").read_text()
    except OSError:
        return False
    caught = next(line for line in status.splitlines() if line.startswith("SigCgt:"))
    return int(caught.split()[1], 16) >> (signal.SIGINT - 1) & 1


def soak(options):
    runner = Soak(options)
    print(f"seed {options.seed}, {len(runner.methods)} methods", flush=True)
    for kind, count, attempt in (("run", options.runs, runner.run), ("kill", options.kills, runner.kill),
                                 ("full", options.full, runner.full), ("cancel", options.cancels, runner.cancel)):
        runner.moments, done, until = 0, 0, time.monotonic() + 60 * options.minutes
        for number in range(count):
            if options.minutes and time.monotonic() > until:
                break
            folder = pathlib.Path(tempfile.mkdtemp(prefix="texloom-soak-"))
            try:
                attempt(number, random.Random(f"{options.seed} {kind} {number}"), folder)
            except Exception as problem:  # whatever it was, its folder says what ran
                sys.exit(f"seed {options.seed}, {kind} {number}, kept in {folder}: {problem}")
            shutil.rmtree(folder)
            done += 1
        more = f", {runner.moments} moments" if runner.moments else ""
        more += f", {runner.refused} refused in a sentence, {runner.maps} maps compared" if kind == "run" else ""
        print(f"{kind}: {done}{more}", flush=True)
    print("nothing lost, nothing differs")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    for name in ("doors", "fault", "saves"):
        parser.add_argument(f"--{name}", required=True)
    for name, count in (("runs", 25), ("kills", 6), ("full", 5), ("cancels", 25)):
        parser.add_argument(f"--{name}", type=int, default=count)
    parser.add_argument("--minutes", type=float, default=0, help="for each kind; no limit if 0")
    parser.add_argument("--thorough", action="store_true", help="a full disk at every write, not at some")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--exemplar", action="append", default=[], type=lambda name: str(pathlib.Path(name).resolve()))
    soak(parser.parse_args())


main()
