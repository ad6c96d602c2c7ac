#!/bin/bash
# `compare` of a candidate with faults in several stages: the verdict of each stage, the first differences of each
# buffer, their fields, and the counts behind prefix sums, in text, JSON, TAP and JUnit XML.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2

cat > planting.py <<'PY'
import array, glob, sys
opened = {}
def words(name):
	"""The 32-bit words of a buffer of the candidate, to be changed."""
	path, = glob.glob(f"{sys.argv[1]}/*-{name}.npy")
	content = open(path, "rb").read()
	at = 10 + content[8] + 256 * content[9]
	opened[path] = content[:at], array.array("I", content[at:])
	return opened[path][1]
def count_wrong(name, count, by=1):
	"""All sums behind one count are wrong."""
	sums = words(name)
	for i in range(count + 1, len(sums)):
		sums[i] += by
PY
# plant FOLDER: a candidate with what the Python on standard input changes.
plant() {
	rm -rf "$1" && cp -r r/trace-epr "$1" && cat planting.py - > plant.py &&
		echo 'for path, (head, data) in opened.items(): open(path, "wb").write(head + data.tobytes())' >> plant.py &&
		python3 plant.py "$1"
}

# tells PATTERN NAME: the last output has a line that is the pattern.
tells() {
	grep -qxE -- "$1" stdout
	verdict $? "$2"
}

run "${frame[@]}" --method epr --trace -o r
verdict "$status" 'a trace'
plant several <<'PY'
pixels = words("mirror_pixel.record")
for pixel in range(40, 52):
	pixels[24 * pixel] ^= 1
	if pixel > 48:
		pixels[24 * pixel + 5] ^= 0x80000000
words("align.frame")[20 * 7 + 3] ^= 3
words("image.radiance")[600] ^= 1
PY

# Without --forced: the first divergence is one line, and the last one.
run compare r/trace-epr several
[ "$status" -eq 1 ] &&
	tail -n 1 stdout | grep -q \
		'^stage 05 mirror_pixel, buffer mirror_pixel.record, pixel (.*, field position\[0\]: ref .* [+-]1 ulp — first of 12; inputs identical$'
verdict $? 'the first divergence is the last line'
tells 'mirror_pixel.record: elements that differ, by field: position 12, normal 3' 'elements of each field'
tells 'align.frame: elements that differ, by field: s 1' 'of later stages too'
for n in 1 3 12 13 1000; do
	run compare r/trace-epr several --first $n
	[ "$status" -eq 1 ] &&
		[ "$(grep -cE '^  pixel \([0-9]+, [0-9]+\), field position\[0\]: ref .* candidate .* [+-]1 ulp$' stdout)" \
		-eq $(((n < 12 ? n : 12) - 1)) ]
	verdict $? "--first $n of 12"
done
for n in 0 -1 1001 4294967297 x ''; do
	refuses 'first: ".*" is not a whole number from 1 to 1000' compare r/trace-epr several --first "$n"
done

