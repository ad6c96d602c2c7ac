#!/bin/bash
# Four faults that ports have had, planted in the numpy port: what vectors, compare and explain say of each.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
find_numpy || exit 0
trace room atrium:triangles=10000:texels=32 --size 96x54 --reflectors 3 --set cube.max_px=64
verdict $? 'a trace of atrium'
reference=$scratch/room/trace-epr port=$scratch/port

# finds N FAULT: the port with that damage differs in one buffer, of splat,
# and the command that compare prints explains it.
finds() {
	rm -rf "$port"
	"$python" tests/ports/numpy/port.py "$reference" "$port" --break "$1" && run compare "$reference" "$port"
	[ "$status" -eq 1 ] && grep -q '^2 buffers judged, 1 different' "$scratch/stdout" &&
		tail -n 1 "$scratch/stdout" |
		grep -q '^stage 12 splat, buffer splat.depth_index, .*inputs identical as far as given'
	verdict $? "compare names the stage: $2"
	tail -n 1 "$scratch/stdout" > "$scratch/first"
	local command
	command=$(sed -n 's/^how the reference computes it: touchstone //p' "$scratch/stdout")
	read -ra command <<< "$command"
	run "${command[@]}"
	[ "$status" -eq 0 ] && mv "$scratch/stdout" "$scratch/explained"
	verdict $? "and the command that explains it: $2"
}

# explained PATTERN FAULT: what the reference computes has the line of the fault.
explained() {
	grep -q -- "$1" "$scratch/explained"
	verdict $? "explain has the line: $2"
}

"$touchstone" vectors -o "$scratch/vectors" > /dev/null
"$python" tests/ports/numpy/vectors.py "$scratch/vectors" "$scratch/computed" fused
run vectors --check "$scratch/computed"
[ "$status" -eq 1 ] && grep -q '^  fault  *fused multiply-add: turn contraction off' "$scratch/stdout"
verdict $? 'vectors names contraction'
"$python" tests/ports/numpy/vectors.py "$scratch/vectors" "$scratch/computed"
run vectors --check "$scratch/computed"
[ "$status" -eq 0 ]
verdict $? 'the other faults are in no primitive'

finds 10 contraction
read -r depth index other same \
	<<< "$(sed -n 's/.*(\([0-9a-f]*\)_\([0-9a-f]*\)) candidate .*(\([0-9a-f]*\)_\([0-9a-f]*\)).*/\1 \2 \3 \4/p' \
	"$scratch/first")"
[ "$index" = "$same" ] && [ $((0x$depth - 0x$other)) -ge -1 ] && [ $((0x$depth - 0x$other)) -le 1 ]
verdict $? 'a unit in the last place'
explained ' d = ' contraction
finds 11 'the last writer wins'
explained ' ts_min_u64 of \*least = ' 'the last writer wins'
finds 12 'an unsigned shift'
explained ' r\.x0 = -[0-9]\| r\.y0 = -[0-9]' 'an unsigned shift'
finds 13 'half size 128'
explained ' half_size = 129$' 'half size 128'
finish
