#!/bin/bash
# What `compare` says of traces, buffers and images, in each of its forms, and how it ends.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2

# ends STATUS PATTERN NAME ARGUMENT...: the command ends so, and prints, or reports, a line that matches.
ends() {
	local expected=$1 pattern=$2 name=$3
	shift 3
	run "$@"
	[ "$status" -eq "$expected" ] && cat stdout stderr | grep -q -- "$pattern" &&
		{ [ "$status" -ne 2 ] || { [ "$(wc -l < stderr)" -eq 1 ] && [ ! -s stdout ]; }; }
	verdict $? "$name"
}

run "${frame[@]:0:${#frame[@]}-1}" --method epr,mvr --self-contained -o r
rm r/trace-*/00-scene.texel.npy
python3 - r/trace-epr r/trace-mvr <<'PY'
import json, sys
for folder in sys.argv[1:]:
	trace = json.load(open(folder + "/trace.json"))
	for b in trace["buffers"]:
		if b["name"] == "scene.texel":
			b["file"] = None
	json.dump(trace, open(folder + "/trace.json", "w"))
PY
cp -r r/trace-epr c

ends 0 '^40 buffers judged, 0 different, 0 missing$' 'a copy is the same' compare r/trace-epr c
change c/20-image.srgb.npy 1 $((3 * (20 * 96 + 33) + 1)) 0 ff
change c/09-align.frame.npy 80 12 12 0000803f
ends 1 \
	'stage 09 align, buffer align.frame, piece 12, field s: ref .* candidate 1 = 0x1p+0 (3f800000) .* ulp — first of 1; inputs identical' \
	'the first divergence in the order of the pipeline' compare r/trace-epr c
grep -q '^40 buffers judged, 2 different, 0 missing$' stdout
verdict $? 'and how many there are'
ends 1 'stage 20 image, buffer image.srgb, pixel (33, 20) \[1\], ref' 'after what is ignored the next' \
	compare r/trace-epr c --ignore align.frame
grep -q 'relaxed: --ignore align.frame' stdout
verdict $? 'and the relaxation is part of the verdict'
ends 0 'relaxed: --allow 1' '--allow' compare r/trace-epr c --allow 1
ends 2 'no buffer and no field "align.frames"' 'a name that nothing has' compare r/trace-epr c --ignore align.frames

run compare r/trace-epr c --json
[ "$status" -eq 1 ] && python3 - stdout <<'PY'
import json, sys
report = json.load(open(sys.argv[1]))
rows = {r["buffer"]: r for r in report["buffers"]}
assert report["verdict"] == "different" and report["candidate_order"] == "canonical"
assert rows["align.frame"]["verdict"] == rows["image.srgb"]["verdict"] == "different"
assert rows["points.key"]["verdict"] == "same" and rows["points.key"]["elements"] > 1000
assert "align.frame" in report["first_divergence"]
PY
verdict $? '--json prints one object with the same figures'

run compare r/trace-epr c --tap
[ "$status" -eq 1 ] && grep -q '^not ok [0-9]* - align$' stdout && grep -q '^ok [0-9]* - splat$' stdout &&
	[ "$(grep -cE '^(not )?ok' stdout)" -eq "$(sed -n 's/^1\.\.//p' stdout)" ]
verdict $? '--tap prints a line a stage'

run compare r/trace-epr c --junit j.xml
[ "$status" -eq 1 ] && python3 - j.xml <<'PY'
import sys, xml.dom.minidom
suite = xml.dom.minidom.parse(sys.argv[1]).documentElement
cases = suite.getElementsByTagName("testcase")
assert len(cases) == int(suite.getAttribute("tests")) == len({c.getAttribute("name") for c in cases})
failures = suite.getElementsByTagName("failure")
assert len(failures) == int(suite.getAttribute("failures")) == 2
assert "align.frame" in failures[0].getAttribute("message")
PY
verdict $? '--junit is XML, a case a stage'
ends 2 '/nonexistent/j.xml: cannot be written: No such file' 'where it cannot be written' compare r/trace-epr c \
	--junit /nonexistent/j.xml

