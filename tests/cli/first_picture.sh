#!/bin/bash
# The first picture of a scene that nobody prepared, without any option but a size: scenes made to be hard, and files of
# TS_SCENES where they are.
. "$(dirname "$0")/tap.bash"
here=$(realpath "$(dirname "$0")")
cd "$scratch" || exit 2
mkdir scenes && python3 "$here/first/scenes.py" scenes || exit 2

# shows SCENE EFFECT METHOD WHAT...: the picture keeps what tests/cli/first/picture.py asks of it.
shows() {
	local scene=$1 effect=$2 method=$3
	shift 3
	run render "$effect" "$scene" --method "$method" --size 128x72 -o picture --force
	[ "$status" -eq 0 ] && python3 "$here/first/picture.py" "picture/$method.png" stdout stderr "$@"
	verdict $? "$effect of $(basename "$scene"): lit $*"
}

# all SCENE WHAT...: four effects; mirrors are in the first alone.
all() {
	shows "$1" reflections epr mirrors
	shows "$1" soft-shadows mvr "${@:2}"
	shows "$1" omni-shadows mvr "${@:2}"
	shows "$1" indirect direct
}

all scenes/far_room.gltf
all scenes/millimetres.gltf
all scenes/closed_box.gltf
all scenes/model.gltf tall
shows scenes/model_on_ground.gltf soft-shadows mvr
for scene in fireplace_room cornell_box_original; do
	[ -s "${TS_SCENES:-}/$scene.glb" ] && all "$TS_SCENES/$scene.glb"
done
for scene in suzanne chess_board; do
	[ -s "${TS_SCENES:-}/$scene.glb" ] && all "$TS_SCENES/$scene.glb" tall
done

# The room is that of 10 units, not the ground of 10000; the eye is in it.
run info scenes/far_room.gltf --json
python3 - stdout <<'PY'
import json, sys
info = json.load(open(sys.argv[1]))
sides = [b - a for a, b in zip(info["box_min"], info["box_max"])]
assert 2 < sides[1] < 4 and 7 < sides[0] < 9 and 5 < sides[2] < 7, sides
PY
verdict $? 'a room on a wide ground is the box'

run render reflections scenes/model.gltf --method epr --size 96x54 --no-images --eye 0,1,9 --target 0,1,0 --fov 30 \
	--mirror 2,1,0,0.5 --mirror -2,1,0,0.5
[ "$status" -eq 0 ] && grep -q ', 2 mirrors' stdout && [ ! -s stderr ]
verdict $? '--eye, --target, --fov and --mirror'

run render reflections scenes/model.gltf --method epr --size 96x54 --no-images --eye 0,1,9 --target 0,1,20
[ "$status" -eq 0 ] && [ "$(grep -c 'no mirror is in the picture; try --mirror' stderr)" -eq 0 ]
verdict $? 'mirrors come where the eye looks'

run render reflections scenes/model.gltf --method epr --size 96x54 --no-images --eye 0,1,9 --target 0,1,20 \
	--mirror 0,1,0,1
[ "$status" -eq 0 ] && grep -q 'no mirror is in the picture; try --mirror' stderr &&
	grep -q 'of the picture is sky; try --eye and --target' stderr && [ "$(wc -l < stderr)" -eq 2 ]
verdict $? 'a picture without its mirrors, of the sky alone, says so'

run render indirect scenes/far_room.gltf --method direct --size 96x54 --no-images --set light.irradiance=0
[ "$status" -eq 0 ] && grep -q 'of the picture is black; try --lamp' stderr
verdict $? 'a black picture says so'

run render reflections gallery:triangles=10000:texels=32 --reflectors 0 --method mvr --size 96x54 --no-images \
	--set image.exposure=1000
[ "$status" -eq 0 ] && grep -q 'of the picture is white; try --exposure auto' stderr
verdict $? 'a white picture says so'

render=(render soft-shadows scenes/far_room.gltf --method mvr --size 96x54 --trace -o traced --force --set lamp.views=4)
run "${render[@]}" --lamp 3000,-2.5,1200 && run replay traced/trace-mvr
[ "$status" -eq 0 ] && grep -q 'lamp: same' stdout && [ -s traced/trace-mvr/00-scene.stand.npy ]
verdict $? 'a trace has the place of the lamp, and replay uses it'

run render soft-shadows gallery:triangles=10000:texels=32 --method mvr --size 96x54 --trace-only scene -o own --force \
	--set lamp.views=4
[ "$status" -eq 0 ] && [ ! -e own/trace-mvr/00-scene.stand.npy ]
verdict $? 'a built-in scene has its lamp where the hall says'

scene=scenes/model.gltf
refuses 'not X,Y,Z' info $scene --eye 1,2
refuses 'not X,Y,Z,R' info $scene --mirror 1,2,3
refuses 'is not X,Y,Z' info $scene --eye nan,1,2
refuses 'not finite or beyond' info $scene --lamp 1e9,1,2
refuses 'is not X,Y,Z,R' info $scene --mirror 1,inf,2,1
refuses 'it is its target' info $scene --eye 1,2,3 --target 1,2,3
refuses 'target: an eye' info $scene --target 1,2,3
refuses 'radius must be above 0' info $scene --mirror 1,2,3,0
refuses 'choose one of them' info $scene --eye 1,2,3 --camera circle
refuses 'from 1 to 150' info $scene --fov 0
finish
