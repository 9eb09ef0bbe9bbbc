#!/usr/bin/env python3
"""Decodes public suites of picture files with texloom-cli and with reference decoders, and compares.

    suites.py PROGRAM [--suites FOLDER] [--memory MiB] [--seconds S] [--only TEXT] [--all]

FOLDER (TEXLOOM_SUITES, or ~/texloom-suites) is where the suites were unpacked, each in a folder of its own: PngSuite,
openexr-images, OpenImageIO-images, exif-orientation-examples, libtiff's pictures, or any others. Every file in it is
decoded: `apply` of a map that takes each pixel from its own place. The picture must be that of a reference (oiiotool, and
GraphicsMagick or ImageMagick where there is one) within 2/255, upright and over the file's data window, or the file must be
refused in one sentence. Either way within the time and the memory given. Not part of ctest: the suites are other people's,
and large. Skipped, with the reason, where the folder or oiiotool is missing.
"""
import argparse
import array
import collections
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import zlib

SKIPPED = 77
CLOSE = 2 / 255
PATIENCE = 10  # how much longer than its processor time a file may take by the clock
# The formats that Texloom reads, by their first bytes; of all others it must only say that it does not.
SIGNATURES = {b"\x89PNG\r\n\x1a\n": "png", b"\xff\xd8\xff": "jpeg", b"II*\0": "tiff", b"MM\0*": "tiff", b"II+\0": "tiff",
              b"\x76\x2f\x31\x01": "openexr", b"#?RADIANCE": "hdr", b"#?RGBE": "hdr"}


def format_of(path):
    with path.open("rb") as file:
        head = file.read(16)
    return next((name for start, name in SIGNATURES.items() if head.startswith(start)), None)


class Peak(threading.Thread):
    """The most memory that a process and its children were seen to hold together, pages that they share counted once."""

    def __init__(self, process):
        super().__init__(daemon=True)
        self.process = process
        self.bytes = 0

    def run(self):
        while self.process.poll() is None:
            self.bytes = max(self.bytes, sum(held(one) for one in family(self.process.pid)))
            time.sleep(0.02)


def family(first):
    """A process, its children and theirs."""
    found = [first]
    for one in found:
        try:
            for task in os.listdir(f"/proc/{one}/task"):
                found += map(int, pathlib.Path(f"/proc/{one}/task/{task}/children").read_text().split())
        except OSError:
            pass
    return found


def held(process):
    try:
        text = pathlib.Path(f"/proc/{process}/smaps_rollup").read_text()
    except OSError:
        return 0
    return 1024 * int(re.search(r"^Pss: +(\d+)", text, re.MULTILINE).group(1)) if "Pss:" in text else 0


def worked(process):
    """Seconds of processor time that a process and its children have taken."""
    ticks = 0
    for one in family(process):
        try:
            ticks += sum(map(int, pathlib.Path(f"/proc/{one}/stat").read_text().rpartition(")")[2].split()[11:13]))
        except OSError:
            pass
    return ticks / os.sysconf("SC_CLK_TCK")