run compare r/trace-epr c -o pictures
[ "$status" -eq 1 ] && [ -s pictures/image.srgb.png ] && [ -s pictures/report.json ] &&
	[ "$(ls pictures | wc -l)" -eq 2 ]
verdict $? '-o draws the pixels that differ'
ends 0 ', 0 different' 'its picture is a mask of all but them' compare r/trace-epr r/trace-epr \
	--mask pictures/image.srgb.png
ends 1 'image.srgb' 'and a mask judges what it shows' compare r/trace-epr c --ignore align.frame \
	--mask pictures/image.srgb.png
python3 - <<'PY'
import struct, zlib
def png(name, black, width=96, height=54):
	rows = b"".join(b"\0" + bytes(0 if (x, y) == black else 255 for x in range(width)) for y in range(height))
	def chunk(kind, data):
		return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
	open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR",
	                                                    struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
	                       chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
png("mask.png", (33, 20))
png("other.png", (34, 20))
png("small.png", (1, 1), 95)
png("half.png", (1, 1), 96, 27)
PY
ends 0 'relaxed: --ignore align.frame --mask mask.png' 'a pixel that the mask leaves out' \
	compare r/trace-epr c --ignore align.frame --mask mask.png
ends 1 'image.srgb' 'another pixel' compare r/trace-epr c --ignore align.frame --mask other.png
ends 2 'mask: 95 x 54 pixels; eye.depth_triangle has 96 x 54' 'a mask of another size' compare r/trace-epr c \
	--mask small.png
ends 2 'mask: 96 x 27 pixels; eye.depth_triangle has 96 x 54' 'of half the height' compare r/trace-epr c --mask half.png
ends 2 'none.png: No such file' 'no mask' compare r/trace-epr c --mask none.png

# One file, images.
ends 0 '^1 buffers judged, 0 different' 'one buffer' compare r/trace-epr/11-points.key.npy c/11-points.key.npy
ends 1 'align.frame, piece 12, field s' 'one that differs' compare r/trace-epr/09-align.frame.npy c/09-align.frame.npy
ends 2 'holds points.key' 'two buffers' compare r/trace-epr/09-align.frame.npy c/11-points.key.npy
ends 2 'does not say which buffer' 'a file of no buffer' compare r/trace-epr/09-align.frame.npy j.xml
ends 0 ' 0 different in 0 % of the pixels, largest difference 0, root mean square 0$' 'the same image' compare \
	r/epr.png r/epr.png
ends 1 'pixel (.*), channel .*first of' 'other images' compare r/epr.png r/mvr.png
ends 1 'first of' 'other floats' compare r/epr.exr r/mvr.exr
ends 0 'different' 'within a relaxation' compare r/epr.exr r/mvr.exr --abs 1e9
ends 2 'the reference has' 'images of other sizes' compare r/epr.png pictures/image.srgb.png

# Raw files of a port that has no trace.json.
mkdir raw
python3 - <<'PY'
for name in "11-points.key", "11-points.record", "20-image.srgb":
	data = open(f"r/trace-epr/{name}.npy", "rb").read()
	open("raw/" + name[3:] + ".bin", "wb").write(data[10 + data[8] + 256 * data[9]:])
PY
layout=points.key=points.key.bin,points.record=points.record.bin,image.srgb=image.srgb.bin
ends 0 '^3 buffers judged, 0 different, 37 missing$' 'raw files' compare r/trace-epr raw --layout $layout
python3 - <<'PY'
for name, size in ("points.key", 8), ("points.record", 32):
	data = open(f"raw/{name}.bin", "rb").read()
	records = [data[i:i + size] for i in range(0, len(data), size)]
	open(f"raw/{name}.bin", "wb").write(b"".join(reversed(records)))
