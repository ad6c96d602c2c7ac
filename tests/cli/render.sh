#!/bin/bash
# What a render writes and prints, and that nothing half-written stays behind.
. "$(dirname "$0")/tap.bash"
small=(render reflections atrium:triangles=10000:texels=32 --size 96x54 --reflectors 2 --set reflectors.px=30
	--set cube.max_px=64)
cd "$scratch" || exit 2
mkdir work

run "${small[@]}" --truth=A,C -o work/new/a
[ "$status" -eq 0 ] && grep -q 'files are in work/new/a' stdout && grep -q 'shading operations' stdout
verdict $? 'render prints a table and where the pictures are'

missing=0
for file in epr.png epr.exr mvr.png mvr.exr truth-a.png truth-c.exr difference-epr-truth-a.png difference-epr-mvr.exr \
	epr-points.png epr-splats.png epr-faces.png epr-index.png mvr-index.png mvr-cube.png report.json; do
	[ -s "work/new/a/$file" ] || { missing=1; echo "# no $file"; }
done
verdict $missing 'every picture is there'

[ ! -e work/new/a.partial ] && ! ls work/new/a | grep -q partial
verdict $? 'no partial file is left'

run "${small[@]}" --method epr -o work/new/a
[ "$status" -eq 2 ] && grep -q -- '--force' stderr && [ -s work/new/a/mvr.png ] && [ ! -e work/new/a.partial ]
verdict $? 'a folder that is not empty is refused'

run "${small[@]}" --method epr -o work/new/a --force
[ "$status" -eq 0 ] && [ -s work/new/a/epr.png ] && [ ! -e work/new/a/mvr.png ] && [ "$(ls work/new)" = a ]
verdict $? '--force replaces the folder as a whole'

echo mine > work/new/a/notes.txt
run "${small[@]}" --method epr -o work/new/a --force
[ "$status" -eq 2 ] && grep -q notes.txt stderr && [ -s work/new/a/notes.txt ]
verdict $? '--force keeps what no render wrote'

rm work/new/a/notes.txt
for foreign in photo.png link.png sub.exr; do
	case $foreign in
	photo.png) echo mine > work/new/a/photo.png ;;
	link.png) rm work/new/a/photo.png && ln -s /dev/null work/new/a/link.png ;;
	sub.exr) rm work/new/a/link.png && mkdir work/new/a/sub.exr ;;
	esac
	run "${small[@]}" --method epr -o work/new/a --force
	[ "$status" -eq 2 ] && grep -q "$foreign" stderr && [ "$(wc -l < stderr)" -eq 1 ] && [ -s work/new/a/epr.png ] &&
		[ ! -e work/new/a.partial ]
	verdict $? "--force keeps $foreign"
done

mkdir work/photos && echo mine > work/photos/mine.png && echo '{}' > work/photos/report.json
run "${small[@]}" --method epr -o work/photos --force
[ "$status" -eq 2 ] && grep -q 'remove the folder' stderr && [ -s work/photos/mine.png ] &&
	[ -s work/photos/report.json ]
verdict $? '--force keeps a folder whose report.json is not of a render'

echo '{"program": "touchstone"}' > work/photos/report.json
run "${small[@]}" --method epr -o work/photos --force
[ "$status" -eq 2 ] && grep -q 'remove the folder' stderr && [ "$(wc -l < stderr)" -eq 1 ] &&
	[ -s work/photos/mine.png ]
verdict $? 'and one whose report.json lists no files, as earlier versions wrote'

run "${small[@]}" --json --no-images --truth=A --backend c
python3 - stdout <<'PY'
import json, sys
report = json.load(open(sys.argv[1]))
assert report["version"] and report["methods"] == ["epr", "mvr", "ivir"] and report["backend"] == "c"
rows = {(r["image"], r["reference"]): r for r in report["metrics"]}
assert report["params"]["width"] == 96 and report["params"]["eye.distance"] == "far"
assert rows[("epr", "truth-a")]["share"] == "sampling" and 0 <= rows[("epr", "mvr")]["rmse"] < 64
counters = {r["counter"]: r for r in report["counters"]}
pixels = counters["reflective pixels"]["epr"]
assert pixels == counters["reflective pixels"]["mvr"]
assert counters["shading operations"]["epr"] <= 25 * pixels
assert counters["look-ups"]["epr"] == 25 * pixels
PY
verdict $? '--json prints one object with the same figures'
[ "$status" -eq 0 ] && [ ! -e out ]
verdict $? '--no-images writes nothing'

