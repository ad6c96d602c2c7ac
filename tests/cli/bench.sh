#!/bin/bash
# The papers' tables: our figures, and the paper's below them.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/bench.bash"
small=(--scene atrium:triangles=10000:texels=32 --objects 1,2 --size 96x54 --set reflectors.px=30 --set cube.max_px=64)

run bench epr-2 "${small[@]}" --runs 2 --truth=A -o "$scratch/epr-2"
[ "$status" -eq 0 ] && grep -q '^Sponza .*paper .*603,000' "$scratch/stdout" &&
	awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench epr-2 fits 120 columns and has the paper'
python3 - "$scratch/epr-2" <<'PY'
import csv, json, os, sys
from results import results, found
report = results(sys.argv[1])
assert sorted(report["files"] + ["report.json"]) == sorted(os.listdir(sys.argv[1]))
parts = {name: [r for r in report[name] if r["source"] == "here"] for name in report if name.startswith("epr_2")}
assert [r["mirrors"] for r in parts["epr_2"]] == [1, 2]
for points, ms, rmse in zip(parts["epr_2"], parts["epr_2_ms"], parts["epr_2_rmse"]):
	assert points["triangles"] >= 10000 and points["points"] > 0
	assert abs(points["points_ratio"] - points["ivir_points"] / points["points"]) < 1e-6
for like, points in zip(parts["epr_2_like"], parts["epr_2"]):
	assert like["points"] == points["points"] > like["ball_points"] > 0
	assert abs(like["ball_ratio"] - like["ivir_adaptive_points"] / like["ball_points"]) < 1e-6
	assert min(ms["point_ms"], ms["view_ms"], ms["deferred_ms"], ms["deferred2_ms"], ms["mvr_ms"]) > 0
	assert abs(rmse["rmse_difference"] - (rmse["epr_rmse"] - rmse["mvr_rmse"]) / 2.55) < 1e-6
for name in parts:
	lines = list(csv.DictReader(open(found(sys.argv[1], name + ".csv"))))
	assert len(lines) == len(report[name])
	for line, row in zip(lines, report[name]):
		assert list(line) == list(row)
		for k, v in row.items():
			assert line[k] == ("" if v is None else str(v)) or abs(float(line[k]) - v) <= 1e-8 * abs(v)
PY
verdict $? 'bench -o writes the report, and each table as CSV with its rows'

# Two cylinders: each bounce looks up 4 times where a sample of the one before has met a mirror.
cylinders=(--scene dining:triangles=10000:texels=32 --size 96x54 --set reflectors.px=48 --set cube.max_px=32 --runs 1)
run bench epr-5 "${cylinders[@]}" -o "$scratch/epr-5"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench epr-5 fits 120 columns'
"$touchstone" render reflections "${cylinders[1]}" --reflectors 2 "${cylinders[@]:2:6}" --set lookup.bounces=3 \
	--set reflectors.shape=cylinder --set eye.turns=2 --frame 40 --truth=A --method epr -o "$scratch/epr-5-of" \
	> "$scratch/stdout" 2> "$scratch/stderr"
python3 - "$scratch" <<'PY'
import os, sys
from results import results
report, render = (results(f"{sys.argv[1]}/{name}") for name in ("epr-5", "epr-5-of"))
rows = [r for r in report["epr_5"] if r["source"] == "here"]
counted = {c["counter"]: c["epr"] for c in render["counters"]}
errors = next(m for m in render["metrics"] if m["image"] == "epr")
assert [r["bounces"] for r in rows] == [1, 2, 3] and len({r["passes"] for r in rows}) == 1
assert rows[2]["lookups"] == counted["look-ups"] and rows[2]["ops"] == counted["shading operations"]
assert abs(rows[2]["rmse"] - errors["rmse"]) < 1e-9 and abs(rows[2]["ssim"] - errors["ssim"]) < 1e-9
for before, after in zip(rows, rows[1:]):
	assert after["lookups"] > before["lookups"] and (after["lookups"] - before["lookups"]) % 4 == 0
for name in "epr", "truth-a":
	picture = f"{sys.argv[1]}/epr-5/3-dining:triangles=10000:texels=32-3-{name}.png"
	assert os.path.basename(picture) in report["files"]
	assert open(picture, "rb").read() == open(f"{sys.argv[1]}/epr-5-of/{name}.png", "rb").read()
PY
verdict $? 'bench epr-5: look-ups, errors and pictures are those of a render'

run bench epr-costs "${small[@]}" --runs 1 -o "$scratch/costs"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench epr-costs fits 120 columns'
for set in points.cull=off cube.px=512 splat.clip=off seed=0; do
	"$touchstone" render reflections atrium:triangles=10000:texels=32 --reflectors 2 "${small[@]:4}" --set $set \
		--truth=A --method epr --no-images --json > "$scratch/costs-$set" 2> "$scratch/stderr"
done
python3 - "$scratch" <<'PY'
import sys
from results import results
report = results(f"{sys.argv[1]}/costs")
of_two = [r for name, part in report.items() if name.startswith("epr_costs") for r in part if r["mirrors"] == 2]
rows = {k: v for r in of_two for k, v in r.items()}
def of(name):
	render = results(f"{sys.argv[1]}/costs-{name}")
	return {**{c["counter"]: c["epr"] for c in render["counters"]},
	        "rmse": next(m["rmse"] for m in render["metrics"] if m["image"] == "epr")}
whole, unculled, fixed, unclipped = map(of, ("seed=0", "points.cull=off", "cube.px=512", "splat.clip=off"))
assert (rows["points"], rows["unculled_points"]) == (whole["points"], unculled["points"])
assert (rows["texels"], rows["fixed_texels"]) == (whole["cube texels"], fixed["cube texels"])
writes = [r["texel writes"] for r in (whole, fixed, unclipped)]
assert [rows[key] for key in ("writes", "fixed_writes", "unclipped_writes")] == writes
assert rows["empty_more"] == whole["empty look-ups"] - unculled["empty look-ups"]
assert abs(rows["points_saved_percent"] - 100 * (1 - whole["points"] / unculled["points"])) < 1e-6
for more, other in ("cull", unculled), ("resize", fixed), ("clip", unclipped):
	assert abs(rows[more + "_rmse_more"] - (whole["rmse"] - other["rmse"])) < 1e-6
assert len(report["relations"]) == 18
PY
verdict $? 'bench epr-costs: counts and errors are those of renders with the switches'

# What the iVIR paper claims of points holds in every scene. Passes: 17 views in passes of 8 are three.
views=(--set lamp.views=17 --set lamp.views_a_pass=8 --set depth_map.px=64 --set lamp.cubes=2 --set cube.max_px=64
	--set lamp.radius=0.03 --size 64x36 --runs 1)
