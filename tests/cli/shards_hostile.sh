#!/bin/bash
# Shards that somebody else wrote, or hurt: merge reads nothing but regular files that SHA256SUMS confirms, obeys no
# word that a shard says was typed but those of its pictures, and refuses all else by one line.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
cd "$scratch" || exit 2
export OMP_WAIT_POLICY=passive

# refuses_merge PATTERN NAME DIR...: exit code 2 and one line.
refuses_merge() {
	local pattern=$1 name=$2
	shift 2
	run merge "$@"
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -s stdout ] && grep -q -- "$pattern" stderr
	verdict $? "$name"
}
# forged CODE SHARD...: HURT-SHARD, with a report that CODE has changed, and digests as if it was written so.
forged() {
	for shard in "${@:2}"; do rm -rf "hurt-$shard" && cp -r "$shard" "hurt-$shard"; done
	python3 - "$@" <<'PY'
import hashlib, json, os, sys
for folder in ["hurt-" + shard for shard in sys.argv[2:]]:
	report = json.load(open(folder + "/report.json"))
	shard = report["shard"]
	exec(sys.argv[1])
	json.dump(report, open(folder + "/report.json", "w"))
	names = [name for name in report["files"] + ["report.json"] if name != "SHA256SUMS"]
	with open(folder + "/SHA256SUMS", "w") as sums:
		for name in sorted(set(names)):
			sums.write(hashlib.sha256(open(os.path.join(folder, name), "rb").read()).hexdigest() + "  " + name + "\n")
PY
}

run "${frame[@]}" --method epr --trace -o r
cp -r r/trace-epr c
change c/09-align.frame.npy 80 12 12 0000803f
change c/20-image.srgb.npy 1 $((3 * (20 * 96 + 33) + 1)) 0 ff
for i in 1 2 3; do run compare r/trace-epr c --shard $i/3 -o s-$i; done
bad=0
for file in s-2/*; do
	rm -rf hurt && cp -r s-2 hurt
	python3 - "hurt/${file#s-2/}" <<'PY'
import sys
data = bytearray(open(sys.argv[1], "rb").read())
data[len(data) // 2] ^= 1
open(sys.argv[1], "wb").write(data)
PY
	run merge s-1 hurt s-3
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] &&
		grep -q '^touchstone: hurt: damaged: .*; run that shard again$' stderr || bad=1
	[ "${file#s-2/}" = SHA256SUMS ] ||
		{ rm "hurt/${file#s-2/}" && run merge s-1 hurt s-3; [ "$status" -eq 2 ] || bad=1; }
done
verdict "$bad" 'a file that is damaged, or missing'
# Nothing but what SHA256SUMS confirms is read, and no link is followed.
with=$(dirname "$(ls s-*/*.png | head -n 1)") && picture=$(basename "$(ls $with/*.png | head -n 1)")
others=$(ls -d s-* | grep -v "$with")
echo secret > secret.png
rm -rf hurt && cp -r "$with" hurt && ln -sf ../secret.png "hurt/$picture" &&
	sed -i "s/^.*  $picture$/$(sha256sum < secret.png | cut -d ' ' -f 1)  $picture/" hurt/SHA256SUMS
refuses_merge "hurt: damaged: hurt/$picture: a link; the file itself would be right" 'a link out of the folder' \
	hurt $others
rm -rf hurt && cp -r "$with" hurt && sed -i "/  $picture$/d" hurt/SHA256SUMS
refuses_merge "hurt: damaged: SHA256SUMS names no $picture" 'a picture that nothing confirms' hurt $others
# forge NAME CODE: a shard 2 whose report says something else is refused, and nothing crashes.
forge() {
	forged "$2" s-2
	rm -rf all
	run merge s-1 hurt-s-2 s-3 -o all
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -e all ]
	verdict $? "refused: $1"
}
forge 'no shard' 'del report["shard"]'
forge 'a number that is none' 'shard["index"] = "2"'
forge 'an index beyond' 'shard["index"] = 4'
forge 'no list of cases' 'shard["cases"] = 7'
forge 'other cases' 'shard["cases"].append("more")'
forge 'no rows' 'report["stages"] = {}'
forge 'a row of another shard' 'report["stages"][0]["stage"] = "scene"'
forge 'a row without an outcome' 'del report["stages"][0]["outcome"]'
forge 'lines that are numbers' 'report["stages"][0]["lines"] = [1]'
forge 'another reference' 'report["reference"] = "elsewhere"'
forge 'no verdict' 'del report["verdict"]'
forge 'an exit code that its rows do not have' 'shard["status"] = 0'
forge 'a status of its own' 'shard["status"] = 3'

# What a shard says was typed may hold anything; merge obeys none of it that is not of the pictures.
series=(render reflections atrium:triangles=10000:texels=32 --size 49x27 --method epr --reflectors 3
	--set reflectors.px=20 --set cube.max_px=16,32)
# typed WORD...: merges shards of which each says that these words were typed, too.
typed() {
	local words
	words=$(printf "'%s', " "$@")
	forged "shard['typed'] = [$words] + shard['typed']" p-1 p-2
	rm -rf all
	run merge hurt-p-1 hurt-p-2 -o all
}
for i in 1 2; do run "${series[@]}" --report own.html --threads 1 --shard $i/2 -o "p-$i"; done
rm -rf own.html all
run merge p-1 p-2 -o all
[ "$status" -eq 0 ] && [ ! -e own.html ]
verdict $? "the page of a shard is not merge's"
run merge p-1 p-2 -o all --force --report whole.html
[ "$status" -eq 0 ] && [ -s whole.html ]
verdict $? 'merge writes its own page'
echo precious > precious
bad=0
for words in --report=precious '--report precious' '-o precious' --help --trace --shard=1/2 --backend=opencl \
	--threads=2 --no-images --junit=precious; do
	typed $words
	[ "$status" -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && [ ! -e all ] && [ "$(cat precious)" = precious ] &&
		grep -q '^touchstone: hurt-p-1: damaged: ' stderr || { echo "$words"; bad=1; }
done
verdict "$bad" 'words that would write or run something else'
typed --set cube.max_px=16,32,64
[ "$status" -eq 2 ] && grep -q 'hurt-p-1: damaged: what was typed is not the series of its cases' stderr
verdict $? 'more combinations than cases'
mkfifo pipe
typed --path=pipe --set seed=7
[ "$status" -eq 0 ] && [ ! -e all/pipe ]
verdict $? 'no file of keyframes is read, and no scene opened'
finish
