#!/bin/bash
# Replay: every stage from its own trace, a port's stages from the port's buffers, and what cannot be replayed.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
run render reflections atrium:triangles=10000:texels=32 --method epr,mvr --size 64x48 --reflectors 2 \
	--set reflectors.px=24 --set cube.max_px=32 --set lookup.bounces=3 --self-contained -o out
[ "$status" -eq 0 ] || cat stderr
epr=out/trace-epr

for method in epr mvr; do
	run replay out/trace-$method
	[ "$status" -eq 0 ] && [ "$(grep -c ': same$' stdout)" -eq "$(wc -l < stdout)" ] && [ ! -s stderr ]
	verdict $? "$method: every stage is the same"
done
[ "$(wc -l < stdout)" -eq 9 ]
verdict $? 'one line a stage'

run replay $epr --stage split --threads 1
[ "$status" -eq 0 ] && [ "$(grep -c '^stage 07 split, buffer .*: same, [0-9]* elements$' stdout)" -eq 4 ]
verdict $? 'one line an output'

run replay $epr --stage splat -o made
[ "$status" -eq 0 ] && cmp -s made/12-splat.depth_index.npy $epr/12-splat.depth_index.npy && [ ! -e made.partial ] &&
	[ "$(ls made | tr '\n' ' ')" = '12-splat.depth_index.npy trace.json ' ]
verdict $? '-o writes the outputs as a trace'
refuses 'made' replay $epr --stage splat -o made
refuses 'add --stage' replay $epr -o made2

# A port: its split.density is half ours; its align.frame follows from that, but for one value.
python3 - <<'PY'
import json, os, struct
def split(path):
	data = open(path, "rb").read()
	n = 10 + struct.unpack("<H", data[8:10])[0]
	return data[:n], bytearray(data[n:])
os.mkdir("port")
head, scale = split("out/trace-epr/07-split.density.npy")
n = len(scale) // 4
values = [x / 2 for x in struct.unpack("<%df" % n, scale)]
open("port/scale.npy", "wb").write(head + struct.pack("<%df" % n, *values))
json.dump({"format": "touchstone-trace", "version": 1, "contract": 1, "pipeline": "epr", "order": "canonical",
	"producer": {"name": "a port"}, "buffers": [{"name": "split.density", "file": "scale.npy"}]},
          open("port/trace.json", "w"))
PY
run replay $epr --stage align --inputs port -o own
[ "$status" -eq 1 ] &&
	grep -q 'stage 09 align, buffer align.frame: different in [0-9]* of [0-9]* elements, first element' stdout
verdict $? 'other inputs make other outputs than the reference holds'
grep -q \
	", first element [0-9]*, field .*: the candidate's inputs give .*, the reference has .* in $epr/09-align.frame.npy$" \
	stdout
verdict $? 'which is not blamed for what the port lacks'
cp own/09-align.frame.npy port/
python3 - <<'PY'
import json, struct
trace = json.load(open("port/trace.json"))
trace["buffers"].append({"name": "align.frame", "file": "09-align.frame.npy"})
json.dump(trace, open("port/trace.json", "w"))
PY
run replay $epr --stage align --inputs port
[ "$status" -eq 0 ] && grep -q ': same' stdout
verdict $? "the port's stage is right, given its own stage before"

python3 - <<'PY'
import struct
data = bytearray(open("port/09-align.frame.npy", "rb").read())
n = 10 + struct.unpack("<H", data[8:10])[0]
data[n + 80 * 7 + 12:n + 80 * 7 + 16] = struct.pack("<f", 1.5)
open("port/09-align.frame.npy", "wb").write(data)
PY
run replay $epr --stage align --inputs port
[ "$status" -eq 1 ] &&
	grep -q \
		'different in 1 of [0-9]* elements, first element 7, field s: .* is right, 1.5 = 0x1.8p+0 (3fc00000) was found in port/09-align.frame.npy$' \
		stdout
