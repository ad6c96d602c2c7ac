#!/bin/bash
# `compare --decided` of shadows: comparisons that turn by less than a step are undecided and no others, what a depth
# map holds is judged by its margins, and a method that has none is judged whole. Of hulls: segments of depths that
# nearly tie with the step are undecided and no others, and boxes of pixels are judged. Of many views: texels of maps
# and pixels. Of surfels: what is nearest, blended and shaded.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
small=(atrium:triangles=10000:texels=32 --size 96x54 --no-images --set lamp.views=8 --set depth_map.px=128
	--set lamp.cubes=4 --set lamp.views_a_pass=3 --set depth_map.bias=0)

# row BUFFER: different and undecided of a line of the table.
row() { awk -v b="$1" '$2 == b { gsub(",", ""); print $4, $7 }' stdout; }

for words in 'soft-shadows mvr' 'omni-shadows epr' \
	'surfels deferred --set surfels.from_mesh=5000 --set deferred.shader=phong_shadow'; do
	read -r effect method more <<< "$words"
	set -- $more
	run render "$effect" "${small[@]}" "$@" --method "$method" --set depth_map.bias_slope=0 --margins -o ref
	run render "$effect" "${small[@]}" "$@" --method "$method" --set depth_map.bias_slope=0.005 --trace -o near
	run render "$effect" "${small[@]}" "$@" --method "$method" --set depth_map.bias_slope=0.1 --trace -o far
	run compare "ref/trace-$method" "near/trace-$method"
	read -r different undecided <<< "$(row shadow_test.lit)"
	[ "$status" -eq 1 ] && [ "$different" -gt 0 ] && [ "$undecided" = - ]
	verdict $? "$effect by $method: a 200th of the slope turns comparisons"
	run compare "ref/trace-$method" "near/trace-$method" --decided
	[ "$(row shadow_test.lit)" = "0 $different" ]
	verdict $? "$effect by $method: all of which are undecided"
	run compare "ref/trace-$method" "far/trace-$method" --decided
	read -r different undecided <<< "$(row shadow_test.lit)"
	[ "$different" -gt 20 ]
	verdict $? "$effect by $method: more turns those that are decided"
	rm -rf ref near far
done

# poke FILE ELEMENT BYTES: a candidate with another depth there.
poke() {
	rm -rf other
	cp -r ref/trace-mvr other
	local header
	header=$((10 + $(od -An -tu2 -j8 -N2 "other/$1")))
	printf "$3" | dd of="other/$1" bs=1 seek=$((header + 4 * $2)) conv=notrunc 2> /dev/null
}

run render soft-shadows "${small[@]}" --method mvr --margins -o ref
# The first texels whose edge is within a step, and more than two away, of those that hold something.
read -r within beyond < <(python3 - ref/trace-mvr/06-depth_map.margin.npy <<'PY'
import struct, sys
data = open(sys.argv[1], 'rb').read()
header = 10 + struct.unpack_from('<H', data, 8)[0]
bits = [word for word, high in struct.iter_unpack('<II', data[header:])]
edge = struct.unpack(f'<{len(bits)}f', struct.pack(f'<{len(bits)}I', *bits))
pairs = list(zip(edge[::2], edge[1::2]))
print(next(i for i, p in enumerate(pairs) if p[0] <= 1), next(i for i, p in enumerate(pairs) if p[0] > 2 and p[1] > 2))
PY
)
poke 06-depth_map.depth.npy "$within" '\x00\x00\x80\x3f'
prints 'depth_map.depth .* 0 .* 1 .* same' compare ref/trace-mvr other --decided
poke 06-depth_map.depth.npy "$beyond" '\x00\x00\x80\x3f'
run compare ref/trace-mvr other --decided
[ "$status" -eq 1 ] && [ "$(row depth_map.depth)" = '1 -' ]
verdict $? 'a texel that is decided is judged'

