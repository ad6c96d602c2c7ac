#!/bin/bash
# The kernels as PTX: every one is there, calls nothing from outside, and computes floats by the instructions of
# tests/kernels/ptx.txt alone, which round to nearest and which no driver may fuse. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

command -v clang > /dev/null || {
	echo '1..0 # skip no clang'
	exit
}

# inexact FILE: the instructions that make floats and are not allowed.
inexact() {
	sed -nE 's/^\s+(@!?%p[0-9]+\s+)?([a-z][a-z0-9_]*\.[a-z0-9_.]*)\s.*/\2/p' "$1" | sort -u |
		grep -E '\.f(16|32|64)|approx|ftz' | grep -vE '^(ld|st|mov|setp|selp)(\.[a-z]\w*)*\.(f32|b32)$' |
		grep -vxFf tests/kernels/ptx.txt
}

scripts/ptx "$folder/kernels.ptx"
result $? 'the kernels are written as PTX'
scripts/assembled src/backends/kernels.def | sed -nE 's/^KERNEL\((\w+),.*/\1/p' | sort > "$folder/kernels"
sed -nE 's/^\.visible \.entry (\w+)\(.*/\1/p' "$folder/kernels.ptx" | sort | cmp -s - "$folder/kernels"
result $? "$(wc -l < "$folder/kernels") kernels are its entry points"
! grep -q '^\.extern' "$folder/kernels.ptx"
result $? 'nothing is called from outside'
inexact "$folder/kernels.ptx" | sed 's/^/# not allowed: /' > "$folder/found"
cat "$folder/found"
[ ! -s "$folder/found" ]
result $? 'floats are made by the instructions of ptx.txt'

# planted OPTION INSTRUCTION
planted() {
	scripts/ptx "$folder/planted.ptx" "$1" && inexact "$folder/planted.ptx" | grep -qx "$2"
	result $? "$1 shows as $2"
}

# A build without clang: PATH has no more than the script needs, and no clang.
mkdir "$folder/bin"
ln -s "$(command -v bash)" "$folder/bin"
PATH=$folder/bin scripts/ptx "$folder/none.ptx" 2> "$folder/log" && [ -e "$folder/none.ptx" ] && [ ! -s "$folder/none.ptx" ] &&
	[ "$(wc -l < "$folder/log")" -eq 1 ] && grep -q '^ptx: no clang: ' "$folder/log" &&
	scripts/cuda-program "$folder/none.ptx" "$folder/none" > "$folder/none.inc" && [ ! -e "$folder/none" ] &&
	grep -q '^static const u32 first_byte.* = {0\(, 0\)*};$' "$folder/none.inc"
result $? 'without clang there are no kernels, and one line says so'

planted -ffp-contract=fast fma.rn.f32
planted -fcuda-flush-denormals-to-zero mul.rn.ftz.f32
planted -ffast-math div.approx.f32
echo "1..$n"
