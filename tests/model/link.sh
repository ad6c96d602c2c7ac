#!/bin/bash
# What the core objects import: of libm nothing but sqrtf and floorf, which IEEE 754 defines exactly, and
# what holds the floating-point environment of a host, which computes nothing. Not of the
# arithmetic vectors, whose rows have the faults of ports too. Prints TAP.
set -u
objects=$BUILD/obj
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

find "$objects"/src/{model,backends,methods,scene} -name '*.c.o' -not -path '*/tools/*' \
	-not -path '*/methods/*/vectors.c.o' 2>/dev/null | sort > "$folder/objects"
if [ ! -s "$folder/objects" ]; then
	echo "not ok 1 - there are objects in $objects"
	exit
fi
echo "ok 1 - there are objects in $objects"

libm=$(${CC:-gcc} -print-file-name=libm.so.6)
nm -D --defined-only "$libm" 2>/dev/null | awk '$2 ~ /[TWi]/ {sub(/@.*/, "", $3); print $3}' | sort -u > "$folder/libm"
if [ ! -s "$folder/libm" ]; then
	echo "ok 2 - nothing of libm is imported # SKIP no libm.so.6 to compare with"
	exit
fi
xargs nm -A --undefined-only < "$folder/objects" | awk '{sub(/:$/, "", $1); print $NF, $1}' | sort > "$folder/undefined"
join "$folder/undefined" "$folder/libm" | grep -vE '^(sqrtf|floorf|feholdexcept|fesetenv) ' > "$folder/found"
if [ -s "$folder/found" ]; then
	echo "not ok 2 - nothing of libm that computes is imported but sqrtf and floorf"
	sed 's/^/# /' "$folder/found"
else
	echo "ok 2 - nothing of libm that computes is imported but sqrtf and floorf"
fi
echo "1..2"
