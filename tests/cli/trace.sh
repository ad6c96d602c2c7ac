#!/bin/bash
# Traces on disk: the same bytes every time, readable by numpy, and nothing half-written or foreign touched.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2

run "${frame[@]}" --method epr,mvr --trace -o a
[ "$status" -eq 0 ] && digests_hold a/trace-epr && digests_hold a/trace-mvr
verdict $? 'a trace a method, and its digests hold'
[ "$(ls a/scene/*.npy | wc -l)" -eq "$(grep -c '"file": "../scene/' a/trace-mvr/trace.json)" ] &&
	! compgen -G 'a/trace-*/00-*' > /dev/null
verdict $? 'the scene is there once, and each trace names it'
run "${frame[@]}" --method epr,mvr --self-contained -o alone
[ "$status" -eq 0 ] && [ ! -e alone/scene ] && digests_hold alone/trace-mvr &&
	grep -q '"version": 1,' alone/trace-mvr/trace.json &&
	diff <(sed 's,\.\./scene/,,; s/"version": 2/"version": 1/' a/trace-mvr/trace.json) alone/trace-mvr/trace.json
verdict $? '--self-contained: the layout of version 1, and otherwise the same trace'
run compare a/trace-epr alone/trace-epr
[ "$status" -eq 0 ] && grep -q ' 0 different, 0 missing' stdout
verdict $? 'it is the same for compare'
run "${frame[@]}" --method epr,mvr --trace --threads 1 --no-fast-paths -o b
[ "$status" -eq 0 ] && diff -r a/trace-epr b/trace-epr && diff -r a/trace-mvr b/trace-mvr
verdict $? 'a second run gives the same bytes, with other threads and without fast paths'

run "${frame[@]}" --method epr,mvr --compress -o packed
[ "$status" -eq 0 ] && ls packed/scene packed/trace-* | grep -q '\.npy\.zst$' &&
	! compgen -G 'packed/*/*.npy' > /dev/null &&
	diff <(sed 's,\.npy\.zst,.npy,' packed/trace-epr/trace.json) a/trace-epr/trace.json &&
	[ "$(du -s packed | cut -f1)" -lt "$(du -s a | cut -f1)" ]
verdict $? '--compress: smaller files, of the same digests'
run compare a/trace-epr packed/trace-epr
[ "$status" -eq 0 ] && grep -q ' 0 different, 0 missing' stdout
verdict $? 'compare reads them'
run compare a/trace-epr/12-splat.depth_index.npy packed/trace-epr/12-splat.depth_index.npy.zst
verdict $status 'and one file of them'
refuses '12-splat.depth_index.npy.zst: compressed; "zstd -d" makes the .npy of it' compare a/trace-epr \
	packed/trace-epr --layout splat.depth_index=12-splat.depth_index.npy.zst
for folder in a packed; do
	"$touchstone" replay $folder/trace-epr > $folder.replay
	"$touchstone" probe $folder/trace-epr --pixel 40,20 > $folder.probe
	"$touchstone" explain $folder/trace-mvr --stage image --item 401 > $folder.explain
	"$touchstone" report $folder/trace-mvr -o $folder.html
done
for what in replay probe explain html; do
	[ -s a.$what ] && diff <(sed 's,a/trace,packed/trace,g' a.$what) packed.$what > differ
	verdict $? "$what: the same of compressed files"
done
if command -v zstd > /dev/null; then
	zstd -dc packed/scene/00-scene.texel.npy.zst | cmp - a/scene/00-scene.texel.npy
	verdict $? 'zstd unpacks a file'
else
	verdict 0 'zstd unpacks a file # SKIP there is no zstd'
fi

# Files of the scene that are not what they should be.
for damage in 'rm $file' 'truncate -s -9 $file' 'echo >> $file' 'mv $file $file.npy; ln -s ${file##*/}.npy $file' \
	'mv b/scene b/other; ln -s other b/scene' 'rm -r b/scene' \
	'printf "\377" | dd of=$file bs=1 seek=300 conv=notrunc 2> /dev/null'; do
	for from in a packed; do
		[[ $from$damage != aprintf* ]] || continue # a plain file of the right size is taken as it is
		rm -rf b && cp -r $from b
		file=$(ls b/scene/00-scene.texel.npy*)
		eval "$damage"
		refuses 'b/trace-mvr/../scene' replay b/trace-mvr --stage illuminate
	done
done
rm -r b

built_in=(atrium:triangles=10000:texels=32 --size 64x36 --reflectors 1 --set cube.max_px=32)
run render reflections "${built_in[@]}" --no-images --self-contained -o built-in
for method in epr mvr; do
	"$touchstone" digest "${built_in[@]}" --method $method 2> stderr | grep -v '^#' > sums
	[ -s sums ] && (cd built-in/trace-$method && sha256sum --quiet -c ../../sums > /dev/null) &&
		[ "$(wc -l < sums)" -eq "$(ls built-in/trace-$method/*.npy | wc -l)" ]
	verdict $? "$method: the files are those that digest names"
done

if /usr/bin/python3 -c 'import numpy' 2> /dev/null; then
	/usr/bin/python3 - a/trace-epr a/trace-mvr <<'PY'
import json, sys, numpy
scalars = {"f32": "<f4", "i32": "<i4", "u32": "<u4", "u64": "<u8", "u8": "|u1"}
for folder in sys.argv[1:]:
	trace = json.load(open(folder + "/trace.json"))
	for b in trace["buffers"]:
		data = numpy.load(folder + "/" + b["file"], allow_pickle=False)
		assert list(data.shape) == b["shape"], b
		fields = trace["records"].get(b["element"])
		if fields is None:
			assert data.dtype == numpy.dtype(scalars[b["element"]]), b
			continue
		assert data.dtype.names == tuple(f["name"] for f in fields), b
		for f in fields:
			base, shape = data.dtype[f["name"]].base, data.dtype[f["name"]].shape
			assert base == numpy.dtype(scalars[f["type"]]), (b, f)
			assert shape == ((f["count"],) if f["count"] > 1 else ()), (b, f)
	assert len(trace["buffers"]) >= 20
PY
	verdict $? 'numpy reads every file; its records have the fields of trace.json'
else
	verdict 0 'numpy reads every file # SKIP /usr/bin/python3 has no numpy'
fi

run "${frame[@]}" --method epr --trace-only points,image --crop 5,7,20,11 -o part
[ "$status" -eq 0 ] && digests_hold part/trace-epr && [ "$(ls part/trace-epr/*.npy | wc -l)" -eq 4 ]
verdict $? '--trace-only writes these stages alone'
run compare part/trace-epr part/trace-epr
[ "$status" -eq 0 ] && grep -q '^[3-9][0-9] buffers judged, 0 different' stdout
verdict $? 'and --crop can be compared with itself'
run compare a/trace-epr part/trace-epr
[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -q 'crop' stderr
verdict $? 'but not with the whole'

for arguments in '--trace-only pointz' '--trace-only cube_face' '--trace-only=' '--crop 0,0,97,1' '--crop 1,2,3' \
	'--crop 0,0,0,0' '--crop 4294967295,0,2,2' '--crop a,b,c,d' '--crop 0,0,4,4 --set eye.samples=4'; do
	refuses "${arguments%%[ =]*}" render reflections "${built_in[@]}" --method epr --no-images $arguments -o none
	[ ! -e none ] && [ ! -e none.partial ]
	verdict $? 'and nothing is left'
done

if limits_files; then
	(ulimit -f 64; timeout 300 "$touchstone" "${frame[@]}" --trace -o full > /dev/null 2> stderr)
	[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -e full ] && [ ! -e full.partial ]
	verdict $? 'a disk that fills leaves nothing behind'
	grep -q '\.npy: .*too large' stderr
	verdict $? 'and the file is named'
fi

short=(render reflections "${built_in[@]}" --method epr --no-images --trace-only points,image)
run "${short[@]}" -o again
for foreign in file hidden link folder; do
	run "${short[@]}" -o again --force
	[ "$status" -eq 0 ] && digests_hold again/trace-epr && [ ! -e again.old ] && [ ! -e again.partial ]
	verdict $? "--force replaces a folder with traces, before a $foreign"
	case $foreign in
	file) echo mine > again/trace-epr/notes.txt ;;
	hidden) echo mine > again/trace-epr/.notes ;;
	link) ln -s /dev/null again/trace-epr/link ;;
	folder) mkdir again/trace-epr/sub ;;
	esac
	run "${short[@]}" -o again --force
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -q 'trace-epr' stderr &&
		[ "$(ls -A again/trace-epr | wc -l)" -eq 6 ] && [ ! -e again.partial ]
	verdict $? "--force keeps a foreign $foreign beside a trace's files"
	rm -rf again/trace-epr/{notes.txt,.notes,link,sub}
