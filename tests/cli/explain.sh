#!/bin/bash
# `explain`: an item line by line, the item behind an element, two traces beside each other, a port's inputs, and what
# cannot be explained.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
splat=$PWD/src/kernels/points/splat.h
cd "$scratch" || exit 2
"$touchstone" "${frame[@]}" --method epr,mvr --self-contained -o out > /dev/null ||
	{ echo "Bail out! no trace"; exit 1; }
epr=out/trace-epr

prints '^launch 1 of 2, kernel split_count of [0-9]* items$' explain $epr --stage split
prints '^launch 2 of 2, kernel split of [0-9]* items$' explain $epr --stage split
prints '^ *1 points/split.h:[0-9]* *ts_k_split_count_item()$' explain $epr --stage split --item 0
grep -q '^launch 2 of 2, kernel split, item 0 of' stdout
verdict $? 'the item of each launch'
run explain $epr --stage split --item 0 --kernel split
[ "$status" -eq 0 ] && ! grep -q split_count stdout
verdict $? 'of one kernel'
prints '^[0-9]* more lines; a larger number of lines keeps them: --lines$' explain $epr --stage split --item 0 --lines 3
[ "$(grep -c -- --lines stdout)" -eq 1 ]
verdict $? 'the option is named once'

# Every pixel's radiance is the number that its explanation ends with; the JSON says what the text says.
run explain $epr --stage image --element image.radiance:7000 --json
[ "$status" -eq 0 ] && python3 - stdout $epr/*-image.radiance.npy <<'PY'
import json, struct, sys
told = json.load(open(sys.argv[1]))
data = open(sys.argv[2], "rb").read()
head = 10 + struct.unpack("<H", data[8:10])[0]
lines = told["launches"][0]["lines"]
stores = lines[told["stores"] - 1]
assert stores["how"] == "store" and stores["to"] == "image.radiance:7000", stores
held = data[head + 4 * 7000 : head + 4 * 7001][::-1].hex()
assert stores["value"][""]["bits"] == held, (stores, held)
assert {line["how"] for line in lines} == {"call", "value", "result", "test", "store", "title"}
assert lines[0]["depth"] == 0 and all(b["depth"] <= a["depth"] + 1 for a, b in zip(lines, lines[1:]))
PY
verdict $? 'the line that stores an element has its bits'

prints ' args->found\[.*\], lookup.point:[0-9]* = ' explain $epr --stage lookup --item 5 --outline

# titles FUNCTION...: of their paragraphs, in the text of splat.h. printed: in what was printed, each once in a row.
titles() {
	local function
	for function; do
		sed -n "/^TS_.* $function(/,/^}/s/^\t*\/\* \(.*\) \*\/$/\1/p" "$splat"
	done
}
printed() { sed -n 's/^.* points\/splat\.h:.* -- //; T; s/ ([0-9]* times)$//; p' stdout | uniq; }

# Headings in the order of the kernel, in all lines and in an outline, which has each once.
run explain $epr --stage splat --item 5
[ "$status" -eq 0 ] && titles ts_k_splat_everywhere ts_k_splat | head -n 5 > text && printed | head -n 5 | diff text -
verdict $? 'titles stand before their lines'
run explain $epr --stage splat --item 5 --outline
[ "$status" -eq 0 ] && titles ts_k_splat_everywhere ts_k_splat > text && [ "$(wc -l < text)" -eq 7 ] &&
	printed | diff text -
verdict $? '--outline prints each title once'
! grep -qE '\? (yes|no)$|ts_k_' stdout && grep -q ' \*least, splat.depth_index:[0-9]* = ' stdout &&
	[ "$(wc -l < stdout)" -lt 150 ]
verdict $? 'no decision and no call, but stores'
grep -q ' box = \.x0 ' stdout && ! grep -qE ' (d|i|j|word) = ' stdout
verdict $? 'of values those that other paragraphs read'

# Every line of an outline is the last of its name in its paragraph, under the titles that it stands under.
run explain $epr --stage splat --item 5 --json --outline
cp stdout outline.json
run explain $epr --stage splat --item 5 --json
python3 - stdout outline.json <<'PY'
import collections, json, sys
whole, outline = [json.load(open(name))["launches"][0]["lines"] for name in sys.argv[1:]]
last, times, titles, at = {}, collections.Counter(), [], {}
for number, line in enumerate(whole, 1):
	depth = line["depth"]
	at = {k: title for k, title in at.items() if k <= depth}
	place = (line["file"], line["line"])
	above = tuple(title for k, title in sorted(at.items()) if k < depth or line["how"] != "title")
	key = above, line["how"], depth, place if line["how"] == "title" else line["text"]
	if line["how"] == "title":
		at[depth] = place
		titles += [key] if key not in last else []
	last[key] = number
	times[key] += 1
keys = {number: key for key, number in last.items()}
assert len(outline) > 50
for line in outline:
	number = line.pop("number")
	assert number in keys, number
	assert times[keys[number]] == line.pop("times") and line == whole[number - 1]
told = {keys[last[key]] for key in titles}
assert len(titles) == len(told) == sum(line["how"] == "title" for line in outline) > 15
stored = {key for key in keys.values() if key[1] == "store" and "value" in whole[last[key] - 1]}
assert len(stored) == sum(line["how"] == "store" for line in outline) > 0
PY
verdict $? 'the values of an outline are the last of all lines'

run explain $epr $epr --stage points --item 3
[ "$status" -eq 0 ] && grep -q '^the same lines in ' stdout && ! grep -q '^[<>]' stdout
verdict $? 'a trace beside itself'

# A port whose pieces are shorter.
python3 - $epr <<'PY'
import glob, json, os, struct, sys
os.mkdir("port")
data = bytearray(open(glob.glob(sys.argv[1] + "/*-points.record.npy")[0], "rb").read())
head = 10 + struct.unpack("<H", data[8:10])[0]
length = head + 32 * 5 + 12
data[length : length + 4] = struct.pack("<f", struct.unpack("<f", data[length : length + 4])[0] / 2)
open("port/record.npy", "wb").write(data)
json.dump({"format": "touchstone-trace", "version": 1, "contract": 1, "pipeline": "epr", "order": "canonical",
	"producer": {"name": "a port"}, "buffers": [{"name": "points.record", "file": "record.npy"}]},
          open("port/trace.json", "w"))
PY
run explain $epr --stage splat --item 5
mv stdout alone
run explain $epr --stage splat --item 5 --inputs port
[ "$status" -eq 0 ] && [ "$(diff alone stdout | grep -c '^<.*\*record = ')" -eq 1 ]
verdict $? "a port's buffers are what the item begins with"
cp -r $epr whole && cp port/record.npy whole/"$(basename $epr/*-points.record.npy)"
run explain $epr whole --stage splat --item 5
[ "$status" -eq 1 ] && [ "$(sed -n 3p stdout | grep -c '^<.* \*record = \.length [0-9.e-]* ([0-9a-f]\{8\})$')" -eq 1 ]
verdict $? 'two traces: the first line that differs, and what in it'
grep -q '^they part in: Bound the projected square' stdout
verdict $? 'two traces: the paragraph in which they part'
run explain $epr whole --stage splat --item 5 --outline
[ "$status" -eq 1 ] && grep -q '^they part in: Bound the projected square' stdout &&
	[ "$(grep -c '^[<>] *[0-9]* points/splat.h:.* square = \.length ' stdout)" -eq 2 ] &&
	grep -q '^ .* -- Bound the projected square' stdout && ! grep -q '^[<>].* -- Clip the piece' stdout
verdict $? 'outlines of two traces'
run explain $epr whole --stage splat --item 5 --json
[ "$status" -eq 1 ] && python3 - stdout <<'PY'
import json, sys
told = json.load(open(sys.argv[1]))
first = told["first_difference"]
one, two = first["trace"]["value"], first["other"]["value"]
assert [key for key in one if one[key] != two[key]] == [".length"]
assert first["title"].startswith("Bound the projected square"), first["title"]
assert int(one[".length"]["bits"], 16) - int(two[".length"]["bits"], 16) == 1 << 23 # half of it
PY
verdict $? 'the same as JSON'
run explain $epr port --stage splat --item 5
[ "$status" -eq 1 ] && [ "$(sed -n 3p stdout | grep -c '^<.* \*record = \.length ')" -eq 1 ]
verdict $? "a port's trace, of one buffer"
cp -r $epr moved && change moved/*-cube_size.face.npy 64 0 0 0100803f
run explain $epr moved --stage splat --item 5 --outline
[ "$status" -eq 1 ] && grep -q '^they part in: Look along the face' stdout
verdict $? 'another input, another paragraph'
run explain $epr whole --stage splat --item 6
[ "$status" -eq 0 ]
verdict $? 'another item is the same'

refuses '--stage NAME must be given' explain $epr
refuses '"gbuffer" is no stage of epr' explain $epr --stage gbuffer --item 1
refuses 'no launch has item 4000000; items of its launches: eye [0-9]*$' explain $epr --stage eye --item 4000000
refuses 'the host computes it' explain $epr --stage eye.view --item 0
refuses 'no such kernel; the nearest is splat' explain $epr --stage splat --item 0 --kernel splatt
refuses 'not BUFFER:E' explain $epr --stage splat --element 12
refuses 'writes no buffer points.record' explain $epr --stage splat --element points.record:12
refuses 'is not a whole number\|--element' explain $epr --stage splat --element splat.depth_index:-1
refuses 'no item writes element' explain $epr --stage splat --element splat.depth_index:4000000000
refuses 'leave --item and --kernel out' explain $epr --stage splat --element splat.depth_index:1 --item 3
refuses 'OTHER or --inputs, not both' explain $epr $epr --stage splat --item 3 --inputs port
refuses 'cannot be its reference' explain $epr out/trace-mvr --stage eye --item 3
refuses 'nowhere' explain $epr nowhere --stage eye --item 3
finish
