"""PNG files of 8 and 16 bits, read and written with nothing but what comes with Python, and made-up exemplars."""
import struct
import zlib


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


class Pixels:
    """Size and samples of a PNG; raises ValueError where it is not whole."""

    def __init__(self, path):
        data = path.read_bytes()
        at, stream, head = 8, b"", b""
        while data[at + 4:at + 8] != b"IEND":
            length, = struct.unpack(">I", data[at:at + 4])
            name, content = data[at + 4:at + 8], data[at + 8:at + 8 + length]
            if zlib.crc32(name + content) != struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]:
                raise ValueError(f"{path.name} is damaged")
            head = content if name == b"IHDR" else head
            stream += content if name == b"IDAT" else b""
            at += 12 + length
        self.width, self.height, self.depth, color = struct.unpack(">IIBB", head[:10])
        self.step = {0: 1, 2: 3, 4: 2, 6: 4}[color] * self.depth // 8  # bytes of a pixel
        flat, self.rows, above = zlib.decompress(stream), [], bytes(self.width * self.step)
        for y in range(self.height):
            first = y * (self.width * self.step + 1)
            above = unfiltered(flat[first + 1:first + 1 + self.width * self.step], flat[first], above, self.step)
            self.rows.append(above)

    def part(self, x, y, width, height):
        """The rows of a box."""
        return [row[x * self.step:(x + width) * self.step] for row in self.rows[y:y + height]]

    def differing_bits(self, other):
        """How many bits of the samples are not alike; all of them where the kinds of picture differ."""
        mine, its = b"".join(self.rows), b"".join(other.rows)
        if (self.width, self.depth, len(mine)) != (other.width, other.depth, len(its)):
            return 8 * max(len(mine), len(its))
        return bin(int.from_bytes(mine, "big") ^ int.from_bytes(its, "big")).count("1")


def write_png(path, width, height, samples, channels=3):
    """A grey or RGB PNG of 8 bits."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    rows = b"".join(b"\0" + samples[y * width * channels:(y + 1) * width * channels] for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) +
                     chunk(b"IEND", b""))


def grain(path, width, height, rng):
    """Grain, or grain over stripes or bricks, perhaps with a flat part."""
    kind, period, flat = rng.randrange(3), rng.randint(6, 14), rng.random() < 0.2
    samples = bytearray()
    for y in range(height):
        for x in range(width):
            course = y // period
            mortar = kind == 2 and (y % period == 0 or (x + course % 2 * period) % (2 * period) == 0)
            light = 90 + 60 * (kind == 1 and x % period < period // 2) - 50 * mortar
            noise = 0 if flat and x < width // 3 else rng.randrange(50)
            samples += bytes(min(255, light + noise + tint) for tint in (20, 0, 10))
    write_png(path, width, height, bytes(samples))


def made_up(folder, rng):
    """A small exemplar and another one, perhaps of another size, and a mask of each."""
    width, height = rng.randint(40, 80), rng.randint(40, 80)
    grain(folder / "exemplar.png", width, height, rng)
    other = (width, height) if rng.random() < 0.7 else (rng.randint(40, 80), rng.randint(40, 80))
    grain(folder / "second.png", *other, rng)
    left, top = rng.randrange(width - 32), rng.randrange(8, 24)
    for name, (across, down) in (("mask.png", (width, height)), ("region.png", other)):
        mask = bytes(255 if left <= x or y > down // 2 else 0 for y in range(down) for x in range(across))
        if name == "region.png":
            mask = bytes(255 if 8 <= x < across - 8 and top <= y < down - 8 else 0
                         for y in range(down) for x in range(across))
        write_png(folder / name, across, down, mask, 1)
    return "exemplar.png"
