#!/bin/bash
# What reference/TRACES.md and its schema say holds for traces of both methods, and the minimal candidate is enough.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
small=(--size 96x54 --reflectors 2 --set reflectors.px=30 --set cube.max_px=64)

run render reflections atrium:triangles=10000:texels=32 "${small[@]}" --set lookup.bounces=3 --method all --margins \
	--no-images -o "$scratch/whole"
verdict $status 'traces of both methods'
run render reflections scenes/room.gltf "${small[@]}" --method mvr --trace --trace-only eye,image --crop 8,4,32,16 \
	--no-images -o "$scratch/part"
verdict $status 'a cropped trace'
/usr/bin/python3 tests/ports/schema.py "$scratch"/whole/trace-{epr,mvr} "$scratch/part/trace-mvr" > "$scratch/schema"
verdict $? 'the schema holds for them, and refuses what is damaged'
grep -A5 '^not ok' "$scratch/schema" | sed 's/^/# /'
run list methods --json
python3 - "$scratch/stdout" <<'PY'
import json, sys
methods = json.load(open(sys.argv[1]))["methods"]
schema = json.load(open("reference/trace.schema.json"))["properties"]
for word, key in (("pipeline", "name"), ("effect", "effect")):
	assert schema[word]["enum"] == list(dict.fromkeys(m[key] for m in methods)), word
PY
verdict $? 'and knows every method and effect'

# The minimal candidate of the document, as it is but for the names of its files.
from=$scratch/whole/trace-epr
mkdir "$scratch/minimal"
sed -n '/^```json$/,/^```$/p' reference/TRACES.md | grep -v '^```' > "$scratch/minimal/trace.json"
cp "$from"/*-visibility.bits.npy "$scratch/minimal/bits.npy"
cp "$from"/*-points.key.npy "$scratch/minimal/keys.npy"
cp "$from"/*-points.record.npy "$scratch/minimal/points.npy"
cp "$from"/*-splat.depth_index.npy "$scratch/minimal/cubes.npy"
run compare "$from" "$scratch/minimal"
[ "$status" -eq 0 ] && grep -q '^4 buffers judged, 0 different' "$scratch/stdout"
verdict $? 'the minimal candidate can be compared'

for damage in 's/"version": 1/"version": 3/' 's/"contract": 1/"contract": 2/' 's/"arrival"/"any"/' 's/"epr"/"pcss"/' \
	's/bits.npy/..\/bits.npy/' 's/keys.npy/bits.npy/' 's/visibility.bits/visibility.words/' '/"buffers"/,$d'; do
	mkdir -p "$scratch/damaged"
	cp "$scratch"/minimal/* "$scratch/damaged/"
	sed -i "$damage" "$scratch/damaged/trace.json"
	run compare "$from" "$scratch/damaged"
	[ "$status" -eq 2 ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -q "$scratch/damaged" "$scratch/stderr"
	verdict $? "refused: the minimal candidate after $damage"
done

# Raw files: the elements alone.
mkdir "$scratch/raw"
tail -c +129 "$scratch/minimal/cubes.npy" > "$scratch/raw/cubes.bin"
cp "$scratch/minimal/bits.npy" "$scratch/raw/"
run compare "$from" "$scratch/raw" --layout splat.depth_index=cubes.bin,visibility.bits=bits.npy
[ "$status" -eq 0 ] && grep -q '^2 buffers judged, 0 different' "$scratch/stdout"
verdict $? 'raw files can be compared'

# The chain of section 5, by its own command.
(cd "$from" && sha256sum 07-split.piece.npy 07-split.density.npy | sed 's/07-//; s/[.]npy$//' | sha256sum) |
	cut -c-64 | grep -qf - "$from/trace.json"
verdict $? 'the chain of a stage, as the document makes it'

finish
