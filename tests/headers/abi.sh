#!/bin/bash
# What programs rely on is what tests/headers/abi.txt says: functions, places of members, constants; clang says the
# same. A change before 1.0 raises the second number of the version, unless only ends of structs grow. Prints TAP.
set -u
n=0
for compiler in "${CC:-gcc}" clang; do
	n=$((n + 1))
	if ! command -v "${compiler%% *}" > /dev/null; then
		echo "ok $n - $compiler # SKIP there is no $compiler"
	elif said=$(CC=$compiler scripts/abi --check 2>&1); then
		echo "ok $n - programs that were built with these headers go on, by $compiler"
	else
		echo "not ok $n - by $compiler the headers say otherwise than tests/headers/abi.txt (scripts/abi --write)"
		sed 's/^/# /' <<< "$said"
	fi
done
echo "1..$n"
