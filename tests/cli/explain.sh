#!/bin/bash
# `explain`: an item line by line, the item behind an element, two traces beside each other, a port's inputs, and what
# cannot be explained.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
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
assert {line["how"] for line in lines} == {"call", "value", "result", "test", "store"}
assert lines[0]["depth"] == 0 and all(b["depth"] <= a["depth"] + 1 for a, b in zip(lines, lines[1:]))
PY
verdict $? 'the line that stores an element has its bits'

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
run explain $epr whole --stage splat --item 5 --json
[ "$status" -eq 1 ] && python3 - stdout <<'PY'
import json, sys
told = json.load(open(sys.argv[1]))
first = told["first_difference"]
one, two = first["trace"]["value"], first["other"]["value"]
assert [key for key in one if one[key] != two[key]] == [".length"]
assert int(one[".length"]["bits"], 16) - int(two[".length"]["bits"], 16) == 1 << 23 # half of it
PY
verdict $? 'the same as JSON'
run explain $epr port --stage splat --item 5
[ "$status" -eq 1 ] && [ "$(sed -n 3p stdout | grep -c '^<.* \*record = \.length ')" -eq 1 ]
verdict $? "a port's trace, of one buffer"
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
