#!/bin/bash
# `report`: a page of a rendered folder and of two traces says what they hold; FLIP is numpy's; text of files stays
# text; bad input is refused; and, where Chromium is installed, the page works in it, by mouse and by keyboard, wide and
# small.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
judge=(/usr/bin/python3 "$(realpath tests/cli/report.py)")
browser=$(realpath tests/cli/report_page.py)
cd "$scratch" || exit 2

# holds NAME CHECK ARGUMENT...: the check of report.py ends well.
holds() {
	local name=$1
	shift
	"${judge[@]}" "$@" > judged 2>&1
	verdict $? "$name"
	[ ! -s judged ] || sed 's/^/# /' judged | tail -3
}

run "${frame[@]:0:${#frame[@]}-1}" --method epr,mvr --truth=A --self-contained -o r --report rendered.html
[ "$status" -eq 0 ] && [ -s rendered.html ] && [ ! -e rendered.html.partial ]
verdict $? 'render --report'
holds 'a rendered folder' folder rendered.html r
holds 'FLIP is that of numpy' flip rendered.html truth-a:epr truth-a:mvr
run report r -o again.html
[ "$status" -eq 0 ] && [ ! -s stdout ] && [ ! -s stderr ] && cmp rendered.html again.html
verdict $? 'report: the same page, byte for byte'
run report r -o near.html --ppd 20
holds 'FLIP is that of numpy at 20 pixels per degree' flip near.html truth-a:epr

