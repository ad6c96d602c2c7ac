#!/bin/bash
# `probe`: text and JSON, what is not there, buffers that are missing, and traces that lie.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
"$touchstone" render reflections atrium:triangles=10000:texels=32 --size 64x64 --reflectors 2 --set reflectors.px=24 \
	--set cube.max_px=16 \
	--set lookup.bounces=2 --no-images --self-contained -o out > /dev/null || { echo "Bail out! no trace"; exit 1; }
epr=out/trace-epr mvr=out/trace-mvr

# u32 FILE ELEMENT: a number behind the header of a .npy file.
u32() {
	local header
	header=$((10 + $(od -An -tu2 -j8 -N2 "$1")))
	od -An -tu4 -j $((header + 4 * $2)) -N4 "$1" | tr -d ' '
}

# pixel of the first record: fields position[3], index
index=$(u32 $epr/05-mirror_pixel.record.npy 3)
mirror=$((index % 64)),$((index / 64))

# says PATTERN ARGUMENT...: text that matches; with JSON it is kept for `told`.
mkdir kept
asked=()
says() {
	prints "$@"
	shift
	mv stdout "kept/${#asked[@]}.text"
	run "$@" --json
	[ "$status" -eq 0 ] && mv stdout "kept/${#asked[@]}.json"
	asked+=("$*")
}
# told: what `says` kept: text has what the JSON has, which agrees wherever it checks itself.
told() {
	local i good why
	python3 - ${#asked[@]} > judged <<'PY'
import json, sys
def checks(v):
	if isinstance(v, dict):
		return [v[k] for k in v if k == "check"] + [c for m in v.values() for c in checks(m)]
	return [c for m in v for c in checks(m)] if isinstance(v, list) else []
def told(v):
	"""As text has it on one line; None: on several."""
	if isinstance(v, dict):
		both = [v.get("value"), v.get("bits")] if set(v) == {"value", "bits"} else [None]
		bits = " ".join(both[1]) if isinstance(both[-1], list) else both[-1]
		return None if bits is None else f"{told(both[0])} ({bits})"
	if isinstance(v, list):
		parts = [None if isinstance(m, dict) else told(m) for m in v]
		return None if None in parts else "[" + ", ".join(parts) + "]" if parts else "none"
	return ("no", "yes")[v] if isinstance(v, bool) else "%.9g" % v if isinstance(v, float) else str(v)
def look(v, lines):
	for key, member in v.items():
		text = told(member)
		if isinstance(member, dict) and text is None:
			look(member, lines)
		assert key == "trace" or text is None or len(text) > 400 or f"{key}: {text}" in lines, (key, text)
for i in range(int(sys.argv[1])):
	try:
		answer = json.load(open(f"kept/{i}.json"))
		look(answer, {line.strip() for line in open(f"kept/{i}.text")})
		found = checks(answer)
		print(0 if found and all(c.startswith("bits agree with") for c in found) else 1)
	except (AssertionError, OSError, ValueError) as error:
		print(1, repr(error))
PY
	for i in "${!asked[@]}"; do
		read -r good why
		verdict "${good:-1}" "JSON of: ${asked[i]}"
		[ -z "$why" ] || echo "# $why"
	done < judged
}

for trace in $epr $mvr; do
	says 'bits agree with image.radiance' probe $trace --pixel "$mirror"
	says 'bits agree with shade.radiance' probe $trace --pixel "$mirror"
	says 'bits agree with image.radiance' probe $trace --pixel 3,60 --view eye
	says 'won_by' probe $trace --pixel 7,8 --view 0.+X
	says 'competitors' probe $trace --pixel 7,8 --view 1.5
done
says 'lost_at' probe $epr --triangle 4
prints 'lost_at' probe $mvr --triangle 4
says 'splat_length' probe $epr --point 0

# Four samples a pixel: each is explained, and their mean.
"$touchstone" render reflections atrium:triangles=10000:texels=32 --size 32x24 --method epr,mvr --reflectors 2 \
	--set reflectors.px=12 \
	--set cube.max_px=16 --set eye.samples=4 --no-images --trace -o four > /dev/null ||
	{ echo "Bail out! no trace"; exit 1; }
seen=$(($(u32 four/trace-epr/05-mirror_pixel.record.npy 3) % (32 * 24)))
for trace in four/trace-epr four/trace-mvr; do
	says 'bits agree with image.sample_radiance' probe $trace --pixel $((seen % 32)),$((seen / 32))
	says 'bits agree with image.radiance' probe $trace --pixel 3,20
done
key=$("$touchstone" probe $epr --point 5 | sed -n 's/^key: //p')
says '^point: 5$' probe $epr --point "$key"

refuses 'must be given' probe $epr
refuses 'must be given' probe $epr --pixel 1,1 --triangle 0
refuses 'goes with --pixel' probe $epr --triangle 1 --view eye
refuses 'X,Y' probe $epr --pixel 5
refuses 'X,Y' probe $epr --pixel 5,6,7
refuses 'whole number' probe $epr --pixel 5,-1
refuses 'no pixel (64, 0); the eye has 64 x 64' probe $epr --pixel 64,0
refuses 'no view ear of reflections by epr, only .*REFLECTOR.FACE, for instance 3.+X' probe $epr --pixel 0,0 --view ear
refuses 'no view 0.+W of .*REFLECTOR.FACE' probe $epr --pixel 0,0 --view 0.+W
refuses 'no view 0.6 of .*REFLECTOR.FACE' probe $epr --pixel 0,0 --view 0.6
refuses 'no face 2.0; there are 2' probe $epr --pixel 0,0 --view 2.0
refuses 'no texel (16, 0)' probe $epr --pixel 16,0 --view 0.0
refuses 'no triangle' probe $epr --triangle 4000000000
refuses 'no point' probe $epr --point 4294967294
refuses 'neither an index nor a key' probe $epr --point 1,2
refuses 'no point of key' probe $epr --point 0,32000,0
refuses 'no points of reflections by mvr, only .*triangles' probe $mvr --point 0
refuses 'trace.json' probe /nonexistent --pixel 0,0
"$touchstone" render reflections atrium:triangles=10000:texels=32 --size 32x32 --reflectors 2 --set cube.max_px=16 \
	--set octree.levels=5 --set cube_view.px=16 --method ivir,megaviews --no-images --trace -o cubes > /dev/null
for method in ivir megaviews; do says 'bits agree with shade.radiance' probe cubes/trace-$method --pixel 16,16; done
for view in 0.front 1.back node0.front; do
	says 'bits agree with view_map.depth_node' probe cubes/trace-megaviews --pixel 8,9 --view $view
done
prints 'omni-shadows by ivir, vir, epr, mvr$' help probe
prints 'VIEW REFLECTOR.FACE, for instance 3.+X or 3.0: the triangles that' help probe

# Shadows: each sample's question, and what adds up to the picture.
shadows=(atrium:triangles=10000:texels=32 --size 64x64 --set lamp.views=4 --set lamp.cubes=2 --set depth_map.px=64
	--no-images --trace)
for words in 'soft-shadows mvr' 'soft-shadows pcss' 'omni-shadows epr'; do
	read -r effect method <<< "$words"
	"$touchstone" render "$effect" "${shadows[@]}" --method "$method" -o "$effect-$method" > /dev/null
	says 'bits agree with shadow_test.lit' probe "$effect-$method/trace-$method" --pixel 20,40
	says 'bits agree with image.radiance' probe "$effect-$method/trace-$method" --pixel 33,60
done
soft=soft-shadows-mvr/trace-mvr
prints 'answer: reaches' probe $soft --pixel 33,60
prints 'blocker_depth\|search_radius' probe soft-shadows-pcss/trace-pcss --pixel 33,60
refuses 'no triangles of soft-shadows by mvr, only the eye' probe $soft --triangle 4
refuses 'no view 0.+X of omni-shadows by epr, only the eye' probe omni-shadows-epr/trace-epr --pixel 3,3 --view 0.+X
run render soft-shadows "${shadows[@]}" --method ivir --trace-only scene,eye,eye.view,pose,lamp,lamp.view,shadow_test \
	-o lacks
refuses 'this needs depth_map.depth' probe lacks/trace-ivir --pixel 33,60

# Indirect light: why this box, what its corners gathered, and the lobes; or the triangles of light.
for method in hulls direct; do
	"$touchstone" render indirect atrium:triangles=10000:texels=32 --size 64x64 --set depth_grid.px=64 --set rsm.px=4 \
		--no-images --trace --method $method -o indirect-$method > /dev/null
	says 'bits agree with indirect.irradiance' probe indirect-$method/trace-$method --pixel 20,40
	says 'bits agree with image.radiance' probe indirect-$method/trace-$method --pixel 33,60
	refuses "no triangles of indirect by $method, only the eye" probe indirect-$method/trace-$method --triangle 4
done
hulls=indirect-hulls/trace-hulls direct=indirect-direct/trace-direct
prints 'bits agree with hull.box' probe $hulls --pixel 20,40
prints 'fit: holds the pixel; thickness: ' probe $hulls --pixel 20,40
prints 'form_factor: ' probe $direct --pixel 20,40
run render indirect atrium:triangles=10000:texels=32 --size 64x64 --set depth_grid.px=64 --set rsm.px=4 --method hulls \
	--trace-only scene,eye,eye.view,pose,lamp,rsm.view,rsm.patch -o lacks-hulls
refuses 'this needs segment.box_offset, segment.box, corner.moment, corner.lobes' probe lacks-hulls/trace-hulls \
	--pixel 33,60

# Many views: what culling leaves, the lights that are drawn, what their maps show, and the filter.
views=(atrium:triangles=10000:texels=32 --size 64x64 --set octree.levels=5 --set rsm.px=4 --set particle.count=64
	--no-images)
for words in 'indirect megaviews' 'indirect manylods' 'particles megaviews' 'particles manylods'; do
	read -r effect method <<< "$words"
	"$touchstone" render "$effect" "${views[@]}" --set vpl.bounces=2 --trace --method "$method" -o "$effect-$method" \
		> /dev/null
	says 'bits agree with vpl_gather.irradiance' probe "$effect-$method/trace-$method" --pixel 20,40
	says 'bits agree with indirect.irradiance' probe "$effect-$method/trace-$method" --pixel 33,60
	prints 'terms add up to the bits of the total' probe "$effect-$method/trace-$method" --pixel 33,60
	refuses "no triangles of $effect by $method, only the eye" probe "$effect-$method/trace-$method" --triangle 4
done
mega=indirect-megaviews/trace-megaviews glow=particles-megaviews/trace-megaviews
for pattern in 'bits agree with vpl_gather.pair_node' 'bounce: 2; triangle: ' 'answer: in shadow' \
	'why: both are leaves' 'bits agree with view_map.depth_node' 'bits agree with bilateral.filtered_rows'; do
	prints "$pattern" probe $mega --pixel 30,50
done
"$touchstone" render indirect "${views[@]}" --set vpl.place=random --trace --method megaviews -o indirect-random \
	> /dev/null
run probe indirect-random/trace-megaviews --pixel 30,50
grep -A1 'begins_at:' "$scratch/stdout" | grep -q 'triangle: ' &&
	grep -q 'bits agree with vpl.light' "$scratch/stdout" &&
	! grep -q differ "$scratch/stdout"
verdict $? 'a light at random begins on a triangle'
"$touchstone" render indirect "${views[@]}" --set vpl_gather.query=descend --trace --method megaviews \
	-o indirect-descend > /dev/null
for pattern in 'bits agree with vpl_gather.irradiance' 'answer: in shadow' 'bits agree with view_map.depth_node'; do
	prints "$pattern" probe indirect-descend/trace-megaviews --pixel 30,50
done
"$touchstone" render indirect "${views[@]}" --set octree.levels=4 --set traverse.hierarchies=views --trace \
	--method megaviews -o indirect-leaves > /dev/null
says 'bits agree with view_map.depth_node' probe indirect-leaves/trace-megaviews --pixel 8,9 --view 0.front
refuses 'stage view_map.fuse is not run with the parameters of this trace' replay indirect-descend/trace-megaviews \
	--stage view_map.fuse
refuses 'this needs view_map.fused_depth, view_map.fused_node' probe indirect-descend/trace-megaviews --pixel 8,9 \
	--view 0.front
"$touchstone" render indirect "${views[@]}" --trace --method bruteforce -o indirect-bruteforce > /dev/null
for method in megaviews manylods bruteforce; do
	says 'bits agree with view_map.fused_depth' probe "indirect-$method/trace-$method" --pixel 8,9 --view 0.front
	says 'bits agree with view_map.depth_node' probe "indirect-$method/trace-$method" --pixel 7,7 --view node1.back
done
prints 'direction: in the corner' probe $mega --pixel 0,0 --view 0.front
refuses 'no texel (16, 0); halves of maps have 16 x 16' probe $mega --pixel 16,0 --view 0.front
refuses 'no light 4000; there are' probe $mega --pixel 0,0 --view 4000.front
refuses 'no node of views 4000; there are' probe $mega --pixel 0,0 --view node4000.front
refuses 'no view nod4.front of .*nodeN.front' probe $mega --pixel 0,0 --view nod4.front
refuses 'no view 4 of .*LIGHT.front' probe $mega --pixel 0,0 --view 4
refuses 'no view 0.+X of indirect by megaviews, only the eye' probe $mega --pixel 0,0 --view 0.+X
refuses 'no view 0.front of reflections by epr, only the eye' probe $epr --pixel 0,0 --view 0.front
refuses 'no view 0.front of soft-shadows by mvr, only the eye' probe $soft --pixel 0,0 --view 0.front
run render indirect "${views[@]}" --method megaviews --trace-only scene,eye,eye.view,pose,lamp,rsm.view,rsm.patch \
	-o lacks-views
refuses 'no file of gbuffer.pixel, .*vpl_gather.pair_views' probe lacks-views/trace-megaviews --pixel 33,60
refuses 'this needs view_map.depth_node, view_map.fused_depth, view_map.fused_node, view_octree.leaf' probe \
	lacks-views/trace-megaviews --pixel 3,6 --view 0.front
run render particles "${views[@]}" --method megaviews --trace-only scene,eye,eye.view,pose -o lacks-glow
refuses 'this needs vpl.light' probe lacks-glow/trace-megaviews --pixel 33,60

# Surfels: what is nearest, blended, hidden, and made of it.
splats=(atrium:triangles=10000:texels=32 --size 64x64 --set surfels.from_mesh=4000 --set depth_map.px=64 --no-images)
for words in 'deferred phong_shadow' 'ewa npr'; do
	read -r method shader <<< "$words"
	"$touchstone" render surfels "${splats[@]}" --set deferred.shader="$shader" --trace --method "$method" \
		-o "surfels-$method" > /dev/null
	for pattern in surfel_depth.surfel surfel_blend.sum surfel_blend.heaviest gbuffer.pixel image.radiance; do
		says "bits agree with $pattern" probe "surfels-$method/trace-$method" --pixel 20,40
	done
	prints 'terms add up to the bits of the total' probe "surfels-$method/trace-$method" --pixel 33,60
	refuses "no triangles of surfels by $method, only the eye" probe "surfels-$method/trace-$method" --triangle 4
	refuses 'no pixel (64, 0); the eye has 64 x 64' probe "surfels-$method/trace-$method" --pixel 64,0
done
deferred=surfels-deferred/trace-deferred ewa=surfels-ewa/trace-ewa
prints 'bits agree with shadow_test.lit' probe $deferred --pixel 33,60
prints 'by_neighbour' probe $ewa --pixel 33,60
"$touchstone" render surfels "$OLDPWD/scenes/room.gltf" "${splats[@]:1}" --camera circle \
	--set deferred.shader=phong_shadow --trace --method deferred -o bulb > /dev/null
for words in '33,60 -Y' '32,2 -X'; do
	read -r pixel face <<< "$words"
	prints "view: 0.$face; " probe bulb/trace-deferred --pixel "$pixel"
	prints 'bits agree with shadow_test.lit' probe bulb/trace-deferred --pixel "$pixel"
done
run render surfels "${splats[@]}" --method deferred --trace-only scene,eye.view,lamp,surfel_setup,surfel_depth \
	-o lacks-surfels
refuses 'no file of gbuffer.pixel, .*surfel_blend.sum' probe lacks-surfels/trace-deferred --pixel 33,60

# A trace without some stages names all that it lacks.
"$touchstone" render reflections atrium:triangles=10000:texels=32 --size 64x64 --reflectors 2 --set reflectors.px=24 \
	--set cube.max_px=16 \
	--method epr --no-images --trace-only scene,eye,mirror_pixel,eye.view,pose,cube_size,image -o part \
	> /dev/null 2>&1 ||
	"$touchstone" render reflections atrium:triangles=10000:texels=32 --size 64x64 --reflectors 2 \
	--set reflectors.px=24 \
		--set cube.max_px=16 --method epr --no-images --trace \
		--trace-only scene,eye,mirror_pixel,eye.view,pose,cube_size,image -o part > /dev/null
prints 'bits agree with image.radiance' probe part/trace-epr --pixel 3,60
refuses 'needs lookup.point, points.record' probe part/trace-epr --pixel "$mirror"
refuses 'needs visibility.bits, split.triangle_density' probe part/trace-epr --triangle 4
refuses 'needs points.key' probe part/trace-epr --point 1,2,3

# lies FILE ELEMENT BYTES PATTERN ARGUMENT...: four bytes of a file are others; they are named, and followed nowhere.
lies() {
	local file=$1 element=$2 bytes=$3 pattern=$4 header
	shift 4
	rm -rf bad
	cp -r $epr bad
	header=$((10 + $(od -An -tu2 -j8 -N2 "bad/$file")))
	printf "$bytes" | dd of="bad/$file" bs=1 seek=$((header + 4 * element)) conv=notrunc 2> /dev/null
	refuses "$pattern" probe bad "$@"
}

lies 04-eye.depth_triangle.npy 0 '\xff\xff\xff\x7f\x00\x00\x80\x3f' 'element 0 names 2147483647' --pixel 0,0
lies 00-scene.triangle.npy 0 '\xff\xff\xff\x7f' 'element 0 field vertex names' --pixel 0,0
lies 02-pose.vertex.npy 0 '\x00\x00\xc0\x7f' 'field position is 7fc00000, not a finite' --pixel 0,0
lies 14-lookup.point.npy 0 '\xfe\xff\xff\xff' 'element 0 names 4294967294' --pixel "$mirror"
lies 11-points.record.npy 4 '\xfe\xff\xff\xff' 'element 0 field piece names' --point 0
lies 03-cube_size.face.npy 7 '\xff\x0f\x00\x00' 'texel' --pixel 7,8 --view 0.0
lies 07-split.offset.npy 5 '\xff\xff\xff\x7f' 'pieces' --triangle 4
lies 00-scene.image.npy 0 '\xff\xff\x00\x00' 'no mip chain' --pixel 0,0
lies 01-eye.view.npy 7 '\xff\xff\xff\x7f' 'pixels; at most' --pixel 0,0
lies 15-lookup.second_offset.npy 1 '\x09\x00\x00\x00' 'one entry at most' --pixel "$mirror"
lies 05-mirror_pixel.offset.npy "$index" '\x21\x00\x00\x00' 'mirror_pixel.offset names it for pixel' --pixel "$mirror"
epr=$hulls
lies 12-segment.box_offset.npy 9 '\xff\xff\xff\x7f' 'element 9 is 2147483647, after ' --pixel 20,40
lies 12-segment.box.npy 2 '\x40\x00\x00\x00' 'element 0 field high names 64 of 64' --pixel 20,40
lies 12-segment.box.npy 0 '\x3f\x00\x00\x00' 'element 0: columns 63 to .* of 64' --pixel 20,40
lies 06-rsm.patch.npy 3 '\x00\x00\xc0\x7f' 'not a finite' --pixel 20,40
epr=$mega
lies 10-vpl.path.npy 1 '\xff\xff\xff\x7f' 'element 1 is 2147483647' --pixel 20,40
lies 13-view_octree.node.npy 6 '\xff\xff\xff\x7f' 'element 0, field parent' --pixel 20,40
lies 13-view_octree.leaf.npy 0 '\xff\xff\xff\x7f' 'less than .* (view_nodes) would be right' --pixel 20,40
lies 16-view_map.depth_node.npy 0 '\xff\xff\xff\x7f' 'names 2147483647' --pixel 20,40
lies 20-vpl_gather.pair_node.npy 0 '\xff\xff\xff\x7f' 'less than' --pixel 20,40
lies 20-vpl_gather.pair_offset.npy 1 '\xff\xff\xff\x7f' 'sum' --pixel 20,40
lies 14-view_octree.cone.npy 5 '\xff\xff\xff\x7f' 'field views' --pixel 20,40
lies 01-eye.view.npy 7 '\x20\x00\x00\x00' 'would be right' --pixel 20,40
lies 13-view_octree.node.npy 6 '\xff\xff\xff\x7f' 'element 0, field parent' --pixel 3,6 --view 0.back
lies 13-view_octree.leaf.npy 0 '\xff\xff\xff\x7f' 'element 0 names 2147483647' --pixel 3,6 --view 0.back
lies 16-view_map.depth_node.npy 0 '\xff\xff\xff\x7f' 'names 2147483647' --pixel 0,0 --view node0.front
lies 14-view_octree.cone.npy 0 '\x00\x00\xc0\x7f' 'a finite number' --pixel 3,6 --view node1.back
lies 09-octree.node.npy 4 '\x00\x00\x00\x00' 'field child' --pixel 3,6 --view node1.back
epr=$glow
lies 06-vpl.light.npy 0 '\x00\x00\xc0\x7f' 'a finite number' --pixel 20,40
epr=$deferred
lies 00-scene.surfel.npy 3 '\x00\x00\xc0\x7f' 'a finite number' --pixel 33,60
lies 03-surfel_setup.disc.npy 12 '\xff\xff\xff\xff' 'field low' --pixel 33,60
lies 04-surfel_depth.surfel.npy 2 '\xff\xff\xff\x7f' 'element 1: .* less than' --pixel 33,60
lies 05-surfel_blend.sum.npy 14 '\x00\x00\x00\x00' 'as surfel_blend.heaviest says' --pixel 33,60
lies 06-gbuffer.pixel.npy 3 '\x00\x00\x80\x7f' 'a finite number' --pixel 33,60
lies 07-offscreen.view.npy 7 '\xff\xff\xff\x7f' 'offscreen.view' --pixel 33,60
lies 02-lamp.light.npy 3 '\x01\x00\x00\x00' 'one view per light, and six where' --pixel 33,60
lies 09-shadow_test.lit.npy 5 '\x02\x00\x00\x00' 'the light' --pixel 33,60
epr=$soft
lies 04-offscreen.view.npy 7 '\xff\xff\xff\x7f' 'element 0: 2147483647 x 64' --pixel 33,60
lies 04-offscreen.view.npy 22 '\x01\x00\x00\x00' 'names 1 of 1' --pixel 33,60
lies 03-lamp.shape.npy 1 '\x05\x00\x00\x00' 'there are 4 views' --pixel 33,60
rm -rf bad
cp -r $soft bad
rm bad/06-depth_map.depth.npy
refuses 'depth_map.depth' probe bad --pixel 33,60
epr=out/trace-epr

# A wrong value is no lie that breaks anything: the check tells.
rm -rf bad
cp -r $epr bad
header=$((10 + $(od -An -tu2 -j8 -N2 bad/??-shade.radiance.npy)))
printf '\x00\x00\x80\x3f' | dd of="$(echo bad/??-shade.radiance.npy)" bs=1 seek=$header conv=notrunc 2> /dev/null
prints 'bits differ from shade.radiance, which holds 3f800000' probe bad --pixel "$mirror"

# The same of a map and of fusion: only the node whose map is wrong is told to differ.
for file in 16-view_map.depth_node 17-view_map.fused_depth; do
	rm -rf bad
	cp -r $mega bad
	header=$((10 + $(od -An -tu2 -j8 -N2 bad/$file.npy)))
	printf '\x00\x00\x00\x00\x00\x00\x80\x3f' | dd of=bad/$file.npy bs=1 seek=$header conv=notrunc 2> /dev/null
	prints "bits differ from ${file#*-}" probe bad --pixel 0,0 --view node0.front
done
prints 'bits agree with view_map.depth_node' probe bad --pixel 0,0 --view node0.front

told
finish
