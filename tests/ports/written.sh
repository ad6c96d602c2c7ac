#!/bin/bash
# Ports written from the installed documents alone: equal bits, each of their questions has its answer in a document,
# and what reference/PORTING.md says goes wrong is found in the stage that it stands beside.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
find_numpy || exit 0

# same FOLDER STAGES EFFECT SCENE OPTION...: the port has the bits of its stages.
same() {
	local folder=$1 stages=$2 method
	shift 2
	rm -rf "$scratch/made" "$scratch/mine"
	run render "$@" --size 64x48 --trace --no-images -o "$scratch/made"
	method=$(basename "$scratch"/made/trace-*)
	"$python" "tests/ports/$folder/port.py" "$scratch/made/$method" "$scratch/mine" &&
		run compare "$scratch/made/$method" "$scratch/mine"
	[ "$status" -eq 0 ] && grep -q "^$stages buffers judged, 0 different" "$scratch/stdout"
	verdict $? "$folder: $*"
}

# catches FOLDER FILE SED STAGE TRAP: the port with that edit, of the trace that `same` had last,
# differs first in the stage.
catches() {
	status=0
	rm -rf "$scratch/wrong" "$scratch/mine"
	cp -R "tests/ports/$1" "$scratch/wrong" && sed -i "$3" "$scratch/wrong/$2" &&
		! cmp -s "$scratch/wrong/$2" "tests/ports/$1/$2" &&
		"$python" "$scratch/wrong/port.py" "$scratch"/made/trace-* "$scratch/mine" &&
		run compare "$scratch"/made/trace-* "$scratch/mine"
	[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" | grep -q "^stage .. $4, buffer"
	verdict $? "$1: stage $4 differs with $5"
}

same surfels 3 surfels checkerboard:surfels=10000 --method deferred
same surfels 3 surfels atrium:triangles=10000:texels=32 --from-mesh 4000 --method deferred --set surfels.radius=12 \
	--eye 0,2,0
same surfels 3 surfels checkerboard:surfels=10000 --method ewa
same surfels 3 surfels checkerboard:surfels=10000 --method deferred --set surfel_setup.bounds=botsch \
	--set ewa.filter=screen
catches surfels port.py 's|((f [*] (\(.*\))) / z) / z)|(f * (\1)) / (z * z))|' surfel_setup 'one division in J'
catches surfels port.py "s|disc\['depth'\] [*] by|disc['depth'] / w|" surfel_depth 'a division for a product'
catches surfels port.py 's|(f32(1) + qx [*] qx) + qy [*] qy|(qx * qx + qy * qy) + f32(1)|' surfel_depth \
	'|q| summed as a length'
answered tests/ports/surfels
same hulls 2 indirect atrium:triangles=10000:texels=32 --method hulls
same hulls 2 indirect atrium:triangles=10000:texels=32 --method hulls --set hull.corners=rectangle \
	--set hull.sharpness=vmf --eye 9,6,3 --target 2,1,-1
catches hulls port.py 's|moved = (.*|moved = np.ones(seen.shape, bool)|' corner 'every corner moved'
catches hulls port.py 's|pixel_of(x, .*, side), |np.minimum(x, 63), |' corner 'the texel for the pixel that it shows'
catches hulls port.py "s|== 'vmf'|!= 'vmf'|" corner.lobes 'the other sharpness'
same hulls 2 area-light atrium:triangles=10000:texels=32 --method hulls
answered tests/ports/hulls
views="--set octree.levels=3 --set vpl.paths=20"
same megaviews 2 indirect atrium:triangles=10000:texels=32 --method megaviews $views --set view_map.px=4
catches megaviews pairs.py 's|size(vs, d, d - rv|size(vs, d - rv, d - rv|' traverse "d' for d in cos α"
catches megaviews pairs.py 's|size(vs, d, d - rv|size(vs, d, d|' traverse "d for d' in sin ρ"
same megaviews 2 indirect atrium:triangles=10000:texels=32 --method megaviews --set octree.levels=3 --set vpl.paths=5 \
	--set view_map.px=32 --set view_map.apart=0
catches megaviews maps.py 's|for w in ends.1.|for w in ends[1][:1]|' view_map \
	'two of the four corners of a coarse texel'
same megaviews 2 indirect dining:triangles=10000:texels=32 --method megaviews $views --set view_map.px=8 \
	--set view_map.multipixel=texels --set view_map.fill=0.3
answered tests/ports/megaviews
finish
