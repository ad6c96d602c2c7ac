#!/bin/bash
# Shards of series: each combination is in exactly one, and what `merge` writes of all of them is to the byte what the
# command writes without shards, but for times.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 2
export OMP_WAIT_POLICY=passive

# series N NAME ARGUMENT...: one run, and N shards of it, merged: pictures, CSV, plots, contact sheets and videos are
# the same. Times are in times.json alone, and what a sweep prints.
series() {
	local n=$1 name=$2 i same=0
	shift 2
	rm -rf whole all s-* && run "$@" -o whole
	[ "$status" -eq 0 ] && [ -s whole/contact-sheet.png ] || same=1
	for ((i = 1; i <= n; i++)); do
		run "$@" --shard "$i/$n" -o "s-$i"
		[ "$status" -eq 0 ] || same=1
	done
	run merge $(ls -d s-* | shuf --random-source=<(yes)) -o all
	[ "$status" -eq 0 ] && diff -r -x 'times*' whole all > differs && [ "$(ls whole)" = "$(ls all)" ] || same=1
	[ "$same" -eq 0 ] || cat differs stderr
	verdict "$same" "$name"
}
small=(render reflections atrium:triangles=10000:texels=32 --size 49x27 --method epr,mvr --reflectors 3
	--set reflectors.px=20 --set cube.hysteresis=4)
series 2 "a sweep" "${small[@]}" --set cube.max_px=16,32 --set seed=1,2 --truth=B
python3 -c 'import json
assert json.load(open("s-1/report.json"))["shard"]["cases"] == [f"combination {i}" for i in range(4)]'
verdict $? 'a shard names all combinations'
series 2 "a sequence" "${small[@]}" --set cube.max_px=16 --frames 3..7:2 --truth=B
python3 -c 'import json
assert json.load(open("s-2/report.json"))["shard"]["cases"] == [f"frame {i}" for i in range(3)]'
verdict $? 'or all frames'
series 3 "combinations of frames, and a shard without any" "${small[@]}" --set cube.max_px=16 --frames 0..2 \
	--set points.split=on,off
found=$(for i in 1 2; do run "${small[@]}" --method epr --set cube.max_px=16 --set seed=1,2,3,4,5 --shard $i/2 -o part \
	--force; tail -n +2 stdout; done | cut -d , -f 1 | sort)
[ "$(xargs <<< "$found")" = '1 2 3 4 5' ]
verdict $? 'each combination is in exactly one'
refuses '--shard: of pictures of several frames' "${small[@]}" --shard 1/2
refuses '--shard: of pictures of several frames' "${small[@]}" --set seed=1,2 --no-images --shard 1/2
refuses '--tap: of what judges' merge s-1 s-2 s-3 --tap
finish
