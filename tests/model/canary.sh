#!/bin/bash
# Builds that break the numeric contract must be seen: by the self-test, or by the compiler itself. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

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
flags="-std=c11 -D_POSIX_C_SOURCE=200809L -fopenmp -Iinclude -iquote src"

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

# build COMPILER FLAG...
build() {
	local compiler=$1
	shift
	"$compiler" $flags "$@" src/model/{selftest,error,threads,say}.c "$folder/main.c" -lm \
		-o "$folder/canary" 2>"$folder/log"
}

# caught NAME PRIMITIVE COMPILER FLAG...: the self-test must name the primitive.
caught() {
	local name=$1 primitive=$2
	shift 2
	if ! command -v "$1" >/dev/null; then
		n=$((n + 1))
		echo "ok $n - $name # SKIP no $1"
		return
	fi
	build "$@" && ! "$folder/canary" >"$folder/out" && grep -q "$primitive" "$folder/out"
	result $? "$name"
}

# refused NAME COMPILER FLAG...: must not compile.
refused() {
	local name=$1
	shift
	! build "$@" && grep -q "numeric contract" "$folder/log"
	result $? "$name"
}

exact="-ffp-contract=off -fno-math-errno -fno-trapping-math"
for compiler in gcc clang; do
	command -v "$compiler" >/dev/null || continue
	for level in -O0 -O3; do
		build "$compiler" "$level" $exact && "$folder/canary" >/dev/null
		result $? "$compiler $level with the flags of the Makefile passes"
	done
	refused "$compiler -ffast-math is refused" "$compiler" -O2 -ffast-math
	caught "$compiler -fassociative-math is caught" "addition" "$compiler" -O2 -ffp-contract=off \
		-fno-trapping-math -fno-signed-zeros -fassociative-math
done
caught "gcc -freciprocal-math is caught" "division" gcc -O2 -ffp-contract=off -fno-trapping-math -freciprocal-math
if grep -qw fma /proc/cpuinfo; then
	caught "gcc -ffp-contract=fast -mfma is caught" "multiply-add" gcc -O2 -mfma -ffp-contract=fast
	caught "gcc -march=native -ffp-contract=fast is caught" "multiply-add" gcc -O3 -march=native -ffp-contract=fast
	caught "clang -ffp-contract=fast -mfma is caught" "multiply-add" clang -O2 -mfma -ffp-contract=fast
else
	n=$((n + 1))
	echo "ok $n - contraction is caught # SKIP this processor has no FMA"
fi
echo "1..$n"
