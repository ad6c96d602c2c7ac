#!/bin/bash
# Opens, writes, fsyncs and renames of a command fail in turn: exit code 2, one line that names the cause, and no output.
# What is only interrupted, or written in part, is written whole.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
source=$(realpath "$(dirname "$0")/preload/fault.c")
memory=$(realpath "$(dirname "$0")/preload/memory.c")
room=$(realpath scenes/room.gltf)
cd "$scratch" || exit 2
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"

if ! ${CC:-gcc} -shared -fPIC -o fault.so "$source" -ldl 2> stderr; then
	echo "ok 1 - the library that fails # SKIP ${CC:-gcc} makes no shared library: $(head -1 stderr)"
	finish
fi

# faulty CALL N ERRNO ARGUMENT...: the command, whose N-th call of the kind fails.
faulty() {
	TOUCHSTONE_FAULT_CALL=$1 TOUCHSTONE_FAULT_AT=$2 TOUCHSTONE_FAULT_ERROR=$3 TOUCHSTONE_FAULT_COUNT=$scratch/count \
		LD_PRELOAD=$scratch/fault.so timeout 100 "$touchstone" "${@:4}" > stdout 2> stderr
	status=$?
}

# sums: of all files of out but times.json.
sums() { (cd out 2> /dev/null && find . -type f ! -name times.json -exec sha256sum {} + | sort -k 2); }

# each NAME MOST ARGUMENT...: a command that makes out; where there are more calls of a kind than MOST, about so many fail.
each() {
	local name=$1 most=$2 call error at calls bad
	shift 2
	rm -rf out*
	faulty none 0 0 "$@"
	sums > whole
	[ "$status" -eq 0 ] && [ -s whole ]
	verdict $? "$name, undisturbed"
	for call in open write fsync rename; do
		rm -rf out* count
		faulty $call 0 0 "$@"
		calls=$(cat count 2> /dev/null || echo 0)
		bad=0
		for ((at = 1; at <= calls; at += calls / most + 1)); do
			error=$((at % 2 == 0 ? 28 : 5)) # ENOSPC or EIO
			rm -rf out*
			faulty $call $at $error "$@"
			[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] &&
				grep -q 'No space left\|Input/output error' stderr && [ ! -e out ] && [ ! -e out.partial ] && continue
			bad=$((bad + 1))
			echo "# $call $at, error $error: exit $status; $(head -1 stderr)"
		done
		[ $bad -eq 0 ] && [ "$calls" -gt 0 ]
		verdict $? "$name: calls of $call fail, of $calls"
	done
	bad=0
	rm -rf out* count
	faulty write 0 0 "$@"
	calls=$(cat count 2> /dev/null || echo 0)
	for ((at = 1; at <= calls; at += calls / most + 1)); do
		for error in 4 0; do # EINTR, a short write
			rm -rf out*
			faulty write $at $error "$@"
			[ "$status" -eq 0 ] && sums | cmp -s - whole || bad=$((bad + 1))
		done
	done
	[ $bad -eq 0 ]
	verdict $? "$name: writes are interrupted, or short, of $calls, and all is written"
}

tiny=(render reflections atrium:triangles=10000:texels=32 --size 16x16 --reflectors 1 --set cube.max_px=16)
each render 40 "${tiny[@]}" --method epr --trace-only points,image -o out
each vectors 6 vectors -o out

run "${tiny[@]}" --method epr --trace --no-images -o ref
each replay 40 replay ref/trace-epr --stage splat -o out

# starved N ARGUMENT...: the command, without memory for its N-th allocation.
starved() {
	timeout 100 env TOUCHSTONE_FAULT_AT="$1" TOUCHSTONE_FAULT_COUNT="$scratch/count" LD_PRELOAD="$scratch/memory.so" \
		"$touchstone" "${@:2}" > stdout 2> stderr
	status=$?
}

if ! ${CC:-gcc} -shared -fPIC -o memory.so "$memory" 2> stderr || ! { starved 0 --version; } 2> /dev/null || [ "$status" -ne 0 ]; then
	echo "ok $((tests += 1)) - memory that ends # SKIP the library without memory does not load"
	finish
fi
starved 0 info "$room" --json
mv stdout described
calls=$(cat count)
bad=0
for ((at = calls - 110; at < calls - 10; at += 3)); do # the last ten are of libraries that end
	{ starved $at info "$room" --json; } 2> /dev/null
	[ "$status" -eq 0 ] && cmp -s stdout described && continue
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && continue
	bad=$((bad + 1))
	echo "# allocation $at of $calls: exit $status"
done
[ $bad -eq 0 ]
verdict $? "info --json: without memory at its end, $calls allocations, nothing is left out"
finish
