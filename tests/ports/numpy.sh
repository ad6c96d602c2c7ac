#!/bin/bash
# The port of two stages to numpy: equal bits on two scenes and on the small ones, and each damaged line is found.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/numpy.bash"
if [ -z "$python" ]; then
	echo '1..0 # skip no python3 with numpy'
	exit 0
fi

# agrees FOLDER: both buffers of the port have the trace's bits.
agrees() {
	numpy_port "$1" && [ "$(grep -c ': equal' "$scratch/port")" -eq 2 ]
	verdict $? "numpy has the same bits: $1"
}

# catches N FOLDER BUFFER: with line N damaged, that buffer differs and no other one.
catches() {
	numpy_port "$2" --break "$1"
	[ $? -eq 1 ] && [ "$(grep DIFFERENT "$scratch/port" | cut -d: -f1)" = "$3" ]
	verdict $? "numpy, damage $1: $3 differs in $2"
}

reflectors=3
for scene in atrium gallery; do
	trace $scene $scene:triangles=10000 --size 240x135
	verdict $? "a trace of $scene"
	agrees $scene
done
reflectors=12
trace room scenes/room.gltf --size 240x135 --set visibility=vertex
agrees room
trace wide atrium:triangles=10000 --size 96x54 --set clip=off
agrees wide
reflectors=0
for scene in mirror twice edge; do
	trace $scene scenes/triangle_$scene.gltf --camera camera --size 64x64 --set face_px=16
	agrees $scene
done

catches 1 edge visibility.bits
catches 2 atrium visibility.bits
for damage in 3 4 5; do catches $damage atrium splat.depth_index; done

finish