done
rm again/trace-epr/11-points.key.npy && ln -s ../../a/trace-epr/11-points.key.npy again/trace-epr/11-points.key.npy
run "${short[@]}" -o again --force
[ "$status" -eq 2 ] && [ -L again/trace-epr/11-points.key.npy ] && digests_hold a/trace-epr
verdict $? '--force keeps a link in the place of a file'
rm -rf again/trace-epr && ln -s ../a/trace-epr again/trace-epr
run "${short[@]}" -o again --force
[ "$status" -eq 2 ] && digests_hold a/trace-epr
verdict $? 'and a link in the place of a trace'

# A scene whose name is not UTF-8.
python3 - <<'PY'
import base64, json, struct
points = struct.pack("<9f", -1, 0, -3, 1, 0, -3, 0, 2, -3)
json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
	"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
	"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, 0, -3],
	               "max": [1, 2, -3]}],
	"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36,
	"uri": "data:application/octet-stream;base64," + base64.b64encode(points).decode()}]}, open(b"sc\xe9ne.gltf", "w"))
PY
run render reflections $'sc\xe9ne.gltf' --size 64x36 --reflectors 1 --no-images --trace --method epr -o odd
[ "$status" -eq 0 ] && digests_hold odd/trace-epr
verdict $? 'a scene with a name of any bytes is traced'

# Six mirrors of which the eye sees not the last.
run render reflections atrium:triangles=10000:texels=32 --size 96x54 --reflectors 6 --set eye.distance=near \
	--set eye.fov=20 --set mvr.faces=adaptive --set cube.max_px=16 --no-images --trace --method mvr -o unseen
[ "$status" -eq 0 ] && digests_hold unseen/trace-mvr
verdict $? 'the last mirrors may be out of sight'

# Copies for viewers: a PLY of as many points as the trace has, and pictures; the trace is the same with and without.
run render reflections atrium:triangles=10000:texels=32 --size 64x36 --reflectors 1 --no-images --viewer --method epr \
	-o seen
rows=$("$touchstone" compare seen/trace-epr seen/trace-epr --json | grep -A1 '"points.key"' | grep -o '[0-9]\+')
[ "$status" -eq 0 ] && grep -aq "^element vertex $rows\$" seen/view-epr/points.ply &&
	[ -s seen/view-epr/eye.depth.exr ] &&
	[ -s seen/view-epr/image.srgb.png ]
verdict $? 'copies for viewers'

finish
