#!/bin/bash
# The backends' tables, with and without a device.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/opencl.bash"
frame=(--scene atrium:triangles=10000:texels=32 --objects 2 --size 96x54 --set reflectors.px=30 --set cube.max_px=64)
prints '^c  *[0-9.]*  *[0-9.]*  *[0-9.]*$' bench start "${frame[@]}" --runs 1

# Of this machine's devices, if there are any, by the method with the fewer kernels to build. What is counted is the
# same in every column, so rates go by the times.
mkdir "$scratch/tmp"
OCL_ICD_VENDORS=/nonexistent run bench backends "${frame[@]}" --runs 1 --threads 2 --json
cp "$scratch/stdout" "$scratch/epr"
TMPDIR=$scratch/tmp run bench backends "${frame[@]}" --method mvr --runs 1 --threads 2 --json
cp "$scratch/stdout" "$scratch/mvr"
backends() {
	python3 - "$scratch/$1" "$@" <<'PY'
import json, sys
report, method, stage, splats = json.load(open(sys.argv[1])), sys.argv[2], sys.argv[3], int(sys.argv[4])
assert report["method"] == method and report["mirrors"] == 2 and report["runs"] == 1
assert report["scene"].startswith("atrium")
names = [row["column"] for row in report["columns"]]
devices = names[2:]
assert names[:2] == ["c1", "c2"]
assert all(row["device"] and row["compiler"] and row["flags"] for row in report["columns"])
assert devices or any("no OpenCL device" in note or "left out" in note for note in report["notes"]), report["notes"]
times = {row["stage"]: row for row in report["milliseconds"]}
stages = [row["stage"] for row in report["milliseconds"]]
assert stages[0] == "eye.view" and stages[-2:] == ["image", "all"] and stage in stages

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
assert len(splat) == splats and len(rates) == splats + 3
assert all(close(row[name] * times["splat"][name], row["c1"] * times["splat"]["c1"]) for row in splat for name in names)
builds = report.get("kernel_build", [])
assert {row["column"] for row in builds} == set(devices)
assert all(min(row["open_s"], row["first_s"], row["next_s"]) > 0 for row in builds)
for empty, filled in zip(builds, builds[1:]):
	if empty["cache"] == "empty":
		assert filled["cache"] == "filled" and empty["column"] == filled["column"]
		assert empty["open_s"] + empty["first_s"] > filled["open_s"] + filled["first_s"]
PY
	verdict $? "bench backends --json, $1: ratios and sums are those of the columns, rates go by the times"
}
backends epr splat 3
backends mvr cube_face 0
[ -z "$(ls "$scratch/tmp")" ]
verdict $? 'an empty kernel cache leaves nothing behind'

# Without any driver.
without_device() { OCL_ICD_VENDORS=/nonexistent VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent "$@"; }
without_device run bench backends "${frame[@]}" --runs 1 --threads 1
[ "$status" -eq 0 ] && grep -q '^backend opencl: no OpenCL device' "$scratch/stdout" &&
	grep -q '^time, ms *c1$' "$scratch/stdout" &&
	grep -q '^all  *[0-9.]*$' "$scratch/stdout" && ! grep -q 'Kernel build' "$scratch/stdout" &&
	awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
verdict $? 'bench backends without a device: the C columns in 120 columns of text, and a line that says so'
without_device run bench backends "${frame[@]}" --runs 1 --device 0
[ "$status" -eq 77 ] && grep -q 'no OpenCL device' "$scratch/stderr"
verdict $? 'bench backends of a device that is not there is skipped'
without_device refuses 'no device can be measured' bench backends "${frame[@]}" --require

# A frame that llvmpipe's limit of loops cuts short.
if grep -q llvmpipe <("$touchstone" list backends); then
	cut=(bench backends --scene atrium:triangles=10000:texels=32 --objects 1 --size 480x270 --method mvr --runs 1
		--threads 1)
	OCL_ICD_VENDORS=/nonexistent run "${cut[@]}"
	[ "$status" -eq 0 ] && grep -q '^vulkan0: left out: stage eye: .* ended a loop of eye early' "$scratch/stdout" &&
		grep -q '^time, ms *c1$' "$scratch/stdout"
	verdict $? 'a device that cannot run the frame is left out'
	OCL_ICD_VENDORS=/nonexistent refuses 'ended a loop of eye early' "${cut[@]}" --require
fi

finish
