#!/bin/bash
# The papers' tables: our figures, and the paper's below them. The backends' tables: with and without a device.
. "$(dirname "$0")/tap.bash"
small=(--scene atrium:triangles=10000 --objects 1,2 --size 96x54 --set reflector_px=30 --set face_max=64)

prints '^96 x 54 pixels' bench epr-1 "${small[@]}"
prints '^Sponza .*paper .*1,510,000' bench epr-1 "${small[@]}"
prints '^Sponza .*paper .*603,000' bench epr-2 "${small[@]}" --runs 1 --truth=A
run bench epr-1 "${small[@]}" --threads 2 --json
python3 - "$scratch/stdout" <<'PY'
import json, sys
report = json.load(open(sys.argv[1]))
assert report["params"]["width"] == 96 and report["params"]["height"] == 54 and report["threads"] == 2
assert report["program"] == "touchstone" and report["version"] and report["backend"] == "c"
rows = [r for r in report["epr_1"] if r["source"] == "here"]
for r in rows:
	assert r["epr_ops"] > 0 and 0 < r["mvr_ops"] <= 6 * 64 * 64 * r["mirrors"]
	assert abs(r["ratio"] - r["mvr_ops"] / r["epr_ops"]) < 1e-6
PY
verdict $? 'the ratio is that of the operations, and it says how it was run'
run bench epr-2 "${small[@]}" --runs 2 --truth=none --json
python3 - "$scratch/stdout" <<'PY'
import json, sys
rows = [r for r in json.load(open(sys.argv[1]))["epr_2"] if r["source"] == "here"]
assert [r["mirrors"] for r in rows] == [1, 2]
for r in rows:
	parts = r["point_ms"] + r["view_ms"] + r["deferred_ms"]
	assert r["triangles"] >= 10000 and r["points"] > 0 and r["rmse_difference"] is None
	assert parts > 0 and r["total_ms"] > 0
PY
verdict $? 'bench --json has a row for each number of mirrors'

frame=(--scene atrium:triangles=10000 --objects 2 "${small[@]:4}")
prints '^c  *[0-9.]*  *[0-9.]*  *[0-9.]*$' bench start "${frame[@]}" --runs 2

# Of this machine's devices, if there are any. What is counted is the same in every column, so rates go by the times.
mkdir "$scratch/tmp"
TMPDIR=$scratch/tmp run bench backends "${frame[@]}" --runs 1 --threads 2 --json
python3 - "$scratch/stdout" "$status" <<'PY'
import json, sys
assert sys.argv[2] == "0"
report = json.load(open(sys.argv[1]))
assert report["method"] == "epr" and report["mirrors"] == 2 and report["runs"] == 1 and report["scene"].startswith("atrium")
names = [row["column"] for row in report["columns"]]
devices = names[2:]
assert names[:2] == ["c1", "c2"] and all(row["device"] and row["compiler"] and row["flags"] for row in report["columns"])
assert devices or any("no opencl device" in note or "left out" in note for note in report["notes"]), report["notes"]
times = {row["stage"]: row for row in report["milliseconds"]}
stages = [row["stage"] for row in report["milliseconds"]]
assert stages[0] == "view" and stages[-2:] == ["image", "all"] and "splat" in stages

def close(a, b):
	return abs(a - b) <= 1e-6 * abs(b)

for row in times.values():
	assert set(row) == {"stage", *names, *(name + "_ratio" for name in devices)}
	assert all(close(row[name + "_ratio"], row[name] / row["c2"]) for name in devices)
rates = {row["rate"]: row for row in report["millions_a_second"]}
for name in names:
	assert close(sum(times[stage][name] for stage in stages[:-1]), times["all"][name])
	assert all(row[name] > 0 for row in rates.values())
splat = [row for row in rates.values() if row["rate"].startswith("splat: ")]
assert len(splat) == 3 and len(rates) == 6
assert all(close(row[name] * times["splat"][name], row["c1"] * times["splat"]["c1"]) for row in splat for name in names)
builds = report.get("kernel_build", [])
assert {row["column"] for row in builds} == set(devices)
assert all(min(row["open_s"], row["first_s"], row["next_s"]) > 0 for row in builds)
for empty, filled in zip(builds, builds[1:]):
	if empty["cache"] == "empty":
		assert filled["cache"] == "filled" and empty["column"] == filled["column"]
		assert empty["open_s"] + empty["first_s"] > filled["open_s"] + filled["first_s"]
PY
verdict $? 'bench backends --json: ratios and sums are those of the columns, rates go by the times'
[ -z "$(ls "$scratch/tmp")" ]
verdict $? 'an empty kernel cache leaves nothing behind'

OCL_ICD_VENDORS=/nonexistent run bench backends "${frame[@]}" --runs 1 --method mvr
[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout" &&
	grep -q '^time, ms .* c1 ' "$scratch/stdout" && grep -q '^face ' "$scratch/stdout" && ! grep -q '^splat' "$scratch/stdout"
verdict $? 'bench backends fits 120 columns, of MVR too'

# Without any driver.
OCL_ICD_VENDORS=/nonexistent run bench backends "${frame[@]}" --runs 1 --threads 1
[ "$status" -eq 0 ] && grep -q '^no opencl device' "$scratch/stdout" && grep -q '^time, ms *c1$' "$scratch/stdout" &&
	grep -q '^all  *[0-9.]*$' "$scratch/stdout" && ! grep -q 'Kernel build' "$scratch/stdout"
verdict $? 'bench backends without a device: the C columns, and a line that says so'
OCL_ICD_VENDORS=/nonexistent run bench backends "${frame[@]}" --runs 1 --device 0
[ "$status" -eq 77 ] && grep -q 'no OpenCL device' "$scratch/stderr"
verdict $? 'bench backends of a device that is not there is skipped'
OCL_ICD_VENDORS=/nonexistent refuses 'no device can be measured' bench backends "${frame[@]}" --require

finish
