#!/bin/bash
# SIGKILL at twenty points of a trace write, counted in calls that change the disk, and at ten moments: the folder is absent,
# or complete and its digests hold. The same while --force replaces an older trace.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
source=$(realpath "$(dirname "$0")/preload/kill.c")
cd "$scratch" || exit 2
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
short=("${frame[@]}" --method epr --trace-only cube_size,points,splat,image)

if ! ${CC:-gcc} -shared -fPIC -o kill.so "$source" -ldl 2> stderr; then
	echo "ok 1 - the library that kills # SKIP ${CC:-gcc} makes no shared library: $(head -1 stderr)"
	finish
fi

# killed_run N ARGUMENT...: the command, killed before its N-th call.
killed_run() {
	local at=$1
	shift
	TOUCHSTONE_KILL_AT=$at TOUCHSTONE_KILL_COUNT=$scratch/count LD_PRELOAD=$scratch/kill.so timeout 100 \
		"$touchstone" "$@" > stdout 2> stderr
	status=$?
}

# sound FOLDER: absent, or complete.
sound() {
	[ ! -e "$1" ] || { [ -s "$1/report.json" ] && digests_hold "$1/trace-epr"; }
}

{ killed_run 0 "${short[@]}" -o whole; } 2> /dev/null
calls=$(cat count 2> /dev/null || echo 0)
[ "$status" -eq 0 ] && [ "$calls" -ge 40 ] && sound whole && [ -e whole ]
verdict $? "a run that is not killed is complete, after $calls calls"

absent=0
for i in {1..20}; do
	at=$((calls * i / 20))
	{ killed_run $at "${short[@]}" -o new; } 2> /dev/null
	[ "$status" -eq 137 ] && sound new
	verdict $? "killed at call $at of $calls"
	[ -e new ] || absent=$((absent + 1))
	if [ "$i" -eq 1 ]; then
		run "${short[@]}" -o new
		[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -q 'new.partial: exists.*killed; remove it' stderr
		verdict $? 'the next run says what to do about what is left'
	fi
	rm -rf new new.partial
done
[ "$absent" -ge 18 ]
verdict $? "nothing appears before the end: $absent of 20"

run "${short[@]}" --set seed=1 -o first
{ cp -r first new; killed_run 0 "${short[@]}" -o new --force; } 2> /dev/null
calls=$(cat count)
for i in {1..12}; do
	at=$((calls - i + 1))
	rm -rf new new.*
	cp -r first new
	{ killed_run $at "${short[@]}" -o new --force; } 2> /dev/null
	[ "$status" -eq 137 ] && sound new && { [ -e new ] || sound new.old; }
	verdict $? "killed at call $at of $calls while it replaces another"
done
rm -rf new new.*

"$touchstone" "${short[@]}" -o timed > /dev/null 2>&1 && sound timed
verdict $? 'a run by the clock is complete'
RANDOM=17
for i in {1..10}; do
	wait_ms=$((100 + RANDOM % 900))
	"$touchstone" "${short[@]}" -o new > /dev/null 2>&1 &
	process=$!
	sleep "$(printf '0.%03d' $wait_ms)"
	{ kill -KILL $process; wait $process; } 2> /dev/null
	sound new
	verdict $? "killed after $wait_ms ms"
	rm -rf new new.partial
done

finish
