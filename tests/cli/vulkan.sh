#!/bin/bash
# The Vulkan backend from the command line: the same bits as C's, what it refuses, how it ends where there is no device, and what
# becomes of kernels that were not made exact.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/vulkan.bash"
small=(dining:triangles=10000:texels=32 --size 48x32 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16)
vk=(--backend vulkan)

# without_device ARGUMENT...
without_device() { VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent run "$@"; }

# ends STATUS PATTERN NAME: the command that ran ended so, with one line on stderr that matches.
ends() {
	[ "$status" -eq "$1" ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -q -- "$2" "$scratch/stderr" &&
		[ ! -s "$scratch/stdout" ]
	verdict $? "$3"
}

without_device digest "${vk[@]}"
ends 77 'no Vulkan device; install' 'no device: skipped'
without_device digest "${vk[@]}" --require
ends 2 'no Vulkan device; install' 'no device: an error with --require'
without_device render reflections "${vk[@]}" -o "$scratch/none"
[ "$status" -eq 77 ] && [ ! -e "$scratch/none" ] && [ ! -e "$scratch/none.partial" ]
verdict $? 'no device: nothing rendered, and nothing written'
without_device list backends
[ "$status" -eq 0 ] && ! grep -q '^vulkan' "$scratch/stdout"
verdict $? 'no device: none is listed'

need_device
make_lift
refuses '--device 7: there are [0-9]* devices, from 0' digest "${vk[@]}" --device 7
refuses '--work-group 7: .* runs at most [0-9]* items at once, and [0-9]* together' digest "${vk[@]}" --work-group 7

# digests METHOD OPTION...: of C and of Vulkan.
digests() {
	run digest "${small[@]}" --method "$@"
	cp "$scratch/stdout" "$scratch/expected"
	lifted digest "${small[@]}" --method "$@" "${vk[@]}"
	[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout" && cmp -s "$scratch/stdout" "$scratch/expected"
	verdict $? "the digests of C: $*"
}
digests epr,mvr
digests mvr --reflectors 0

# Traces.
lifted "${frame[@]}" --method epr --trace -o "$scratch/vk" "${vk[@]}"
run "${frame[@]}" --method epr --trace -o "$scratch/c"
run compare "$scratch/c/trace-epr" "$scratch/vk/trace-epr"
[ "$status" -eq 0 ] && grep -q ' 0 different' "$scratch/stdout"
verdict $? 'the trace of C'
lifted "${frame[@]}" --method epr --trace -o "$scratch/arrival" "${vk[@]}" --order arrival
run compare "$scratch/c/trace-epr" "$scratch/arrival/trace-epr"
[ "$status" -eq 0 ] && grep -q ' 0 different' "$scratch/stdout"
verdict $? 'in order of arrival too'
run list backends --json
python3 - "$scratch" <<'PY'
import json, sys
trace = json.load(open(sys.argv[1] + "/vk/trace-epr/trace.json"))
device = next(d for d in json.load(open(sys.argv[1] + "/stdout"))["backends"] if d["name"] == "vulkan")
producer, arithmetic = trace["producer"], trace["arithmetic"]
assert producer["backend"] == "vulkan" and producer["device"].startswith(device["device"] + ", ")
assert producer["compiler"] and producer["flags"] == "group=64"
assert arithmetic["rounding"] == "nearest even" and arithmetic["contraction"] is False and arithmetic["selftest"] == 0
PY
verdict $? 'its producer and arithmetic are the device'"'"'s'

# llvmpipe's limit: a loop that it ends is told, not hidden.
if grep -q llvmpipe "$scratch/stdout"; then
	run digest atrium --size 480x270 --method mvr --reflectors 0 "${vk[@]}"
	ends 2 'stage eye: backend vulkan: .* ended a loop of eye early; llvmpipe' 'a loop that the driver ends is an error'
fi

# Kernels of a folder: without the pass they are fused and regrouped, and the vectors see it.
compiled() { # GLSL SPIRV KERNEL...
	local glsl=$1 spirv=$2
	shift 2
	mkdir -p "$spirv"
	for kernel; do
		glslangValidator -V -g0 --target-env vulkan1.2 -o "$spirv/$kernel.spv" "$glsl/$kernel.comp" > /dev/null
	done
}
mkdir "$scratch/spirv"
refuses 'spirv/vectors.spv: No such file' digest "${vk[@]}" --build "$scratch/spirv"
compiled "$caches/gen/glsl" "$scratch/spirv" vectors points_vectors hulls_vectors
refuses 'breaks the numeric contract.*rint (3[0-9]* of 4096' digest "${vk[@]}" --build "$scratch/spirv"
scripts/spirv-exact "$scratch"/spirv/*.spv
refuses 'stage pose: --build: .*pose.spv: No such file' digest "${vk[@]}" --build "$scratch/spirv"
head -c 30 "$scratch/spirv/vectors.spv" > "$scratch/short"
cp "$scratch/short" "$scratch/spirv/vectors.spv"
refuses 'vectors.spv: not a SPIR-V module' digest "${vk[@]}" --build "$scratch/spirv"

# A device whose quotients and roots are some ulp off, as Vulkan lets them be: they are made of integers.
cp -r "$caches/gen/glsl" "$scratch/ulps"
sed -i 's|return a / b;|return a * (1.0 / b);|; s|return sqrt(x);|return 1.0 / inversesqrt(x);|' "$scratch/ulps/base/compat.glsl"
grep -q inversesqrt "$scratch/ulps/base/compat.glsl"
verdict $? 'quotients and roots with errors are planted'
compiled "$scratch/ulps" "$scratch/off" vectors points_vectors hulls_vectors
scripts/spirv-exact "$scratch"/off/*.spv 2> /dev/null
refuses 'stage pose: --build: .*pose.spv: No such file' digest "${vk[@]}" --build "$scratch/off" # after all vectors

finish
