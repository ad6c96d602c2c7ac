#!/bin/bash
# What `compare -o DIR` draws of cubes: each texel that a port has wrong is white, in its place on its face,
# and no other.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2

cat > pictures.py <<'PY'
import ast, glob, struct, zlib

def opened(folder, name):
	path, = glob.glob(f"{folder}/*-{name}.npy")
	data = bytearray(open(path, "rb").read())
	return path, data, 10 + data[8] + 256 * data[9]

def faces(folder):
	"""(first texel, texels a side) of each cube, by the names of the record's fields."""
	path, data, at = opened(folder, "cube_size.face")
	place, size = {}, 0
	for name, kind, *shape in ast.literal_eval(data[10:at].decode())["descr"]:
		place[name] = int(kind[2:]), size
		size += int(kind[2:]) * (shape[0][0] if shape else 1)
	def value(row, name):
		width, offset = place[name]
		return int.from_bytes(data[row + offset:row + offset + width], "little")
	return [(value(row, "offset"), value(row, "n")) for row in range(at, len(data), size)]

def spoil(folder, name, size, elements):
	path, data, at = opened(folder, name)
	for element in elements:
		data[at + size * element] ^= 1
	open(path, "wb").write(data)

def rows_of(path):
	"""Rows of a grey PNG of 8 bits."""
	data, at, packed = open(path, "rb").read(), 8, b""
	while at < len(data):
		size, kind = struct.unpack_from(">I4s", data, at)
		if kind == b"IHDR":
			width, height, depth, colour = struct.unpack_from(">IIBB", data, at + 8)
		if kind == b"IDAT":
			packed += data[at + 8:at + 8 + size]
		at += 12 + size
	assert depth == 8 and colour == 0
	raw, last, rows = zlib.decompress(packed), bytearray(width), []
	for y in range(height):
		how, line = raw[y * (width + 1)], bytearray(raw[y * (width + 1) + 1:(y + 1) * (width + 1)])
		for i in range(width):
			a, b, c = line[i - 1] if i else 0, last[i], last[i - 1] if i else 0
			near = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
			line[i] = line[i] + (0, a, b, (a + b) // 2, near)[how] & 255
		rows.append(line)
		last = line
	return rows

def white(path):
	rows = rows_of(path)
	assert {v for row in rows for v in row} <= {0, 255}
	return (len(rows[0]), len(rows)), {(x, y) for y, row in enumerate(rows) for x, v in enumerate(row) if v}
PY

run "${frame[@]}" --method epr,mvr --self-contained --margins -o r
verdict "$status" 'two traces'

# Texels of two cubes of EPR, in corners and within.
cp -r r/trace-epr c
python3 - <<'PY'
from pictures import *
cubes = faces("c")
wanted = {1: [(0, 0, 0), (3, -1, 2), (5, -1, -1)], 3: [(2, 1, -2)]}
for cube, texels in wanted.items():
	first, n = cubes[cube]
	assert n > 4
	wanted[cube] = n, [(f, x % n, y % n) for f, x, y in texels]
	spoil("c", "splat.depth_index", 8, [first + (f * n + y) * n + x for f, x, y in wanted[cube][1]])
open("wanted", "w").write(repr(wanted))
PY
run compare r/trace-epr c -o drawn
[ "$status" -eq 1 ] && [ "$(ls drawn)" = $'report.json\nsplat.depth_index-cube-1.png\nsplat.depth_index-cube-3.png' ]
verdict $? 'a picture of each cube that differs'
python3 - <<'PY'
from pictures import *
for cube, (n, texels) in ast.literal_eval(open("wanted").read()).items():
	size, spots = white(f"drawn/splat.depth_index-cube-{cube}.png")
	assert size == (6 * n, n) and spots == {(f * n + x, y) for f, x, y in texels}, (cube, size, spots)
PY
verdict $? 'whose six faces stand side by side, white where they differ'

# Levels of a mip map, of four values a texel; and two margins a texel.
cp -r r/trace-mvr m
python3 - <<'PY'
from pictures import *
(first, n), (third, _) = faces("m")[::2]
assert n == 64 and third == 2 * 6 * n * n
sizes = [6 * (n >> level) ** 2 for level in range(7)]
cube = 2 * sum(sizes)
spoil("m", "cube_face.mip",
      4, [4 * cube + 1, 4 * (cube + sizes[0] + (4 * 32 + 7) * 32 + 5) + 3, 4 * (cube + sum(sizes[:6]) + 5)])
spoil("m", "cube_face.margin", 8, [2 * ((n + 9) * n + 4) + 1])
PY
run compare r/trace-mvr m -o mips
[ "$status" -eq 1 ] && python3 - <<'PY'
from pictures import *
assert white("mips/cube_face.mip-cube-2.png") == ((384, 127), {(0, 0), (4 * 32 + 5, 64 + 7), (5, 126)})
assert white("mips/cube_face.margin-cube-0.png") == ((384, 64), {(64 + 4, 9)})
PY
verdict $? 'levels one below the other'
[ "$(ls mips | wc -l)" -eq 3 ]
verdict $? 'and no other picture'

# Points in the order of their arrival: texels that name the same points by other indices are right.
cp -r r/trace-epr a
python3 - <<'PY'
from pictures import *
def reverse(name, size):
	path, data, at = opened("a", name)
	rows = [data[i:i + size] for i in range(at, len(data), size)]
	open(path, "wb").write(data[:at] + b"".join(reversed(rows)))
	return len(rows)
n = reverse("points.key", 8)
reverse("points.record", 32)
path, data, at = opened("a", "splat.depth_index")
for i in range(at, len(data), 8):
	if data[i:i + 8] != b"\xff" * 8:
		data[i:i + 4] = (n - 1 - int.from_bytes(data[i:i + 4], "little")).to_bytes(4, "little")
data[at + 4] ^= 1
open(path, "wb").write(data)
PY
sed -i 's/"order": "canonical"/"order": "arrival"/' a/trace.json
run compare r/trace-epr a -o arrived
[ "$status" -eq 1 ] && python3 - <<'PY'
from pictures import *
assert white("arrived/splat.depth_index-cube-0.png")[1] == {(0, 0)}
PY
verdict $? 'points that arrived in another order'

# A reference whose cubes do not fit their texels.
cp -r r/trace-epr bad
python3 - <<'PY'
from pictures import *
path, data, at = opened("bad", "cube_size.face")
n = faces("bad")[0][1]
open(path, "wb").write(data[:at] + data[at:].replace(n.to_bytes(4, "little"), (16000).to_bytes(4, "little")))
PY
run compare bad c -o refused
[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -e refused ] &&
	grep -q 'cube 0 of 16000 texels a side at 0: splat.depth_index has ' stderr
verdict $? 'cubes that do not fit are refused'

finish