# With it: every stage.
run compare r/trace-epr several --forced
[ "$status" -eq 1 ] && [ "$(grep -c '^stage .*, buffer ' stdout)" -eq 1 ]
verdict $? 'the first divergence is one line with --forced too'
tells 'stage 04 eye: same' 'a stage that is the same'
tells 'stage 05 mirror_pixel: different' 'the first that differs'
tells '  mirror_pixel.record, pixel \(.*\), field position\[0\]: ref .* — first of 12' 'and its first difference'
tells '  align.frame, piece 7, field s: ref .* candidate .* ulp — first of 1' 'and of the next that differs'
[ "$(grep -cE '^stage [0-9]+ [a-z_.]+: (same|different)$' stdout)" -eq "$(python3 -c '
import json
trace = json.load(open("r/trace-epr/trace.json"))
there = {b["name"] for b in trace["buffers"] if b["file"]}
print(sum(bool(there & set(s["writes"])) for s in trace["stages"]))')" ]
verdict $? 'a line a stage'
run compare r/trace-epr several --forced --first 2
grep -A1 '^  mirror_pixel.record' stdout | grep -q '^    pixel (.*), field position\[0\]: ref'
verdict $? 'with --first the next difference stands below'

run compare r/trace-epr several --forced --first 2 --json
[ "$status" -eq 1 ] && python3 - <<'PY'
import json
report = json.load(open("stdout"))
stages = {s["stage"]: s for s in report["stages"]}
mirror = stages["mirror_pixel"]
assert mirror["lines"][0] == report["first_divergence"] and mirror["outcome"] == "failed"
assert (mirror["number"], mirror["verdict"], mirror["why"]) == (5, "different", "")
assert stages["eye"]["verdict"] == "same"
buffers = {d["buffer"]: d for d in report["differences"]}
assert set(buffers) == {r["buffer"] for r in report["buffers"] if r["verdict"] == "different"}
pixels = buffers["mirror_pixel.record"]
assert pixels["fields"] == {"position": 12, "normal": 3} and pixels["judged_by"] == "elements"
assert pixels["line"] == report["first_divergence"]
assert [d["element"] for d in pixels["first"]] == [40, 41] and abs(pixels["first"][1]["ulps"]) == 1
assert pixels["first"][0]["field"] == "position[0]" and pixels["first"][0]["how"] == "unequal"
assert pixels["first"][0]["where"] in pixels["line"] and pixels["first"][0]["reference"] in pixels["line"]
PY
verdict $? 'the JSON report has the same'

# A wrong count: the first, one in the middle, the last.
last=$(python3 - <<'PY'
import glob, os
print((os.path.getsize(glob.glob("r/trace-epr/*-points.offset.npy")[0]) - 128) // 4 - 2)
PY
)
for count in 0 17 "$last"; do
	echo "count_wrong('points.offset', $count)" | plant count
	run compare r/trace-epr count
	[ "$status" -eq 1 ] &&
		tail -n 1 stdout | grep -qE \
			"^stage 10 points.count, buffer points.offset, count of piece $count \(element $((count + 1)) less element $count\), ref [0-9]+ candidate [0-9]+ — first of 1; inputs identical\$"
	verdict $? "the count of piece $count of $last"
done
tells 'points.offset: sums, judged by their counts' 'and how that is known'
prints ' 0 different' compare r/trace-epr count --allow 1
echo "sums = words('points.offset'); sums[:-1] = sums[1:]" | plant inclusive
run compare r/trace-epr inclusive
[ "$status" -eq 1 ] &&
	tail -n 1 stdout | grep -q 'points.offset, element 0, where the sums begin, ref 0 candidate [1-9]'
verdict $? 'sums that do not begin at 0'
grep -q '^how the reference computes it: .* --element points.offset:0$' stdout
verdict $? 'whose explanation is of element 0'
run replay r/trace-epr --stage points.count --inputs count
[ "$status" -eq 1 ] && grep -q "first count of element $last .*: [0-9]* is right, [0-9]* was found" stdout
verdict $? 'replay names the count too'

# Stages that cannot be run on wrong sums are not judged, and the others are.
run compare r/trace-epr count --forced
[ "$status" -eq 1 ] && grep -q '^[0-9]* buffers judged, 1 different, 0 missing, [1-9] not judged$' stdout
verdict $? 'a stage that cannot be run'
tells 'stage 10 points.count: different' 'the stage at fault differs'
tells 'stage 11 points: not judged: count/10-points.offset.npy: element .* would be right' \
	'and the next says why it is not judged'
tells 'stage 20 image: same' 'which keeps no other from being judged'
run compare r/trace-epr count --forced --tap --junit j.xml
grep -qE '^ok [0-9]+ - points # SKIP not judged: count/' stdout && grep -q '^not ok [0-9]* - points.count$' stdout &&
	grep -q '^#   points.offset: sums' stdout && python3 - <<'PY'
import xml.dom.minidom
suite = xml.dom.minidom.parse("j.xml").documentElement
cases = {c.getAttribute("name"): c for c in suite.getElementsByTagName("testcase")}
skipped, failures = suite.getElementsByTagName("skipped"), suite.getElementsByTagName("failure")
assert len(cases) == int(suite.getAttribute("tests")) and len(skipped) == int(suite.getAttribute("skipped")) > 0
assert len(failures) == int(suite.getAttribute("failures")) == 1
assert "count of piece" in failures[0].getAttribute("message")
assert "judged by their counts" in failures[0].firstChild.data
assert cases["points"].firstChild.getAttribute("message").startswith("not judged: count/")
PY
verdict $? 'TAP and JUnit say so too'
mv count $'n\xe9'
run compare r/trace-epr $'n\xe9' --forced --junit j.xml --json
[ "$status" -eq 1 ] && python3 -c '
import json, xml.dom.minidom
xml.dom.minidom.parse("j.xml")
why = {s["stage"]: s["why"] for s in json.load(open("stdout"))["stages"]}
assert "n\\xe9/10-points.offset.npy" in why["points"]'
verdict $? 'a folder with a name of any bytes'
refuses 'points.offset.npy: element .* would be right' compare r/trace-epr $'n\xe9' --forced --ignore points.offset

# Points in the order of their arrival: one is missing, one is there twice, and three are wrong.
plant arrival <<'PY'
import json
trace = json.load(open(sys.argv[1] + "/trace.json"))
json.dump(dict(trace, order="arrival"), open(sys.argv[1] + "/trace.json", "w"))
keys, records = words("points.key"), words("points.record")
n = len(keys) // 2
order = [*range(n - 1, 500, -1), *range(500)] + [7]
for buffer, size in (keys, 2), (records, 8):
	old = list(buffer)
	for place, point in enumerate(order):
		buffer[size * place:size * place + size] = array.array("I", old[size * point:size * point + size])
for point in 3, 600, 900:
	records[8 * order.index(point) + 3] ^= 1
PY
python3 - <<'PY'
import struct
def words(name, size):
	data = open(f"r/trace-epr/{name}.npy", "rb").read()[128:]
	return [data[i:i + size] for i in range(0, len(data), size)]
def name(key):
	key, = struct.unpack("<Q", key)
	return f"key (piece {key >> 32}, x {(key & 0xffff) - 32768}, y {(key >> 16 & 0xffff) - 32768})"
keys = words("11-points.key", 8)
open("right", "w").write("".join(f"  {line}\n" for line in [name(keys[500]) + ": missing", name(keys[7]) + ": twice"] +
                                 [name(keys[i]) + ", field length:" for i in (3, 600, 900)]))
PY
run compare r/trace-epr arrival --first 9 --ignore \
	points.key,splat.depth_index,lookup.point,lookup.second_point,lookup.third_point,lookup.second_parent,lookup.third_parent
grep -a '^stage 11 points, buffer points.record, key (' stdout | sed 's/^.*record, /  /; s/ — .*//' |
	cat - <(grep -a '^  key' stdout | sed 's/length: .*/length:/') | cmp -s - right
verdict $? 'points in order of arrival, by their keys'
tells 'points.record: elements that differ, by field: length 3' 'and fields of those that are there'
run compare r/trace-epr arrival --forced --first 2
grep -aA2 '^stage 11 points: different' stdout |
	grep -qF "points.key,$(sed -n '1s/^ //p' right) — first of 1 missing, 1 beside"
verdict $? 'a point too few is missing from what the stage makes'

# The scene is no stage, and is judged all the same.
echo 'words("scene.vertex")[0] ^= 1' | plant scene
run compare r/trace-epr scene --tap
[ "$status" -eq 1 ] && grep -q '^not ok 1 - scene$' stdout && grep -q '^# stage 00 scene, buffer scene.vertex' stdout
verdict $? 'a scene that differs is in the TAP'

finish