run render soft-shadows "${small[@]}" --method pcss --margins -o pcss
rm -rf other
cp -r pcss/trace-pcss other
prints ' 0 different' compare pcss/trace-pcss other --decided
run render soft-shadows "${small[@]}" --method mvr --trace -o without
refuses 'needs depth_map.margin for each element of depth_map.depth, which a reference with margins has' \
	compare without/trace-mvr ref/trace-mvr --layout depth_map.depth=06-depth_map.depth.npy --decided

# Steps beside that at which two neighbours of different segments would tie, 4 ulps off.
hulls=(render indirect atrium:triangles=10000:texels=32 --size 96x54 --set depth_grid.px=64 --set rsm.px=2
	--method hulls --no-images)
run "${hulls[@]}" --trace -o plain
read -r below above beyond < <(python3 - plain/trace-hulls <<'PY'
import glob, struct, sys
def buffer(name, kind):
	data = open(glob.glob(f"{sys.argv[1]}/*-{name}.npy")[0], "rb").read()
	return memoryview(data[10 + struct.unpack_from("<H", data, 8)[0]:]).cast(kind)
depth, label = buffer("depth_grid.depth", "f"), buffer("segment.label", "I")
pairs = [(p, p + 1) for p in range(64 * 64) if p % 32 < 31]
ties = (abs(depth[p] - depth[q]) / (1 - min(depth[p], depth[q])) for p, q in pairs
        if label[p] != label[q] and depth[p] != depth[q] and min(depth[p], depth[q]) < 1)
tie = min(t for t in ties if t > 0.02)
print(*(f"{tie * f:.12f}" for f in (1 - 2 ** -21, 1 + 2 ** -21, 1.1)))
PY
)
run "${hulls[@]}" --set segment.step="$below" --margins -o low
run "${hulls[@]}" --set segment.step="$above" --trace -o high
run "${hulls[@]}" --set segment.step="$beyond" --trace -o higher
run compare low/trace-hulls high/trace-hulls
read -r different undecided <<< "$(row segment.label)"
[ "$status" -eq 1 ] && [ "$different" -gt 0 ] && [ "$undecided" = - ]
verdict $? 'hulls: 8 ulps of the step turn a test'
run compare low/trace-hulls high/trace-hulls --decided
[ "$(row segment.label)" = "0 $different" ]
verdict $? 'hulls: what hangs together with it is undecided'
run compare low/trace-hulls higher/trace-hulls --decided
read -r different undecided <<< "$(row segment.label)"
[ "$different" -gt 20 ]
verdict $? 'hulls: more turns those that are decided'

rm -rf other
cp -r low/trace-hulls other
box=$(cd other && echo *-hull.box.npy)
header=$((10 + $(od -An -tu2 -j8 -N2 "other/$box")))
printf '\x01\x00\x00\x00' | dd of="other/$box" bs=1 seek=$((header + 4 * 50 * 96)) conv=notrunc 2> /dev/null
run compare low/trace-hulls other --decided
[ "$status" -eq 1 ] && [ "$(row hull.box)" = '1 -' ] && [ "$(row segment.label)" = '0 -' ]
verdict $? 'the box of a pixel that is decided is judged'
refuses 'needs segment.margin for each element of segment.label, which a reference with margins has' \
	compare plain/trace-hulls high/trace-hulls \
	--layout segment.label="$(cd plain/trace-hulls && echo *-segment.label.npy)" --decided

