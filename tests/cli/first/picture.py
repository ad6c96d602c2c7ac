#!/usr/bin/env python3
# picture.py PNG STDOUT STDERR [mirrors] [tall]: fails unless the picture is worth looking at: at most 95 % black, and,
# if asked for, with reflective pixels, and with a thing that covers a quarter of the height.
import re
import struct
import sys
import zlib

SKY = (124, 149, 188)


def rows_of(path):
    data, at, packed = open(path, "rb").read(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
    assert depth == 8 and colour == 2
    raw, stride, last, rows = zlib.decompress(packed), 3 * width, bytearray(3 * width), []
    for y in range(height):
        how, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = line[i - 3] if i >= 3 else 0, last[i], last[i - 3] if i >= 3 else 0
            p = a + b - c
            near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = line[i] + (0, a, b, (a + b) // 2, near)[how] & 255
        rows.append(line)
        last = line
    return rows


rows, asked = rows_of(sys.argv[1]), sys.argv[4:]
pixels = [[tuple(r[i:i + 3]) for i in range(0, len(r), 3)] for r in rows]
black = sum(max(p) <= 8 for row in pixels for p in row) / sum(map(len, pixels))
assert black <= 0.95, f"{black:.3f} black"
assert "of the picture is black" not in open(sys.argv[3]).read()
if "mirrors" in asked:
    n = int(re.search(r"reflective pixels in sight +([\d,]+)", open(sys.argv[2]).read()).group(1).replace(",", ""))
    assert n > 0, "no reflective pixel"
elif "tall" in asked:
    seen = [y for y, row in enumerate(pixels) if any(max(abs(a - b) for a, b in zip(p, SKY)) > 2 for p in row)]
    assert seen and seen[-1] - seen[0] + 1 >= len(rows) / 4, "the thing is small"
    print(f"# height {100 * (seen[-1] - seen[0] + 1) // len(rows)} %")