verdict $? 'a wrong value is named in decimal, hexadecimal float and bits'
run replay $epr --stage align --inputs port --json
python3 - <<'PY'
import json
report = json.load(open("stdout"))
stage, = report["stages"]
output, = stage["outputs"]
assert report["inputs"] == "port" and report["pipeline"] == "epr"
assert stage["stage"] == "align" and stage["number"] == 9 and stage["verdict"] == output["verdict"] == "different"
assert output["buffer"] == "align.frame" and output["different"] == 1 and output["elements"] > 1000
first = output["first"]
assert (first["element"], first["field"], first["component"],
        first["found"]) == (7, "s", 0, "1.5 = 0x1.8p+0 (3fc00000)")
PY
verdict $? '--json says the same'

cp -r $epr bad
printf '\xff\xff\xff\x7f' |
	dd of=bad/11-points.record.npy bs=1 seek=$(($(stat -c %s bad/11-points.record.npy) - 16)) conv=notrunc 2> /dev/null
refuses \
	'points.record.npy: element [0-9]*, field piece: 2147483647 (7fffffff); less than [0-9]* (pieces) would be right$' \
	replay bad --stage splat
run replay bad
[ "$status" -eq 2 ] && grep -q '^stage 12 splat: not replayed: .*field piece' stdout &&
	grep -q '^stage 09 align: same$' stdout &&
	grep -q ' of 20 stages could not be replayed$' stderr
verdict $? 'the other stages are replayed'

run render reflections atrium:triangles=10000:texels=32 --method epr --size 64x48 --reflectors 2 \
	--trace-only split,align -o part
refuses 'stage points.count: part/trace-epr: no file of scene.triangle' replay part/trace-epr --stage points.count -o x
[ ! -e x ] && [ ! -e x.partial ]
verdict $? 'nothing is left of it'
refuses 'stage cull: no file of its outputs' replay part/trace-epr --stage cull
run replay part/trace-epr --stage cull -o x
[ "$status" -eq 0 ] && grep -q 'not compared' stdout && cmp -s x/08-cull.keep.npy $epr/08-cull.keep.npy
verdict $? 'outputs that the trace lacks are written all the same'
refuses 'no file of scene.vertex, scene.object$' replay part/trace-epr --stage pose
refuses 'is no stage of epr' replay $epr --stage cube_face
refuses 'needs 2' replay part/trace-epr --stage lookup.second
refuses 'of method mvr' replay $epr --inputs out/trace-mvr
refuses 'parameter reflectors.px is 115' replay $epr --inputs part/trace-epr
run render reflections atrium:triangles=10000:texels=32 --method epr --size 64x48 --reflectors 1 --order arrival \
	--trace --no-images -o arrival
refuses 'order is "arrival"; a reference must be canonical' replay arrival/trace-epr --stage splat
refuses 'order is "arrival"; a reference must be canonical' replay arrival/trace-epr
# Depth maps made in batches are one file, whose stages are replayed on the whole.
shadows=(atrium:triangles=10000:texels=32 --size 64x48 --set lamp.views=5 --set lamp.cubes=3 --set depth_map.px=24
	--trace --no-images)
for words in 'soft-shadows ivir --margins --set lamp.source=scene' 'omni-shadows epr --set points.buffered=on' \
	'soft-shadows pcss' 'omni-shadows mvr --margins'; do
	read -r effect method options <<< "$words"
	# shellcheck disable=SC2086
	run render "$effect" "${shadows[@]}" --method "$method" $options --set lamp.views_a_pass=2 -o batches
	# shellcheck disable=SC2086
	run render "$effect" "${shadows[@]}" --method "$method" $options --set lamp.views_a_pass=6 -o whole
	run replay "batches/trace-$method"
	[ "$status" -eq 0 ] && [ "$(grep -c ': same$' "$scratch/stdout")" -ge 8 ] && ! grep -vq ': same$' "$scratch/stdout"
	verdict $? "$effect by $method: every stage gives the same bits from its own trace"
	run compare "batches/trace-$method" "whole/trace-$method"
	[ "$status" -eq 0 ] && grep -q ' 0 different' "$scratch/stdout"
	verdict $? "$effect by $method: batches change no buffer"
	rm -rf batches whole