# Of many views: another value in the first element that is not decided passes, in the first that is it does not; and a
# bias that is a hundredth or a fortieth more turns shadows that are decided.
rm -rf ref
for method in megaviews bruteforce; do
	views=(render indirect atrium:triangles=10000:texels=32 --size 96x54 --set octree.levels=5 --set vpl.paths=450
		--set rsm.px=16 --no-images
		--set vpl_gather.lights=0 --method "$method")
	run "${views[@]}" --margins -o ref
	for more in depth_map.bias=1.01 vpl_gather.bias_plane=1.025; do
		run "${views[@]}" --set $more --trace -o far --force
		run compare "ref/trace-$method" "far/trace-$method" --decided
		read -r different undecided <<< "$(row vpl_gather.irradiance)"
		[ "$different" -gt 100 ] && [ $((20 * ${undecided/-/0})) -lt "$different" ]
		verdict $? "$method: $more turns what is decided"
	done
	for words in 'view_map.depth_node view_map.margin 8 1' 'vpl_gather.irradiance vpl_gather.margin 4 3'; do
		read -r buffer margin bytes each <<< "$words"
		for which in 1 0; do
			rm -rf other
			cp -r "ref/trace-$method" other
			python3 - other "$buffer" "$margin" "$bytes" "$each" $which <<'PY'
import glob, struct, sys
folder, buffer, margin, bytes, each, undecided = *sys.argv[1:4], *map(int, sys.argv[4:])
def opened(name):
	path = glob.glob(f"{folder}/*-{name}.npy")[0]
	data = bytearray(open(path, "rb").read())
	return path, data, 10 + struct.unpack_from("<H", data, 8)[0]
path, data, at = opened(margin)
near = memoryview(data[at:]).cast("f")
first = next(i for i, m in enumerate(near) if (m <= 1) == (undecided == 1))
path, data, at = opened(buffer)
data[at + bytes * (first * each + each - 1) + bytes - 2] ^= 0x40
open(path, "wb").write(data)
PY
			run compare "ref/trace-$method" other --decided
			[ "$status" -eq $((1 - which)) ] && [ "$(row "$buffer")" = "$([ $which = 1 ] && echo '0 1' || echo '1 -')" ]
			verdict $? "$method: $buffer where it is $([ $which = 0 ] || echo un)decided"
		done
	done
	rm -rf ref far
done

# Of surfels: the same; margins of two words are of pairs of f32 bits.
# An outline of which nothing is undecided is made so.
run render surfels checkerboard:surfels=20000 --size 96x54 --no-images --set deferred.shader=npr --margins \
	--self-contained -o ref
for words in 'surfel_depth.surfel surfel_depth.margin 8 1 2' 'surfel_blend.sum surfel_blend.margin 8 8 2' \
	'surfel_blend.heaviest surfel_blend.margin 8 1 2' 'image.radiance deferred.margin 4 3 1'; do
	read -r buffer margin bytes each pair <<< "$words"
	for which in 1 0; do
		rm -rf other
		cp -r ref/trace-deferred other
		python3 - other "$buffer" "$margin" "$bytes" "$each" "$pair" $which <<'PY'
import glob, struct, sys
folder, buffer, margin, bytes, each, pair, undecided = *sys.argv[1:4], *map(int, sys.argv[4:])
def opened(name):
	path = glob.glob(f"{folder}/*-{name}.npy")[0]
	data = bytearray(open(path, "rb").read())
	return path, data, 10 + struct.unpack_from("<H", data, 8)[0]
path, data, at = opened(margin)
near = list(memoryview(data[at:]).cast("f"))
near = [a if a <= 1 else b for a, b in zip(near[::4], near[2::4])] if pair == 2 else near
first = next((i for i, m in enumerate(near) if (m <= 1) == (undecided == 1)), None)
if first is None:
	first = len(near) // 2
	struct.pack_into("<f", data, at + 4 * first, 0.5)
	open(path.replace(folder, "ref/trace-deferred"), "wb").write(data)
path, data, at = opened(buffer)
data[at + bytes * (first * each + each - 1) + bytes - 2] ^= 0x40
open(path, "wb").write(data)
PY
		run compare ref/trace-deferred other --decided --ignore "$margin"
		[ "$status" -eq $((1 - which)) ] && [ "$(row "$buffer")" = "$([ $which = 1 ] && echo '0 1' || echo '1 -')" ]
		verdict $? "surfels: $buffer where it is $([ $which = 0 ] || echo un)decided"
	done
done
rm -rf ref

finish
