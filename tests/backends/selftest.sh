#!/bin/bash
# Every object of the C backend has a self-test of its own, and one that is built by other flags, or changes them, is
# named. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=${BUILD:-build/release}
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

skip() { # NAME WHY
	n=$((n + 1))
	echo "ok $n - $1 # SKIP $2"
}

find "$build/obj/src/backends/c" -name '*.o' | sort > "$folder/objects"
while read -r object; do
	objdump -h "$object" | grep -q ' ts_selftests ' || echo "# $object has none"
done < "$folder/objects" > "$folder/without"
cat "$folder/without"
[ -s "$folder/objects" ] && [ ! -s "$folder/without" ]
result $? "each of $(wc -l < "$folder/objects") objects has a self-test"

cat > "$folder/main.c" <<'C'
#include <stdio.h>
#include "model/core.h"
int main(void)
{
	ts_status status = ts_selftest_require();
	printf("%s\n", ts_error_message());
	return (int)status;
}
C

# named FILE PRIMITIVE SOURCE COMPILER FLAG...: the self-test must name both; "passes": it must find nothing.
named() {
	local file=$1 primitive=$2 source=$3
	shift 3
	if ! command -v "$1" > /dev/null; then
		skip "$* $source" "no $1"
		return
	fi
	"$@" -std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -Iinclude -iquote src -c "$source" \
		-o "$folder/other.o" &&
		${CC:-gcc} -fopenmp -Iinclude -iquote src "$folder/main.c" "$folder/other.o" "$build/libtouchstone.a" \
		-lcrypto -lm \
			-o "$folder/other" 2> "$folder/log"
	if [ $? -ne 0 ]; then
		sed 's/^/# /' "$folder/log"
		result 1 "$* $source builds"
		return
	fi
	"$folder/other" > "$folder/out"
	local status=$?
	if [ "$primitive" = passes ]; then
		[ $status -eq 0 ]
	else
		[ $status -eq 2 ] && [ "$(wc -l < "$folder/out")" -eq 1 ] &&
			grep -q "^self-test: $file breaks the numeric contract in .*$primitive" "$folder/out"
	fi
	result $? "$* ${source##*/}: ${primitive}"
	sed 's/^/# /' "$folder/out"
}

if grep -qE -- '-fsanitize|--coverage' "$build/flags"; then
	skip "objects by other flags" "the others are instrumented"
	echo "1..$n"
	exit
fi

one=src/backends/c/points/splat_extent.c
exact="-ffp-contract=off -fno-math-errno -fno-trapping-math"
sly="-U__FAST_MATH__ -U__FINITE_MATH_ONLY__ -D__FINITE_MATH_ONLY__=0"
named $one passes $one gcc -O2 $exact
for compiler in gcc clang; do
	named $one "addition (re-associated)" $one $compiler -O2 -ffast-math $sly
	named $one "signed zero" $one $compiler -O2 $exact -fno-signed-zeros
	named $one "not-a-number" $one $compiler -O2 $exact -ffinite-math-only $sly
done
named $one "division" $one gcc -O2 $exact -freciprocal-math
named "src/backends/c/items.c of kernels/points/align.h" "addition" src/backends/c/items.c gcc -O1 \
	-ffast-math $sly \
	-I"${BUILD:-build/release}/gen" '-DITEMS="kernels/points/align.h"' '-DITEMS_DEF="items/points/align.def"'

# begin, end TEXT...: that source with it before all else, and before its end.
begin() { printf '%s\n' "$@" | cat - $one > "$folder/pragma.c"; }
end() { head -n -1 $one | cat - <(printf '%s\n' "$@" '#include "backends/selftest.h"') > "$folder/pragma.c"; }
end '#pragma GCC optimize("fast-math")'
named "$folder/pragma.c" "re-associated" "$folder/pragma.c" gcc -O2 $exact
if grep -qw fma /proc/cpuinfo; then
	named $one "multiply-add" $one gcc -O2 -mfma -ffp-contract=fast
	named $one "multiply-add" $one clang -O2 -mfma -ffp-contract=fast
	begin '#pragma STDC FP_CONTRACT ON'
	named "$folder/pragma.c" "multiply-add" "$folder/pragma.c" clang -O2 -mfma $exact
	end '#pragma STDC FP_CONTRACT ON'
	named "$folder/pragma.c" "multiply-add" "$folder/pragma.c" clang -O2 -mfma $exact
else
	skip "contraction is named" "this processor has no FMA"
fi
if grep -qw avx512f /proc/cpuinfo; then
	named $one "multiply-add" $one gcc -O2 -ffp-contract=fast
else
	skip "contraction of loops for vectors alone is named" "this processor has no AVX-512"
fi
echo "1..$n"
