#!/bin/bash
# The JSON reports of compare, golden check, merge and vectors --check are as their schemas say, and the first
# divergence has the fields that its line tells.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
here=$PWD/tests/cli
cd "$scratch" || exit 2
export OMP_WAIT_POLICY=passive

# suits SCHEMA NAME REPORT...
suits() {
	local schema=$1 name=$2
	shift 2
	/usr/bin/python3 "$here/schemas.py" "$here/$schema.schema.json" "$@" > faults
	local result=$?
	[ $result -eq 0 ] || cat faults
	verdict $result "$name"
}
# wrong FILE OFFSET: another byte, counted from the end.
wrong() {
	/usr/bin/python3 - "$@" <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[-int(sys.argv[2])] ^= 1
open(sys.argv[1], "wb").write(data)
PY
}
# keep NAME ARGUMENT...: what the command prints, as NAME.json.
keep() {
	local name=$1
	shift
	run "$@" --json
	mv stdout "$name.json"
}

run "${frame[@]:0:${#frame[@]}-1}" --method epr --trace -o r
python3 - <<'PY'
import ast, json, struct
trace = json.load(open("r/trace-epr/trace.json"))
for buffer in trace["buffers"]:
	if buffer["file"] is None: continue
	head = open("r/trace-epr/" + buffer["file"], "rb").read(512)
	size, = struct.unpack_from("<H", head, 8)
	assert list(ast.literal_eval(head[10:10 + size].decode())["shape"]) == buffer["shape"], buffer
points = next(buffer for buffer in trace["buffers"] if buffer["name"] == "points.key")
assert trace["counters"]["points"] == points["shape"][0] > 0
PY
verdict $? 'trace.json says the shapes that the files have, and what was counted'
cp -r r/trace-epr c
keep same compare r/trace-epr c
wrong c/05-mirror_pixel.record.npy 24
wrong c/*-image.srgb.npy 40
wrong c/10-points.offset.npy 8
keep different compare r/trace-epr c --first 3
keep forced compare r/trace-epr c --forced --first 2 -o pictures
cp pictures/report.json folder.json
for i in 1 2; do run compare r/trace-epr c --shard $i/2 -o s-$i; done
cp s-1/report.json shard.json
keep merged merge s-1 s-2
suits compare 'compare of traces' same.json different.json folder.json forced.json shard.json merged.json
suits compare 'and a shard of that' merged.json shard.json
suits compare 'and what differs' shard.json different.json
/usr/bin/python3 - <<'PY'
import json, struct
report = json.load(open("different.json"))
first, line = report["divergence"], report["first_divergence"]
assert line.startswith(f"stage {first['number']:02} {first['stage']}, buffer {first['buffer']}, {first['where']}, "
                       f"field {first['field']}: ")
assert f"ref {first['reference']} candidate {first['candidate']}" in line and line.endswith("; " + first["inputs"])
assert first["inputs"] == "inputs identical" and f"{first['ulps']:+} ulp" in line
bits = [int(first[side + "_bits"], 16) for side in ("reference", "candidate")]
assert all(f"({first[side + '_bits']})" in first[side] for side in ("reference", "candidate"))
assert bits[0] ^ bits[1] in (1, 1 << 8, 1 << 16, 1 << 24)
found = float.fromhex(first["candidate"].split(" = ")[1].split(" ")[0])
assert struct.unpack(">f", bytes.fromhex(first["candidate_bits"]))[0] == found
PY
verdict $? 'the first divergence as fields'
keep images compare r/epr.png r/epr.png -o same
wrong_images=(compare r/epr.exr r/epr.png --exposure 3)
keep other "${wrong_images[@]}" --first 2
suits compare_images 'compare of images' images.json other.json

mkdir goldens
echo "few: mvr dining:triangles=10000:texels=32 --size 24x16 --reflectors 0 --small" > goldens/cases.txt
echo "none: mvr dining:triangles=10000:texels=32 --size 24x16 --reflectors 0" >> goldens/cases.txt
run golden new --goldens goldens
accepts goldens few
golden=(golden check --goldens goldens)
keep missing "${golden[@]}"
accepts goldens none
keep same "${golden[@]}" few
wrong goldens/few/small/*-image.srgb.npy 7
for i in 1 2; do run "${golden[@]}" --shard $i/2 -o g-$i; done
cp g-1/report.json shard.json
keep merged merge g-1 g-2
keep different "${golden[@]}"
suits golden 'golden check' missing.json same.json different.json shard.json merged.json
suits golden 'and a shard of that' merged.json shard.json

run vectors -o v
keep right vectors --check v
wrong v/dot.out.npy 5
rm v/cross.out.npy
for file in v/*face*.out.npy; do wrong "$file" 3; done
keep wrong vectors --check v
suits vectors 'vectors --check' right.json wrong.json
finish
