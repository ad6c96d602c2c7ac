#!/bin/bash
# Shards: each case is in exactly one, and what `merge` writes of all of them is to the byte what the command writes
# without shards, but for times; shards that are missing, there twice, of other runs or damaged are refused by one line.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/stamp.bash"
schema=$PWD/tests/cli/junit.xsd
BUILD=$(realpath "${BUILD:-build/release}")
cd "$scratch" || exit 2
export OMP_WAIT_POLICY=passive

# What differs from run to run: times, the machine's name.
timeless() { sed -E 's/ (time|timestamp|hostname)="[^"]*"//g' "$1"; }
# alike A B: the folders hold the same, but for times.
alike() { diff -r -x 'times*' "$1" "$2" > differs; }
# refuses_merge PATTERN NAME DIR...: exit code 2 and one line.
refuses_merge() {
	local pattern=$1 name=$2
	shift 2
	run merge "$@"
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -s stdout ] && grep -q -- "$pattern" stderr
	verdict $? "$name"
}
# whole_and_shards STATUS N NAME ARGUMENT...: one run, and N shards of it, merged: files, JUnit, JSON and TAP are the
# same. What the last call ran whole, with the same end, is there already.
ran=
whole_and_shards() {
	local expected=$1 n=$2 name=$3 i worst=0 same=0
	shift 3
	rm -rf all s-*
	if [ "$ran" != "$expected $*" ]; then
		rm -rf whole && run "$@" -o whole --junit whole.xml --json && mv stdout whole.json
		[ "$status" -eq "$expected" ] || same=1
		run "$@" --tap && mv stdout whole.tap
		ran="$expected $*"
	fi
	for ((i = 1; i <= n; i++)); do
		run "$@" --shard "$i/$n" -o "s-$i" --junit "s-$i.xml"
		[ "$status" -le "$worst" ] || worst=$status
		xmllint --noout --schema "$schema" "s-$i.xml" 2> lint || same=1
	done
	[ "$worst" -eq "$expected" ] || same=1
	run merge $(ls -d s-* | grep -v xml | shuf --random-source=<(yes)) -o all --junit all.xml --json &&
		mv stdout all.json
	[ "$status" -eq "$expected" ] && alike whole all && cmp whole.json all.json || same=1
	diff <(timeless whole.xml) <(timeless all.xml) >> differs || same=1
	xmllint --noout --schema "$schema" all.xml 2> lint || same=1
	run merge $(ls -d s-* | grep -v xml) --tap && cmp stdout whole.tap || same=1
	[ "$same" -eq 0 ] || cat differs
	verdict "$same" "$name"
}

for text in 0/3 4/3 1/0 1 /3 1/ 1/3/5 -1/3 1/1001 a/b '' ' 1/2' 1.5/2 01x/2; do
	refuses '^touchstone: --shard .*: not I/N, with I from 1 to N and N at most 1000; for instance 1/4$' golden check \
		--shard "$text"
done

# Goldens, one of which differs.
mkdir goldens
for i in 1 2 3 4 5; do
	echo "case-$i: mvr dining:triangles=10000:texels=16 --size 24x16 --reflectors 0 --set seed=$i --small"
done > goldens/cases.txt
run golden new --goldens goldens
accepts goldens case-{1,2,3,4,5}
golden=(golden check --goldens goldens)
whole_and_shards 0 3 'goldens that are the same' "${golden[@]}"
change goldens/case-2/small/*-image.radiance.npy 4 7 0 0000803f
change goldens/case-5/small/*-image.srgb.npy 1 7 0 aa
for n in 1 2; do whole_and_shards 1 $n "$n shards of goldens that differ" "${golden[@]}"; done
run "${golden[@]}" && mv stdout whole.text
run merge s-1 s-2
cmp whole.text stdout
verdict $? 'the text, too'
: > counted
for i in 1 2 3; do
	run "${golden[@]}" --shard "$i/3" && grep -oE ' case-[0-9]' stdout >> counted
done
[ "$(sort counted | xargs)" = 'case-1 case-2 case-3 case-4 case-5' ]
verdict $? 'each case is in exactly one'
run "${golden[@]}" --shard 7/9
[ "$status" -eq 0 ] && grep -q '^0 passed, 0 failed, 0 skipped$' stdout &&
	grep -q 'shard 7/9: none of the 5 cases is in it; it passes' stderr
verdict $? 'a shard without a case passes, and says so'
whole_and_shards 1 7 'more shards than cases' "${golden[@]}"
rm -r goldens/case-4/small
whole_and_shards 2 2 'a shard that ends with an error' "${golden[@]}"

# A comparison, whose inputs are judged by other shards.
run "${frame[@]}" --method epr --trace -o r
cp -r r/trace-epr c
whole_and_shards 0 3 'a comparison' compare r/trace-epr c
change c/09-align.frame.npy 80 12 12 0000803f
rm c/11-points.record.npy
python3 - <<'PY'
import json
trace = json.load(open("c/trace.json"))
for b in trace["buffers"]:
	if b["name"] == "points.record": b["file"] = None
json.dump(trace, open("c/trace.json", "w"))
PY
whole_and_shards 1 4 "4 shards of a comparison that differs" compare r/trace-epr c
change c/20-image.srgb.npy 1 $((3 * (20 * 96 + 33) + 1)) 0 ff
ran=
for n in 1 30; do whole_and_shards 1 $n "$n shards of one whose picture does, too" compare r/trace-epr c; done
whole_and_shards 1 3 'each stage by the candidate'"'"'s inputs' compare r/trace-epr c --forced --first 3
whole_and_shards 0 3 'relaxed' compare r/trace-epr c --ignore align.frame --allow 5
refuses '--shard: means something for traces only' compare r/trace-epr/20-image.srgb.npy c/20-image.srgb.npy --shard 1/2

# What is refused.
rm -rf s-*
for i in 1 2 3; do run compare r/trace-epr c --shard $i/3 -o s-$i; done
refuses_merge 'of 3 shards 1 is missing: 2; name its folder too' 'a shard is missing' s-1 s-3
refuses_merge 'of 3 shards 2 are missing: 1, 3; name their folders too' 'two are missing' s-2
cp -r s-2 again
refuses_merge 'both are shard 2; name each once' 'a shard is there twice' s-1 s-2 s-3 again
rm -r again
run compare r/trace-epr c --shard 2/4 -o of-4
refuses_merge 'shard 2 of 4; s-1 is one of 3' 'of another number' s-1 of-4 s-3
run compare r/trace-epr c --ulp 1 --shard 2/3 -o other
refuses_merge 'ran with "--ulp=1"' 'with other options' s-1 other s-3
run "${golden[@]}" --shard 2/3 -o other-command
refuses_merge 'of command golden check, and s-1 of compare' 'of another command' s-1 other-command s-3
stamp another .
for i in 1 2; do ./touchstone compare r/trace-epr c --shard $i/2 -o "another-$i" > /dev/null; done
refuses_merge 'another-1: of commit another, and this program of ' 'of another program' another-1 another-2
./touchstone compare r/trace-epr c --shard 2/3 -o other-commit > /dev/null
refuses_merge 'of commit another, and s-1 of ' 'of another commit' s-1 other-commit s-3
run compare r/trace-epr c -o no-shard
refuses_merge 'no-shard/SHA256SUMS: No such file' 'of no shard' no-shard s-1
refuses_merge 'nowhere/SHA256SUMS: No such file' 'of no folder' nowhere
run merge s-1 s-2 s-3 -o s-1
[ "$status" -eq 2 ] && grep -q 's-1: not empty' stderr
verdict $? 'a shard is not replaced by what is merged'
finish
