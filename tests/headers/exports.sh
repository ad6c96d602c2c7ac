#!/bin/bash
# The shared library exports the functions that the public headers declare, and nothing else. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo '#include <touchstone/touchstone.h>' > "$folder/all.c"
gcc -std=c11 -Iinclude -fsyntax-only -aux-info "$folder/prototypes" "$folder/all.c" &&
	sed -nE 's|^/\* include/touchstone/.* \**(ts_[a-z0-9_]+) \(.*|\1|p' "$folder/prototypes" |
	sort -u > "$folder/declared"
nm -D --defined-only "${BUILD:-build/release}/libtouchstone.so" | awk '{print $NF}' | sort -u > "$folder/exported"

if [ -s "$folder/declared" ] && diff "$folder/declared" "$folder/exported" > "$folder/difference"; then
	echo "ok 1 - libtouchstone.so exports what the headers declare"
else
	echo "not ok 1 - libtouchstone.so exports what the headers declare (<: only declared, >: only exported)"
	sed 's/^/# /' "$folder/difference"
fi
echo "1..1"
