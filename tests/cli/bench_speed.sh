#!/bin/bash
# `bench speed`, of small frames on a machine that may be busy: what it measures, judges and refuses.
. "$(dirname "$0")/tap.bash"
small=(--busy --runs 2 --threads 2 --size 96x54 --set reflectors.count=2 --set cube.px=16)
run bench speed "${small[@]}" --scene A300 --json
cp "$scratch/stdout" "$scratch/frames"
run bench speed "${small[@]}" --scene pixels --objects 64x36,128x72,256x144 --method mvr --json
cp "$scratch/stdout" "$scratch/growth"
python3 - "$scratch/frames" "$scratch/growth" <<'PY'
import json, math, sys
frames, growth = (json.load(open(path)) for path in sys.argv[1:])

def close(a, b):
	return abs(a - b) <= 1e-6 * abs(b)

assert frames["machine"] and frames["quiet"]["busy"] is True and frames["busy_rows"] >= 0
assert all(row["here"] > 0 and row["state"] == "busy" for row in frames["limits"]) and len(frames["limits"]) == 4
stages = {}
for row in frames["stages"]:
	stages.setdefault(row["frame"], {})[row["stage"]] = row
assert set(stages) == {"A300 by epr", "A300 by mvr"}
for rows in stages.values():
	parts = [row for name, row in rows.items() if name != "all"]
	assert all(row["ms"] >= 0 and row["spread"] >= 0 and row["state"] == "busy" for row in parts)
	assert 90 < sum(row["share"] for row in parts) < 110
assert stages["A300 by epr"]["splat"]["mb"] > 0 and "cube_face" not in stages["A300 by epr"]
assert "growth" not in frames
assert all(row["verdict"] in ("", "not judged: busy") for row in frames["figures"])
assert [row["value"] for row in growth["growth"] if row["what"] == "frame"] == [64 * 36, 128 * 72, 256 * 144]
assert {row["method"] for row in growth["growth"]} == {"mvr"} and "stages" not in growth
law = next(row for row in growth["exponents"] if row["what"] == "frame")
times = [row for row in growth["growth"] if row["what"] == "frame"]
assert close(times[1]["exponent"], math.log(times[1]["ms"] / times[0]["ms"]) / math.log(4))
assert close(law["steepest"], max(row["exponent"] for row in times[1:]))
x, y = ([math.log(row[key]) for row in times] for key in ("value", "ms"))
mx, my = sum(x) / 3, sum(y) / 3
assert close(law["exponent"], sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x))
PY
verdict $? 'stages, limits, figures and exponents are those of the times'
refuses 'nothing of that name is measured; the nearest is A300' bench speed --scene A30
refuses 'no frame is measured by it' bench speed --method eprr
refuses 'the values of one growth' bench speed --objects 3
refuses 'takes no --busy' bench start --busy
refuses 'takes no --truth' bench speed --truth=A
finish
