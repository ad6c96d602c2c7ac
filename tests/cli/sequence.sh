#!/bin/bash
# Frames one after the other: each has the bits that it has alone, figures are those of its pictures, and videos are
# made by whatever is called ffmpeg, or not at all.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
small=(render reflections atrium:triangles=10000:texels=32 --size 65x35 --reflectors 3 --set reflectors.px=20
	--set cube.max_px=32 --set cube.hysteresis=4)
mkdir bin none

# An encoder that knows no dates: says what it saw, and gives the pictures back.
cat > bin/ffmpeg <<'SH'
#!/bin/bash
echo "$@" >> "$FFMPEG_LOG"
for last; do :; done
while [ "$1" != -i ]; do shift; done
cat $2 > "$last"
SH
chmod +x bin/ffmpeg
export FFMPEG_LOG=$scratch/ffmpeg.log

PATH=$scratch/bin:$PATH run "${small[@]}" --method epr,mvr --truth=B --frames 3..9:3 -o whole
[ "$status" -eq 0 ] && grep -q 'flicker_truth-b' stdout && [ "$(ls -d whole/frame-*)" = "whole/frame-000003
whole/frame-000006
whole/frame-000009" ] && [ ! -e whole.partial ]
verdict $? 'a folder a frame'

same=0
run "${small[@]}" --method epr,mvr --truth=B --frame 9 -o alone
[ "$status" -eq 0 ] || same=1
for file in alone/*.png alone/*.exr; do cmp "$file" "whole/frame-000009/${file#alone/}" || same=1; done
[ "$(ls alone/*.png | wc -l)" -gt 8 ] || same=1
verdict $same 'a frame has the files that it has alone'

python3 - <<'PY'
import csv, json, math, subprocess, struct, zlib, sys

def pixels(path):
	data, at, stream = open(path, "rb").read(), 8, b""
	while at < len(data):
		n, kind = struct.unpack(">I4s", data[at:at + 8])
		if kind == b"IHDR": width, height = struct.unpack(">II", data[at + 8:at + 16])
		if kind == b"IDAT": stream += data[at + 8:at + 8 + n]
		at += 12 + n
	raw, rows, above = zlib.decompress(stream), [], bytes(3 * width)
	for y in range(height):
		kind, row = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
		for i in range(3 * width):
			a = row[i - 3] if i >= 3 else 0
			b, c = above[i], above[i - 3] if i >= 3 else 0
			p = a + b - c
			paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
			row[i] = row[i] + (0, a, b, (a + b) // 2, paeth)[kind] & 255
		rows.append(row)
		above = row
	return b"".join(map(bytes, rows))

lines = list(csv.DictReader(open("whole/sequence.csv")))
assert [(r["frame"], r["image"]) for r in lines] == [(f, i) for f in ("3", "6", "9") for i in ("epr", "mvr", "truth-b")]
picture = {(r["frame"], r["image"]): pixels(f"whole/frame-{int(r['frame']):06d}/{r['image']}.png") for r in lines}
for r in lines:
	image, truth = picture[r["frame"], r["image"]], picture[r["frame"], "truth-b"]
	if r["image"] != "truth-b":
		rmse = math.sqrt(sum((a - b) ** 2 for a, b in zip(image, truth)) / len(image))
		assert abs(rmse - float(r["rmse_truth-b"])) < 1e-5
	if r["frame"] == "3":
		assert r["change"] == r["flicker_truth-b"] == ""
		continue
	before = str(int(r["frame"]) - 3)
	was, truth_was = picture[before, r["image"]], picture[before, "truth-b"]
	change = math.sqrt(sum((a - b) ** 2 for a, b in zip(image, was)) / len(image))
	assert abs(change - float(r["change"])) < 1e-5
	beyond = [max(0, abs(a - b) - abs(c - d)) ** 2 for a, b, c, d in zip(image, was, truth, truth_was)]
	if r["image"] != "truth-b":
		assert abs(math.sqrt(sum(beyond) / len(image)) - float(r["flicker_truth-b"])) < 1e-5 and any(beyond)
report = json.load(open("whole/report.json"))
over = {(r["image"], r["figure"]): r for r in report["over_frames"]}
values = [float(r["rmse_truth-b"]) for r in lines if r["image"] == "epr"]
row = over["epr", "rmse_truth-b"]
assert abs(row["mean"] - sum(values) / 3) < 1e-5 and abs(row["most"] - max(values)) < 1e-5
assert row["least_at"] == 3 + 3 * values.index(min(values)) and row["most_at"] == 3 + 3 * values.index(max(values))
times = json.load(open("whole/times.json"))["renders"]
assert [(t["combination"], t["frame"]) for t in times] == [(0, 3), (0, 6), (0, 9)]
assert all(t["milliseconds"]["epr"] > 0 and t["resident_bytes"] > 1e6 for t in times)
for name in report["files"]: open("whole/" + name, "rb").close()
assert {"contact-sheet.png", "rmse-frame.svg", "flicker-frame.svg", "epr.mp4", "mvr.mp4",
        "truth-b.mp4"} < set(report["files"])
PY
verdict $? 'figures of the frames are those of their pictures'

cat whole/frame-*/epr.png | cmp - whole/epr.mp4 && [ "$(wc -l < ffmpeg.log)" -eq 3 ] &&
	grep -q -- '-i frame-\*/epr.png' ffmpeg.log
verdict $? 'ffmpeg sees the frames in their order'

PATH=$scratch/bin:$PATH run "${small[@]}" --method epr,mvr --truth=B --frames 3..9:3 -o again --threads 1
[ "$status" -eq 0 ] && [ "$(diff -rq whole again | grep -v 'times.json\|report.json')" = '' ]
verdict $? 'another run, with other threads, leaves the same files'

ln -s "$(command -v timeout)" none/timeout
PATH=$scratch/none run "${small[@]}" --method epr --truth=B --frames 0..1 -o plain
[ "$status" -eq 0 ] && grep -q 'no video: ffmpeg is not installed' stderr && [ "$(grep -c ffmpeg stderr)" -eq 1 ] &&
	[ -e plain/frame-000001/epr.png ] && [ ! -e plain/epr.mp4 ] && ! grep -q '"epr.mp4"' plain/report.json
verdict $? 'without ffmpeg there are frames'
python3 - <<'PY'
import csv
lines = [line for line in csv.DictReader(open("plain/sequence.csv")) if line["image"] == "epr"]
first, second = (line["reflective_flicker_truth-b"] for line in lines)
assert first == "" and float(second) > 0, (first, second)
PY
verdict $? 'mirrors flicker from the second frame on'

printf '#!/bin/bash\necho "Unknown encoder" >&2\nexit 1\n' > bin/ffmpeg
PATH=$scratch/bin:$PATH run "${small[@]}" --method epr --frames 0..1 -o failing
[ "$status" -eq 0 ] && grep -q 'no video: ffmpeg failed: Unknown encoder' stderr && [ ! -e failing/epr.mp4 ] &&
	! grep -q '"epr.mp4"' failing/report.json
verdict $? 'an ffmpeg that fails leaves no video'

run "${small[@]}" --method epr,mvr --truth=B --set density.scale=0.25,0.5 --set reflectors.px=20,25 -o sweep
python3 - <<'PY'
import csv, json, os
printed, kept = list(csv.DictReader(open("stdout"))), list(csv.DictReader(open("sweep/sweep.csv")))
assert len(printed) == len(kept) == 8 and all("milliseconds" in r for r in printed) and "milliseconds" not in kept[0]
for a, b in zip(printed, kept): assert {k: a[k] for k in b if k != "image"} == {k: b[k] for k in b if k != "image"}
times = [t["milliseconds"] for t in json.load(open("sweep/times.json"))["renders"]]
assert times[0]["mvr"] == times[2]["mvr"] and times[1]["mvr"] == times[3]["mvr"] != times[0]["mvr"]
assert len({t["epr"] for t in times}) == 4
names = ["density.scale=0.25,reflectors.px=20", "density.scale=0.5,reflectors.px=20"]
read = lambda name: open(f"sweep/{name}", "rb").read()
def pixels(row, method):
	file = read(f"{names[row]}/{method}.png")
	return file[file.index(b"IDAT"):]  # behind the texts, which have the parameters
assert pixels(0, "mvr") == pixels(1, "mvr") and pixels(0, "epr") != pixels(1, "epr")
assert os.path.getsize("sweep/contact-sheet.png") > 0 and b"density.scale" in read("rmse-density.scale.svg")
PY
verdict $? 'a sweep runs no method again for what it does not read'
[ "$status" -eq 0 ] && [ ! -s stderr ] && [ -z "$(ls sweep | grep mp4)" ] && python3 - <<'PY'
import json
report, times = json.load(open("sweep/report.json")), json.load(open("sweep/times.json"))["renders"]
assert [(t["combination"], t["frame"]) for t in times] == [(c, 0) for c in range(4)]
assert times[1]["values"] == {"density.scale": "0.25", "reflectors.px": "25"}
rows = {row["name"]: row["shows"] for row in report["pictures"]}
assert rows["../contact-sheet.png"] == "renders from left to right; from above epr, mvr, truth-b"
assert {"epr.png .exr", "mvr.png .exr", "truth-b.png .exr", "../sweep.csv"} < set(rows) and "../*.mp4" not in rows
assert all(f"density.scale={c},reflectors.px=20/mvr.png" in report["files"] for c in ("0.25", "0.5"))
PY
verdict $? 'its report names its renders and pictures; there is no video of a frame'

run "${small[@]}" --method mvr,epr --frames 30..31 --exposure auto -o frames
mv stdout sequence.txt
run "${small[@]}" --method mvr --exposure auto -o first
python3 - <<'PY'
import json
first, frames = (json.load(open(f"{name}/report.json"))["params"]["image.exposure"] for name in ("first", "frames"))
assert first == frames and first != 1 and f"exposure {first:g}: 95 % of frame 0 by mvr" in open("sequence.txt").read()
PY
verdict $? 'the exposure of a sequence is that of frame 0, wherever the sequence begins'

# A flat grey wall fills the picture: 0.8 is what it is shown at, by whatever light.
python3 - <<'PY'
import base64, json, struct
position = struct.pack("<9f", -90, -90, 0, 90, -90, 0, 0, 180, 0)
json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
           "extensionsUsed": ["KHR_lights_punctual"],
	"extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 0.25}]}},
	"nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]},
	          {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
	"cameras": [{"name": "c", "type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}],
	"materials": [{"pbrMetallicRoughness": {"metallicFactor": 0}}],
	"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
	"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-90, -90, 0],
	               "max": [90, 180, 0]}],
	"bufferViews": [{"buffer": 0, "byteLength": 36}],
	"buffers": [{"byteLength": 36,
	             "uri": "data:application/octet-stream;base64," + base64.b64encode(position).decode()}]},
	open("wall.gltf", "w"))