class Ended:
    def __init__(self, words, seconds, folder):
        begun = time.monotonic()
        process = subprocess.Popen([str(word) for word in words], cwd=folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        peak = Peak(process)
        peak.start()
        self.late, out = False, None
        while out is None:
            try:
                out, err = process.communicate(timeout=1)
            except subprocess.TimeoutExpired:
                # Time by the clock says nothing where others have the processor, unless it is much.
                if worked(process.pid) > seconds or time.monotonic() - begun > PATIENCE * seconds:
                    self.late = True
                    process.send_signal(signal.SIGKILL)
        peak.join()
        self.status, self.peak, self.seconds = process.returncode, peak.bytes, time.monotonic() - begun
        self.out, self.err = out.decode(errors="replace"), err.decode(errors="replace")


def identity(path, width, height):
    """A position map (16-bit PNG) by which each pixel comes from its own place."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    packed, rows = zlib.compressobj(1), []
    row = array.array("H", bytes(6 * width))
    row[0::3] = array.array("H", range(width))
    for y in range(height):
        row[1::3] = array.array("H", [y]) * width
        ordered = array.array("H", row)
        ordered.byteswap()
        rows.append(packed.compress(b"\0" + ordered.tobytes()))
    head = struct.pack(">IIBBBBB", width, height, 16, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", b"".join(rows) + packed.flush()) +
                     chunk(b"IEND", b""))


def channels_of(path):
    """Of a PNG, or of a TIFF as oiiotool and Texloom write it."""
    data = path.read_bytes()
    if data[:4] == b"\x89PNG":
        return {0: 1, 2: 3, 3: 3, 4: 2, 6: 4}[data[25]]
    return tags_of(data).get(277, 1)


def holds_floats(path):
    """Whether a TIFF's samples are floats, which know no bounds."""
    return tags_of(path.read_bytes()).get(339, 1) == 3


def tags_of(data):
    """The first directory of a TIFF: of each tag the first of its short numbers, as far as they are few."""
    at, = struct.unpack_from("<I", data, 4)
    tags = {}
    for entry in range(struct.unpack_from("<H", data, at)[0]):
        tag, kind, count, value = struct.unpack_from("<HHII", data, at + 2 + 12 * entry)
        if kind == 3:
            tags[tag] = value & 0xffff if count <= 2 else struct.unpack_from("<H", data, value)[0]
    return tags


class Suites:
    def __init__(self, options, folder):
        self.options = options
        self.program = pathlib.Path(options.program).resolve()
        self.folder = folder
        self.magick = next((words for words in (["gm", "convert"], ["magick"]) if shutil.which(words[0])), None)
        self.counts = collections.Counter()
        self.faults = []
        self.most = 0

    def fault(self, path, what):
        self.faults.append(f"{path}: {what}")
        print(self.faults[-1], flush=True)

    def oiiotool(self, *words):
        try:
            return subprocess.run(["oiiotool", *map(str, words)], cwd=self.folder, capture_output=True, timeout=900,
                                  text=True, errors="replace")
        except subprocess.TimeoutExpired:  # then it is no reference for this file
            return subprocess.CompletedProcess(words, 1, "", "")

    def texloom(self, path, width, height):
        """Decodes a file. @return how it ended."""
        identity(self.folder / "map.png", width, height)
        return Ended([self.program, "apply", "map.png", path, "-o", self.folder / "ours.tif", "--overwrite", "--quiet",
                      "--memory", self.options.memory], self.options.seconds, self.folder)

    def reference(self, path):
        """What oiiotool makes of a file, upright and with its corner at 0. @return its size, or None."""
        done = self.oiiotool("--autoorient", path, "--origin", "+0+0", "--fullpixels", "-d", "float", "--compression", "none",
                             "-o", self.folder / "oiio.tif", "--echo", "{TOP.width} {TOP.height}")
        said = re.search(r"^(\d+) (\d+)$", done.stdout, re.MULTILINE)
        return (int(said[1]), int(said[2])) if done.returncode == 0 and said else None

    def second(self, path):
        """What the other reference makes of it, where there is one."""
        if self.magick:
            subprocess.run([*self.magick, f"{path}[0]", "-auto-orient", "magick.png"], cwd=self.folder, capture_output=True,
                           timeout=300)

    def errors(self):
        """By how much our picture differs at most from each reference, of the channels that both have."""
        known, words, mine = {}, [], channels_of(self.folder / "ours.tif")
        names = [name for name in ("oiio.tif", "magick.png") if (self.folder / name).exists()]
        for name in names:
            theirs = channels_of(self.folder / name)
            if mine != theirs and (2 in (mine, theirs) or max(mine, theirs) > 4):
                continue
            few = ["--ch", ",".join(map(str, range(min(mine, theirs))))] if mine != theirs else []
            bounds = [] if holds_floats(self.folder / "ours.tif") else ["--clamp:min=0:max=1"]
            words += ["ours.tif", *few, name, *few, *bounds, "--diff"]
            known[name] = float("inf")
        if not words:
            return {}
        said = self.oiiotool("--fail", CLOSE, "--failpercent", 0, *words).stdout
        for name, block in zip(known, said.split("Computing diff of")[1:]):
            found = re.search(r"Max error += ([\d.e+-]+|inf|nan)", block)
            known[name] = float(found[1]) if found else 0.0 if "PASS" in block else float("inf")
        return known

    def check(self, path):
        kind = format_of(path)
        for name in ("ours.tif", "ours.json", "oiio.tif", "magick.png"):
            (self.folder / name).unlink(missing_ok=True)
        size = self.reference(path) if kind else None
        width, height = size or (16, 16)
        if max(width, height) > 65535 or width * height > 40_000_000:
            self.counts["not tried: too large for a map"] += 1
            return
        ended = self.texloom(path, width, height)
        self.most = max(self.most, ended.peak)
        if ended.late:
            return self.fault(path, f"still at work after {ended.seconds:.0f} s")
        if ended.peak > self.options.memory << 20:
            self.fault(path, f"took {ended.peak >> 20} MiB, more than the {self.options.memory} allowed")
        if ended.status not in (0, 1, 2):
            return self.fault(path, f"ended with status {ended.status}: {ended.err[-300:]}")
        if ended.status != 0:
            return self.refused(path, kind, size, ended)
        if kind is None:
            return self.fault(path, "read, though it is of no format that is read")
        self.compare(path)

    def refused(self, path, kind, size, ended):
        if ended.err.count("\n") != 1:
            return self.fault(path, f"not one sentence: {ended.err!r}")
        if kind is None:
            self.counts["of other formats, refused"] += 1
            return
        self.counts["refused though oiiotool reads it" if size else "refused as by the reference"] += 1
        if size or self.options.all:
            print(f"refused: {path.name}: {ended.err.strip()[-240:]}", flush=True)

    def compare(self, path):
        self.second(path)
        errors = self.errors()
        told = ", ".join(f"{name} {error:.4f}" for name, error in errors.items())
        if not errors:
            self.counts["read, without a reference to compare with"] += 1
            print(f"no reference: {path}", flush=True)
        elif min(errors.values()) <= CLOSE:
            self.counts["like a reference"] += 1
            if max(errors.values()) > CLOSE:
                self.counts["of which the references differ"] += 1
                print(f"references differ: {path.name}: {told}", flush=True)
        elif not self.explained(path):
            self.fault(path, f"differs from {told}")

    def explained(self, path):
        """Whether a picture that differs does so as is said: whole numbers of 32 bits are scaled, and colours that the
        file's tags describe are converted, so that only the values in the file can be compared."""
        info = self.oiiotool("--info", "-v", path).stdout
        if re.search(r"channels?, u?int ", info):
            self.counts["whole numbers of 32 bits, which are scaled by what they span"] += 1
            return True
        if not re.search(r"ICCProfile|chromaticities|Gamma|gAMA", info + path.read_bytes()[:4096].decode("latin1")):
            return False
        data = self.folder / f"file_height{path.suffix}"
        data.unlink(missing_ok=True)
        data.symlink_to(path)
        ended = Ended([self.program, "apply", "map.png", data, "-o", self.folder / "ours.tif", "--overwrite", "--quiet"],
                      self.options.seconds, self.folder)
        straight = ["--iconfig", "oiio:UnassociatedAlpha", "1"]
        said = self.oiiotool("--autoorient", *straight, path, "--origin", "+0+0", "--fullpixels", "-d", "float",
                             *straight, "ours.tif", "--fail", CLOSE, "--failpercent", 0, "--diff")
        same = ended.status == 0 and "PASS" in said.stdout
        self.counts["with colours of their own, the same values as the reference"] += same
        return same


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--suites", default=os.environ.get("TEXLOOM_SUITES", "~/texloom-suites"))
    parser.add_argument("--memory", type=int, default=1024, help="MiB that each may take")
    parser.add_argument("--seconds", type=float, default=120, help="of processor time that each may take")
    parser.add_argument("--only", default="", help="only files whose path holds this")
    parser.add_argument("--all", action="store_true", help="print every refusal")
    options = parser.parse_args()
    suites = pathlib.Path(options.suites).expanduser().resolve()
    if not suites.is_dir():
        skip(f"there is no folder {suites}; unpack the suites there, or name it with --suites")
    if not shutil.which("oiiotool"):
        skip("oiiotool is missing: apt-get install openimageio-tools")
    files = sorted(path for path in suites.rglob("*") if path.is_file() and options.only in str(path))
    if not files:
        skip(f"{suites} holds no files")
    with tempfile.TemporaryDirectory(prefix="texloom-suites-") as folder:
        run = Suites(options, pathlib.Path(folder))
        for path in files:
            run.check(path)
        counts = ", ".join(f"{count} {what}" for what, count in sorted(run.counts.items()))
        print(f"{len(files)} files: {counts}; {len(run.faults)} faults; at most {run.most >> 20} MiB")
        sys.exit(1 if run.faults else 0)


if __name__ == "__main__":
    main()
