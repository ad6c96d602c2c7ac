#!/bin/bash
# Goldens of scenes of one's own, in a folder of one's own: camera, eye, lamp and mirrors; patterns of cases.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/stamp.bash"
export OMP_WAIT_POLICY=passive # other tests run beside this one
scenes=$(realpath scenes) core=$(realpath "${BUILD:-build/release}/touchstone-core")
stamp clean-1 "$scratch"
touchstone=$scratch/touchstone
cd "$scratch" || exit
mkdir -p own/goldens own/assets
cp "$scenes/room.gltf" own/assets
cp "$scenes/splats.ply" own/goldens
lamp='--lamp 0,2,0.5 --set lamp.views=6 --set depth_map.px=32'
cat > own/goldens/cases.txt <<CASES
eye-mirror: epr ../assets/room.gltf --size 32x18 --mirror 0,1,0,0.5 --set cube.max_px=16 --eye 1,1,2 --fov 70 --small
eye-lamp: soft-shadows/mvr ../assets/room.gltf --size 32x18 --camera circle $lamp
points: surfels/deferred ../assets/room.gltf --from-mesh 2000 --camera door --size 32x18
ply: surfels/deferred splats.ply --size 32x18
inside: mvr atrium:triangles=10000:texels=32 --size 32x18 --mirror 0,1,0,0.5 --set cube.max_px=16
CASES
golden() { run golden "$@" --goldens own/goldens; }
# cases LINE NAME: the last run printed a line of each of these.
cases() {
	[ "$status" -eq 0 ] && [ "$(cut -c 12- stdout | tr '\n' ' ')" = "$1 " ]
	verdict $? "$2"
}

golden new
cases 'eye-mirror eye-lamp points ply inside' 'goldens of scenes of files are proposed'
golden bless 'eye-*' --reason first
cases 'eye-mirror eye-lamp' 'bless takes a pattern'
golden bless inside 'p*' --reason first -q
[ "$status" -eq 0 ] && [ ! -s stdout ]
verdict $? 'bless takes several names, and is quiet by -q'
golden check
[ "$status" -eq 0 ] && tail -n 1 stdout | grep -qx '5 passed, 0 failed, 0 skipped'
verdict $? 'and are the same'
(cd own && "$touchstone" golden check --goldens goldens ply > ../stdout) &&
	(cd own/goldens && "$touchstone" golden check --goldens . ply > ../../stdout)
verdict $? 'from any folder'
golden check ply '*-lamp' eye-lamp
[ "$(tail -n 1 stdout)" = '2 passed, 0 failed, 0 skipped' ] && head -n 1 stdout | grep -q eye-lamp
verdict $? 'each case that is named is judged once, in the order of the table'
refuses 'no case "x\*"' golden check ply 'x*' --goldens own/goldens
grep -qx 'scene=../assets/room.gltf' own/goldens/eye-mirror/params.txt &&
	grep -qx 'mirror=0,1,0,0.5' own/goldens/eye-mirror/params.txt
verdict $? 'params.txt says the scene and its places'

# The same picture as by render, with the same options.
run render reflections own/assets/room.gltf --method epr --size 32x18 --mirror 0,1,0,0.5 --set cube.max_px=16 \
	--eye 1,1,2 --fov 70 -o out
run compare out/epr.png own/goldens/eye-mirror/preview.png
[ "$status" -eq 0 ]
verdict $? 'a golden has the picture that render makes'

# Each place matters; its order does not.
# moved FROM TO PATTERN: an edit of cases.txt is found.
moved() {
	cp own/goldens/cases.txt kept
	sed -i "s|$1|$2|" own/goldens/cases.txt
	golden check 'eye-*' inside
	cp kept own/goldens/cases.txt
	[ "$status" -eq "$3" ] && grep -q -- "$4" stdout
	verdict $? "$1 becomes $2: $4"
}
moved '--eye 1,1,2' '--eye 1,1,3' 1 'params.txt: of the scene.s options "eye=1,1,2", but cases.txt makes it "eye=1,1,3"'
moved '--lamp 0,2,0.5' '' 1 'options "lamp=0,2,0.5", but cases.txt makes it ""'
moved '--camera circle --lamp 0,2,0.5' '--lamp 0,2,0.5 --camera circle' 0 '^3 passed'
moved '--mirror 0,1,0,0.5 --set' '--mirror 0,1,0,0.5 --mirror 1,1,1,0.5 --set' 1 \
	'but cases.txt makes it "mirror=1,1,1,0.5"'

# The file matters: another position is a difference of the scene's arrays.
cp own/assets/room.gltf kept.gltf
python3 - <<'PY'
import json
scene = json.load(open("own/assets/room.gltf"))
scene["nodes"][0].setdefault("translation", [0, 0, 0])[0] += 0.125
json.dump(scene, open("own/assets/room.gltf", "w"))
PY
golden check eye-mirror
[ "$status" -eq 1 ] && grep -q '^different  eye-mirror  00-scene\.vertex' stdout
verdict $? 'a scene that was changed is found, by its first array'

# A golden's folder is a trace of digests, of its small buffers and of its picture.
golden new 'eye-*'
run compare own/goldens/eye-lamp own/goldens/eye-lamp.new
[ "$status" -eq 1 ] &&
	grep -q \
		'^stage 00 scene, buffer scene.vertex, SHA-256 ref .*, as each side leaves its file out; of the scene, which no stage makes' \
		stdout &&
	grep -Eq '^image.shadow +image.srgb +1,728 +[1-9][0-9]* .* different$' stdout
verdict $? 'compare tells the stage that moved, and the pixels'
run compare own/goldens/eye-mirror own/goldens/eye-mirror.new
[ "$status" -eq 1 ] && grep -q 'buffer scene.vertex, .* field position.*: ref .* ulp' stdout
verdict $? 'and the element of a small buffer'
run report own/goldens/eye-lamp own/goldens/eye-lamp.new -o page.html
[ "$status" -eq 0 ] && [ "$(grep -c '"picture":' page.html)" -ge 1 ] &&
	grep -q 'stage 00 scene, buffer scene.vertex' page.html
verdict $? 'a page has the old beside the new'
run render soft-shadows own/assets/room.gltf --method mvr --size 32x18 --camera circle --lamp 0,2,0.5 \
	--set lamp.views=6 --set depth_map.px=32 --trace --no-images -o traced
run compare own/goldens/eye-lamp.new traced/trace-mvr
[ "$status" -eq 0 ] && grep -q ' 0 different, 0 missing' stdout
verdict $? 'a port is compared with a golden'
cp own/goldens/ply/preview.png own/goldens/eye-lamp.new/preview.png
refuses 'eye-lamp.new/preview.png: not the picture whose digest SHA256SUMS says' compare own/goldens/eye-lamp \
	own/goldens/eye-lamp.new
rm -r own/goldens/*.new
rm own/assets/room.gltf
golden check
[ "$status" -eq 2 ] && tail -n 1 stdout | grep -qx '2 passed, 3 failed, 0 skipped' &&
	grep -q 'unusable .*room.gltf: No such file' stdout
verdict $? 'a scene that is gone spoils its own cases alone'
mv kept.gltf own/assets/room.gltf

# The static core reads built-in scenes; the library checks a golden by its folder.
"$core" golden check --goldens own/goldens > stdout 2> stderr
[ $? -eq 2 ] && [ "$(grep -c '^unusable .*is no built-in scene' stdout)" -eq 4 ] && grep -q '^same  *inside' stdout
verdict $? 'touchstone-core judges the cases of built-in scenes'
finish
