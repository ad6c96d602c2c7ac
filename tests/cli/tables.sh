#!/bin/bash
# Lists come from the program's own tables, as text and as JSON.
. "$(dirname "$0")/tap.bash"

prints '^touchstone [0-9]' --version
prints '^splat ' list stages
prints '^points.record .*ts_point' list buffers
prints '^density.scale .*0.5' list params
prints '^eye.distance  *far ' list params
prints '^epr .*reflections' list methods
prints '^atrium ' list scenes
prints '^c  *0  *[a-z].*  exact  *kept  *yes ' list backends
prints 'triangles' info atrium:triangles=10000 --reflectors 1

for what in 'list stages' 'list buffers' 'list sizes' 'list params' 'list methods' 'list truths' 'list scenes' \
	'list backends' 'list benches' 'info atrium:triangles=10000'; do
	run $what
	[ "$status" -eq 0 ] && awk 'length > 120 || / $/ { exit 1 }' "$scratch/stdout"
	verdict $? "fits 120 columns: $what"
done

# What wraps loses no word: the columns of a table, taken from their place under the heads.
run list params --json
cp "$scratch/stdout" "$scratch/json"
run list params
python3 - "$scratch/json" "$scratch/stdout" <<'PY'
import json, sys
rows = json.load(open(sys.argv[1]))["params"]
head, *lines = open(sys.argv[2]).read().splitlines()
heads = ["parameter", "default", "range", "unit", "source", "what"]
at = [head.index(h) for h in heads] + [None]
for i, key in enumerate(["name", "default", "range", "unit", "source", "doc"]):
	text = "".join(line[at[i]:at[i + 1]] for line in lines).replace(" ", "")
	assert text == "".join(r[key] for r in rows).replace(" ", ""), key
PY
verdict $? 'wrapping loses nothing'

# One row alone, wrapped to the terminal.
prints '^stages  *split cull' list params density.scale
prints '^parameter  *mvr.filter$' list params 'mvr.*'
prints '^writes  *splat.depth_index$' list stages splat
prints '^bytes  *32$' list buffers points.record
refuses 'params: no "density.scal"; the nearest is density.scale, and "list params" lists all$' list params density.scal
refuses 'params: no "nix\*"; "list params" lists all$' list params 'nix*'
if python3 -c 'import pty; pty.openpty()' 2> "$scratch/found"; then
	python3 - "$touchstone" <<'PY'
import fcntl, os, pty, struct, subprocess, sys, termios
def widest(columns):
	ours, theirs = pty.openpty()
	fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
	subprocess.run([sys.argv[1], "list", "params", "width"], stdout=theirs, check=True)
	return max(map(len, os.read(ours, 65536).decode().splitlines()))
assert 40 < widest(50) <= 50 and 90 < widest(100) <= 100
PY
	verdict $? 'a row alone is as wide as the terminal'
else
	verdict 0 'a row alone is as wide as the terminal # SKIP no terminals here'
fi
run list params 'mvr.*' --json
python3 -c 'import json, sys; rows = json.load(open(sys.argv[1]))["params"]
assert {r["name"] for r in rows} > {"mvr.filter"}
assert all(r["name"].startswith("mvr.") and "mvr" in r["methods"].split() for r in rows)' \
	"$scratch/stdout"
verdict $? 'in JSON, who reads it'

run list ''
lists=$(sed 's/.*there are //; s/,//g; s/ and / /' "$scratch/stderr")
for what in $lists; do
	run list $what --json
	python3 -c 'import json, sys; rows = json.load(open(sys.argv[1]))[sys.argv[2]]
assert all(r["name"] for r in rows) and rows
for key in rows[0]: assert len({type(r[key]) for r in rows} - {type(None)}) == 1, key' "$scratch/stdout" $what
	verdict $? "list $what --json is an object with rows, and a column of a kind"
done

# Each cell stands in its column: names are words, apart from each other, and documents are sentences.
for what in sizes scenes truths; do
	run list $what --json
	python3 -c 'import json, sys; rows = json.load(open(sys.argv[1]))[sys.argv[2]]; names = [r["name"] for r in rows]
assert len(set(names)) == len(names) > 1 and not any(" " in n for n in names) and all(" " in r["doc"] for r in rows)' \
		"$scratch/stdout" $what
	verdict $? "the columns of list $what"
done

# Each parameter can be set to its default.
run list params --json
python3 - "$touchstone" "$scratch/stdout" <<'PY'
import json, subprocess, sys
rows = json.load(open(sys.argv[2]))["params"]
arguments = [a for r in rows for a in ("--set", f'{r["name"]}={r["default"]}')]
choices = [a for r in rows if "|" in r["range"] for c in r["range"].split("|") for a in ("--set", f'{r["name"]}={c}')]
subprocess.run([sys.argv[1], "info", "atrium:triangles=10000", *arguments, *choices], check=True,
               stdout=subprocess.DEVNULL)
PY
verdict $? 'every parameter takes its default and every choice'

finish
