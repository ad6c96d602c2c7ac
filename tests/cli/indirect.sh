#!/bin/bash
# Renders of indirect light: what the pictures show and how far apart the methods are, against the buffers of a trace.
. "$(dirname "$0")/tap.bash"
small=(atrium:triangles=10000:texels=32 --size 96x54 --set rsm.px=4 --set depth_grid.px=64)
cd "$scratch" || exit 2

refuses 'octree.levels, vpl_gather.level, view_map.px or vpl.paths$' render indirect "${small[@]}" \
	--method hulls,megaviews --set view_map.px=256 --set vpl.paths=16777216 --set vpl.bounces=4
refuses 'octree.levels, vpl_gather.level, view_map.px or particle.count$' render particles "${small[@]}" \
	--set view_map.px=256 --set particle.count=16777216

refuses 'parameter view_map.px: 48 is not a power of two; 32 or 64 would be right$' render indirect "${small[@]}" \
	--set view_map.px=48
refuses 'parameter view_map.px: 255 is not a power of two; 128 or 256 would be right$' digest --set view_map.px=255
if awk '/^MemTotal/ { exit $2 > 85e6 }' /proc/meminfo; then # kB: three quarters of that hold no 64 GiB
	refuses 'about 68.* GB .* choose a smaller image, traverse.queue_mb$' render indirect "${small[@]}" \
		--method megaviews --set traverse.queue_mb=65536 --set vpl.paths=20
fi

cat > read.py <<'PY'
import glob, struct, sys, zlib