cp -r r/trace-epr c
"${judge[@]}" spoil c eye.depth_triangle:8:10,5 image.radiance:12:33,20 image.srgb:3:33,20 image.srgb:3:34,20
run compare r/trace-epr c --report compared.html --first 9
[ "$status" -eq 1 ]
verdict $? 'compare --report'
line=$(grep '^stage 04 eye, buffer eye.depth_triangle' stdout)
firsts='{"10,5": "eye.depth_triangle", "33,20": "image.radiance", "34,20": "image.srgb"}'
holds 'two traces' comparison compared.html r/trace-epr c "$line" 3 "$firsts"
run report r/trace-epr c -o reported.html --probes 2
[ "$status" -eq 0 ]
verdict $? 'report of two traces that differ'
holds 'and what it says' comparison reported.html r/trace-epr c "$line" 2 "$firsts"
run report r/trace-epr c -o none.html --probes 0
holds 'no probes' comparison none.html r/trace-epr c "$line" 0 "$firsts"
run compare r/epr.png r/mvr.png --report images.html
[ "$status" -eq 1 ]
verdict $? 'compare --report of images'
holds 'FLIP of images' flip images.html r/epr.png:r/mvr.png
"${judge[@]}" ramp ramp.png
run compare ramp.png ramp.png --report ramp.html
holds 'codes of 16 bits are rounded' codes ramp.html
run report r/trace-epr r/trace-mvr -o two.html
holds 'FLIP of traces of two methods' flip two.html epr:mvr
rm c/*-image.srgb.npy
/usr/bin/python3 - <<'PY'
import json
trace = json.load(open("c/trace.json"))
for buffer in trace["buffers"]:
	if buffer["name"] == "image.srgb":
		buffer["file"] = None
json.dump(trace, open("c/trace.json", "w"))
PY
run compare r/trace-epr c --report partial.html
[ "$status" -eq 1 ] && grep -q '"reference":0,"image":1' partial.html
verdict $? 'a port without display values has the picture of its radiance'

# Text of files, in trace.json, in report.json and in names of folders.
evil='</script><script>window.hacked=1</script><b class=hacked>'
cp -r r/trace-epr 'evil<b>'
/usr/bin/python3 - "$evil" <<'PY'
import json, sys
for path, keys in (("evil<b>/trace.json", ("producer", "name")), ("r/report.json", ("notes",))):
	root = json.load(open(path))
	if keys[0] == "notes":
		root["notes"] = root["scene"] = sys.argv[1]
		root["notes"] = [sys.argv[1]]
	else:
		root["producer"]["name"] = root["scene"]["name"] = sys.argv[1]
	json.dump(root, open(path, "w"))
PY
run report r/trace-epr 'evil<b>' r -o hostile.html
[ "$status" -eq 0 ]
verdict $? 'a page of hostile names'
holds 'they are data' names hostile.html "$evil"
holds 'also of folders' names hostile.html 'evil<b>'

# Files of other types than expected.
mkdir odd
cp r/epr.png odd/
for odd in '{"program": "touchstone", "files": ["epr.png"], "methods": ["epr"], "notes": 5, "verdict": {"a": []},
	"stages": 7, "differences": [3], "buffers": "x", "effect": [1], "scene": {},
	"counters": [{"a": {"b": []}}, {"c": null}], "milliseconds": [{"stage": null, "x": "y", "z": 1}], "params": 9}'; do
	echo "$odd" | tee odd/report.json > odd/times.json
done
run report odd -o odd.html
verdict "$status" 'a page of odd figures'

# Series: a sweep, and a sequence of one method with a video.
series=("${frame[@]:0:${#frame[@]}-1}" --method epr)
run "${series[@]}" --truth=A --set density.scale=0.25,0.5 -o sweep --report sweep.html
[ "$status" -eq 0 ] && run "${series[@]}" --frames 0..1 -o sequence
echo video > sequence/epr.mp4
sed -i 's/"files": \[/&"epr.mp4", /' sequence/report.json
run report sequence -o sequence.html
verdict "$status" 'pages of series'
holds 'a sweep has its plot, its values and captions' series sweep.html sweep rmse-density.scale.svg
holds 'a sequence has its video' series sequence.html sequence epr.mp4

refuses 'report: no file to write; add -o FILE.html' report r
refuses 'report: too few arguments' report -o x.html
refuses 'nothing: holds no trace.json, report.json or params.txt' report nothing -o x.html
refuses '--ppd: 0 pixels per degree; 1 to 1000 would be right' report r -o x.html --ppd 0
refuses '--probes' report r -o x.html --probes 10001
refuses 'cannot be written' report r -o nowhere/x.html
refuses 'lies in q, which a later render replaces' "${frame[@]:0:${#frame[@]}-1}" -o q --report q/x.html
refuses '--no-images writes no pictures' "${frame[@]}" -o q --trace --report x.html
refuses '--report: means something for traces and images only' compare r/trace-epr/*-eye.view.npy \
	r/trace-epr/*-eye.view.npy --report x.html
echo kept > kept.html
mkdir bad
for what in '{"program": "other"}' '[]' '{' '{"program": "touchstone", "files": ["absent.png"]}'; do
	echo "$what" > bad/report.json
	refuses 'bad/' report bad -o kept.html
done
echo '{"program": "touchstone", "files": ["cut.png"]}' > bad/report.json
head -c 500 r/epr.png > bad/cut.png
refuses 'bad/cut.png: damaged' report bad -o kept.html
[ "$(cat kept.html)" = kept ]
verdict $? 'a page that could not be written leaves the old one'
echo '{"program": "touchstone", "files": ["../r/epr.png", "/etc/passwd", ".hidden.png", "a/b/c.png", 3]}' \
	> bad/report.json
run report bad -o names.html
[ "$status" -eq 0 ] && grep -q '"pictures":\[\]' names.html
verdict $? 'no name leads out of the folder'
"${judge[@]}" noise bad/noise.png 4300
echo '{"program": "touchstone", "files": ["noise.png"]}' > bad/report.json
run report bad -o large.html
[ "$status" -eq 0 ] && [ "$(wc -l < stderr)" -eq 1 ] &&
	grep -q 'large.html: 70 MB; browsers take long above 64 MB' stderr
verdict $? 'a large page is said to be'
rm -f large.html bad/noise.png

cp "$touchstone" alone
touchstone=$scratch/alone
run report r -o alone.html
[ "$status" -eq 0 ] && grep -q 'data:image/png' alone.html
verdict $? 'a page of PNG files without the module of images'
touchstone=$(realpath "$OLDPWD/${BUILD:-build/release}/touchstone")

if [ -n "${TS_WHOLE-}" ] && command -v chromium chromium-browser google-chrome > /dev/null; then
	while read -r outcome name; do
		[ "$outcome" = not ] && name=${name#ok }
		[ "$outcome" = ok ]
		verdict $? "$name"
	done < <(/usr/bin/python3 "$browser" compared.html rendered.html hostile.html odd.html sweep.html sequence.html)
	[ "$tests" -gt 50 ]
	verdict $? 'all checks in a browser ran'
else
	echo "ok $((tests += 1)) - the page in a browser # SKIP with TS_WHOLE=1, where there is a chromium"
fi
finish
