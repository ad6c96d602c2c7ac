#!/bin/bash
# The goldens of reference/ together take every choice, stage and scene; what is stored is what its digests say.
. "$(dirname "$0")/tap.bash"

for what in params stages methods scenes; do
	"$touchstone" list $what --json > "$scratch/$what.json"
done
# cover WHAT: what of that kind no case takes, from the tables of the program and the stored files; nothing is right.
cover() {
	python3 - "$1" "$scratch" <<'PY'
import glob, json, os, re, sys
what, scratch = sys.argv[1:]
table = {k: json.load(open(f"{scratch}/{k}.json"))[k] for k in ("params", "stages", "methods", "scenes")}
cases = {}
for path in glob.glob("reference/*/params.txt"):
	folder = os.path.dirname(path)
	case = dict(line.rstrip("\n").split("=", 1) for line in open(path))
	case["files"] = {re.sub(r"^\d\d-|\.npy$", "", line.split()[1]) for line in open(folder + "/SHA256SUMS")}
	cases[os.path.basename(folder)] = case
names = {m.group(1) for m in re.finditer(r"^([a-z0-9-]+):", open("reference/cases.txt").read(), re.M)}
effect = [m["name"] for m in table["methods"] if m["effect"] == "reflections"]
of = lambda method: [case for case in cases.values() if case["method"] == method]
missing = []
if what == "folders":
	missing = sorted(names ^ cases.keys())
elif what == "choices":
	for p in table["params"]:
		method = "mvr" if p["name"].startswith("mvr.") else "epr"
		taken = {case[p["name"]] for case in of(method)}
		missing += [f"{p['name']}={c}" for c in p["range"].split("|") if "|" in p["range"] and c not in taken]
		missing += [p["name"]] if len(taken) < 2 else []
	missing += [f"bounces={n}" for n in "123" if n not in {case["bounces"] for case in of("epr")}]
	missing += [f"reflectors=0 by {m}" for m in effect if "0" not in {case["reflectors"] for case in of(m)}]
elif what == "stages":
	writes = {s["name"]: re.findall(r"[a-z0-9_.]+", s["writes"]) for s in table["stages"]}
	for m in effect:
		lines = open(f"src/pipelines/{m}.c").read().splitlines()
		steps = [s[1] for line in lines if "only_margins" not in line and (s := re.match(r'\t\{\.stage = "(\w+)"', line))]
		made = set().union(*(case["files"] for case in of(m)))
		missing += [] if steps else [m]
		missing += [f"{m}: {s}" for s in steps if not writes[s] or not set(writes[s]) <= made]
elif what == "scenes":
	missing = [f"{s['name']} by {m}" for m in effect for s in table["scenes"]
	           if s["name"] not in {case["scene"].split(":")[0] for case in of(m)}]
print("".join(f"# missing: {text}\n" for text in missing), end="")
sys.exit(bool(missing))
PY
}

for what in folders choices stages scenes; do
	cover $what
	verdict $? "the cases take all $what"
done
for folder in reference/*/; do
	[ -f "$folder/preview.png" ] && [ -f "$folder/SHA256SUMS" ] && { [ ! -d "$folder/small" ] ||
		(cd "$folder/small" && sha256sum -c --ignore-missing --status ../SHA256SUMS); }
	verdict $? "$folder holds what its digests say"
	grep -q "^$(basename "$folder"): ." reference/CHANGES
	verdict $? "$folder was blessed for a reason"
done
[ "$(du -sk reference | cut -f 1)" -lt 20480 ]
verdict $? 'reference/ is smaller than 20 MB'

finish
