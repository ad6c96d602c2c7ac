#!/bin/bash
# Nodes and cameras that a glTF file moves, against closed forms in double precision, in pictures, traces and replay.
. "$(dirname "$0")/tap.bash"
animated=$(realpath "$(dirname "$0")")/animated.py
cd "$scratch" || exit 2

/usr/bin/python3 "$animated" write animated.gltf
small=(--method epr --size 96x54 --reflectors 2 --set cube.hysteresis=8)
render=(render reflections animated.gltf "${small[@]}")

run "${render[@]}" --frames 0..41 -o frames
for frame in 0 17 41; do
	run "${render[@]}" --frame $frame --trace -o alone-$frame
	[ "$status" -eq 0 ] && cmp alone-$frame/epr.exr "frames/frame-$(printf %06d $frame)/epr.exr"
	verdict $? "frame $frame alone and in a sequence: the same picture"
	/usr/bin/python3 "$animated" check alone-$frame/trace-epr $frame
	verdict $? "frame $frame: nodes, normals and eye are where the keyframes say"
done
run "${render[@]}" --frame 3 --reflectors 0 --trace -o early
run "${render[@]}" --frame 41 --reflectors 0 --trace -o late
cmp early/trace-epr/02-pose.vertex.npy late/trace-epr/02-pose.vertex.npy &&
	"$touchstone" compare early/epr.exr late/epr.exr > stdout
verdict $? 'after 38 frames the animation begins again'

run replay alone-17/trace-epr
[ "$status" -eq 0 ] && grep -q 'eye.view: same' stdout && grep -q 'pose: same' stdout &&
	grep -q 'cube_size: same' stdout
verdict $? 'replay takes motion and path from the trace'
prints 'bits agree with image.radiance' probe alone-17/trace-epr --pixel 48,27

# A mirror on a node that moves goes with it.
run render reflections animated.gltf --method epr --size 96x54 --reflectors 0 --reflector ball --frame 17 --trace \
	-o mirror
[ "$status" -eq 0 ] && /usr/bin/python3 - mirror/trace-epr "$animated" <<'PY'
import sys
import numpy as np
sys.path.insert(0, sys.argv[2].rpartition("/")[0])
import animated
face = np.load(sys.argv[1] + "/03-cube_size.face.npy")[0]
corners = np.array([[0, 0, 0], [-1.5, 0, 0], [0, 1.5, 0], [0, 0, 1.5]]) + animated.BALL
matrix = animated.places(17)[1]
world = corners @ matrix[:3, :3].T + matrix[:3, 3]
animated.near(face["box_min"], world.min(axis=0), "box")
animated.near(face["box_max"], world.max(axis=0), "box")
PY
verdict $? 'a reflector moves with its node'

# The rotations as normalized shorts.
/usr/bin/python3 "$animated" write shorts.gltf shorts
run render reflections shorts.gltf "${small[@]}" --frame 17 --trace -o shorts
[ "$status" -eq 0 ] && /usr/bin/python3 "$animated" check shorts/trace-epr 17 shorts
verdict $? 'rotations of normalized integers'

# What does not move has no motion, and the bits that it had.
/usr/bin/python3 "$animated" write still.gltf still
run render reflections still.gltf "${small[@]}" --frame 5 --trace -o still
run render reflections animated.gltf "${small[@]}" --frame 5 --animation none --trace -o none
[ ! -e still/trace-epr/00-scene.motion.npy ] && [ ! -e still/trace-epr/00-scene.path.npy ] &&
	[ ! -e none/trace-epr/00-scene.motion.npy ] &&
	"$touchstone" compare still/epr.exr none/epr.exr > stdout
verdict $? '--animation none: all stands still'
run render reflections animated.gltf "${small[@]}" --animation rest --trace -o rest
[ "$status" -eq 0 ] && [ ! -e rest/trace-epr/00-scene.motion.npy ] && [ -s rest/trace-epr/00-scene.path.npy ]
verdict $? '--animation NAME: another one, of the eye alone'
prints 'of 2 animations "turn" is played' info animated.gltf
refuses 'no animation is named "walk"; there are 2: "turn", "rest"' info animated.gltf --animation walk
refuses 'built-in scenes have no animations' info atrium --animation walk

/usr/bin/python3 "$animated" write long.gltf long
prints 'the animation lasts 4.61169e+18 seconds: the first [0-9]* frames are played' info long.gltf

cp -r alone-17 broken
/usr/bin/python3 - broken/trace-epr/00-scene.motion.npy <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[-12:-8] = b"\x03\0\0\0" # moves of the last record
open(sys.argv[1], "wb").write(data)
PY
refuses 'scene.motion.*moves: 3 .*; 0, 1 or 2 would be right' replay broken/trace-epr --stage pose

while read -r defect words; do
	/usr/bin/python3 "$animated" write bad.gltf "$defect"
	refuses "$words" info bad.gltf
done <<'TXT'
nan is not finite
unsorted item 2 is 0.5; a time after 1
negative a time from 0 is expected
few 3 items for 2 times; 2 are expected
range input is 999; a whole number
sampler sampler is 9; the animation has 4
type the type is not what this use needs
twice the rotation of nodes/1 is animated already
matrix nodes/1 has a matrix
cycle nodes/2
huge beyond 16777216
zero quaternion of length 0
TXT

finish
