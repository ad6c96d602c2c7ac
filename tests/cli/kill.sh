#!/bin/bash
# SIGKILL at the calls that change the disk, and by the clock: what was there, or what was to come, is whole, and the
# next run works without a hand. Of a render, of --force where the file system exchanges folders and where not, of
# golden new and bless; of the one process, and of the worker, whose parent clears up.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/stamp.bash"
root=$PWD
sources=$(realpath "$(dirname "$0")"/../faults/{fault,calls,serve,tree}.c) # a sanitizer keeps its malloc
stamp clean-1 "$scratch"
touchstone=$scratch/touchstone
cd "$scratch" || exit 2
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
tiny=(render reflections atrium:triangles=10000:texels=32 --size 16x16 --reflectors 1 --set cube.max_px=16 --method mvr
	--trace-only cube_size,image)

# shellcheck disable=SC2086
if ! ${CC:-gcc} -std=gnu11 -iquote "$root" -shared -fPIC -o fault.so $sources -ldl 2> stderr; then
	echo "ok 1 - the library that kills # SKIP ${CC:-gcc} makes no shared library: $(head -1 stderr)"
	finish
fi

# killed_run N ARGUMENT...: the command, which kills itself before its N-th call.
killed_run() {
	timeout 100 env TOUCHSTONE_FAULT=kill:$1 TOUCHSTONE_FAULT_COUNT=$scratch/count LD_PRELOAD=$scratch/fault.so \
		"$touchstone" "${@:2}" > stdout 2> stderr
	status=$?
}

# sum FOLDER: one digest of all files but times.json; "absent" if there is none.
sum() {
	[ -d "$1" ] || { echo absent; return; }
	(cd "$1" && find . -type f ! -name times.json -exec sha256sum {} + | sort -k 2 | sha256sum)
}

# kills NAME STEP BEFORE FOLDER ARGUMENT...: where every STEP-th call kills, and each of the last twelve, FOLDER, which
# the commands BEFORE set up, holds what it held, or what it would; the next run makes it so, and leaves nothing beside
# it.
kills() {
	local name=$1 step=$2 before=$3 folder=$4 old new at calls bad=0 kept=0 tried=0
	shift 4
	eval "$before"
	old=$(sum "$folder")
	{ killed_run 0 "$@"; } 2> /dev/null
	new=$(sum "$folder")
	calls=$(cat count 2> /dev/null || echo 0)
	[ "$status" -eq 0 ] && [ "$calls" -ge 10 ] && [ "$old" != "$new" ]
	verdict $? "$name: $calls calls"
	for ((at = 1; at <= calls; at += at + 12 < calls ? step : 1)); do
		eval "$before"
		{ killed_run $at "$@"; } 2> /dev/null
		tried=$((tried + 1))
		local ended=$status found
		found=$(sum "$folder")
		[ "$found" = "$old" ] && kept=$((kept + 1))
		run "$@"
		[ "$ended" -eq 137 ] && { [ "$found" = "$old" ] || [ "$found" = "$new" ] || [ "$found-$moved" = absent-1 ]; } &&
			{ [ "$status" -eq 0 ] || grep -q 'not empty\|nothing new' stderr; } && [ "$(sum "$folder")" = "$new" ] &&
			[ "$(find . -name '*.partial' -o -name '*.lock' -o -name '*.old' | wc -l)" -eq 0 ] && continue
		bad=$((bad + 1))
		echo "# killed at $at of $calls: exit $ended, then $status: $(head -1 stderr); $(ls -A | tr '\n' ' ')"
	done
	[ $bad -eq 0 ] && [ $kept -gt 0 ] && [ $tried -gt 2 ]
	verdict $? "$name: $tried kills; before $kept of them the old folder was there"
}

run "${tiny[@]}" --set seed=1 -o first
moved=0
kills 'a new folder' 7 'rm -rf new' new "${tiny[@]}" --no-worker -o new
kills '--force' 6 'rm -rf new; cp -r first new' new "${tiny[@]}" --no-worker -o new --force
export TOUCHSTONE_FAULT_MOVES=yes
moved=1
kills '--force by two renames' 30 'rm -rf new; cp -r first new' new "${tiny[@]}" --no-worker -o new --force
unset TOUCHSTONE_FAULT_MOVES
moved=0

mkdir reference
echo 'few: mvr dining:triangles=10000:texels=32 --size 16x16 --reflectors 0 --small' > reference/cases.txt
kills 'golden new' 20 'rm -rf reference/few.new' reference/few.new golden new --no-worker --goldens reference
cp -r reference/few.new proposed
kills 'golden bless' 20 'rm -rf reference/few*; cp -r proposed reference/few.new' reference/few \
	golden bless few --reason first --no-worker --goldens reference
mv reference/few blessed
mv blessed/CHANGES changes
{ echo earlier; cat changes; } > blessed/CHANGES
kills 'golden bless of another' 12 \
	'rm -rf reference/few*; cp -r blessed reference/few; cp -r proposed reference/few.new' \
	reference/few golden bless few --reason second --no-worker --goldens reference

# The worker is killed: its parent clears up and says so.
rm -rf new
{ killed_run 0 "${tiny[@]}" -o new; } 2> /dev/null
calls=$(cat count)
bad=0
for ((at = 1; at <= calls; at += 8)); do
	rm -rf new
	{ killed_run $at "${tiny[@]}" -o new; } 2> /dev/null
	[ "$status" -eq 2 ] &&
		[ "$(cat stderr)" = 'touchstone: the run was killed, as systems do where memory ends; no result' ] &&
		[ "$(find . -name 'new*' | wc -l)" -le 1 ] && continue
	[ "$status" -eq 2 ] && [ -e new/report.json ] && [ ! -e new.partial ] && [ ! -e new.lock ] && continue
	bad=$((bad + 1))
	echo "# worker killed at $at of $calls: exit $status; $(head -1 stderr)"
done
[ $bad -eq 0 ]
verdict $? "the parent of a worker that is killed leaves nothing half-written, $calls calls"

# By the clock, both processes at once.
RANDOM=17
bad=0
rm -rf new
cp -r first new
old=$(sum new)
for i in {1..12}; do
	setsid "$touchstone" "${tiny[@]}" -o new --force > /dev/null 2>&1 &
	process=$!
	sleep "$(printf '0.%03d' $((RANDOM % 150)))"
	{ kill -KILL -- -$process; wait $process; } 2> /dev/null
	run "${tiny[@]}" -o new --force
	[ "$status" -eq 0 ] && digests_hold new/trace-mvr && [ ! -e new.partial ] && [ ! -e new.lock ] || bad=$((bad + 1))
done
[ $bad -eq 0 ] && [ "$(sum new)" != "$old" ]
verdict $? 'both processes are killed at twelve moments, and the next run works'

finish
