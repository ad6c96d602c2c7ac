#!/bin/bash
# What each stage reads and writes is what sets.txt says: none comes to depend on a buffer unnoticed. Prints TAP.
set -u
if scripts/house/sets | diff "$(dirname "$0")/sets.txt" - | sed 's/^/# /' | grep .; then
	echo "not ok 1 - reads and writes of the stages (<: sets.txt, >: the program)"
else
	echo "ok 1 - reads and writes of the stages"
fi
echo "1..1"
