#!/bin/bash
# The port of five stages to Vulkan: equal bits on four scenes,
# and what compare and explain say of faults that ports have had.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
. "$(dirname "$0")/vulkan.bash"

agrees() {
	compared exact "$1" && [ "$status" -eq 0 ] && grep -q '^6 buffers judged, 0 different' "$scratch/stdout"
	verdict $? "Vulkan has the same bits: $1"
}

# finds FAULT SCENE STAGE ALONE LINE: the faulty port differs first in that stage; of the commands that compare
# proposes, explain prints the line; and given their own inputs the stages ALONE differ.
finds() {
	local command
	compared faulty "$2"
	[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" |
		grep -q "^stage .. $3, buffer .*inputs identical as far as given"
	verdict $? "compare names stage $3: $1"
	read -ra command <<< "$(sed -n 's/^how the reference computes it: touchstone //p' "$scratch/stdout")"
	run "${command[@]}"
	[ "$status" -eq 0 ] && grep -q -- "$5" "$scratch/stdout"
	verdict $? "explain has the line: $1"
	compared faulty "$2" --forced
	[ "$status" -eq 1 ] && [ "$(sed -n 's/^stage .. \(.*\): different$/\1/p' "$scratch/stdout" | xargs)" = "$4" ]
	verdict $? "alone differ: $4: $1"
}

for scene in triangle_mirror triangle_twice triangle_side; do
	micro $scene $scene
	agrees $scene
done
trace gallery gallery:triangles=10000 --size 96x54 --reflectors 3 --set cube.max_px=64
agrees gallery
trace atrium atrium:triangles=10000 --size 48x27 --reflectors 1
mkdir "$scratch/atrium/port"
"$scratch/port" "$scratch/exact" "$scratch/atrium/trace-epr" "$scratch/atrium/port" 2> "$scratch/stderr"
[ $? -eq 2 ] && grep -q 'material [0-9]* is masked' "$scratch/stderr"
verdict $? 'what the port has not is refused: masked materials'
VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent "$scratch/port" "$scratch/exact" \
	"$scratch/gallery/trace-epr" "$scratch/gallery/port" 2> "$scratch/stderr"
[ $? -eq 77 ] && grep -q 'no Vulkan device' "$scratch/stderr"
verdict $? 'no device'

# llvmpipe fuses nothing, not even what fma() asks for; the pass reports it.
made faulty points.comp 's|0.5 [*] ts_length(\(.*\));|fma(0.5, ts_length(\1), 0.0);|' 2> "$scratch/stderr"
[ $? -eq 0 ] && grep -q 'points.spv: function 50 .* not in the contract' "$scratch/stderr"
verdict $? 'planted: fma, which spirv-exact names'
made faulty points.comp 's|float(\([xy]\)) / f.s|float(\1) * (1.0 / f.s)|'
verdict $? 'planted: a reciprocal for a division'
finds 'a reciprocal for a division' gallery points points ' du = '
made faulty stage.glsl 's/HALF_SIZE = 129/HALF_SIZE = 128/'
verdict $? 'planted: half size 128'
finds 'half size 128' gallery points.count 'points.count splat' ' half_size = 129$'
made faulty splat.comp 's|atomicMin(\((texel.*)).v\), mine)|\1 = mine|'
verdict $? 'planted: the last writer wins'
finds 'the last writer wins' triangle_twice splat splat ' ts_min_u64 of \*least = '
finish
