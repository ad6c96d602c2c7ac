#!/bin/bash
# Each kind of OpenCL call fails, first, last and in between, with memory of either kind: the command says so in one
# line and leaves no folder. Calls that only describe or release may fail unnoticed if nothing is otherwise for it, and
# so may the last ones that let go of memory.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
need_device opencl
need_altering
render=(render reflections scenes/triangle.gltf --camera camera --reflectors 0 --size 64x64 --set cube.px=16
	--method epr,mvr --trace --truth=A --backend opencl)
errors=(-5 -4 -2)

# failed_run HOW N: fails from call N on as HOW says, and says what that came to: told, or "same" if nothing shows.
failed_run() {
	altered "$1 TOUCHSTONE_CL_FAIL_AT=$2 TOUCHSTONE_CL_ERROR=${errors[$2 % 3]}" "${render[@]}" -o "$scratch/new"
	outcome="exit code $status, $(wc -l < "$scratch/stderr") lines: $(head -c 200 "$scratch/stderr")"
	if [ "$status" -eq 0 ] && [ ! -s "$scratch/stderr" ]; then
		diff -rq -x '*.json' -x '*.exr' "$scratch/whole" "$scratch/new" > /dev/null && outcome=same
	elif [ "$status" -eq 2 ] || [ "$status" -eq 77 ]; then
		[ "$(wc -l < "$scratch/stderr")" -eq 1 ] && [ ! -e "$scratch/new" ] && [ ! -e "$scratch/new.partial" ] &&
			outcome=told
		[ "$status" -eq 77 ] && ! grep -q 'no OpenCL device' "$scratch/stderr" && outcome='exit code 77'
	fi
	rm -rf "$scratch/new" "$scratch/new.partial"
}

# plan: for each kind of call in $scratch/calls its name, the numbers to fail, and "must" if that has to be told.
plan() {
	python3 - "$scratch/calls" <<'PY'
import sys
calls = open(sys.argv[1]).read().split()
places = {}
for number, name in enumerate(calls, 1):
	places.setdefault(name, []).append(number)
free = lambda name: name.startswith(("clGet", "clRelease")) and name not in ("clGetPlatformIDs", "clGetDeviceIDs")
ends = lambda name: name in ("clEnqueueUnmapMemObject", "clFinish")
last = max(number for number, name in enumerate(calls, 1) if not free(name) and not ends(name))
for name, at in places.items():
	n = len(at)
	some = [at[0], at[-1]] if free(name) else [at[i] for i in (0, 2 * n // 3, n - 1)]
	for number in dict.fromkeys(some):
		print(name, number, "may" if free(name) or number > last else "must")
PY
}

run "${render[@]}" -o "$scratch/whole"
ends 0 '' 'a run that nothing disturbs'
for how in TOUCHSTONE_CL_COPIES=1 TOUCHSTONE_CL_OWN=1; do
	rm -rf "$scratch/new"
	altered "$how TOUCHSTONE_CL_CALLS=$scratch/calls" "${render[@]}" -o "$scratch/new"
	[ "$status" -eq 0 ] && diff -rq -x '*.json' -x '*.exr' "$scratch/whole" "$scratch/new" > /dev/null
	verdict $? "$how: $(wc -l < "$scratch/calls") calls, of $(sort -u "$scratch/calls" | wc -l) kinds, change nothing"
	rm -rf "$scratch/new"
	while read -r name number must; do
		failed_run "$how" "$number"
		[ "$outcome" = told ] || { [ "$outcome" = same ] && [ "$must" = may ]; }
		verdict $? "$how: $name, call $number: $outcome"
	done < <(plan)
	calls=$(wc -l < "$scratch/calls")
	for i in {1..6}; do
		at=$((calls * i / 9))
		failed_run "$how TOUCHSTONE_CL_LOST=1" $at
		[ "$outcome" = told ]
		verdict $? "$how: all calls from $at on: $outcome"
	done
done

# What the compiler said comes before the one line, so that is all without a log.
failed_run TOUCHSTONE_CL_OWN=1 "$(grep -nm 1 clBuildProgram "$scratch/calls" | cut -d: -f1)"
[ "$outcome" = told ] && grep -q 'building the kernels:' "$scratch/stderr"
verdict $? 'no log is promised where there is none'

finish
