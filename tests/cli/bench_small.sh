#!/bin/bash
# Small tables of papers whose figures are counted and summed again from renders and traces; longer ones are those of
# bench.sh.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/bench.bash"
small=(--scene atrium:triangles=10000:texels=32 --objects 1,2 --size 96x54 --set reflectors.px=30 --set cube.max_px=64)
run bench epr-1 "${small[@]}"
[ "$status" -eq 0 ] && grep -q '^96 x 54 pixels' "$scratch/stdout" &&
	grep -q '^Sponza .*paper .*1,510,000' "$scratch/stdout"
verdict $? 'bench epr-1 says the size, and has the paper'
run bench epr-1 "${small[@]}" --objects 2,3 --threads 2 --json
python3 - "$scratch/stdout" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
assert report["params"]["width"] == 96 and report["params"]["height"] == 54 and report["threads"] == 2
assert report["program"] == "touchstone" and report["version"] and report["backend"] == "c"
rows = [r for r in report["epr_1"] if r["source"] == "here"]
for r in rows:
	assert r["epr_ops"] > 0 and 0 < r["mvr_ops"] <= 6 * 64 * 64 * r["mirrors"]
	assert abs(r["ratio"] - r["mvr_ops"] / r["epr_ops"]) < 1e-6
	assert 16 <= r["diameter"] <= 27 and r["projected"] > 16
PY
verdict $? 'the ratio is that of the operations, and it says how it was run'

# Over frames: means of what each frame has, and ratios of means. MVR is that of the first frame.
for frame in 3 5; do
	run bench epr-1 "${small[@]}" --frame $frame --json
	cp "$scratch/stdout" "$scratch/frame-$frame"
done
run bench epr-1 "${small[@]}" --frames 3..6:2 -o "$scratch/frames"
[ "$status" -eq 0 ] && grep -q '^96 x 54 pixels, means over 2 frames from 3 to 6' "$scratch/stdout" &&
	! grep -q over_frames "$scratch/stdout"
verdict $? 'bench epr-1 says what it is the mean of'
python3 - "$scratch" <<'PY'
import csv, sys
from results import results, found
several, *each = (results(f"{sys.argv[1]}/{name}") for name in ("frames", "frame-3", "frame-5"))
here = [[{**a, **b} for a, b in zip(report["epr_1"], report["epr_1_rates"]) if a["source"] == "here"]
        for report in (several, *each)]
spread = {(r["mirrors"], r["figure"]): r for r in several["over_frames"]}
assert several["frames"] == [3, 6, 2] and [r["mirrors"] for r in here[0]] == [1, 2]
for both, a, b in zip(*here):
	for key in "epr_ops", "in_sight", "reflective":
		row, values = spread[both["mirrors"], key], (a[key], b[key])
		mean = sum(values) / 2
		assert (row["least"], row["mean"], row["most"]) == (min(values), mean, max(values))
		assert values[row["most_at"] == 5] == max(values)
		assert both[key] == (mean if key == "in_sight" else int(mean))
	assert both["mvr_ops"] == a["mvr_ops"] != b["mvr_ops"]
	mean = (a["epr_ops"] + b["epr_ops"]) / 2
	assert both["ratio"] is None if mean == 0 else abs(both["ratio"] - a["mvr_ops"] / mean) < 1e-6 * both["ratio"]
assert sum(r["epr_ops"] for r in here[1] + here[2]) > 0
lines = list(csv.DictReader(open(found(sys.argv[1] + "/frames", "over_frames.csv"))))
assert [float(r["mean"]) for r in lines] == [float("%.9g" % r["mean"]) for r in several["over_frames"]]
PY
verdict $? 'bench epr-1: means and extremes over frames are those of the frames'
refuses 'bench epr-6: takes no --frames' bench epr-6 --frames 0..9
refuses 'either one frame or several' bench epr-1 --frames 0..9 --frame 3

# Seams of hulls, summed again from traces of each choice, and pairs of a corner and a triangle of light.
one=(dining:triangles=10000 --size 64x36 --set depth_grid.px=64 --set rsm.px=4)
run bench ssagh-borders --scene "${one[@]:0:1}" "${one[@]:1}" -o "$scratch/borders"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench ssagh-borders fits 120 columns'
for set in corner.facing=ramp corner.facing=paper hull.corners=rectangle; do
	"$touchstone" render indirect "${one[@]}" --set $set --method hulls,direct --no-images --trace \
		-o "$scratch/$set" > "$scratch/stdout" 2> "$scratch/stderr"
done
python3 - "$scratch" <<'PY'
import glob, struct, sys
from math import dist
from results import results
W, H, G = 64, 36, 64
def buffer(choice, method, name):
	data = open(glob.glob(f"{sys.argv[1]}/{choice}/trace-{method}/[0-9]*-{name}.npy")[0], "rb").read()
	return memoryview(data)[10 + struct.unpack_from("<H", data, 8)[0]:]
def records(choice, name, floats, bytes_each):
	data = buffer(choice, "hulls", name)
	return [struct.unpack_from(f"<{floats}f", data, at) for at in range(0, len(data), bytes_each)]
