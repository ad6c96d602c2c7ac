#!/bin/bash
# Truths by a limited number of rays: their figures are the whole truths', within the error that they state.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
shadows=(--size 96x54 --set depth_map.px=64 --set lamp.views=16 --set lamp.cubes=4 --set truth.area_samples=64)
light=(--size 64x36 --set truth.bounce_rays=64 --set octree.levels=5 --set rsm.px=8)

# RAYS EFFECT SCENE METHOD OPTION...
judge() {
	local rays=$1 effect=$2 scene=$3 method=$4
	shift 4
	for seed in 0 1 2 3; do
		run render "$effect" "$scene" --method "$method" --truth=all "$@" --set seed=$seed --no-images --json
		mv stdout "whole-$seed.json"
		run render "$effect" "$scene" --method "$method" --truth=all "$@" --set truth.rays=$rays --set seed=$seed \
			--no-images --json
		mv stdout "part-$seed.json"
	done
	python3 - <<'PY'
import json
n = 0
for seed in range(4):
	whole, part = (json.load(open(f"{f}-{seed}.json")) for f in ("whole", "part"))
	rows = {(m["image"], m["reference"]): m for m in whole["metrics"]}
	assert "truth_parts" not in whole and not any("rmse_error" in m for m in whole["metrics"])
	assert any(t["samples"] < t["of"] for t in part["truth_parts"])
	for m in part["metrics"]:
		for key in "rmse", "reflective_rmse":
			if not m.get(key + "_error"): continue
			exact = rows[m["image"], m["reference"]][key]
			n += 1
			assert abs(m[key] - exact) < 4 * m[key + "_error"] + 0.002 * exact, (m, exact)
			assert m["ssim"] is None
assert n >= 4
PY
	verdict $? "$effect in $scene: parts agree with the whole"
}
judge 120000 soft-shadows gallery:triangles=10000:texels=32 mvr "${shadows[@]}"
judge 120000 soft-shadows dining:triangles=10000:texels=32 mvr "${shadows[@]}"
judge 120000 omni-shadows atrium:triangles=10000:texels=32 mvr "${shadows[@]}"
judge 120000 indirect dining:triangles=10000:texels=32 direct "${light[@]}"
judge 120000 area-light gallery:triangles=10000:texels=32 direct --size 64x36 --set truth.area_samples=256 \
	--set lamp.radius=0.3
judge 60000 surfels gallery:triangles=10000:texels=32 deferred --from-mesh 20000 --size 96x54

part=(soft-shadows gallery:triangles=10000:texels=32 --method mvr "${shadows[@]}" --truth --set truth.rays=60000)
run render "${part[@]}" -o one --threads 1
run render "${part[@]}" -o two --threads 2
rm -f one/times* two/times*
sed -i /\"threads\"/d one/report.json two/report.json
[ "$status" -eq 0 ] && diff -r one two > /dev/null
verdict $? 'two runs by whatever threads write the same'
grep -q 'Truths in part' stdout && grep -q 'texels a ray' stdout
verdict $? 'the table says what was asked'

run render reflections dining:triangles=10000:texels=32 --size 96x54 --method epr --truth --set truth.rays=60000 \
	--no-images
[ "$status" -eq 0 ] && grep -q '^truth C: left out' stdout && grep -q 'truth-b' stdout && ! grep -q 'truth-c' stdout
verdict $? 'what cannot be made in part is left out, with a line'
refuses 'bench ivir-3: truth.rays=60: tables judge by whole truths; leave it out' bench ivir-3 --set truth.rays=60
run render "${part[@]/60000/1}" --no-images
[ "$status" -eq 0 ] && grep -q '^texels a ray  *65,536$' stdout
verdict $? 'a limit of one ray asks one texel of all'

run render "${part[@]}" --set lamp.views=8,16 -o sweep
head -1 sweep/sweep.csv | grep -q 'rmse_error_truth-area'
verdict $? 'a sweep has the errors'
finish
