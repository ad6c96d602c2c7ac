#!/bin/bash
# What stages, methods, sizes, scenes and truths read of the parameters in the small goldens is in
# src/study/asked/reads.def, which reads_all.sh compares whole. Prints TAP.
set -u
words() { sed -n 's/^READS("\(.*\)", "\(.*\)", "\(.*\)")$/\1 \2 \3/p' |
	awk '{ for (i = 3; i <= NF; i++) print $1, $2, $i }' | sort; }
noted=$(scripts/reads --short | words)
if [ -n "$noted" ] && ! comm -13 <(words < src/study/asked/reads.def) - <<< "$noted" | sed 's/^/# not in reads.def: /' |
	grep .; then
	echo "ok 1 - parameters that the small goldens read"
else
	echo "not ok 1 - parameters that the small goldens read: scripts/reads --write"
fi
echo "1..1"
