#!/bin/bash
# `compare --decided` of shadows: comparisons that turn by less than a step are undecided and no others, what a depth map
# holds is judged by its margins, and a method that has none is judged whole.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
small=(atrium:triangles=10000 --size 96x54 --no-images --set views=8 --set map_px=128 --set light_samples=4 --set pass=3
	--set bias=0)

# row BUFFER: different and undecided of a line of the table.
row() { awk -v b="$1" '$2 == b { print $4, $7 }' stdout; }

for words in 'soft-shadows mvr' 'omni-shadows epr'; do
	read -r effect method <<< "$words"
	run render "$effect" "${small[@]}" --method "$method" --set bias.slope=0 --margins -o ref
	run render "$effect" "${small[@]}" --method "$method" --set bias.slope=0.005 --trace -o near
	run render "$effect" "${small[@]}" --method "$method" --set bias.slope=0.1 --trace -o far
	run compare "ref/trace-$method" "near/trace-$method"
	read -r different undecided <<< "$(row resolve.lit)"
	[ "$status" -eq 1 ] && [ "$different" -gt 0 ] && [ "$undecided" = - ]
	verdict $? "$effect by $method: a 200th of the slope turns comparisons"
	run compare "ref/trace-$method" "near/trace-$method" --decided
	[ "$(row resolve.lit)" = "0 $different" ]
	verdict $? "$effect by $method: all of which are undecided"
	run compare "ref/trace-$method" "far/trace-$method" --decided
	read -r different undecided <<< "$(row resolve.lit)"
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
read -r within beyond < <(python3 - ref/trace-mvr/06-depth.margin.npy <<'PY'
import struct, sys
data = open(sys.argv[1], 'rb').read()
header = 10 + struct.unpack_from('<H', data, 8)[0]
bits = [word for word, high in struct.iter_unpack('<II', data[header:])]
edge = struct.unpack(f'<{len(bits)}f', struct.pack(f'<{len(bits)}I', *bits))
pairs = list(zip(edge[::2], edge[1::2]))
print(next(i for i, p in enumerate(pairs) if p[0] <= 1), next(i for i, p in enumerate(pairs) if p[0] > 2 and p[1] > 2))
PY
)
poke 06-scatter.depth.npy "$within" '\x00\x00\x80\x3f'
prints 'scatter.depth .* 0 .* 1 .* same' compare ref/trace-mvr other --decided
poke 06-scatter.depth.npy "$beyond" '\x00\x00\x80\x3f'
run compare ref/trace-mvr other --decided
[ "$status" -eq 1 ] && [ "$(row scatter.depth)" = '1 -' ]
verdict $? 'a texel that is decided is judged'

run render soft-shadows "${small[@]}" --method pcss --margins -o pcss
rm -rf other
cp -r pcss/trace-pcss other
prints ' 0 different' compare pcss/trace-pcss other --decided
run render soft-shadows "${small[@]}" --method mvr --trace -o without
refuses 'needs depth.margin for each element of scatter.depth; render the reference with --margins' \
	compare without/trace-mvr ref/trace-mvr --layout scatter.depth=06-scatter.depth.npy --decided

finish
