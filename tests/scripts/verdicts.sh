#!/bin/bash
# The verdicts of tables that take no scene, with TS_WHOLE and TS_SCENES those of all tables but on times, are those of
# reference/verdicts.json; and a report is summed up as its rows say. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

scripts/verdicts --only ssagh-5,ssagh-6,ssagh-7 > "$folder/out" 2>&1
result $? "verdicts of tables without a scene"
sed 's/holds in 4 rows/holds in 5 rows/' reference/verdicts.json > "$folder/verdicts.json"
VERDICTS=$folder/verdicts.json scripts/verdicts --only ssagh-7 > "$folder/out" 2> /dev/null
[ $? -eq 1 ] && grep -q '^SSAGH, figure 7: holds in 4 rows' "$folder/out"
result $? "another verdict is seen"

# A command with two claims of one table.
cat > "$folder/command" <<'SH'
#!/bin/sh
case "$1 $2" in
"bench list") echo '{"claims": [{"paper": "P", "place": "figure 1", "bench": "one", "rows": "a |b"},
	{"paper": "P", "place": "figure 2", "bench": "one", "rows": "t"},
	{"paper": "P", "place": "table 1", "bench": null, "rows": null}]}' ;;
"list benches") echo '{"benches": [{"name": "one", "brief": "--runs 1"}]}' ;;
"bench one") [ "$3 $4" = "--runs 1" ] && cat "${0%/*}/report" ;;
"--version ") echo "command 1.2, commit abc" ;;
esac
SH
chmod +x "$folder/command"
cat > "$folder/report" <<'JSON'
{"timed_relations": ["time"], "relations": [
	{"relation": "a first", "scene": "x", "verdict": "holds"},
	{"relation": "a first", "scene": "y", "verdict": "differs: too \"few\" (points 3 here, 7 in the paper)"},
	{"relation": "a first", "scene": "z", "verdict": "differs: too \"few\" (points (all) 4 here)"},
	{"relation": "b", "scene": "all", "verdict": "holds"},
	{"relation": "time", "scene": "x", "verdict": "not judged: others used 1.00 processors, 0.20 are allowed"},
	{"relation": "time", "scene": "y", "verdict": "holds"},
	{"relation": "total", "verdict": "holds"}]}
JSON
unjudged='1 row of times not judged, for others used the machine'
first='{"paper": "P", "place": "figure 1", "counts": "differs in 2 of 4 rows: '
first+='a first in y, z: too \"few\"", "times": ""}'
cat > "$folder/wanted" <<JSON
{
	"version": "1.2",
	"commit": "abc",
	"scenes": ["x", "y", "z"],
	"verdicts": [
		$first,
		{"paper": "P", "place": "figure 2", "counts": "holds in 1 row", "times": "times: holds in 1 row; $unjudged"}
	]
}
JSON
VERDICTS=$folder/verdicts.json TOUCHSTONE=$folder/command scripts/verdicts --write 2> /dev/null
diff "$folder/wanted" "$folder/verdicts.json"
result $? "rows are counted, by what differs where, and times apart"
VERDICTS=$folder/verdicts.json TOUCHSTONE=$folder/command scripts/verdicts > "$folder/out" 2> /dev/null
result $? "what was written is found again"
sed -i 's/"total"/"sum"/; s/"time"/"clock"/g' "$folder/report"
VERDICTS=$folder/verdicts.json TOUCHSTONE=$folder/command scripts/verdicts > "$folder/out" 2>&1
[ $? -eq 1 ] && grep -q 'P, figure 2: bench one has no row that begins with t$' "$folder/out"
result $? "a claim that no row asks is refused"
if [ -n "${TS_WHOLE:-}" ] && [ -n "${TS_SCENES:-}" ]; then
	scripts/verdicts 2> /dev/null | sed 's/^/# /'
	result "${PIPESTATUS[0]}" "verdicts of all tables"
fi
echo "1..$n"