done
for words in 'indirect hulls --margins --set lamp.source=scene' 'indirect direct' \
	'area-light hulls --margins --set lamp.radius=0.2' 'area-light direct --set lamp.radius=0' \
	'indirect hulls --set segment.method=components --set hull.cosine=quadrature' \
	'indirect hulls --set corner.facing=paper --set hull.corners=rectangle' \
	'indirect megaviews --margins --set octree.levels=4 --set vpl.paths=60 --set vpl.bounces=2' \
	'indirect megaviews --margins --set octree.levels=4 --set vpl.paths=60 --set vpl.place=random' \
	'indirect megaviews --margins --set octree.levels=4 --set vpl.paths=60 --set vpl_gather.query=descend' \
	'indirect megaviews --margins --set octree.levels=3 --set vpl.paths=30 --set traverse.hierarchies=views' \
	'indirect manylods --set octree.levels=4 --set vpl_gather.lights=0' \
	'indirect bruteforce --set octree.levels=3 --set vpl.paths=30' \
	'particles megaviews --margins --set octree.levels=4 --set particle.count=60' \
	'particles manylods --set octree.levels=4 --set particle.count=60' \
	'surfels deferred --set surfels.from_mesh=3000 --set surfel_blend.accumulation=half' \
	'surfels deferred --set surfels.from_mesh=3000 --set deferred.shader=phong_shadow --set depth_map.px=64' \
	'surfels ewa --set surfels.from_mesh=3000 --set deferred.shader=npr_shadow --set depth_map.px=64'; do
	read -r effect method how <<< "$words"
	# shellcheck disable=SC2086
	run render $effect atrium:triangles=10000:texels=32 --size 64x48 --set depth_grid.px=64 --set rsm.px=4 --trace \
		--no-images -o light --method $method $how
	run replay "light/trace-$method"
	[ "$status" -eq 0 ] && [ "$(grep -c ': same$' "$scratch/stdout")" -ge 8 ] && ! grep -vq ': same$' "$scratch/stdout"
	verdict $? "$words: every stage gives the same bits from its own trace"
	rm -rf light
done
run render surfels "$OLDPWD/scenes/room.gltf" --size 64x48 --set surfels.from_mesh=3000 \
	--set deferred.shader=phong_shadow --set depth_map.px=64 --margins --no-images -o bulb --method deferred
run replay bulb/trace-deferred
[ "$status" -eq 0 ] && [ "$(grep -c ': same$' "$scratch/stdout")" -ge 8 ] && ! grep -vq ': same$' "$scratch/stdout"
verdict $? "surfels about a point light: every stage gives the same bits from its own trace"
rm -rf bulb
# Lists of fragments that would lead a kernel beyond its buffers: NAME PLACE VALUE, of u32.
spoil() {
	python3 - "$@" <<'PY'
import struct, sys
name, place, value = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
data = bytearray(open(f"lists/trace-deferred/04-fragment_list.{name}.npy", "rb").read())
struct.pack_into("<I", data, 10 + struct.unpack_from("<H", data, 8)[0] + 4 * place, value)
open(f"spoilt/trace-deferred/04-fragment_list.{name}.npy", "wb").write(data)
PY
}
run render surfels atrium:triangles=10000:texels=32 --size 64x48 --trace --no-images -o lists --method deferred \
	--set surfels.from_mesh=3000 --set surfel_blend.accumulation=8bit
for words in 'offset 0 1 where sums begin' 'offset 5 4000000000 the sum before it' \
	'offset 3072 4000000000 where sums end' 'surfel 7 123456789 less than'; do
	read -r name place value why <<< "$words"
	rm -rf spoilt && cp -r lists spoilt
	spoil "$name" "$place" "$value"
	refuses "$why" replay spoilt/trace-deferred --stage surfel_blend
done
rm -rf lists spoilt
refuses 'No such file' replay nowhere
refuses 'No such file' replay $epr --inputs nowhere
refuses 'write touchstone replay TRACE' replay

finish
