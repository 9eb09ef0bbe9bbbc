"""Deaths and full disks at chosen moments, and what must be true after them."""
import json
import os
import time

from pictures import Pixels, made_up

PREFIX = ".texloom-"  # of temporary files

# Moments by name: which of the things that are written (see Faults.writers), the call before which the process dies, and
# the ending of the file's name. The calls of all kinds are gone through in turn besides.
NAMED = [
    ("inside a picture", "result", "pwrite", ".png"),
    ("between the picture's bytes and its name", "result", "rename", "out.png"),
    ("between the picture and its sidecar", "result", "rename", "out.json"),
    ("inside the sidecar", "result", "pwrite", ".json"),
    ("between the sidecar and the report", "result", "rename", "report.json"),
    ("inside a checkpoint", "checkpoint", "pwrite", ".checkpoint"),
    ("between a checkpoint's bytes and its name", "checkpoint", "rename", ".checkpoint"),
    ("between the last checkpoint and the picture", "checkpoint", "rename", "out.png"),
    ("inside a session", "session", "pwrite", ".texloom"),
    ("between a session's bytes and its name", "session", "rename", "recovery.texloom"),
    ("inside the copy of a session's picture", "session", "pwrite", ".png"),
    ("between the pictures of a session and itself", "session", "rename", "work.texloom"),
]
CALLS = ("rename", "fsync", "pwrite")


class Faults:
    """Runs programs that die or find the disk full. Counts the deaths, and files that were lost or half-written."""

    def __init__(self, soak, thorough):
        self.soak = soak
        self.thorough = thorough
        self.writers = {"result": self.result, "session": self.session, "checkpoint": self.checkpoint}
        self.kills = self.full_disks = self.lost = 0

    # What is written: each prepares a folder with earlier files and returns the program, its arguments for another seed,
    # and what checks the folder.

    def result(self, folder, rng, ending="png"):
        made_up(folder, rng)
        words = ["synth", "quilting", "exemplar.png", "--size", 64, "--set", "patch=16", "-o", f"out.{ending}", "--map",
                 "map.png", "--report", "report.json", "--quiet"]
        self.soak.call(self.soak.program, words, folder)
        return self.soak.program, [*words, "--seed", 7], self.whole

    def session(self, folder, rng):
        self.soak.call(self.soak.saves, ["save", folder, 1], folder)
        return self.soak.saves, ["save", folder, 2], lambda where: self.soak.call(self.soak.saves, ["check", where], where)

    def checkpoint(self, folder, rng):
        made_up(folder, rng)
        words = ["synth", "slow-diffusion", "exemplar.png", "--size", 48, "--set", "rounds=4", "--quiet", "--overwrite"]
        self.soak.call(self.soak.doors, [*words, "-o", "whole.png"], folder)
        return self.soak.doors, [*words, "-o", "out.png"], lambda where: self.goes_on(where, words)

    def goes_on(self, folder, words):
        """What was broken off is taken up, and comes to the same bits."""
        self.soak.call(self.soak.doors, [*words, "-o", "out.png", "--resume"], folder)
        self.soak.expect_alike(folder / "whole.png", folder / "out.png", "gone on after a kill")
        self.expect((folder / "out.png.checkpoint").exists() is False, "the checkpoint of a finished run is still there")
        (folder / "out.png").unlink()

    def whole(self, folder):
        """Everything that is there can be read, and every picture can be made again from the recipe in it."""
        for image in folder.glob("out*.png"):
            self.soak.call(self.soak.program, ["run", image.name, "-o", "remade.png", "--quiet", "--overwrite"], folder)
            self.soak.expect_alike(image, folder / "remade.png", "recipe of a killed run")
            for name in ("remade.png", "remade.json"):
                (folder / name).unlink()
        for name in folder.glob("[!.]*.png"):
            Pixels(name)
        for name in folder.glob("[!.]*.json"):
            json.loads(name.read_text())

    def expect(self, kept, what):
        if not kept:
            self.lost += 1
            raise self.soak.Broken(what)

    def dies(self, program, words, folder, fault, check):
        """@return whether the moment came."""
        status = self.soak.call(program, words, folder, fault)
        if status != 0:
            self.kills += 1
        before = self.lost
        try:
            check(folder)
        except Exception:
            self.lost = max(self.lost, before + 1)
            raise
        return status != 0

    def kill(self, number, rng, folder):
        """Dies at one of the named moments, or at every call of one kind in turn, over earlier files."""
        kind = number % (len(NAMED) + len(CALLS) * len(self.writers))
        if kind < len(NAMED):
            name, writer, call, ending = NAMED[kind]
            program, words, check = self.writers[writer](folder, rng)
            if not self.dies(program, words, folder, f"kill:{call}:1:{ending}", check):
                raise self.soak.Broken(f"the moment never came: {name}")
        else:
            call = CALLS[kind % len(CALLS)]
            program, words, check = self.writers[list(self.writers)[(kind - len(NAMED)) // len(CALLS)]](folder, rng)
            moment = 1
            while moment < 1000 and self.dies(program, words, folder, f"kill:{call}:{moment}", check):
                moment += 1 if self.thorough else 1 + moment // 4
        self.sweeps(program, words, folder)

    def sweeps(self, program, words, folder):
        """The next run of the same folder removes what killed ones left."""
        old = time.time() - 3600
        for left in folder.rglob(PREFIX + "*"):
            os.utime(left, (old, old))
        self.soak.call(program, words, folder)
        if list(folder.glob(PREFIX + "*")):
            raise self.soak.Broken("temporary files of killed runs are still there")

    def full(self, number, rng, folder):
        """The disk is full from every write on, over earlier files, which must stay as they were or be new and whole."""
        kinds = ["png", "tif", "exr", "jpg", "hdr", "session", "checkpoint"]
        kind = kinds[number % len(kinds)]
        if kind in self.writers:
            program, words, check = self.writers[kind](folder, rng)
        else:
            program, words, check = self.result(folder, rng, kind)
        for call in CALLS:
            moment = 0
            while True:
                moment += 1 if self.thorough else 1 + moment // 2
                before = {entry.name: entry.stat().st_size for entry in folder.rglob("*") if entry.is_file()}
                # An earlier checkpoint that is replaced is told of, too.
                status = self.soak.call(program, words, folder, f"full:{call}:{moment}", lines=2 if kind == "checkpoint" else 1)
                if status == 0:
                    break
                self.full_disks += 1
                self.left_in_order(folder, before, kind)
                if kind != "checkpoint":
                    check(folder)
            if kind == "checkpoint" and (folder / "out.png").exists():
                check(folder)

    def left_in_order(self, folder, before, kind):
        now = {entry.name: entry.stat().st_size for entry in folder.rglob("*") if entry.is_file()}
        for name in now:
            self.expect(not name.startswith(PREFIX), f"{name} was left by a run that found the disk full")
            self.expect(name in before or kind in self.writers, f"{name} is new after a run that found the disk full")
        for name, size in before.items():
            self.expect(now.get(name, 0) > 0 or size == 0, f"{name} is lost")
