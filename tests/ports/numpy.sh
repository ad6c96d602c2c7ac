#!/bin/bash
# The port of three stages to numpy: equal bits on two scenes, the small ones and shadows,
# and each damaged line is found.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
find_numpy || exit 0

# compared FOLDER OPTION...: makes the port's candidate of that trace and compares them.
compared() {
	local folder=$scratch/$1
	shift
	"$python" tests/ports/numpy/port.py "$folder/trace-epr" "$folder/numpy" "$@" || return 2
	run compare "$folder/trace-epr" "$folder/numpy"
}

agrees() {
	compared "$1" && [ "$status" -eq 0 ] && grep -q '^2 buffers judged, 0 different' "$scratch/stdout"
	verdict $? "numpy has the same bits: $1"
}

# catches N FOLDER STAGE: with line N damaged, the report's last line names that stage, and no other buffer differs.
catches() {
	compared "$2" --break "$1" && [ "$status" -eq 1 ] && grep -q '^2 buffers judged, 1 different' "$scratch/stdout" &&
		tail -n 1 "$scratch/stdout" | grep -q "^stage $3, buffer"
	verdict $? "numpy with damage $1: stage $3 differs in $2"
}

for scene in atrium gallery; do
	trace $scene $scene:triangles=10000 --size 240x135 --reflectors 3
	verdict $? "a trace of $scene"
	agrees $scene
done
trace room scenes/room.gltf --size 240x135 --reflectors 12 --set visibility.test=vertex
agrees room
trace open atrium:triangles=10000 --size 96x54 --reflectors 3 --set splat.clip=off --set splat.box=touched
agrees open
trace small atrium:triangles=10000 --size 96x54 --reflectors 3 --set cube.max_px=64
for scene in triangle_mirror triangle_twice triangle_edge triangle_side; do
	micro $scene $scene
	agrees $scene
done

micro triangle_behind triangle_behind --set splat.clip=off
agrees triangle_behind

# arrives FOLDER TIED: points in the reverse order are found again;
# TIED texels (-: none) hold another of the tied points.
arrives() {
	compared "$1" --arrival && [ "$status" -eq 0 ] && grep -q '^4 buffers judged, 0 different' "$scratch/stdout" &&
		[ "$(awk '$1 == "splat" {print $4, $5}' "$scratch/stdout")" = "0 $2" ]
	verdict $? "numpy in order of arrival: $1, tied $2"
}
arrives small -
arrives triangle_mirror -
arrives triangle_twice 24

catches 1 triangle_edge '06 visibility'
catches 2 small '06 visibility'
for damage in 3 4 5; do catches $damage small '12 splat'; done
catches 6 triangle_side '12 splat'
catches 9 triangle_behind '12 splat'

# scatters EFFECT METHOD OPTION...: stored points in depth maps, as they are and half a texel away.
scatters() {
	local effect=$1 method=$2 from=$scratch/$1/trace-$2 to=$scratch/$1/numpy
	shift 2
	run render "$effect" atrium:triangles=10000 --method "$method" --size 96x54 --reflectors 0 --set lamp.views=67 \
		--set lamp.cubes=2 --set depth_map.px=32 --set points.buffered=on "$@" --trace --no-images -o "$scratch/$effect"
	"$python" tests/ports/numpy/port.py "$from" "$to" --stages scatter && run compare "$from" "$to"
	[ "$status" -eq 0 ] && grep -q '^1 buffers judged, 0 different' "$scratch/stdout"
	verdict $? "numpy has the same bits: $effect by $method"
	"$python" tests/ports/numpy/port.py "$from" "$to" --stages scatter --break 3 && run compare "$from" "$to"
	[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" | grep -q '^stage .. scatter, buffer depth_map.depth'
	verdict $? "numpy with damage 3: stage scatter differs in $effect by $method"
}
scatters soft-shadows ivir --set lamp.source=scene
scatters omni-shadows vir

finish