def seams(choice):
	pixels = records(choice, "gbuffer.pixel", 7, 48)
	box = buffer(choice, "hulls", "hull.box").cast("I")
	ours, right = (buffer(choice, method, "indirect.irradiance").cast("f") for method in ("hulls", "direct"))
	block = [((2 * y + 1) * G // (2 * H) // 32, (2 * x + 1) * G // (2 * W) // 32) for y in range(H) for x in range(W)]
	sums = {"across": [0, 0], "within": [0, 0]}
	for i in range(W * H):
		for j in ([i + 1] if i % W < W - 1 else []) + ([i + W] if i < W * (H - 1) else []):
			p, q = pixels[i], pixels[j]
			if p[3] == 1 or q[3] == 1: continue
			near, far = sorted((1 / (1 - p[3]), 1 / (1 - q[3])))
			if far / near > 1 / 0.98 or sum(a * b for a, b in zip(p[4:], q[4:])) < 0.99: continue
			kind = "across" if block[i] != block[j] else "within" if box[i] == box[j] else None
			for c in range(3) if kind else ():
				a, b = 3 * i + c, 3 * j + c
				sums[kind][0] += abs((ours[b] - right[b]) - (ours[a] - right[a]))
				sums[kind][1] += (right[a] + right[b]) / 2
	return {kind: 100 * change / light for kind, (change, light) in sums.items()}
def pairs(choice):
	faces = counts = full = 0
	corners = records(choice, "corner.moment", 3, 64)
	for a in records(choice, "rsm.patch", 16, 64):
		side = dist(a[0:3], a[3:6])
		for p in corners if side else ():
			height = sum(n * (x - y) for n, x, y in zip(a[9:12], p, a))
			if abs(height) < 1e-5: continue
			faces, counts, full = faces + (height > 0), counts + (height > side / 16), full + (height >= side * 5 / 16)
	return 100 * counts / faces, 100 * full / faces
report = results(f"{sys.argv[1]}/borders")
rows = {r["choice"]: r for r in report["ssagh_borders"]}
for choice, name in (("corner.facing=ramp", "as it is"), *(2 * (c,) for c in list(rows)[1:])):
	found, row = seams(choice), rows[name]
	for kind in found:
		assert abs(row[kind + "_percent"] - found[kind]) < 1e-3 * found[kind], (choice, kind, row, found)
ours = rows["as it is"]
counts, full = pairs("corner.facing=ramp")
assert abs(ours["counted_percent"] - counts) < 0.5 and abs(ours["full_percent"] - full) < 0.5 and full < counts < 100
judged = {r["relation"]: r["here"] for r in report["relations"]}
for (relation, here), (choice, key) in zip(judged.items(), (("corner.facing=paper", "across_percent"),
	("corner.facing=paper", "relative_rmse"), ("hull.corners=rectangle", "across_percent")), strict=True):
	assert relation.startswith(choice) and abs(here - rows[choice][key] / ours[key]) < 1e-5
PY
verdict $? 'bench ssagh-borders sums what traces have'
refuses 'takes no --runs' bench ssagh-borders --runs 2

# Crumbs of both sides and of fronts alone; PSNRs and pixels are those of renders.
crumbs=(--size 96x64 --set surfels.from_mesh=3000 --set truth.grid_rays=2 --set eye.distance=near)
run bench nv40-crumbs --scene atrium:triangles=10000 "${crumbs[@]}" --threads 2 -o "$scratch/crumbs"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	[ "$(grep -c '^touchstone: scene atrium:triangles=10000, filter ' "$scratch/stderr")" -eq 3 ]
verdict $? 'bench nv40-crumbs fits 120 columns and says its rows'
for sides in material front; do
	run render surfels atrium:triangles=10000 "${crumbs[@]}" --set surfels.sides=$sides --method deferred,ewa \
		--truth=surface --no-images --json
	cp "$scratch/stdout" "$scratch/crumbs-$sides.json"
done
python3 - "$scratch" <<'PY'
import json, sys
from results import results
report = results(sys.argv[1] + "/crumbs")
rows = {r["filter"]: r for r in report["nv40_crumbs"]}
for sides, key in ("material", "psnr"), ("front", "psnr_front"):
	render = json.load(open(f"{sys.argv[1]}/crumbs-{sides}.json"))
	psnr = {m["image"]: m["psnr"] for m in render["metrics"] if m["reference"] == "truth-surface"}
	for name, method in ("lesser radius", "deferred"), ("exact EWA", "ewa"):
		assert abs(rows[name][key] - psnr[method]) < 1e-6, (name, rows[name], psnr)
for r in rows.values():
	assert 0 <= r["crumbs_new"] <= r["crumbs_front"] <= r["crumbs_new"] + r["crumbs"] and r["backs_alone"] >= 0, r
assert len(rows) == len(report["relations"]) == 3
left, gained, opened = (r["here"] for r in report["relations"])
assert abs(left - max(r["crumbs_front"] / r["crumbs"] for r in rows.values())) < 1e-6 * left
assert abs(gained - min(r["psnr_front"] - r["psnr"] for r in rows.values())) < 1e-6
seen = json.load(open(f"{sys.argv[1]}/crumbs-material.json"))["params"]
most, pixels = max(r["crumbs_new"] for r in rows.values()), seen["width"] * seen["height"]
assert (opened == 0) == (most == 0) and (most == 0 or most <= opened / 100 * pixels <= 5 * most + pixels * 1e-9), opened
for r, holds in zip(report["relations"], (left <= 1, gained >= 0, opened <= 0.3)):
	assert r["verdict"].startswith("holds" if holds else "differs: "), r
PY
verdict $? 'bench nv40-crumbs has the errors of renders by both sides'
refuses 'no area' bench nv40-crumbs --scene scenes/splats.gltf
finish
