#!/bin/bash
# The kernels as GLSL, plain as porters get them, compile; the SPIR-V of the backend is valid, keeps the numeric
# contract, and has no instruction but those of tests/kernels/spirv.txt. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=${BUILD:-build/release}
n=0

result() { # GOOD NAME
	n=$((n + 1))
	if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; fi
}

command -v glslangValidator spirv-val spirv-dis > /dev/null || {
	echo "1..0 # skip no glslang-tools, or no spirv-tools"
	exit
}

scripts/glsl "$folder/glsl"
result $? 'the kernels are written as GLSL'
bad=0
for shader in "$folder"/glsl/*.comp; do
	glslangValidator -V --target-env vulkan1.2 -o "$folder/plain.spv" "$shader" > "$folder/log" ||
		{ bad=1; sed 's/^/# /' "$folder/log"; }
done
result $bad "$(find "$folder/glsl" -name '*.comp' | wc -l) kernels compile"

bad=0
for module in "$build"/gen/spirv/*.spv; do
	spirv-val --target-env vulkan1.2 --scalar-block-layout "$module" > "$folder/log" 2>&1 ||
		{ bad=1; sed 's/^/# /' "$folder/log"; }
done
result $bad 'modules are valid'

# Names of instructions, and of what is called, declared or asked for beside them.
for module in "$build"/gen/spirv/*.spv; do spirv-dis --no-indent "$module"; done > "$folder/text"
sed -E 's/^%[^=]*= //' "$folder/text" | awk '
	/^Op(Capability|Extension|ExtInstImport|MemoryModel)/ { print; next }
	/^OpExtInst / { print $1, $4; next }
	/^OpExecutionMode/ { print $1, $3, $4 == 32 ? 32 : ""; next }
	/^OpDecorate / { print $1, $3; next }
	/^Op/ { print $1 }' | sed -E 's/ +$//' | sort -u > "$folder/found"
comm -23 "$folder/found" <(sort tests/kernels/spirv.txt) > "$folder/unknown"
sed 's/^/# not allowed: /' "$folder/unknown"
[ ! -s "$folder/unknown" ]
result $? "only the instructions of spirv.txt"
comm -13 "$folder/found" <(sort tests/kernels/spirv.txt) > "$folder/unused"
sed 's/^/# not needed: /' "$folder/unused"
[ ! -s "$folder/unused" ]
result $? "and each of them"

# Each result of a float operation is decorated.
python3 - "$folder/text" <<'PY'
import re, sys
bad, decorated = 0, set()
for line in open(sys.argv[1]):
	if line.startswith("; SPIR-V"):
		decorated = set()
	match = re.match(r"OpDecorate (%\S+) NoContraction", line)
	if match:
		decorated.add(match[1])
	match = re.match(r"(%\S+) = Op(F(?:Add|Sub|Mul|Div|Negate|Rem|Mod)|Dot|VectorTimes\w+|Matrix\w*) ", line)
	bad += bool(match) and match[1] not in decorated
sys.exit(bad != 0)
PY
result $? 'no operation on floats may be contracted'

# What is built again after an edit: the modules that read what changed.
cp -r "$build/gen/glsl" "$folder/edited" && cp -r "$build/gen/spirv" "$folder/spirv"
again() { # the names of those that were made again
	scripts/vulkan-program "$folder/edited" "$folder/spirv" > "$folder/spirv.inc"
	for module in "$folder"/spirv/*.of; do
		cmp -s "$module" "$build/gen/spirv/${module##*/}" || basename "$module" .of
	done | paste -sd' '
}
[ -z "$(again)" ] && cmp -s "$folder/spirv.inc" "$build/gen/spirv.inc"
result $? 'nothing is made again without an edit'
echo '// edited' >> "$folder/edited/points/splat.glsl"
made=" $(again) "
[[ $made = *" splat "*" splat_pieces "* && $made != *" pose "* ]] && cmp -s "$folder/spirv.inc" "$build/gen/spirv.inc"
result $? 'an edited header is read by those that include it'
cp "$build/gen/glsl/points/splat.glsl" "$folder/edited/points"
sed -i 's/if (i < launch.n)/if (i <= launch.n)/' "$folder/edited/splat.comp"
[ "$(again)" = splat ] && ! cmp -s "$folder/spirv/splat.spv" "$build/gen/spirv/splat.spv"
result $? 'a kernel is, and what was edited back'

# The pass: what it does, once; and what it refuses.
printf 'no module, but sixteen' > "$folder/bad.spv"
scripts/spirv-exact "$folder/bad.spv" 2> "$folder/log"
[ $? -eq 2 ] && grep -q 'bad.spv: this is no SPIR-V' "$folder/log"
result $? 'what is no module is refused'
cp "$build/gen/spirv/align.spv" "$folder/once.spv"
scripts/spirv-exact "$folder/once.spv" && cmp -s "$folder/once.spv" "$build/gen/spirv/align.spv"
result $? 'a module that is exact stays as it is'
head -c 100 "$build/gen/spirv/align.spv" > "$folder/cut.spv"
scripts/spirv-exact "$folder/cut.spv" 2> "$folder/log"
[ $? -eq 2 ] && [ "$(stat -c %s "$folder/cut.spv")" -eq 100 ] && [ "$(wc -l < "$folder/log")" -eq 1 ]
result $? 'a module that ends too soon is refused, and stays as it is'
scripts/spirv-exact "$folder/none.spv" 2> "$folder/log"
[ $? -eq 2 ] && [ "$(cat "$folder/log")" = "$folder/none.spv: No such file or directory" ]
result $? 'a file that is not there is one line'

# A module of another version, with what no pass mends.
cat > "$folder/dot.comp" <<'GLSL'
#version 450
layout(local_size_x = 1) in;
layout(set = 0, binding = 0) buffer all { vec4 a; float r; } b;
void main() { b.r = dot(b.a, b.a * 2.0) + fma(b.r, b.r, b.r); }
GLSL
glslangValidator -V --target-env vulkan1.1 -o "$folder/dot.spv" "$folder/dot.comp" > /dev/null &&
	scripts/spirv-exact "$folder/dot.spv" 2> "$folder/log" && spirv-val --target-env vulkan1.1 "$folder/dot.spv" &&
	grep -q 'OpDot adds in no defined order' "$folder/log" && grep -q 'function 50 of an extended set' "$folder/log" &&
	[ "$(wc -l < "$folder/log")" -eq 2 ] && [ "$(spirv-dis "$folder/dot.spv" | grep -c NoContraction)" -eq 3 ]
result $? 'a module of Vulkan 1.1 is valid then, and its dot product and fma are told'
echo "1..$n"