cp stdout one.json
run "${small[@]}" --json --no-images --truth=A --threads 1
python3 - one.json stdout <<'PY'
import json, sys
a, b = (json.load(open(f)) for f in sys.argv[1:])
for key in "counters", "bytes", "metrics", "shading":
	assert a[key] == b[key], key
PY
verdict $? 'threads change no figure'
refuses 'leave one of the two out' "${small[@]}" --no-images -o out

if limits_files; then
	(ulimit -f 2; timeout 300 "$touchstone" "${small[@]}" -o work/full > /dev/null 2> stderr)
	[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -e work/full ] && [ ! -e work/full.partial ]
	verdict $? 'a disk that fills leaves nothing behind'
fi

"$touchstone" "${small[@]}" --method epr -o work/read 2> stderr | head -1 > stdout
[ -s stdout ] && [ -s work/read/epr.png ] && [ -s work/read/report.json ] && [ ! -e work/read.partial ]
verdict $? 'a reader that leaves early costs no picture'

# A name that is not UTF-8 and holds an escape sequence, on a minimal scene.
name=$'sc\xe9ne\e[31m.gltf'
python3 - "$name" <<'PY'
import base64, json, os, struct, sys
points = struct.pack("<9f", -1, 0, -3, 1, 0, -3, 0, 2, -3)
json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "Pot"}],
	"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
	"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, 0, -3],
	               "max": [1, 2, -3]}],
	"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36,
	"uri": "data:application/octet-stream;base64," + base64.b64encode(points).decode()}]},
          open(os.fsencode(sys.argv[1]), "w"))
PY
run render reflections "$name" "${small[@]:3}" --method epr -o work/odd
[ "$status" -eq 0 ] && ! grep -q $'\e' stdout &&
	python3 -c 'import json; assert "\\xe9" in json.load(open("work/odd/report.json"))["scene"]'
verdict $? 'a name of any bytes is reported'
run info "$name"
[ "$status" -eq 0 ] && [ "$(sed -n 's/^  node .*triangles: //p' stdout)" = Pot ] &&
	run info "$name" --reflectors 0 --reflector Pot &&
	grep -q '^  reflectors  *1$' stdout
verdict $? 'info lists the nodes that --reflector takes'

refuses "mounted\|Permission denied" "${small[@]}" -o /proc

for dir in /dev/null /proc/none/x .; do
	run "${small[@]}" -o $dir
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ]
	verdict $? "refused: -o $dir"
done

mkdir work/held.partial
run "${small[@]}" -o work/held
[ "$status" -eq 2 ] && [ -d work/held.partial ] && [ ! -e work/held ]
verdict $? 'the partial folder of another run is left alone'

# A signal in the middle of the work.
timeout --foreground -s INT 1 "$touchstone" render reflections atrium --size 1920x1080 --truth \
	-o work/deep/er/interrupted > stdout 2> stderr
[ $? -ne 0 ] && [ ! -e work/deep ]
verdict $? 'an interrupted render leaves nothing behind'

refuses 'memory.* or no truth C' render reflections atrium:triangles=10000:texels=32 --size 16384x16384 --truth=C \
	-o work/huge
[ ! -e work/huge ] && [ ! -e work/huge.partial ]
verdict $? 'nor does one that needs too much memory'

run render particles dining:triangles=10000:texels=32 --size 64x36 --set octree.levels=5 --set particle.count=50 \
	--truth --json -o work/particles
