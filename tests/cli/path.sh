#!/bin/bash
# --path: an eye that moves along keyframes, in pictures, traces, replay and the sizes of cubes.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2

scene=gallery:triangles=10000:texels=32
cat > eye.txt <<'TXT'
# frame, eye, target
0 2,1.5,2 0,1,0
6 -2,1.5,2 0,1,0
12 -1,1.2,-1 1,1,0
TXT
small=(--method epr --size 96x54 --reflectors 2 --set cube.hysteresis=8)
render=(render reflections "$scene" "${small[@]}" --path eye.txt)

same() { cmp -s "$1/trace-epr/$3" "$2/trace-epr/$3"; }

run "${render[@]}" --frames 0..14 -o frames
for frame in 0 5 9 14; do
	run "${render[@]}" --frame $frame --trace -o alone-$frame
	[ "$status" -eq 0 ] && cmp alone-$frame/epr.exr "frames/frame-$(printf %06d $frame)/epr.exr" &&
		cmp alone-$frame/epr.png "frames/frame-$(printf %06d $frame)/epr.png"
	verdict $? "frame $frame alone and in a sequence: the same picture"
done

run replay alone-9/trace-epr
[ "$status" -eq 0 ] && grep -q 'eye.view: same' stdout && grep -q 'cube_size: same' stdout
verdict $? 'replay takes the path from the trace'
[ -s alone-9/trace-epr/00-scene.path.npy ] && same alone-5 alone-9 00-scene.path.npy &&
	! same alone-5 alone-9 01-eye.view.npy
verdict $? 'a trace has the path; the eye moves'

# The same pictures by an eye that stands at a keyframe.
run render reflections "$scene" --method mvr --size 96x54 --reflectors 0 --frame 6 --path eye.txt --trace -o key
run render reflections "$scene" --method mvr --size 96x54 --reflectors 0 --frame 6 --eye=-2,1.5,2 --target 0,1,0 \
	--trace -o still
cmp -s key/trace-mvr/01-eye.view.npy still/trace-mvr/01-eye.view.npy &&
	"$touchstone" compare key/mvr.png still/mvr.png > stdout
verdict $? 'at a keyframe the eye is where --eye puts it'

run render reflections "$scene" --method mvr --size 96x54 --reflectors 0 --trace -o own
[ ! -e own/trace-mvr/00-scene.path.npy ]
verdict $? 'without --path a trace has no path'

python3 - alone-9/trace-epr/00-scene.path.npy <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[-64 * 4 : -64 * 4 + 4] = b"\x00\x00\xc0\x7f" # the eye's x of frame 9
open(sys.argv[1], "wb").write(data)
PY
refuses 'scene.path.*a finite number' replay alone-9/trace-epr --stage eye.view

refuses 'choose one of them' info "$scene" --path eye.txt --eye 1,2,3
refuses 'choose one of them' info "$scene" --path eye.txt --eye 1,2,3 --target 1,2,4
refuses 'choose one of them' info "$scene" --path eye.txt --camera circle
refuses 'No such file' info "$scene" --path none.txt
refuses 'regular file' info "$scene" --path /dev/zero
printf '0 1,2,3 4,5,6\n0 1,2,3 4,5,7\n' > bad.txt
refuses 'bad.txt:2: its frame' "${render[@]:0:3}" --path bad.txt
run info checkerboard:surfels=10000 --path eye.txt
verdict "$status" 'a built-in scene with a camera of its own'
finish
