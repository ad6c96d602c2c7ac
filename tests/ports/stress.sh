#!/bin/bash
# The large case of reference/PORTING.md, section 2: what llvmpipe's limit of loops does to the port and to the backend,
# and equal bits of the port, whose buffers exceed 128 MiB, without that limit, which newer versions do not have.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
. "$(dirname "$0")/vulkan.bash"

read -ra command <<< "$(sed -n 's/^[$] touchstone \(render .*\) -o large .*/\1/p' reference/PORTING.md)"
run "${command[@]}" -o "$scratch/large"
verdict $status 'a trace of the large case'

same() { [ "$status" -eq 0 ] && grep -q '^6 buffers judged, 0 different' "$scratch/stdout"; }

! grep -q llvmpipe <("$touchstone" list backends) || run "${command[@]}" --backend vulkan -o "$scratch/refused"
if [ "$status" -ne 0 ]; then
	[ "$status" -eq 2 ] &&
		grep -q "stage points.count: backend vulkan: .* ended a loop of points_count early" "$scratch/stderr"
	verdict $? 'the backend reports the loop that the driver ended'
	compared exact large
	[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" |
		grep -q '^stage .. points.count, buffer points.offset, count of piece 0'
	verdict $? 'compare names the stage whose loop the driver ended'
	make_lift
	with=(env LD_PRELOAD="$lift" MESA_SHADER_CACHE_DIR="$caches/mesa-lifted")
fi
compared exact large && same
verdict $? 'Vulkan has the same bits without that limit'
finish