PY
run render reflections wall.gltf --camera c --reflectors 0 --method mvr --size 64x64 --exposure auto -o wall
python3 - <<'PY'
import struct, zlib
data, at, stream = open("wall/mvr.png", "rb").read(), 8, b""
while at < len(data):
	n, kind = struct.unpack(">I4s", data[at:at + 8])
	if kind == b"IDAT": stream += data[at + 8:at + 8 + n]
	at += 12 + n
raw = zlib.decompress(stream)
first = raw[1:4]
assert all(abs(v - 231) <= 2 for v in first), first # sRGB of 0.8
PY
verdict $? 'what is as bright as 95 % of frame 0 is shown at 0.8'

refuses 'parameter image.exposure' "${small[@]}" --exposure bright
refuses 'not A..B or A..B:STEP' "${small[@]}" --frames 5
refuses 'not A..B or A..B:STEP' "${small[@]}" --frames 5..4
refuses 'not A..B or A..B:STEP' "${small[@]}" --frames 0..9:0
refuses 'not A..B or A..B:STEP' "${small[@]}" --frames 0..100001
refuses 'not A..B or A..B:STEP' "${small[@]}" --frames 0..9:2x
refuses 'either one frame or several' "${small[@]}" --frames 0..9 --frame 3
refuses 'either one frame or several' "${small[@]}" --frames 0..9 --set frame=3
refuses 'name the frame by --frame' "${small[@]}" --frames 0..9 --trace
finish
