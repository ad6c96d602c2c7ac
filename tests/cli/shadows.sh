#!/bin/bash
# Renders of shadows: truths, tables, pictures, and what is refused.
. "$(dirname "$0")/tap.bash"
small=(atrium:triangles=10000:texels=32 --size 96x54 --set depth_map.px=64 --set lamp.views=4 --set lamp.views_a_pass=3
	--set lamp.cubes=2 --set truth.area_samples=16)
cd "$scratch" || exit 2

run render soft-shadows "${small[@]}" --method ivir,mvr --truth -o soft
[ "$status" -eq 0 ] && ! grep -qi 'mirror\|reflective\|refl\.\|cube' stdout && grep -q 'in penumbra' stdout
verdict $? 'tables of shadows say nothing of mirrors'

missing=0
for file in ivir.png mvr.exr truth-samples.png truth-area.exr difference-ivir-truth-samples.png \
	difference-mvr-truth-area.exr difference-truth-samples-truth-area.png ivir-depth.png mvr-lit.png report.json; do
	[ -s "soft/$file" ] || { missing=1; echo "# no $file"; }
done
verdict $missing 'every picture is there'

cp soft/report.json one.json
run render soft-shadows "${small[@]}" --method ivir,mvr --truth --no-images --threads 1 --json
python3 - one.json stdout <<'PY'
import json, sys
a, b = (json.load(open(f)) for f in sys.argv[1:])
for key in "counters", "bytes", "shadows", "metrics":
	assert a[key] == b[key], key
rows = {r["image"]: r for r in a["shadows"]}
assert [rows[n]["samples"] for n in ("ivir", "mvr", "truth-samples", "truth-area")] == [4, 4, 4, 16]
for r in rows.values():
	assert r["full"] + r["part"] + r["none"] == r["pixels"] > 0
shares = {(r["image"], r["reference"]): r["share"] for r in a["metrics"]}
assert shares["ivir", "truth-samples"] == "method" and shares["truth-samples", "truth-area"] == "sampling"
assert not any("reflective_rmse" in r for r in a["metrics"])
counters = {r["counter"]: r for r in a["counters"]}
covered = counters["texels covered by rays"]
assert 0 < covered["ivir"] == covered["mvr"] <= 4 * 64 * 64
assert counters["wrong depths"]["mvr"] < covered["mvr"] / 50
assert a["params"]["reflectors.count"] == 0
PY
verdict $? 'threads change no figure, and the figures agree'

run render omni-shadows "${small[@]}" --method ivir --set points.cull=off --truth=samples --no-images --json \
	--reflectors 1
python3 - stdout <<'PY'
import json, sys
a = json.load(open(sys.argv[1]))
counters = {r["counter"]: r["ivir"] for r in a["counters"]}
assert counters["texels covered by rays"] > 1000 and counters["holes"] == counters["leaks"] == 0
assert [r["image"] for r in a["shadows"]] == ["ivir", "truth-samples"] and a["params"]["reflectors.count"] == 1
PY
verdict $? 'cubes without culling have neither holes nor leaks'

run render soft-shadows "${small[@]}" --method mvr --truth=samples --set depth_map.bias=1,8
[ "$status" -eq 0 ] && [ "$(wc -l < stdout)" -eq 3 ] &&
	head -1 stdout | grep -q 'wrong_depths,rmse_truth-samples,ssim_truth-samples$' &&
	! head -1 stdout | grep -q reflective
verdict $? 'a sweep prints the truths of shadows'

refuses 'of soft-shadows; there are samples and area' render soft-shadows --truth=samples,A
refuses 'of reflections; there are A, B and C' render reflections --truth=area
refuses 'of reflections' bench epr-2 --truth=area
refuses 'write --truth=samples,area' render omni-shadows --truth samples,area
refuses 'there are samples and area, or none' render omni-shadows --truth=sample
refuses 'memory' render omni-shadows atrium:triangles=10000:texels=32 --set depth_map.px=8192 \
	--set lamp.views_a_pass=1024 --set lamp.cubes=1024 --method mvr --no-images
finish
