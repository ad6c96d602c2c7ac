#!/bin/bash
# Random inputs of both stages: a replay has the bits of the numpy port, and readings of the documents that hardly any
# scene tells from the right ones are found. SEEDS: how many of each.
. "$(dirname "$0")/../cli/tap.bash"
. "$(dirname "$0")/ports.bash"
find_numpy || exit 0
seeds=${SEEDS:-8}

# replays FOLDER STAGE SEED [--break N]: $status is 1 if the port has other bits, 2 if it cannot be told.
replays() {
	"$python" tests/ports/numpy/fuzz.py "$scratch/$1/trace-epr" "$scratch/made" "${@:2}" || { status=2; return; }
	run replay "$scratch/$1/trace-epr" --stage "$2" --inputs "$scratch/made"
}

agrees() {
	local seed bad=0
	for ((seed = 1; seed <= seeds; seed++)); do
		replays "$1" "$2" "$seed"
		[ "$status" -eq 0 ] && grep -q ': same, [1-9]' "$scratch/stdout" && continue
		bad=1
		sed "s/^/# seed $seed: /" "$scratch/stdout" "$scratch/stderr"
	done
	verdict $bad "$seeds seeds, the same bits: stage $2, $1"
}

# finds N FOLDER STAGE: with damage N of the port, one of the seeds has other bits.
finds() {
	local seed
	for ((seed = 1; seed <= seeds; seed++)); do
		replays "$2" "$3" "$seed" --break "$1"
		[ "$status" -ne 0 ] && break
	done
	[ "$status" -eq 1 ] && grep -q ': different in' "$scratch/stdout"
	verdict $? "damage $1 is found: stage $3, $2, seed $seed"
}

trace default scenes/triangle_mirror.gltf --camera camera --reflectors 0 --size 64x64
trace paper scenes/triangle_mirror.gltf --camera camera --reflectors 0 --size 64x64 --set splat.clip=off \
	--set visibility.test=vertex
for folder in default paper; do
	agrees $folder splat
	agrees $folder visibility
done
finds 6 default splat
finds 7 default splat
finds 8 default visibility
finds 9 paper splat

finish
