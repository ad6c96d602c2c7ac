#!/bin/bash
# The kernels as PTX, in one file as porters get them and as the modules of the backend: every one is there, calls
# nothing from outside, and computes floats by the instructions of tests/kernels/ptx.txt alone, which round to nearest
# and which no driver may fuse; and what is built again after an edit. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=${BUILD:-build/release}
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

command -v clang > /dev/null || {
	echo '1..0 # skip no clang'
	exit
}

# inexact FILE...: the instructions that make floats and are not allowed.
inexact() {
	sed -nE 's/^\s+(@!?%p[0-9]+\s+)?([a-z][a-z0-9_]*\.[a-z0-9_.]*)\s.*/\2/p' "$@" | sort -u |
		grep -E '\.f(16|32|64)|approx|ftz' | grep -vE '^(ld|st|mov|setp|selp)(\.[a-z]\w*)*\.(f32|b32)$' |
		grep -vxFf tests/kernels/ptx.txt
}

scripts/ptx "$folder/kernels.ptx"
result $? 'the kernels are written as PTX'
scripts/assembled src/backends/kernels.def | sed -nE 's/^KERNEL\((\w+),.*/\1/p' | sort > "$folder/kernels"
sed -nE 's/^\.visible \.entry (\w+)\(.*/\1/p' "$folder/kernels.ptx" | sort | cmp -s - "$folder/kernels"
result $? "$(wc -l < "$folder/kernels") kernels are its entry points"
modules=("$build"/gen/ptx/*.ptx)
printf '%s\n' "${modules[@]}" | sed -E 's,.*/(.*)\.ptx,\1,' | sort | cmp -s - "$folder/kernels" &&
	[ "$(grep -hE '^\.visible \.entry' "${modules[@]}" | wc -l)" -eq "${#modules[@]}" ]
result $? 'and each is a module'
! grep -q '^\.extern' "$folder/kernels.ptx" "${modules[@]}"
result $? 'nothing is called from outside'
inexact "$folder/kernels.ptx" "${modules[@]}" | sed 's/^/# not allowed: /' > "$folder/found"
cat "$folder/found"
[ ! -s "$folder/found" ]
result $? 'floats are made by the instructions of ptx.txt'

# planted OPTION INSTRUCTION
planted() {
	scripts/ptx "$folder/planted.ptx" -DOF=vectors "$1" && inexact "$folder/planted.ptx" | grep -qx "$2"
	result $? "$1 shows as $2"
}

planted -ffp-contract=fast fma.rn.f32
planted -fcuda-flush-denormals-to-zero mul.rn.ftz.f32
planted -ffast-math div.approx.f32

# What is built again after an edit, in a copy of the tree: the folders that read what changed.
tree=$folder/tree
mkdir -p "$tree/$build" && cp -a Makefile scripts src include "$tree" && cp -a "$build/gen" "$tree/$build"
again() { # the folders that are, or with -n would be, made again
	env -u MAKEFLAGS -u MAKELEVEL make -C "$tree" JOBS=2 V=0 BUILD="$build" "$build/gen/ptx.inc" "$@" 2> "$folder/log" |
		sed -nE 's/.*GEN\t.*kernels\.(\w+)\.ptx"?$/\1/p' | sort | paste -sd' '
}
differ() { # the modules that are others than before
	local module
	for module in "${modules[@]}"; do
		cmp -s "$module" "$tree/$module" || basename "$module" .ptx
	done | paste -sd' '
}
[ -z "$(again)" ] && cmp -s "$tree/$build/gen/ptx.inc" "$build/gen/ptx.inc"
result $? 'nothing is made again without an edit'
echo '/* edited */' >> "$tree/src/kernels/base/vec.h"
[ "$(again -n)" = "$(printf '%s\n' "$build"/gen/kernels.*.ptx | sed -E 's/.*kernels\.(.*)\.ptx/\1/' | sort |
	paste -sd' ')" ]
result $? 'an edited header of base is read by all folders'
cp -p src/kernels/base/vec.h "$tree/src/kernels/base"
sed -i 's/ts_k_cover_of(view, &t, TS_SAFE_HALF)/ts_k_cover_of(view, \&t, 130)/' "$tree/src/kernels/points/splat_box.h"
[ "$(again)" = points ] && made=" $(differ) " && [[ $made = *" splat "*" splat_pieces "* && $made != *" align "* ]]
result $? 'one of points by points, and the modules of its kernels are others'
cp src/kernels/points/splat_box.h "$tree/src/kernels/points"
[ "$(again)" = points ] && cmp -s "$tree/$build/gen/ptx.inc" "$build/gen/ptx.inc"
result $? 'and what was edited back'

# A build without clang.
mkdir "$folder/bin"
ln -s /usr/bin/* "$folder/bin"
rm -f "$folder"/bin/clang*
[ -z "$(PATH=$folder/bin again)" ] &&
	[ "$(grep -c '^cuda-program: this build has no kernels for CUDA: ' "$folder/log")" -eq 1 ] &&
	grep -q '^static const u32 first_byte.* = {0\(, 0\)*};$' "$tree/$build/gen/ptx.inc"
result $? 'without clang there are no kernels, and one line says so'
echo "1..$n"