[ "$status" -eq 0 ] && [ -s work/particles/megaviews.png ] && [ -s work/particles/manylods.png ] &&
	[ -s work/particles/truth-glow.png ] && grep -q 'truth-glow' stdout
verdict $? 'particles by both methods, and their truth'
refuses 'there is glow, or none' render particles --truth=vpls
run render surfels checkerboard:surfels=10000 --size 64x36 --set truth.grid_rays=2 --method deferred --truth --json \
	-o work/surfels
python3 - stdout <<'PY' && [ "$status" -eq 0 ] && [ -s work/surfels/difference-deferred-truth-discs.png ]
import json, sys
rows = {(r["image"], r["reference"]): r for r in json.load(open(sys.argv[1]))["metrics"]}
assert rows["deferred", "truth-discs"]["share"] == "method"
assert rows["truth-discs", "truth-surface"]["share"] == "sampling"
assert 0 < rows["deferred", "truth-discs"]["rmse"] < rows["deferred", "truth-surface"]["rmse"]
PY
verdict $? 'surfels and their truths'
# Of 10000 surfels in few pixels: 96 bytes each and 192 in the tree; a pixel has 48 in the G-buffer, 12 twice, 3, and 4
# for the light that throws shadows; each picture that stays has 17.
for truth in none surface discs; do
	for shader in phong phong_shadow; do
		run render surfels checkerboard:surfels=10000 --size 16x16 --method deferred --truth=$truth \
			--set truth.grid_rays=1 --set deferred.shader=$shader --set depth_map.px=32 --json --no-images
		cp stdout "$truth-$shader.json"
	done
done
python3 - << 'PY'
import json
for shader, lit in ("phong", 0), ("phong_shadow", 4):
    reports = (json.load(open(f"{t}-{shader}.json")) for t in ("none", "surface", "discs"))
    pictures = (256 * 17 * n for n in (1, 2, 2))
    none, surface, discs = (r["estimated_bytes"] - r["held_bytes"] - p for r, p in zip(reports, pictures))
    assert none == surface and discs == 10000 * (96 + 192) + 256 * (48 + 2 * 12 + 3 + lit) > none
PY
verdict $? 'memory of the tree of surfels is counted'
printf 'ply\nformat ascii 1.0\nelement vertex 1\n%sproperty float radius\nend_header\n0 0 0 0 0 1 1\n' \
	"$(printf 'property float %s\n' x y z nx ny nz)
" > one.ply
run render surfels one.ply --size 64x36 --set eye.distance=outside --truth --set deferred.shader=phong_shadow \
	--set depth_map.px=32 -o work/one
[ "$status" -eq 0 ] && grep -q '^truth surface: none' stdout && grep -q 'truth-discs' stdout &&
	! grep -q 'truth-surface' stdout
verdict $? 'surfels that are samples of nothing known'
python3 - > carpet.ply << 'PY'
rows = [(x / 50, y, z / 50, 0, 1, 0, 0.03) for y in (0, 0.005) for x in range(-40, 40) for z in range(-40, 40)]
print("ply\nformat ascii 1.0\nelement vertex %d" % len(rows))
print("\n".join("property float " + name for name in ("x", "y", "z", "nx", "ny", "nz", "radius")) + "\nend_header")
print("\n".join(" ".join(map(str, row)) for row in rows))
PY
for epsilon in 0.02 0.004; do
	run render surfels carpet.ply --size 64x36 --set eye.distance=outside --set surfel_depth.epsilon=$epsilon \
		--no-images
	cp stderr carpet-$epsilon.txt
done
[ "$(grep -c '^touchstone: \(deferred\|ewa\): at .* layers are blended that lie 0.005 apart' carpet-0.02.txt)" -eq 2 ] \
	&& [ ! -s carpet-0.004.txt ]
verdict $? 'layers that epsilon blends are a line for each method'
refuses 'there are discs and surface, or none' render surfels --truth=glow
refuses 'view_map.px or particle.count' render particles dining:triangles=10000:texels=32 --set octree.levels=11 \
	--set particle.count=16000000 --set view_map.px=256

finish
