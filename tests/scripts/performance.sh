#!/bin/bash
# scripts/performance puts the tables of a report into a page, and leaves all else of it. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

cat > "$folder/command" <<'SH'
#!/bin/sh
echo "$*" > "${0%/*}/asked"
[ -e "${0%/*}/refuses" ] && { echo "the machine is busy" >&2; exit 2; }
cat << 'JSON'
{"machine": "M | 2", "threads": 2, "version": "1.2", "compiler": "gcc", "flags": "-O3", "busy_rows": 3,
 "quiet": {"load": 0.1, "load_limit": 1, "others": 0.01, "others_limit": 0.2, "loop_ms": 3.5, "busy": false},
 "limits": [{"limit": "minima", "here": 812.345, "unit": "M/s", "spread": 1.5, "state": ""}],
 "stages": [{"frame": "A by epr", "stage": "splat", "ms": 1234.5, "share": 60.0, "near": null},
            {"frame": "A by epr", "stage": "pose", "ms": 0.01, "share": 0.01, "near": null}],
 "figures": [{"figure": "a|b", "here": 0.5}]}
JSON
SH
chmod +x "$folder/command"
page=$folder/page.md
{
	echo "# Page"
	for name in machine limits stages figures growth; do
		printf 'before\n<!-- measured: %s -->\nold\n<!-- end -->\n' $name
	done
	echo "last"
} > "$page"
PERFORMANCE=$page TOUCHSTONE=$folder/command scripts/performance --runs 1
[ "$(cat "$folder/asked")" = "bench speed --runs 1 --json" ] && ! grep -q old "$page" &&
	[ "$(grep -c before "$page")" -eq 5 ] &&
	grep -q '^last$' "$page" && grep -q '^M | 2; 2 threads.$' "$page" &&
	grep -q '^| minima | 812 | M/s | 1.5 |  |$' "$page" &&
	grep -q '^| A by epr | splat | 1234 | 60 |  |$' "$page" && ! grep -q pose "$page" &&
	grep -q '^| a\\|b | 0.5 |$' "$page" &&
	grep -q '^Nothing was measured.$' "$page" && ! grep -q 'busy machine' "$page"
result $? "tables stand in their places, and nothing else changes"
cp "$page" "$folder/before"
"$folder/command" | sed 's/"busy": false/"busy": true/' > "$folder/report"
PERFORMANCE=$page scripts/performance --from "$folder/report"
[ "$(diff "$folder/before" "$page" | grep '^[<>]')" = "> **On a busy machine: nothing is judged.**" ]
result $? "a busy machine is told"
touch "$folder/refuses"
cp "$page" "$folder/before"
PERFORMANCE=$page TOUCHSTONE=$folder/command scripts/performance 2> /dev/null
[ $? -eq 2 ] && cmp -s "$page" "$folder/before"
result $? "what is refused changes nothing"
echo "1..$n"
