#!/bin/bash
# scripts/fuzz-seeds: each target of tests/fuzz has whole inputs to begin with.
. "$(dirname "$0")/../cli/tap.bash"
scripts/fuzz-seeds "$scratch/seeds" > "$scratch/said" 2>&1
verdict $? 'seeds are written' || cat "$scratch/said"
for target in tests/fuzz/*.c; do
	target=$(basename "$target" .c)
	[ -n "$(find "$scratch/seeds/$target" -type f -size +0 2> "$scratch/said" | head -n 1)" ]
	verdict $? "$target"
done
finish
