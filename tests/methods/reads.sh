#!/bin/bash
# What stages, methods, sizes, scenes and truths read of the parameters in the small goldens is in
# src/study/asked/reads.def; with TS_WHOLE the file says what all runs read, no more and no less. Prints TAP.
set -u
file=src/study/asked/reads.def
words() { sed -n 's/^READS("\(.*\)", "\(.*\)", "\(.*\)")$/\1 \2 \3/p' |
	awk '{ for (i = 3; i <= NF; i++) print $1, $2, $i }' | sort; }
if [ -n "${TS_WHOLE:-}" ]; then
	noted=$(scripts/reads)
	other=$(diff "$file" - <<< "$noted")
else
	noted=$(scripts/reads --short | words)
	other=$(comm -13 <(words < "$file") - <<< "$noted")
fi
if [ -n "$noted" ] && [ -z "$other" ]; then
	echo "ok 1 - who reads which parameter"
else
	printf '%s\n' "$other" | sed 's/^/# not as reads.def says: /'
	echo "not ok 1 - who reads which parameter: scripts/reads --write"
fi
echo "1..1"