run bench ivir-1 "${views[@]}" --scene atrium:triangles=10000,gallery:triangles=10000 -o "$scratch/ivir-1"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	grep -q "^iVIR points / VIR's .* at most 1 .* holds" "$scratch/stdout"
verdict $? 'bench ivir-1 fits 120 columns and judges'
python3 - "$scratch/ivir-1" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
here = {name: [r for r in rows if r["source"] == "here"] for name, rows in report.items() if name.startswith("ivir_1")}
assert report["params"]["reflectors.count"] == 0 and report["params"]["density.rate"] == "watertight"
assert len(here["ivir_1_points"]) == 2
for points, work in zip(here["ivir_1_points"], here["ivir_1_work"]):
	assert 0 < points["points_culled"] <= points["points"] <= points["vir_points"]
	assert points["points_culled"] <= points["vir_points_culled"] <= points["vir_points"]
	assert points["points_a_triangle"] >= 1
	assert work["traversed"] == 3 * points["triangles"] and work["mvr_traversed"] == 17 * points["triangles"]
	assert points["points"] <= work["scatters"] <= 17 * points["points"] and work["scatters_culled"] <= work["scatters"]
for row, holes, default, points in zip(here["ivir_1_rmse"], here["ivir_1_holes"], here["ivir_1_default"],
                                       here["ivir_1_points"]):
	assert abs(row["rmse_more"] - (row["rmse_paper"] - row["rmse_mvr"])) < 1e-6 and row["rmse_default"] > 0
	assert abs(row["rmse_more_default"] - (row["rmse_default"] - row["rmse_mvr"])) < 1e-6
	assert 0 < row["ssim_default"] <= 1 and holes["holes"] > holes["holes_default"] >= 0 and holes["covered"] > 0
	assert abs(default["over_paper"] - default["points_default"] / points["points_culled"]) < 1e-6
verdicts = [r["verdict"] for r in report["relations"]]
assert verdicts and all(v == "holds" or v.startswith(("differs: ", "not judged: ")) for v in verdicts)
PY
verdict $? 'bench ivir-1: points, passes over the geometry and scatters are those that iVIR table 1 compares'

run bench ivir-2 "${views[@]}" --scene dining:triangles=10000:texels=32 --objects 2 --set reflectors.px=12 --json
cp "$scratch/stdout" "$scratch/mirrors"
run bench ivir-3 "${views[@]}" --scene dining:triangles=10000:texels=32 --objects 1,2 --json
python3 - "$scratch/mirrors" "$scratch/stdout" <<'PY'
import sys
from results import results
mirrors, lights = (results(path) for path in sys.argv[1:])
rows = mirrors["ivir_2_points"] + [r for r in lights["ivir_3_points"] if r["source"] == "here"]
assert [r.get("mirrors", r.get("lights")) for r in rows] == [2, 1, 2]
for r in rows:
	assert 0 < r["points"] and 0 < r["vir_points"]
	assert abs(r["saved_percent"] - 100 * (1 - r["points"] / r["vir_points"])) < 1e-6
for holes in mirrors["ivir_2_holes"] + [r for r in lights["ivir_3_holes"] if r["source"] == "here"]:
	assert holes["holes"] > holes["holes_default"] >= 0, "the default is watertight, but for culled pieces"
assert rows[0]["saved_percent"] >= 80 and 16 <= rows[0]["largest_face"] <= 64
paper = [r for r in lights["ivir_3_points"] if r["source"] == "paper"]
assert [r["vir_points"] for r in paper] == [14310000] and round(paper[0]["saved_percent"], 1) == 23.5
PY
verdict $? 'bench ivir-2 and ivir-3: points saved, here and in the paper'

# The iVIR paper's figures: the pictures of each row are there, those of `render`, and judged.
figures=(--size 64x36 --set lamp.views=6 --set depth_map.px=32 --set truth.area_samples=16 --set cube.max_px=32
	--threads 2)
