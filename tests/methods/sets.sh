#!/bin/bash
# What each stage of a family reads and writes is what its sets.txt says: none comes to depend on a buffer unnoticed. Prints TAP.
set -u
n=0
for folder in $(sed -n 's/^#include FAMILY(\(.*\))/\1/p' src/families.def); do
	n=$((n + 1))
	if scripts/house/sets "$folder" | diff "$(dirname "$0")/$folder/sets.txt" - 2>&1 | sed 's/^/# /' | grep .; then
		echo "not ok $n - reads and writes of the stages of $folder (<: sets.txt, >: the program)"
	else
		echo "ok $n - reads and writes of the stages of $folder"
	fi
done
echo "1..$n"
