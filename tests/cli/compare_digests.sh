#!/bin/bash
# Traces with files left out are judged by the digests of their trace.json: 0.5 MB name the stage that differs.
. "$(dirname "$0")/tap.bash"
export OMP_WAIT_POLICY=passive # other tests run beside this one
cd "$scratch" || exit
frame=(render reflections atrium:triangles=10000:texels=32 --size 48x27 --reflectors 1 --set cube.max_px=16 --method epr
	--no-images)
run "${frame[@]}" --trace-only image -o small
run "${frame[@]}" --trace -o whole
run "${frame[@]}" --trace-only image --set lookup.samples=adaptive -o other
small=small/trace-epr whole=whole/trace-epr other=other/trace-epr
n=$(python3 -c "import json; print(len(json.load(open('$whole/trace.json'))['buffers']))")

# judges STATUS PATTERN NAME ARGUMENT...
judges() {
	local expected=$1 pattern=$2 name=$3
	shift 3
	run compare "$@"
	[ "$status" -eq "$expected" ] && grep -qE -- "$pattern" stdout
	verdict $? "$name"
}
same="^$n buffers judged, 0 different, 0 missing"
judges 0 "$same" 'two traces of files that are left out' "$small" "$small"
judges 0 "$same" 'a file against a digest' "$whole" "$small"
judges 0 "$same" 'a digest against a file' "$small" "$whole"
judges 0 "$same" 'relaxed too, where digests are the same' "$small" "$whole" --ulp 1
judges 1 \
	'^stage 19 shade, buffer shade.(radiance|n_samples), SHA-256 ref [0-9a-f]{16}\.\.\. candidate [0-9a-f]{16}\.\.\., as other/trace-epr leaves its file out; inputs identical$' \
	'the first stage that differs is named' "$whole" "$other"
judges 1 '^shade +shade.radiance +[1-9][0-9,]* +- .* different$' \
	'its elements are counted, and none is called different' "$whole" "$other"
judges 1 '^shade +shade.radiance .* not judged$' 'a relaxed comparison needs the elements' "$whole" "$other" --abs 0.1
run compare "$whole" "$other" --abs 0.1 --tap
grep -q '^ok .* - shade # SKIP not judged: a relaxed comparison needs its file, which other/trace-epr leaves out' stdout
verdict $? 'and says so'
cp -r "$other" arrival && sed -i 's/"order": "canonical"/"order": "arrival"/' arrival/trace.json
judges 1 '^shade +shade.radiance .* not judged$' 'so do points in the order of their arrival' "$whole" arrival
run compare "$whole" arrival --tap
grep -q '^ok .* - shade # SKIP not judged: points in the order of their arrival needs its file, which arrival' stdout
verdict $? 'and says so, too'
judges 1 '^shade +shade.radiance .* not judged$' 'so does --allow' "$whole" "$other" --allow 1
run compare "$whole" "$other" --json
python3 - <<'PY'
import json
report = json.load(open("stdout"))
assert report["divergence"]["stage"] == "shade" and report["divergence"]["inputs"] == "inputs identical"
by = {d["buffer"]: d["judged_by"] for d in report["differences"]}
assert by["shade.radiance"] == "digest" and by["image.radiance"] == "elements"
PY
verdict $? 'JSON says what was judged by digests'
run compare "$whole" "$other" --report page.html -o compared
[ "$status" -eq 1 ] && [ -s page.html ] && [ -s compared/image.srgb.png ]
verdict $? 'the page and the pictures are made of what is there'

# What a port may write.
# spoils WHAT EDIT: a trace.json is refused with one line.
spoils() {
	rm -rf bad && cp -r "$small" bad
	python3 - "$2" <<'PY'
import json, sys
root = json.load(open("bad/trace.json"))
entry = root["buffers"][0]
exec(sys.argv[1])
json.dump(root, open("bad/trace.json", "w"))
PY
	run compare "$whole" bad
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] &&
		grep -q 'bad/trace.json: buffer scene.vertex: a shape, and 64 hex' stderr
	verdict $? "refused: $1"
}
spoils 'a short digest' 'entry["sha256"] = "12"'
spoils 'capital digits' 'entry["sha256"] = entry["sha256"].upper()'
spoils 'a negative shape' 'entry["shape"] = [-1]'
spoils 'more elements than 64 bits count' 'entry["shape"] = [2**62, 8]'
spoils 'too many dimensions' 'entry["shape"] = [1] * 9'
cp -r "$small" none
python3 - <<'PY'
import json
root = json.load(open("none/trace.json"))
for entry in root["buffers"]:
	entry.pop("sha256")
json.dump(root, open("none/trace.json", "w"))
PY
judges 0 '^2 buffers judged, 0 different' 'without digests only files are judged' "$whole" none
finish