hall=dining:triangles=10000:texels=32
figure() {
	run bench "ivir-$1" "${figures[@]}" --scene $hall -o "$scratch/ivir-figure-$1" "${@:2}"
	[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
	verdict $? "bench ivir-$1 fits 120 columns"
}
figure culling
figure 4
figure 5 --objects 3 --runs 1
figure 6 --objects 2
python3 - "$scratch/ivir-figure" <<'PY'
import os, sys
from results import results
wanted = {
	"culling": ("", "ivir-paper", {"ivir-paper-culled", "ivir", "ivir-culled"}, "truth-area"),
	"4": ("", "mvr", {"vir", "ivir-paper", "ivir", "ivir-centre"}, "truth-area"),
	"5": ("-3", "mvr-128", {"pcss", "ivir-paper", "ivir", "ivir-centre", "mvr"}, "truth-area"),
	"6": ("-2", "mvr", {"vir", "ivir-paper", "ivir", "ivir-centre", "ivir-paper-faces", "ivir-faces"}, "truth-c"),
}
for table, (objects, first, others, truth) in wanted.items():
	report = results(f"{sys.argv[1]}-{table}")
	names = {first, truth} | others | {"difference-" + name for name in others}
	found = {name for name in os.listdir(f"{sys.argv[1]}-{table}") if name.endswith(".png")}
	assert found == {f"1-dining:triangles=10000:texels=32{objects}-{name}.png" for name in names}, (table, found)
	assert found <= set(report["files"])
	verdicts = [r["verdict"] for r in report["relations"]]
	assert verdicts and all(v == "holds" or v.startswith(("differs: ", "not judged: ")) for v in verdicts)
def row(table, part):
	return results(f"{sys.argv[1]}-{table}")[part][0]
holes, change = row("culling", "ivir_culling_holes"), row("culling", "ivir_culling")
assert holes["holes_default"] == 0 < holes["holes"] <= holes["holes_culled"] < holes["covered"]
assert change["rmse_culled_default"] <= change["rmse_culled"]
for table in "culling", "4", "5":
	wide = row(table, f"ivir_{table}_penumbra")
	assert abs(wide["penumbra"] / wide["penumbra_narrow"] - 0.1 / 0.02 * 32 / 256) < 1e-5, "by radius and side"
beside, more = row("4", "ivir_4"), row("4", "ivir_4_more")
assert beside["rmse_centre"] < beside["rmse_default"] and more["rmse_more_centre"] < more["rmse_more_default"]
assert row("6", "ivir_6")["rmse_faces"] < row("6", "ivir_6")["rmse_ivir"], "nearer to MVR with its faces"
few = row("5", "ivir_5")
assert few["rmse_128_centre"] < few["rmse_128_default"] and few["rmse_128_mvr"] > 0
PY
verdict $? 'bench ivir-culling, ivir-4, ivir-5 and ivir-6 write their pictures and judge them'
run render soft-shadows $hall --method mvr,ivir --set reflectors.count=0 --set scene.ground=on --set lamp.radius=0.1 \
	"${figures[@]}" -o "$scratch/figure"
cmp -s "$scratch/figure/ivir.png" "$scratch/ivir-figure-4/1-$hall-ivir.png" &&
	cmp -s "$scratch/figure/difference-mvr-ivir.png" "$scratch/ivir-figure-4/1-$hall-difference-ivir.png"
verdict $? 'pictures of bench are those of render'

prints '^Breakfast .* paper  *8,590,000 ' bench epr-3 "${views[@]}" --scene dining:triangles=10000:texels=32 --objects 1

# A plot has a curve of each kind and labels for all points.
plot=(--scene atrium:triangles=10000:texels=32 --objects 1 --size 48x28 --set reflectors.px=16 --runs 1 --truth=A)
run bench epr-6 "${plot[@]}" -o "$scratch/epr-6"
python3 - "$scratch/epr-6" <<'PY'
import csv, sys, xml.etree.ElementTree as xml
from results import found
rows = list(csv.DictReader(open(found(sys.argv[1], "epr_6.csv"))))
svg = xml.parse(found(sys.argv[1], "epr_6.svg")).getroot()
tag = "{http://www.w3.org/2000/svg}"
texts = [t.text for t in svg.iter(tag + "text")]
assert len(list(svg.iter(tag + "circle"))) == len(rows) == 17
assert {r["curve"] for r in rows} <= set(texts)
assert len(list(svg.iter(tag + "polyline"))) == len({r["curve"] for r in rows})
assert "whole frame, ms" in texts and "RMSE to truth A, grey levels" in texts
epr = [int(r["points"]) for r in rows if r["points"]]
assert len(epr) == 11 and epr[:4] == epr[4:8] and epr[8:] == sorted(epr[8:]) and min(epr) > 0
assert all(float(r["ms"]) > 0 and float(r["rmse"]) > 0 for r in rows)
for c in svg.iter(tag + "circle"):
	assert 70 <= float(c.get("cx")) <= 770 and 50 <= float(c.get("cy")) <= 500
PY
verdict $? 'bench epr-6: CSV, and a plot of all its points'
refuses 'needs a truth' bench epr-6 --truth=none
refuses 'one scene' bench epr-6 --scene atrium,gallery

# Rows of sizes. Gathers of direct are pixels by triangles, those of hulls corners by triangles, whatever the size.
run bench ssagh-1 --scene atrium:triangles=10000:texels=32 --objects 96x54,192x108,1280x720 --set rsm.px=2 \
	--set depth_grid.px=64 --runs 1 -o "$scratch/ssagh-1"
[ "$status" -eq 0 ] && grep -q '^Crytek Sponza .* 921,600 .*paper .* 28.3800 .* 142.2600 .* 5.01 ' "$scratch/stdout" &&
	awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench ssagh-1 fits 120 columns and has the paper'
python3 - "$scratch/ssagh-1" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
here = [[r for r in report[part] if r["source"] == "here"] for part in ("ssagh_1", "ssagh_1_gathers")]
assert [r["pixels"] for r in here[0]] == [96 * 54, 192 * 108, 1280 * 720]
for frame, work in zip(*here):
	assert abs(frame["speedup"] - frame["direct_ms"] / frame["hulls_ms"]) < 1e-6
	assert abs(frame["direct_rate"] * frame["direct_ms"] - 1e3) < 1e-4 and frame["hulls_rate"] > 0
	assert abs(frame["direct_ns"] * frame["pixels"] / 1e6 - frame["direct_ms"]) < 1e-6 * frame["direct_ms"]
	assert work["direct_gathers"] == 4 * work["pixels"] and work["hulls_gathers"] == 16 * work["boxes"] > 0
	assert work["rmse"] > 0 and 0 < work["relative_rmse"] != work["relative_rmse_vmf"] > 0
judged = {r["relation"]: (r["here"], r["verdict"]) for r in report["relations"]}
def agrees(relation, values, right):
	value, verdict = judged[relation]
	assert abs(value - values) < 1e-6 * values, (relation, value, values)
	assert verdict.startswith("not judged: ") or (verdict == "holds") == right(values), (relation, verdict)
speed, gathers, cost = ([r[k] for r in part] for part, k in
                        ((here[0], "speedup"), (here[1], "hulls_gathers"), (here[0], "direct_ns")))
agrees("direct / hulls", speed[2], lambda v: v >= 5.01)
agrees("direct / hulls, from size to size", min(b / a for a, b in zip(speed, speed[1:])), lambda v: v >= 1)
agrees("gathers of hulls, most by least", max(gathers) / min(gathers), lambda v: v <= 1.1)
agrees("direct, ns a pixel, most by least", max(cost) / min(cost), lambda v: v <= 1.25)
agrees("gathers of direct by those of hulls", here[1][2]["gathers_ratio"], lambda v: v >= 5.01)
for relation, key in (("PSNR of hulls to direct, dB", "psnr"), ("SSIM of hulls to direct", "ssim")):
	agrees(relation, [r for r in report["ssagh_1_images"] if r["source"] == "here"][2][key],
	       lambda v: v >= (30 if key == "psnr" else 0.9))
assert len(judged) == 9 and all(v == "holds" or v.startswith(("differs: ", "not judged: ")) for _, v in judged.values())
paper = [r for r in report["ssagh_1"] if r["source"] == "paper"]
assert len(paper) == 1 and round(paper[0]["direct_ns"], 1) == 38.2
PY
verdict $? 'bench ssagh-1: gathers, speed-ups and verdicts are those of its rows'

"$touchstone" render indirect atrium:triangles=10000:texels=32 --size 96x54 --set rsm.px=2 --set depth_grid.px=64 \
	--method hulls,direct --truth=none --no-images --trace -o "$scratch/ssagh-1-of" \
	> "$scratch/stdout" 2> "$scratch/stderr"
python3 - "$scratch/ssagh-1" "$scratch/ssagh-1-of" <<'PY'
import sys
from results import results
here = next(r for r in results(sys.argv[1])["ssagh_1_light"] if r["source"] == "here")
shown = [r for r in results(sys.argv[2])["light_errors"] if (r["image"], r["reference"]) == ("hulls", "direct")]
named = [k for k in shown[0] if k not in ("image", "reference")]
assert len(shown) == 1 and len(named) == 6 and all(here[k] == shown[0][k] > 0 for k in named), (here, shown)
PY
verdict $? 'bench ssagh-1: errors near triangles of light and elsewhere are those of a render'
# In doubles: a triangle gives light to the places in front of it that have a corner of it above their horizon.
python3 - "$scratch/ssagh-1" "$scratch/ssagh-1-of" <<'PY'
import glob, struct, sys
from results import results
def buffer(method, name, layout):
	data = open(glob.glob(f"{sys.argv[2]}/trace-{method}/*-{name}.npy")[0], "rb").read()
	return list(struct.iter_unpack(layout, data[10 + struct.unpack_from("<H", data, 8)[0]:]))
def height(n, p, q):
	return sum(a * (b - c) for a, b, c in zip(n, q, p))
triangles = [p for p in buffer("hulls", "rsm.patch", "<12f 16x") if any(p)]
light, right = (buffer(method, "image.radiance", "<3f") for method in ("hulls", "direct"))
unlit, seen = [], []
for pixel, x, t in zip(buffer("hulls", "gbuffer.pixel", "<3ff3f4x3f4x"), light, right):
	p, depth, n, albedo = pixel[:3], pixel[3], pixel[4:7], pixel[7:]
	if depth == 1:
		continue
	seen.append(sum(t))
	lit = any(height(q[9:], q[:3], p) > 0 and max(height(n, p, q[k:k + 3]) for k in (0, 3, 6)) > 0 for q in triangles)
	if not lit and sum(x) > 0:
		unlit.append(sum(x))
here = next(r for r in results(sys.argv[1])["ssagh_1_unlit"] if r["source"] == "here")
mean = 100 * (sum(unlit) / len(unlit)) / (sum(seen) / len(seen))
assert len(unlit) > 10 and here["unlit_pixels"] == len(unlit), (here, mean)
assert abs(here["unlit_percent"] - mean) < 1e-6 * mean, (here, mean)
PY
verdict $? 'bench ssagh-1: light of hulls that no triangle of light gives'

# Figures 3 and 4: errors are those of renders, and what must hold is read off them.
lamps=(dining:triangles=10000:texels=32 --size 96x54 --set depth_grid.px=128 --set lamp.radius=0.3)
for figure in '3 constant' '4 sg'; do
	read -r number cosine <<< "$figure"
	run bench ssagh-$number --scene "${lamps[@]}" -o "$scratch/ssagh-$number"
	[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
		[ "$(grep -c ' holds$' "$scratch/stdout")" -eq 4 ]
	verdict $? "bench ssagh-$number fits 120 columns and holds"
	for integral in ours $cosine; do
		"$touchstone" render area-light "${lamps[@]}" --truth=none --force --set hull.cosine=$integral \
			-o "$scratch/area-$integral" > "$scratch/stdout" 2> "$scratch/stderr"
	done
	python3 - "$scratch" "$number" "$cosine" <<'PY'
import sys
from results import results
scratch, number, cosine = sys.argv[1:]
report = results(f"{scratch}/ssagh-{number}")
here = {k: v for part in (f"ssagh_{number}", f"ssagh_{number}_gained") for r in report[part] if r["source"] == "here"
        for k, v in r.items()}
for who, integral in ("ours", "ours"), ("other", cosine):
	rows = results(f"{scratch}/area-{integral}")["metrics"]
	row = next(r for r in rows if (r["image"], r["reference"]) == ("hulls", "direct"))
	for k in "psnr", "ssim", "relative_rmse":
		assert abs(here[f"{who}_{k}"] - row[k]) < 1e-9 * abs(row[k]), (k, here, row)
assert abs(here["psnr_gain"] - here["ours_psnr"] + here["other_psnr"]) < 1e-9 and here["psnr_gain"] > 3
assert here["ours_dark"] == 0 and (here["other_dark"] > 0) == (cosine == "constant")
judged = {r["relation"]: (r["here"], r["verdict"]) for r in report["relations"]}
assert judged["PSNR of ours above the other's, dB"] == (here["psnr_gain"], "holds") and len(judged) == 4
PY
	verdict $? "bench ssagh-$number: errors are those of renders"
done
refuses 'takes no --runs' bench ssagh-3 --runs 2
# Each picture of ssagh-2 is that of a render with its choice, and differences and verdicts are those of its figures.
one=(atrium:triangles=10000:texels=32 --set rsm.px=2 --set depth_grid.px=64)
run bench ssagh-2 --scene "${one[0]}" "${one[@]:1}" --objects 96x54 -o "$scratch/ssagh-2"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench ssagh-2 fits 120 columns'
for choice in segment.method=none hull.cosine=constant hull.cosine=sg hull.cosine=quadrature hull.cosine=ours; do
	"$touchstone" render indirect "${one[@]}" --set reflectors.count=0 --size 96x54 --set $choice \
		--method hulls,direct --truth=none --no-images --json > "$scratch/$choice" 2> "$scratch/stderr"
done
python3 - "$scratch" <<'PY'
import sys
from results import results
report = results(sys.argv[1] + "/ssagh-2")
row = {k: v for name, rows in report.items() if name.startswith("ssagh_2") for k, v in rows[0].items()}
names = {"segment.method=none": "_grid", "hull.cosine=constant": "_constant", "hull.cosine=sg": "_gaussian",
         "hull.cosine=quadrature": "_quadrature", "hull.cosine=ours": ""}
for choice, name in names.items():
	shown = results(f"{sys.argv[1]}/{choice}")
	metric, light = shown["metrics"][0], shown["light_errors"][0]
	assert (row["psnr" + name], row["ssim" + name]) == (metric["psnr"], metric["ssim"]), (choice, row, metric)
	assert row["elsewhere" + name] == light["relative_rmse_elsewhere"] and row["median" + name] == light["median_error"]
	if name:
		assert abs(row["psnr_over" + name] - row["psnr"] + row["psnr" + name]) < 1e-6
		assert abs(row[name[1:] + "_ratio"] - row["elsewhere" + name] / row["elsewhere"]) < 1e-6
judged = {r["relation"]: (r["here"], r["verdict"]) for r in report["relations"]}
for relation, name in (("grid", "_grid"), ("constant cosine", "_constant"), ("Gaussian cosine", "_gaussian")):
	here, said = judged[relation + ": dB that ours brings"]
	assert here == row["psnr_over" + name] and (said == "holds") == (here >= 0)
	here, said = judged[relation + ": RMSE elsewhere, by ours"]
	assert here == row[name[1:] + "_ratio"] and (said == "holds") == (here >= 1)
assert len(judged) == 8
PY
verdict $? 'bench ssagh-2: pictures are those of renders'
# A model is seen through its own camera, as by render.
run bench ssagh-2 --scene scenes/room.gltf --set depth_grid.px=64 --objects 96x54 --json
cp "$scratch/stdout" "$scratch/own-camera"
for camera in door circle; do
	"$touchstone" render indirect scenes/room.gltf --camera $camera --set depth_grid.px=64 --size 96x54 \
		--method hulls,direct --truth=none --no-images --json > "$scratch/camera-$camera" 2> "$scratch/stderr"
done
python3 - "$scratch" <<'PY'
import sys
from results import results
psnr = {camera: results(f"{sys.argv[1]}/camera-{camera}")["metrics"][0]["psnr"] for camera in ("door", "circle")}
assert results(sys.argv[1] + "/own-camera")["ssagh_2"][0]["psnr"] == psnr["door"] != psnr["circle"]
PY
verdict $? 'bench ssagh-2 sees models through their first camera'
# Flicker is at most the change of hulls, and at least that less the change of direct, as rendered frames have them.
run bench ssagh-flicker --scene "${one[0]}" "${one[@]:1}" --size 96x54 --frames 3..5 --json
cp "$scratch/stdout" "$scratch/flicker"
"$touchstone" render indirect "${one[@]}" --set reflectors.count=0 --size 96x54 --frames 3..5 --method hulls,direct \
	--truth=none -o "$scratch/flicker-frames" > "$scratch/stdout" 2> "$scratch/stderr"
python3 - "$scratch" <<'PY'
import csv, sys
from results import results
lines = list(csv.DictReader(open(sys.argv[1] + "/flicker-frames/sequence.csv")))
hulls, direct = (sum(float(r["change"]) for r in lines if r["image"] == m and r["frame"] != "3") / 2
                 for m in ("hulls", "direct"))
row = results(sys.argv[1] + "/flicker")["ssagh_flicker"][0]
assert abs(row["direct_change"] - direct) < 1e-5, (row, hulls, direct)
assert max(0, hulls - direct) < row["flicker"] < hulls, (row, hulls, direct)
assert abs(row["flicker_percent"] - 100 * row["flicker"] / row["direct_change"]) < 1e-4
PY
verdict $? 'bench ssagh-flicker: change beyond that of direct'

# Labels of a depth image, counted again from traces of both segmentations.
one=(atrium:triangles=10000 --size 96x54 --set depth_grid.px=64)
run bench ssagh-segments --scene "${one[@]:0:1}" "${one[@]:1}" -o "$scratch/segments"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	grep -q '^labels that join components  *0  .* holds$' "$scratch/stdout"
verdict $? 'bench ssagh-segments fits 120 columns'
for segmentation in sweeps components; do
	"$touchstone" render indirect "${one[@]}" --set rsm.px=2 --set segment.method=$segmentation --method hulls \
		--no-images --trace-only segment -o "$scratch/$segmentation" > "$scratch/stdout" 2> "$scratch/stderr"
done
python3 - "$scratch" <<'PY'
import glob, json, struct, sys
from results import results
def blocks(name):
	data = open(glob.glob(f"{sys.argv[1]}/{name}/trace-hulls/*segment.label.npy")[0], "rb").read()
	labels = memoryview(data[10 + struct.unpack_from("<H", data, 8)[0]:]).cast("I")
	return [[labels[(y + j) * 64 + x + i] for j in range(32) for i in range(32)] for y in (0, 32) for x in (0, 32)]
pairs = [(len(set(a)), len(set(b))) for a, b in zip(blocks("sweeps"), blocks("components"))]
rows = {(r["scene"], r["of"]): r for r in results(f"{sys.argv[1]}/segments")["ssagh_segments"]}
for of, of_these in ("all", pairs), ("parted", [p for p in pairs if p[1] > 1]):
	row, n = rows["atrium:triangles=10000", of], len(of_these)
	labels, components = zip(*of_these)
	assert (row["blocks"], row["most_labels"], row["most_components"]) == (n, max(labels), max(components))
	assert abs(row["labels"] - sum(labels) / n) < 1e-6 and abs(row["components"] - sum(components) / n) < 1e-6
	assert abs(row["excess"] - row["labels"] + row["components"]) < 1e-6
	assert row["most_excess"] == max(a - b for a, b in of_these) > 0
	assert row["equal_percent"] == 100 * sum(a == b for a, b in of_these) / n and row["joined"] == 0
PY
verdict $? 'bench ssagh-segments counts what traces have'
refuses 'takes no --runs' bench ssagh-segments --runs 2

# Counts are those of the renders that the table is of, and empty texels those of a trace.
room=scenes/room.gltf
maps=(--set octree.levels=4 --set rsm.px=64 --set vpl_gather.level=2 --size 48x27)
run bench mega-10 --scene "$room" --objects 64,256 "${maps[@]}" --runs 1 -o "$scratch/mega-10"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-10 fits 120 columns'
run render indirect "$room" --method megaviews,manylods --set vpl.paths=256 "${maps[@]}" --no-images --json
cp "$scratch/stdout" "$scratch/mega-render"
run render indirect "$room" --method megaviews --set vpl.paths=256 "${maps[@]}" --no-images --trace \
	--trace-only view_octree,view_map.fuse -o "$scratch/mega-trace"
python3 - "$scratch/mega-10" "$scratch/mega-render" "$scratch/mega-trace/trace-megaviews" <<'PY'
import glob, json, math, struct, sys
from results import results
report, render = (results(path) for path in sys.argv[1:3])
names = ("mega_10", "mega_10_ms", "mega_10_pairs", "mega_10_fates", "mega_10_sharing", "mega_10_mib",
         "mega_10_manylods_mib", "mega_10_queries", "mega_10_views", "mega_10_deep")
rows = [{k: v for name in names for k, v in report[name][i].items()} for i in (0, 1)]
lods = [report["mega_10_manylods_mib"][i] for i in (0, 1)]
ours = [report["mega_10_mib"][i] for i in (0, 1)]
few, many = rows
def near(a, b):
	assert abs(a - b) <= 1e-6 * abs(b), (a, b)
for method, columns in (("megaviews", {"pairs": "pairs", "pairs culled": "culled", "pairs rendered": "rendered",
                         "views served": "served", "pairs wider than a texel": "wider",
                         "of these of several views": "wider_several", "view leaves": "leaves",
                         "scene leaves": "scene_leaves"}), ("manylods", {"pairs": "manylods_pairs"})):
	counted = {c["counter"]: c[method] for c in render["counters"]}
	assert all(counted[name] == many[key] > 0 for name, key in columns.items()), (counted, many)
	sizes = {b["buffer"]: b[method] for b in render["bytes"]}
	mib = ours[1]["maps_mib"] if method == "megaviews" else lods[1]["manylods_maps_mib"]
	near(mib, (sizes["view_map.depth_node"] + sizes["view_map.fused_depth"] + sizes["view_map.fused_node"]) / 2 ** 20)
	near(ours[1]["scene_mib"], sum(n for b, n in sizes.items() if b.split(".")[0] in ("voxel", "octree")) / 2 ** 20)
for r, m, l in zip(rows, ours, lods):
	near(r["speedup"], r["manylods_ms"] / r["megaviews_ms"])
	assert r["bruteforce_pairs"] == r["scene_leaves"] * r["views"]
	near(r["pairs_a_view"], r["pairs"] / r["views"])
	near(r["sharing"], r["served"] / r["rendered"])
	near(r["culled_percent"], 100 * r["culled"] / r["pairs"])
	near(r["pairs_culling_percent"], 100 * (1 - r["pairs"] / r["unculled_pairs"]))
	near(r["wider_percent"], 100 * r["wider"] / r["rendered"])
	near(r["wider_several_percent"], 100 * r["wider_several"] / r["rendered"])
	near(r["views_only_pairs_ratio"], r["views_only_pairs"] / r["pairs"])
	near(r["views_only_brute_ratio"], r["views_only_pairs"] / r["bruteforce_pairs"])
	near(r["descend_ratio"], r["descend_ms"] / r["ask_ms"])
	near(r["fused_ratio"], r["descend_ms"] / (r["fuse_ms"] + r["ask_ms"]))
	assert (r["texels"], r["descend_texels"], r["descend_rmse"]) == (1, 5, 0)
	near(m["mib"], m["scene_mib"] + m["views_mib"] + m["maps_mib"])
	near(l["mib_ratio"], l["manylods_mib"] / m["mib"])
	near(l["manylods_maps_mib"], r["views"] * 2 * 16 * 16 * 16 / 2 ** 20)
	near(r["deep_several_percent"], 100 * r["deep_several"] / r["deep_rendered"])
	assert r["deep_rendered"] > r["rendered"] and r["empty_percent"] < 100 and r["sharing"] > 1
assert (few["views"], many["views"]) == (64, 256) and few["pairs_exponent"] is None
near(many["pairs_exponent"], math.log(many["pairs"] / few["pairs"]) / math.log(4))
near(many["ms_exponent"], math.log(many["megaviews_ms"] / few["megaviews_ms"]) / math.log(4))
def data(name):
	raw = open(glob.glob(f"{sys.argv[3]}/*-{name}.npy")[0], "rb").read()
	return raw[10 + struct.unpack_from("<H", raw, 8)[0]:]
nodes, depths, empty, leaves = data("view_octree.node"), memoryview(data("view_map.fused_depth")).cast("I"), 0, 0
for i in range(len(nodes) // 32):
	if struct.unpack_from("<I", nodes, 32 * i + 20)[0] == 0:
		leaves += 1
		empty += sum(d == 0xffffffff for d in depths[512 * i:512 * i + 512])
assert leaves == many["leaves"]
near(many["empty_percent"], 100 * empty / (512 * leaves))
judged = {(r["relation"], r["paths"]): r["verdict"] for r in report["relations"]}
assert all(v == "holds" or v.startswith(("differs: ", "not judged: ")) for v in judged.values())
assert all(judged["RMSE to the image without culling", paths] == "holds" for paths in (64, 256))
grows = judged["pairs grow slower than views: exponent", 256] == "holds"
assert grows == (many["pairs_exponent"] <= 1) and len(judged) == 18
PY
verdict $? 'bench mega-10: pairs, memory, exponents and empty texels, counted again'
python3 - "$scratch/mega-10" <<'PY'
import csv, sys, xml.etree.ElementTree as xml
from results import found
rows, rest, views = (list(csv.DictReader(open(found(sys.argv[1], name + ".csv"))))
                     for name in ("mega_10", "mega_10_ms", "mega_10_views"))
svg = xml.parse(found(sys.argv[1], "mega_10_1.svg")).getroot()
tag = "{http://www.w3.org/2000/svg}"
texts = [t.text for t in svg.iter(tag + "text")]
dots = [(float(c.get("cx")), float(c.get("cy"))) for c in svg.iter(tag + "circle")]
assert {"MegaViews", "ManyLoDs", "views", "maps, ms"} <= set(texts)
assert len(list(svg.iter(tag + "polyline"))) == 4 and len(dots) == 8 == 4 * len(rows)
assert all(70 <= x <= 770 and 50 <= y <= 500 for x, y in dots) and dots[0][0] < dots[1][0]
ms = [float(r[k]) for k in ("megaviews_ms", "manylods_ms") for r in rows]
ms += [float(r["views_only_ms"]) for r in views] + [float(r["bruteforce_ms"]) for r in rest]
assert sorted(range(8), key=lambda i: ms[i]) == sorted(range(8), key=lambda i: -dots[i][1])
PY
verdict $? 'bench mega-10: CSV, and a plot of a curve a method'

run bench mega-14 --scene "$room" --objects 64 --set octree.levels=4 --set rsm.px=64 --size 48x27 --runs 1 \
	-o "$scratch/mega-14"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-14 fits 120 columns'
python3 - "$scratch/mega-14" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
row = {k: v for part in ("mega_14", "mega_14_psnr", "mega_14_ssim") for k, v in report[part][0].items()}
for few in ("1", "4", "18"):
	assert abs(row["time_" + few] - row["ms_" + few] / row["ms"]) < 1e-6 * row["time_" + few]
	for measure in ("psnr", "ssim"):
		assert abs(row[f"{measure}_more_than_{few}"] - (row[measure] - row[f"{measure}_{few}"])) < 1e-6
judged = [r for r in report["relations"] if r["scene"] == "room.gltf"]
assert len(judged) == 2 * sum(row["time_" + few] >= 0.5 for few in ("1", "4", "18"))
PY
verdict $? 'bench mega-14: differences and times, counted again, and judged where the few are no faster'

# Every wrong answer has one reason.
run bench mega-15 --scene "$room" --objects 4,5 --set rsm.px=64 --set vpl.paths=128 --size 48x27 -o "$scratch/mega-15"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-15 fits 120 columns'
python3 - "$scratch/mega-15" <<'PY'
import sys
from results import results
report = results(sys.argv[1])
answers, pictures = report["mega_15_answers"], report["mega_15"]
assert len(answers) == 2 and all(r["asked"] > 100 for r in answers)
for side in ("16", "64"):
	for answer, why in zip(answers, report["mega_15_why_" + side]):
		shares = [v for k, v in why.items() if k.endswith(side + "_percent")]
		assert len(shares) == 10 and abs(sum(shares) - answer["wrong_" + side + "_percent"]) < 1e-6
for r in pictures:
	assert abs(r["psnr_gain"] - (r["psnr_64"] - r["psnr_16"])) < 1e-6
PY
verdict $? 'bench mega-15: reasons add up to the wrong answers'

# Views of four bounces, and particles: pairs are those of the renders.
run render indirect "$room" --method megaviews,manylods --set vpl.paths=64 --set vpl.bounces=4 "${maps[@]}" \
	--no-images --json
cp "$scratch/stdout" "$scratch/bounces-render"
run render particles "$room" --method megaviews,manylods --set particle.count=256 "${maps[@]}" --no-images --json
cp "$scratch/stdout" "$scratch/particles-render"
run bench mega-10-bounces --scene "$room" --objects 16,64 "${maps[@]}" --runs 1 -o "$scratch/mega-bounces"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-10-bounces fits 120 columns'
run bench mega-particles --scene "$room" --objects 64,256 "${maps[@]}" --runs 1 -o "$scratch/mega-particles"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-particles fits 120 columns'
python3 - "$scratch" <<'PY'
import json, math, sys
from results import results
def near(a, b):
	assert abs(a - b) <= 1e-6 * abs(b), (a, b)
for name, key in ("bounces", "mega_10_bounces"), ("particles", "mega_particles"):
	report = results(f"{sys.argv[1]}/mega-{name}")
	counted = json.load(open(f"{sys.argv[1]}/{name}-render"))
	few, many = ({k: v for part in (key, key + "_pairs", key + "_mib") for k, v in report[part][i].items()}
	             for i in (0, 1))
	pairs = {c["counter"]: c for c in counted["counters"]}["pairs"]
	assert (many["pairs"], many["manylods_pairs"]) == (pairs["megaviews"], pairs["manylods"]) and few["pairs"] > 0
	a, b = (r["views"] if name == "bounces" else r["particles"] for r in (few, many))
	assert 16 < a <= 64 and 64 < b <= 256
	near(many["pairs_ratio"], many["manylods_pairs"] / many["pairs"])
	near(many["pairs_exponent"], math.log(many["pairs"] / few["pairs"]) / math.log(b / a))
	near(many["maps_ratio"], many["manylods_maps_mib"] / many["maps_mib"])
	near(many["manylods_maps_mib"], b * 2 * 16 * 16 * 16 / 2 ** 20)
	judged = {r["relation"]: r["verdict"] for r in report["relations"]}
	assert len(judged) == (3 if name == "particles" else 2)
	assert all(v == "holds" or v.startswith(("differs: ", "not judged: ")) for v in judged.values())
	assert 0 < many["empty_percent"] < 100
PY
verdict $? 'bench mega-10-bounces and mega-particles: pairs, maps and exponents, counted again'

# Views at random: pairs are those of the renders.
run render indirect "$room" --method megaviews --set vpl.paths=64 --set vpl.place=random "${maps[@]}" --no-images --json
cp "$scratch/stdout" "$scratch/random-render"
run bench mega-11 --scene "$room" --objects 16,64 "${maps[@]}" --runs 1 -o "$scratch/mega-11"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench mega-11 fits 120 columns'
python3 - "$scratch/mega-11" "$scratch/random-render" <<'PY'
import json, math, sys
from results import results
def near(a, b):
	assert abs(a - b) <= 1e-6 * abs(b), (a, b)
report = results(sys.argv[1])
counted = {c["counter"]: c["megaviews"] for c in json.load(open(sys.argv[2]))["counters"]}
few, many = ({k: v for part in ("", "_light", "_bounces", "_random") for k, v in report["mega_11" + part][i].items()}
             for i in (0, 1))
assert (many["pairs_random"], many["views_random"]) == (counted["pairs"], counted["virtual point lights"])
assert many["views"] == 64 and 64 < many["views_4"] <= 256 and 32 < many["views_random"] <= 64
near(many["pairs_ratio"], many["pairs_random"] / many["pairs"])
near(many["sharing_random"], counted["views served"] / counted["pairs rendered"])
near(many["pairs_exponent_random"],
     math.log(many["pairs_random"] / few["pairs_random"]) / math.log(many["views_random"] / few["views_random"]))
assert 5 < many["psnr"] < 100 and few["pairs_exponent"] is None
judged = {r["relation"]: r["verdict"] for r in report["relations"]}
assert len(judged) == 3 and all(v == "holds" or v.startswith("differs: ") for v in judged.values()), judged
PY
verdict $? 'bench mega-11: pairs, views and exponents, counted again'

run bench mega-12 --scene "$room" --objects 8,16 --set vpl.paths=64 "${maps[@]}" --runs 1 --json
cp "$scratch/stdout" "$scratch/mega-12"
run bench mega-13 --scene "$room" --objects 3,4 --set vpl.paths=64 "${maps[@]}" --runs 1 --json
cp "$scratch/stdout" "$scratch/mega-13"
run bench mega-16 --scene "$room" --objects 1,4 --set vpl.paths=64 --set octree.levels=4 --set rsm.px=64 --size 48x27 \
	-o "$scratch/mega-16"
python3 - "$scratch/mega-12" "$scratch/mega-13" "$scratch/mega-16" <<'PY'
import math, sys
from results import results
sides, levels, gather = (results(path) for path in sys.argv[1:])
def near(a, b):
	assert abs(a - b) <= 1e-6 * abs(b), (a, b)
def here(report, name):
	return [r for r in report[name] if r["source"] == "here"]
a, b = here(sides, "mega_12_pairs")
near(b["pairs_exponent"], math.log2(b["pairs"] / a["pairs"]))
near(b["sharing_exponent"], math.log2(b["sharing"] / a["sharing"]))
a, b = here(sides, "mega_12_mib")
near(b["manylods_maps_mib"], 64 * 2 * (16 * 16 * 16 + 8 * (64 + 16 + 4 + 1)) / 2 ** 20)
a, b = (dict(x, **y) for x, y in zip(here(levels, "mega_13"), here(levels, "mega_13_pairs")))
assert (a["levels"], b["levels"]) == (3, 4) and 0 < a["leaves"] < b["leaves"]
near(b["pairs_exponent"], math.log(b["pairs"] / a["pairs"]) / math.log(b["leaves"] / a["leaves"]))
near(b["ms_exponent"], math.log(b["megaviews_ms"] / a["megaviews_ms"]) / math.log(b["leaves"] / a["leaves"]))
a, b = here(gather, "mega_16")
assert b["pairs"] > b["culled"] > 0 == a["culled"] and a["noise"] > 0
near(b["culled_percent"], 100 * b["culled"] / b["pairs"])
near(b["noise_ratio"], b["noise"] / b["unculled_noise"])
assert a["unculled_noise"] == b["unculled_noise"] and b["noise"] != b["unculled_noise"]
for report in (sides, levels, gather):
	assert all(r["verdict"] == "holds" or r["verdict"].startswith(("differs: ", "not judged: "))
	           for r in report["relations"])
PY
verdict $? 'bench mega-12, mega-13 and mega-16: exponents, maps and culled pairs, counted again'
refuses 'mega-10: takes no --truth' bench mega-10 --truth=vpls
refuses '16777216' bench mega-10 --objects 16777217

# Fragments and pixels of renders and of a trace; a scene of triangles is sampled.
grid=(checkerboard:surfels=20000 --size 64x36)
# Shading operations and PSNRs are those of renders; each row is said as it comes.
run bench nv40-shading --scene "${grid[0]}" --objects 64x36,240x135 --set truth.grid_rays=2 --threads 2 \
	-o "$scratch/shading"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	[ "$(grep -c '^touchstone: checkerboard:surfels=20000, pixels [0-9]*, overlap ' "$scratch/stderr")" -eq 2 ]
verdict $? 'bench nv40-shading fits 120 columns and says its rows'
run render surfels "${grid[0]}" --size 240x135 --method flat,gouraud,phong,deferred --truth=surface \
	--set truth.grid_rays=2 --set eye.distance=outside --no-images --json
python3 - "$scratch" <<'PY'
import json, sys
from results import results
report, render = results(sys.argv[1] + "/shading"), json.load(open(sys.argv[1] + "/stdout"))
part = lambda name: [r for r in report[name] if r["source"] == "here"][1]
counters = {c["counter"]: c for c in render["counters"]}
psnr = {m["image"]: m["psnr"] for m in render["metrics"] if m["reference"] == "truth-surface"}
ops, dB = part("nv40_shading"), part("nv40_shading_psnr")
shaded = counters["shading operations"]
for method in "flat", "gouraud", "phong", "deferred":
	assert abs(ops[method + "_a_pixel"] - shaded[method] / shaded["deferred"]) < 1e-6
	assert abs(dB[method + "_psnr"] - psnr[method]) < 1e-6, (method, dB, psnr)
assert shaded["phong"] == counters["fragments"]["deferred"] > 5 * shaded["deferred"]
assert shaded["flat"] == shaded["gouraud"] == counters["surfels drawn"]["flat"]
PY
verdict $? 'bench nv40-shading has the operations and the errors of renders'
run bench nv40 --scene "${grid[0]},scenes/room.gltf" --objects 64x36,240x135 --set depth_map.px=64 --threads 2 \
	--runs 1 -o "$scratch/nv40"
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	grep -q '^slides .* 32,400  *paper .* 22.80 *21.30 *15.70 *15.00$' "$scratch/stdout"
verdict $? 'bench nv40 fits 120 columns and has the slides'
for filter in min object; do
	run render surfels "${grid[@]}" --method deferred --set ewa.filter=$filter --no-images --json --trace \
		--trace-only surfel_blend -o "$scratch/nv40-$filter"
	cp "$scratch/stdout" "$scratch/nv40-$filter.json"
done
python3 - "$scratch" <<'PY'
import glob, json, struct, sys
from results import results
report = results(sys.argv[1] + "/nv40")
parts = [[r for r in rows if r["source"] == "here"] for name, rows in report.items() if name.startswith("nv40")]
grid, room = ({k: v for part in parts for k, v in part[i].items()} for i in (0, 2))
assert (grid["scene"], grid["surfels"]) == ("checkerboard:surfels=20000", 19600) and room["surfels"] > 250000
def near(a, b):
	assert abs(a - b) <= 1e-6 * abs(b), (a, b)
for row in grid, room:
	rates = [row[s + f] for s in ("phong", "npr", "phong_shadow", "npr_shadow")
	         for f in ("", "_object", "_alone", "_object_alone")]
	assert min(rates) > 0 and len(set(rates)) == 16
	near(row["npr_ratio"], row["npr"] / row["phong"])
	near(row["npr_shadow_ratio"], row["npr_shadow"] / row["phong_shadow"])
	near(row["shadow_ratio"], row["phong_shadow"] / row["phong"])
	near(row["filter_ratio"], row["phong"] / row["phong_object"])
	near(row["threads_ratio"], row["phong"] / row["phong_alone"])
	near(row["overlap_ratio"], row["overlap"] / row["overlap_object"])
for filter, end in ("min", ""), ("object", "_object"):
	counters = json.load(open(f"{sys.argv[1]}/nv40-{filter}.json"))["counters"]
	counted = {c["counter"]: c["deferred"] for c in counters}
	raw = open(glob.glob(f"{sys.argv[1]}/nv40-{filter}/*/*-surfel_blend.heaviest.npy")[0], "rb").read()
	keys = memoryview(raw[10 + struct.unpack_from("<H", raw, 8)[0]:]).cast("Q")
	pixels = sum(k != 2 ** 64 - 1 for k in keys)
	assert grid["covered" + end] == pixels == counted["shading operations"] == grid["shaded" + end]
	near(grid["overlap" + end], counted["fragments"] / pixels)
	assert grid["shaded_a_pixel" + end] == 1
assert grid["overlap_object"] < grid["overlap"] < room["overlap"]
assert len(report["relations"]) >= 21
assert all(r["verdict"] == "holds" or r["verdict"].startswith(("differs: ", "not judged: "))
           for r in report["relations"])
asked = [r for r in report["relations"] if r["relation"].startswith("fragments a pixel, of 10 to 20 surfels")]
dense = [r for r in report["nv40_fragments"] if r["source"] == "here" and 10 <= r["surfels_a_pixel"] <= 20]
assert [r["here"] for r in asked] == [r["overlap"] for r in dense] and len(dense) > 0
paper = [r for r in report["nv40_ratios"] if r["source"] == "paper"]
assert len(paper) == 1 and round(paper[0]["npr_ratio"], 2) == 0.93
PY
verdict $? 'bench nv40: rates, ratios, fragments and pixels, counted again'

finish
