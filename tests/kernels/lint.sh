#!/bin/bash
# The kernels keep to the numeric contract, and the lint sees what does not. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

scripts/lint-kernels | sed 's/^/# /'
result "${PIPESTATUS[0]}" "src/kernels is clean"

sees() { # REASON LINE
	printf '%s\n' "/* 0.1 and fma() may stand in a comment */" "$2" > "$folder/bad.h"
	scripts/lint-kernels "$folder/bad.h" > "$folder/out"
	[ $? -eq 1 ] && grep -q "bad.h:2: .*$1" "$folder/out"
	result $? "the lint sees: $2"
}
sees "not exact" "f32 a = 0.1f;"
sees "not a float" "f32 a = 0.5;"
sees "not a float" "f32 a = 1e3;"
sees "out of range" "f32 a = 1e39f;"
sees "contract" "f32 a = fmaf(b, c, d);"
sees "contract" "f32 a = dot(b, c);"
sees "contract" "f32 a = sqrtf(b);"
sees "subset" "double a;"
sees "subset" "float3 a;"
sees "which language" "#ifdef __OPENCL_C_VERSION__"

printf 'f32 a = ts_dot(b, c) + 0.5f + 1e3f + p.x / 16777216.0f;\n' > "$folder/good.h"
scripts/lint-kernels "$folder/good.h"
result $? "the lint lets pass what is allowed"
echo "1..$n"
