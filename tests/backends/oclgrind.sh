#!/bin/bash
# Oclgrind, which interprets the OpenCL kernels item by item, sees no data race: neither in the atomic operations of
# compat.h, each of which it reports as soon as a copy has it plain, nor in frames, whose buffers are those of C.
. "$(dirname "$0")/../cli/tap.bash"
room=$(realpath scenes/room.gltf)
compat=$(realpath src/kernels/base/compat.h)
cd "$scratch" || exit 2

if ! command -v oclgrind > /dev/null; then
	echo "1..0 # SKIP Oclgrind is not installed"
	exit
fi
# It takes no function that is inlined.
build='-cl-opt-disable -DTS_FN=static'

cat > race.cl <<'C'
#include "compat.h"
__kernel void race(__global u64 *wide, __global u32 *words, __global i64 *sums, __global u32 *seen)
{
	u32 i = (u32)get_global_id(0);
	ts_min_u64(&wide[0], (u64)(64u - i));
	ts_or_u64(&wide[1], (u64)1 << i);
	ts_min_u32(&words[0], 64u - i);
	ts_next_u32(&words[1]);
	ts_add_i64(&sums[0], (i64)i);
	ts_next_i64(&sums[1]);
	seen[i] = ts_peek_u32(&words[0]);
}
C
cat > race.sim <<'SIM'
race.cl race
64 1 1
16 1 1
<size=16 fill=64 ulong dump>
<size=8 fill=64 uint dump>
<size=16 fill=0 long dump>
<size=256 fill=0 uint>
SIM

# races: the kernel above with the compat.h of this folder; its reports.
races() { oclgrind-kernel --data-races --log races --build-options "-I. $build" race.sim > values; }
# reported NAME DEFINITION: with NAME defined so.
reported() {
	sed "0,/^#define $1(.*/s//#define $1($2/" "$compat" > compat.h
	races && grep -q 'data race at global memory' races
	verdict $? "reported: $1($2"
}

cp "$compat" .
races && [ ! -s races ] && [ "$(grep -o '[0-9]*$' values | tr '\n' ' ')" = '1 18446744073709551615 1 128 2016 64 ' ]
verdict $? 'the atomic operations as they are'
reported ts_min_u64 'p, v) (*(p) = min(*(p), (v)))'
reported ts_min_u64 'p, v) ((v) < *(p) ? atom_min((p), (v)) : 0)'
reported ts_min_u64 'p, v) ((uint)((v) >> 32) <= ((volatile __global uint *)(p))[1] ? atom_min((p), (v)) : 0)'
reported ts_min_u32 'p, v) ((v) < *(volatile __global uint *)(p) ? atomic_min((p), (v)) : 0)'
reported ts_peek_u32 'p) (*(volatile __global uint *)(p))'
reported ts_or_u64 'p, v) (*(p) |= (v))'
reported ts_add_i64 'p, v) (*(p) += (v))'
reported ts_next_i64 'p) (*(p))++'
reported ts_next_u32 'p) (*(p))++'

# frame METHOD ARGUMENT...: without a race, and with the buffers of C. Oclgrind rounds correctly, and does not say so.
frame() {
	local of=(render "${@:2}" --method "$1" --size 16x16 --no-images --trace)
	run "${of[@]}" -o "c-$1"
	timeout 800 oclgrind --data-races --log races "$touchstone" "${of[@]}" -o "cl-$1" --backend opencl --inexact \
		--no-worker --build "$build" > stdout 2> stderr
	[ ! -s races ]
	verdict $? "$1: no data race"
	run compare "c-$1/trace-$1" "cl-$1/trace-$1"
	[ "$status" -eq 0 ] && grep -q ' 0 different, 0 missing' stdout
	verdict $? "$1: the buffers of C"
}
frame epr reflections "$room" --reflectors 1 --set cube.max_px=16
frame hulls indirect "$room" --reflectors 0 --set rsm.px=4 --set depth_grid.px=32
frame megaviews indirect "$room" --reflectors 0 --set rsm.px=4 --set octree.levels=2 --set traverse.queue_mb=1
finish
