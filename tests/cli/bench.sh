#!/bin/bash
# The papers' tables: our figures, and the paper's below them.
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

finish
