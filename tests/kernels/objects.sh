#!/bin/bash
# The machine code of this build has no instruction on floats and no import but those of tests/kernels/objects, and what
# breaks the numeric contract is seen there. `make matrix` asks it of every build. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=${BUILD:-build/release}
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

if grep -qE -- '-fsanitize|--coverage' "$build/flags"; then
	n=$((n + 1))
	echo "ok $n - $build keeps to the lists # SKIP its code is instrumented"
else
	scripts/disassembled "$build" > "$folder/out"
	result $? "$build keeps to the lists"
	head -n 20 "$folder/out" | sed 's/^/# /'
fi

# sees INSTRUCTION BODY COMPILER FLAG...: as a file of the C backend, whose function of three floats has that body.
sees() {
	local what=$1 body=$2
	shift 2
	command -v "$1" > /dev/null || {
		n=$((n + 1))
		echo "ok $n - $* shows as $what # SKIP no $1"
		return
	}
	mkdir -p "$folder/obj/src/backends/c"
	printf '%s\n' "${before-}" 'float planted(float a, float b, float c)' "{ $body }" > "$folder/planted.c"
	"$@" -c "$folder/planted.c" -o "$folder/obj/src/backends/c/planted.c.o" 2> "$folder/log" ||
		sed 's/^/# /' "$folder/log"
	scripts/disassembled "$folder" > "$folder/out"
	[ $? -eq 1 ] && grep -qE "^src/backends/c/planted\.c: (planted: )?$what" "$folder/out"
	result $? "$* shows as $what: ${before-}${before:+ }$body"
}

product="return a * b + c;"
for compiler in gcc clang; do
	sees vfmadd "$product" $compiler -O2 -march=haswell -ffp-contract=fast
	sees vfmadd "return __builtin_fmaf(a, b, c);" $compiler -O2 -mfma -ffp-contract=off
	sees fmaf "return __builtin_fmaf(a, b, c);" $compiler -O2 -ffp-contract=off
	sees tanhf "return __builtin_tanhf(a) + b + c;" $compiler -O2
	sees cvtss2sd "return (float)((double)a * b + c);" $compiler -O2
	sees cvtss2sd "return (float)(a * 0.1) + b + c;" $compiler -O2
	sees fsin '__asm__("fsin" : "+t"(a)); return a + b + c;' $compiler -O2
	sees flds "return (float)((long double)a * b + c);" $compiler -O2
	sees rcpss '__asm__("rcpss %0, %0" : "+x"(a)); return a + b + c;' $compiler -O2
	sees cvtss2si "return (float)__builtin_lrintf(a) + b + c;" $compiler -O2 -fno-math-errno
	sees 'roundss \$0x4' "return __builtin_rintf(a) + b + c;" $compiler -O2 -msse4.1
	sees vcvtps2ph \
		"return (float)__builtin_ia32_vcvtps2ph((float __attribute__((vector_size(16)))){a, b, c, a}, 0)[0];" \
		$compiler -O2 -mf16c
done
before='#pragma STDC FP_CONTRACT ON'
sees vfmadd "$product" clang -O2 -mfma -ffp-contract=off
before='__attribute__((optimize("fast-math")))'
sees rcpps "float __attribute__((vector_size(16))) v = {a, b, c, a}, w = {b, c, a, b}; v /= w; return v[0];" gcc -O2 \
	-ffp-contract=off
before='__attribute__((target("fma"), optimize("fp-contract=fast")))'
sees vfmadd "$product" gcc -O2 -ffp-contract=off
before=
sees rsqrtss "return 1.0f / __builtin_sqrtf(a) + b + c;" gcc -O2 -ffast-math
sees fadds "return a + b * c;" gcc -O2 -mfpmath=387
sees fmadd "$product" aarch64-linux-gnu-gcc -O2
sees fmadd.s "$product" riscv64-linux-gnu-gcc -O2
sees __addsf3 "return a + b + c;" riscv64-linux-gnu-gcc -O2 -march=rv64imac -mabi=lp64
sees 'fmadds|xsmadd' "$product" powerpc64le-linux-gnu-gcc -O2
sees 'maebr|wfmasb' "$product" s390x-linux-gnu-gcc -O2
sees vfma "$product" arm-linux-gnueabihf-gcc -O2 -mfpu=vfpv4
sees __aeabi_fadd "return a + b + c;" arm-linux-gnueabihf-gcc -O2 -mfloat-abi=soft
sees 'fadds|flds' "return a + b + c;" i686-linux-gnu-gcc -O2

# What has no code.
mkdir -p "$folder/late/obj/src/backends/c"
gcc -O2 -flto -c "$folder/planted.c" -o "$folder/late/obj/src/backends/c/planted.c.o"
scripts/disassembled "$folder/late" > "$folder/out"
[ $? -eq 1 ] && grep -q 'no instruction on floats' "$folder/out"
result $? 'objects that are compiled when linking are not passed over'
mkdir -p "$folder/none/obj/src/backends/c"
scripts/disassembled "$folder/none" > "$folder/out"
[ $? -eq 1 ] && grep -q 'no objects of a processor' "$folder/out"
result $? 'a folder without objects is no build'
echo "1..$n"