# Rows of a PNG of 8-bit RGB as bytes.
def png(path):
	data, at, packed = open(path, "rb").read(), 8, b""
	while at < len(data):
		n, kind = struct.unpack_from(">I4s", data, at)
		if kind == b"IHDR":
			width, height, depth, colour = struct.unpack_from(">IIBB", data, at + 8)
		packed += data[at + 8:at + 8 + n] if kind == b"IDAT" else b""
		at += 12 + n
	assert (depth, colour) == (8, 2)
	raw, rows, above = zlib.decompress(packed), [], bytearray(3 * width)
	for y in range(height):
		start = y * (3 * width + 1)
		row, kind = bytearray(raw[start + 1:start + 1 + 3 * width]), raw[start]
		if kind == 2 and not any(row): # that above again
			row, kind = above, 0
		for k in range(3 * width if kind > 0 else 0):
			a, b, c = (row[k - 3], above[k], above[k - 3]) if k > 2 else (0, above[k], 0)
			nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
			row[k] = (row[k] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
		rows.append(row)
		above = row
	return rows

# The elements of a buffer of a trace, as struct.unpack has them.
def buffer(trace, name, layout):
	data = open(glob.glob(f"{trace}/*-{name}.npy")[0], "rb").read()
	return list(struct.iter_unpack(layout, data[10 + struct.unpack_from("<H", data, 8)[0]:]))
PY

# Lights at random are those of the truth, too: with all of them, unfiltered, only maps err.
run render indirect "${small[@]}" --method megaviews --set octree.levels=6 --set vpl.paths=300 --set vpl.place=random \
	--set vpl_gather.lights=0 --set bilateral.px=0 --truth=vpls --no-images --json
python3 -c 'import json, sys
metrics = [m for m in json.load(open(sys.argv[1]))["metrics"] if m["reference"] == "truth-vpls"]
assert [m["psnr"] > 20 for m in metrics] == [True], metrics' "$scratch/stdout"
verdict $? 'truth vpls gathers from lights at random'

run render indirect "${small[@]}" --method hulls,direct --truth=lights --trace -o light
[ "$status" -eq 0 ] && ! grep -qi 'mirror\|reflective\|refl\.\|cube' stdout &&
	[ "$(awk 'length > 120' stdout | wc -l)" -eq 0 ]
verdict $? 'tables of indirect light say nothing of mirrors'

missing=0
for file in hulls.png direct.exr truth-lights.png difference-hulls-direct.png difference-hulls-truth-lights.exr \
	difference-direct-truth-lights.png hulls-segments.png hulls-lobes.png report.json; do
	[ -s "light/$file" ] || { missing=1; echo "# no $file"; }
done
verdict $missing 'every picture is there'

python3 - <<'PY'
from read import png
hulls, direct, apart = (png(f"light/{name}.png") for name in ("hulls", "direct", "difference-hulls-direct"))
for a, b, d in zip(hulls, direct, apart):
	assert list(d) == [min(255, 4 * abs(p - q)) for p, q in zip(a, b)]
assert max(map(max, apart)) > 0
PY
verdict $? 'a difference is four times as bright'

# Light of lamps: what pixels gather is the closed form, hulls are near it, and shadows only take away.
run render area-light "${small[@]}" --set lamp.radius=0.3 --set truth.area_samples=64 --method hulls,direct --truth \
	--trace -o lamps
[ "$status" -eq 0 ] && ! grep -qi 'reflective\|near a triangle' stdout && python3 - <<'PY'
import json, math
from read import buffer
rows = {(r["image"], r["reference"]): r for r in json.load(open("lamps/report.json"))["metrics"]}
assert rows["direct", "truth-exact"]["relative_rmse"] < 1e-4 and rows["hulls", "truth-exact"]["relative_rmse"] < 0.3
assert rows["direct", "truth-shadowed"]["relative_rmse"] > 0.1
# In doubles, by solid angles of small parts: of every 97th pixel.
triangles = [(p[:3], p[3:6], p[6:9], p[12:15]) for p in buffer("lamps/trace-direct", "polygon.patch", "<15f4x")]
pixels = buffer("lamps/trace-direct", "gbuffer.pixel", "<3ff3f20x")
light = buffer("lamps/trace-direct", "indirect.irradiance", "<3f")
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
n, tried = 24, 0
for pixel, found in list(zip(pixels, light))[::97]:
	p, depth, normal = pixel[:3], pixel[3], pixel[4:7]
	total = 0
	for a, b, c, exitance in triangles if depth < 1 else ():
		u, v = ([y - x for x, y in zip(a, q)] for q in (b, c))
		turned = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
		for i in range(n):
			for j in range(2 * (n - i) - 1):
				third = 1 / 3 if j % 2 == 0 else 2 / 3
				s, t = (i + third) / n, (j // 2 + third) / n
				way = [x + s * y + t * z - w for x, y, z, w in zip(a, u, v, p)]
				square = dot(way, way)
				cosines = max(0, dot(normal, way)) * max(0, -dot(turned, way))
				total += exitance[0] * cosines / (2 * n * n * math.pi * square * square)
	tried += total > 0
	assert abs(found[0] - total) < 0.01 * total + 2e-3, (found, total)
assert tried > 20
PY
verdict $? 'light of lamps against their areas in small parts'

python3 - <<'PY'
import json, math
from read import buffer
rows = {(r["image"], r["reference"]): r for r in json.load(open("light/report.json"))["metrics"]}
seen = [depth < 1 for _, depth, _ in buffer("light/trace-hulls", "gbuffer.pixel", "<12sf32s")]
light = [buffer(f"light/trace-{method}", "image.radiance", "<3f") for method in ("hulls", "direct")]
pairs = [(a, b) for s, p, q in zip(seen, *light) if s for a, b in zip(p, q)]
assert 0 < len(pairs) < 3 * len(seen)
right = math.sqrt(sum((a - b) ** 2 for a, b in pairs) * len(pairs)) / sum(b for _, b in pairs)
assert abs(rows["hulls", "direct"]["relative_rmse"] - right) < 1e-6 * right
assert rows["hulls", "truth-lights"]["relative_rmse"] > rows["direct", "truth-lights"]["relative_rmse"] / 2 > 0
PY
verdict $? 'the relative RMSE is that of radiance, without the sky'

# By every pixel and every triangle, in doubles.
python3 - <<'PY'
import json, math
from read import buffer
rows = {(r["image"], r["reference"]): r for r in json.load(open("light/report.json"))["light_errors"]}
pixels = buffer("light/trace-hulls", "gbuffer.pixel", "<3f f 32x")
triangles = [(p[:3], p[3:6], p[6:9]) for p in buffer("light/trace-hulls", "rsm.patch", "<9f 28x") if any(p)]
spheres = [([sum(c) / 3 for c in zip(*abc)], math.dist(*abc[:2])) for abc in triangles]
x, t = (buffer(f"light/trace-{method}", "image.radiance", "<3f") for method in ("hulls", "direct"))
parts = {True: [], False: []}
for i, (*place, depth) in enumerate(pixels):
	if depth == 1:
		continue
	near = any(math.dist(place, centre) <= radius for centre, radius in spheres)
	apart = sum(abs(a - b) for a, b in zip(x[i], t[i]))
	error = apart and (apart / sum(t[i]) if sum(t[i]) > 0 else math.inf)
	parts[near].append((sum((a - b) ** 2 for a, b in zip(x[i], t[i])), sum(t[i]), error))
both = parts[True] + parts[False]
squares, light = ({k: sum(e[at] for e in parts[k]) for k in parts} for at in (0, 1))
relative = {k: math.sqrt(squares[k] / 3 / len(parts[k])) / (light[k] / 3 / len(parts[k])) for k in parts}
row = rows["hulls", "direct"]
def close(a, b):
	assert abs(a - b) <= 1e-6 * b, (a, b)
assert min(len(parts[True]), len(parts[False])) > 100
close(row["relative_rmse_near"], relative[True])
close(row["relative_rmse_elsewhere"], relative[False])
close(row["near_percent"], 100 * len(parts[True]) / len(both))
close(row["near_error_percent"], 100 * squares[True] / sum(squares.values()))
close(row["median_error"], sorted(e[2] for e in both)[(len(both) - 1) // 2])
close(row["beyond_percent"], 100 * sum(e[2] > 0.1 for e in both) / len(both))
assert all(r["near_percent"] == row["near_percent"] for r in rows.values()) and len(rows) == 3
PY
verdict $? 'errors in radiance, near triangles of light and elsewhere'

# 32 pixels a texel, one between blocks. The last box is drawn over all others.
python3 - <<'PY'
from read import buffer, png
rows = png("light/hulls-segments.png")
labels = [label for label, in buffer("light/trace-hulls", "segment.label", "<I")]
place = lambda i: 32 * i + i // 32 + 1
colour = lambda x, y: tuple(rows[y][3 * x:3 * x + 3])
assert len(rows) == place(64) and len(rows[0]) == 3 * place(64)
assert all(colour(0, y) == colour(place(32) - 1, y) == colour(y, 0) == colour(y, place(32) - 1) == (0, 0, 0)
           for y in range(place(64)))
of = {}
for y in range(64):
	for x in range(64):
		of.setdefault((y // 32, x // 32, labels[64 * y + x]), set()).add(colour(place(x) + 16, place(y) + 16))
assert all(len(colours) == 1 for colours in of.values()) and len(set(map(min, of.values()))) > len(of) * 0.9 > 9
x0, y0, x1, y1, near, far, label, _ = buffer("light/trace-hulls", "segment.box", "<4I2f2I")[-1]
dim = min(of[label // 1024 // 2, label // 1024 % 2, label % 1024])
for x, y in ((place(x0), place(y0)), (place(x1) + 31, place(y1) + 31)):
	assert tuple(c // 2 for c in colour(x, y)) == dim
PY
verdict $? 'segments have a colour each, and boxes theirs'

# 8 pixels a pixel. The disc within the top left corner of the last large box, of 36 pixels' radius: its middle shows
# what comes from the viewer.
python3 - <<'PY'
import math
from read import buffer, png
rows = png("light/hulls-lobes.png")
assert len(rows) == 8 * 54 and len(rows[0]) == 3 * 8 * 96
boxes = buffer("light/trace-hulls", "segment.box", "<4I2f2I")
b = [k for k, b in enumerate(boxes) if b[2] - b[0] > 22 and b[3] - b[1] > 22][-1]
x, y = boxes[b][0] * 12, boxes[b][1] * 27 // 4
assert tuple(rows[y][3 * x:3 * x + 3]) == (96, 96, 96)
_, back, _ = buffer("light/trace-hulls", "eye.view", "<48s12s4s")[0]
lobe = buffer("light/trace-hulls", "corner.lobes", "<15fI")[4 * b]
back = memoryview(back).cast("f")
for c in range(3):
	cosine = sum(p * q for p, q in zip(lobe[6 + 3 * c:], back))
	light = lobe[c] / max(lobe[:3]) * math.exp(lobe[3 + c] * (cosine - 1))
	right = 255 * (12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055)
	assert abs(rows[y + 37][3 * (x + 37) + c] - right) < 4
PY
verdict $? 'lobes stand at the corners of the larger boxes'

finish
