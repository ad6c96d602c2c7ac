#!/bin/bash
# What the kernels' text cannot show stops the build of `make matrix` that runs them with traps: overflow of signed
# integers, shifts, divisors of 0, floats beyond integers, places beyond arrays. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

command -v clang > /dev/null || {
	echo '1..0 # skip no clang'
	exit
}
traps=$(sed -n 's/^TRAPS = "\(.*\)"$/\1/p' scripts/matrix)

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# ends HOW BODY: of a kernel function of f32 a, b, i32 k, i64 l and u32 n, which are 1, 0, the greatest,
# the greatest and 40.
ends() {
	cat > "$folder/kernel.c" << END
#include "$PWD/src/kernels/base/vec.h"
TS_FN f32 ts_bad(f32 a, f32 b, i32 k, i64 l, u32 n) { $2 }
int main(void)
{
	volatile f32 a = 1.0f, b = 0.0f;
	volatile i32 k = INT32_MAX;
	volatile i64 l = INT64_MAX;
	volatile u32 n = 40u;
	volatile f32 r = ts_bad(a, b, k, l, n);
	(void)r;
	return 0;
}
END
	# shellcheck disable=SC2086
	clang $traps -std=c11 -Iinclude -iquote src -ffp-contract=off -Wno-everything "$folder/kernel.c" \
		-o "$folder/kernel" -lm 2> "$folder/log" || sed 's/^/# /' "$folder/log"
	{ (ulimit -c 0; exec "$folder/kernel"); } 2> /dev/null
	local status=$?
	[ -x "$folder/kernel" ] && if [ "$1" = stops ]; then [ $status -gt 128 ]; else [ $status -eq 0 ]; fi
	result $? "$1: $2"
	rm -f "$folder/kernel"
}

stops_at() { ends stops "$1"; }
runs() { ends runs "$1"; }

stops_at "return (f32)(k + 1);"
stops_at "return (f32)(k * 2);"
stops_at "return (f32)(-2 - k);"
stops_at "return (f32)(-(-k - 1));"
stops_at "return (f32)(l + 1);"
stops_at "return (f32)((i64)k * l);"
stops_at "k++; return (f32)k;"
stops_at "return (f32)(-k << 1);"
stops_at "return (f32)(1u << n);"
stops_at "return (f32)(k >> n);"
stops_at "return a / b;"
stops_at "return ts_dot(ts_v3_make(a, b, a), ts_v3_make(b, a, b)) / ts_length(ts_v3_make(b, b, b));"
stops_at "return (f32)(n / ts_f2u(b));"
stops_at "return (f32)(n % ts_f2u(b));"
stops_at "return (f32)((-k - 1) / (i32)-a);"
stops_at "return (f32)(i32)(a * 4294967296.0f);"
stops_at "return (f32)(u32)-a;"
stops_at "f32 d[3] = {a, b, a}; return d[n];"
runs "return (f32)(k - 1) + (f32)(n << 3) + b / a;"
runs "return (f32)((u32)k + n * 0x80000000u) + (f32)(-k >> 3);"
runs "return (f32)ts_f2i(a * 4294967296.0f);"
echo "1..$n"