PY
ends 1 'buffer points.key, key (' 'in another order' compare r/trace-epr raw --layout $layout
ends 0 ', 0 different' 'which --order declares' compare r/trace-epr raw --layout $layout --order arrival
python3 - <<'PY'
data = open("raw/points.record.bin", "rb").read()
open("raw/points.record.bin", "wb").write(data[:-32])
PY
ends 2 'as many records as keys' 'fewer records than keys' compare r/trace-epr raw --layout $layout --order arrival
ends 2 'no order "random"' 'an order that is none' compare r/trace-epr raw --layout $layout --order random
ends 2 'only with --layout' 'an order without raw files' compare r/trace-epr c --order arrival
ends 2 'rows of 288' 'a part of a row' compare r/trace-epr raw --layout image.srgb=points.key.bin
ends 2 'not the name of a file' 'a way out of the folder' compare r/trace-epr raw --layout image.srgb=../r/epr.png

# Inputs that a candidate has, lacks, or lacks wholly.
mkdir parts
python3 - <<'PY'
import json
trace = json.load(open("c/trace.json"))
def part(name, *keep):
	trace["buffers"] = [{"name": b, "file": f} for b, f in keep]
	json.dump(trace, open(f"parts/{name}.json", "w"))
bad, cull = ("align.frame", "09-align.frame.npy"), ("cull.keep", "08-cull.keep.npy")
part("none", bad)
part("some", bad, cull)
part("all", bad, cull, ("split.piece", "07-split.piece.npy"), ("split.density", "07-split.density.npy"))
PY
for part in 'none; none of its inputs was given' 'all; inputs identical' \
	'some; inputs identical as far as given; not given: split.piece, split.density'; do
	cp -r c "parts/${part%%;*}" && mv "parts/${part%%;*}.json" "parts/${part%%;*}/trace.json"
	ends 1 "align.frame, piece 12, field s: .* first of 1; ${part#*; }\$" "of its inputs ${part%%;*}" \
		compare r/trace-epr "parts/${part%%;*}"
done

# What cannot be compared.
ends 2 'a trace of mvr; the reference' 'other pipelines' compare r/trace-epr r/trace-mvr
ends 2 'No such file' 'no folder' compare r/trace-epr none
ends 2 'No such file' 'no trace' compare r/trace-epr raw
cp -r c odd && mv odd $'n\xe9\e[31mo'
run compare r/trace-epr $'n\xe9\e[31mo' --json
[ "$status" -eq 1 ] && python3 -c 'import json; assert "\\xe9" in json.load(open("stdout"))["candidate"]'
verdict $? 'a folder with a name of any bytes'
mv $'n\xe9\e[31mo' odd
python3 - <<'PY'
import json
trace = json.load(open("odd/trace.json"))
trace["producer"]["name"] = "é" * 200
json.dump(trace, open("odd/trace.json", "w"), ensure_ascii=False)
PY
ends 1 'align.frame' 'a producer with a long name' compare r/trace-epr odd --json
for wrong in '{' '[]' '{"format": "touchstone-trace"}' '{"format": "touchstone-trace", "version": 1, "contract": 9}'; do
	echo "$wrong" > odd/trace.json
	ends 2 'odd/trace.json: ' "a trace.json of $wrong" compare r/trace-epr odd
done
rm odd/trace.json && mkfifo odd/trace.json
ends 2 'not a regular file' 'a pipe for a trace.json' compare r/trace-epr odd
rm odd/trace.json && ln -s /dev/zero odd/trace.json
ends 2 'is a link' 'a link for a trace.json' compare r/trace-epr odd

"$touchstone" compare r/trace-epr c > /dev/full 2> stderr
[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ]
verdict $? 'a full standard output is an error'
"$touchstone" compare r/trace-epr c --tap > /dev/full 2> stderr
[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ]
verdict $? 'also with --tap'
ends 2 '/dev/full: cannot be written: No space left' 'and a full disk of --junit' compare r/trace-epr c \
	--junit /dev/full

finish
