#!/bin/bash
# `compare` of candidates with one pair of nodes too few, too many, or another, whose places in the list tell nothing;
# and `explain` of a pair.
. "$(dirname "$0")/tap.bash"
room=$(realpath scenes/room.gltf)
cd "$scratch" || exit 2

run render indirect "$room" --method megaviews --size 32x18 --reflectors 0 --set rsm.px=8 --set octree.levels=3 \
	--no-images --trace -o r
verdict "$status" 'a trace'

# plant FOLDER: a candidate whose pairs, (node, node of views), the Python on standard input changes.
plant() {
	rm -rf "$1" && cp -r r/trace-megaviews "$1" && cat > plant.py && python3 - "$1" <<'PY'
import glob, re, struct, sys
path, = glob.glob(sys.argv[1] + "/*-traverse.rendered.npy")
data = open(path, "rb").read()
head, words = data[:128], struct.unpack(f"<{len(data) // 8 - 16}Q", data[128:])
pairs = [(word >> 32, word & 0xffffffff) for word in words]
views = range(1 + max(v for _, v in pairs))
absent = sorted({(s, v) for s, _ in pairs for v in views} - set(pairs))
middle = len(pairs) // 2
def names(*changed):
	"""The lines that are right."""
	open("right", "w").write("".join(f"pair (node {s}, node of views {v}){how}\n" for (s, v), how in changed))
exec(open("plant.py").read())
head = re.sub(rb"\((\d+),\)( *)", lambda m: (b"(%d,)" % len(pairs)).ljust(len(m[0])), head)
open(path, "wb").write(head + struct.pack(f"<{len(pairs)}Q", *(s << 32 | v for s, v in pairs)))
PY
}
# named NUMBER: so many elements differ, and the first differences are the right lines.
named() {
	run compare r/trace-megaviews planted --first 9
	[ "$status" -eq 1 ] && grep -qE "^traverse +traverse\.rendered +[0-9,]+ +$1 " stdout &&
		sed -n 's/^stage .*, buffer traverse.rendered, \(pair.*\) — first of .*/\1/p; s/^  \(pair .*\)/\1/p' stdout |
		cmp -s - right
}

plant planted <<'PY'
names((pairs.pop(middle), ": missing"))
PY
named 1
verdict $? 'a pair too few is named'
tail -n 1 stdout | grep -q ' — first of 1 missing, 0 beside; inputs identical$'
verdict $? 'and no other'
run compare r/trace-megaviews planted --forced
[ "$status" -eq 1 ] && grep -A1 '^stage .* traverse: different' stdout |
	grep -qF "traverse.rendered, $(cat right) — first of 1 missing, 0 beside"
verdict $? 'with --forced too'
plant planted <<'PY'
names((absent[0], ": not of the reference"))
pairs = sorted(pairs + [absent[0]])
PY
named 1
verdict $? 'a pair too many'
plant planted <<'PY'
names((pairs[middle], ": missing"), (absent[-1], ": not of the reference"))
pairs[middle] = absent[-1]
pairs.sort()
PY
named 2
verdict $? 'another pair'
plant planted <<'PY'
names((pairs[middle], ": twice"))
pairs.insert(middle, pairs[middle])
PY
named 1
verdict $? 'a pair twice'

# The order of a canonical candidate counts; so does the node of the scene, which is no distance.
plant planted <<'PY'
(s, v), (t, w) = pairs[middle : middle + 2]
pairs[middle : middle + 2] = (t, w), (s, v)
show = lambda ref, cand: ", ref %d | %d (%08x_%08x)" % (ref * 2) + " candidate %d | %d (%08x_%08x)" % (cand * 2)
names(((s, v), show((s, v), (t, w))), ((t, w), show((t, w), (s, v))))
PY
named 2
verdict $? 'two pairs in another order'
plant planted <<'PY'
s, v = pairs[0]
pairs[0] = s + 1, v
PY
run compare r/trace-megaviews planted --ulp 9
[ "$status" -eq 1 ]
verdict $? 'no tolerance of floats lets another node pass'
plant planted <<'PY'
pairs.reverse()
PY
sed -i 's/"order": "canonical"/"order": "arrival"/' planted/trace.json
run compare r/trace-megaviews planted
[ "$status" -eq 0 ] && grep -q '"arrival"' planted/trace.json
verdict $? 'in order of arrival any order is right'

refuses \
	'no item writes element 3 of traverse.rendered; it is made of what items leave: ask for one by its number and kernel$' \
	explain r/trace-megaviews --stage traverse --element traverse.rendered:3
prints 'kernel traverse_count, item 0 of' explain r/trace-megaviews --stage traverse --item 0 --kernel traverse_count

finish
