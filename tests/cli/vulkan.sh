#!/bin/bash
# The Vulkan backend from the command line: the same bits as C's, what it refuses, how it ends where there is no device,
# and what becomes of kernels that were not made exact.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/vulkan.bash"
# As small as may be: llvmpipe takes some hundred times what C takes.
small=(dining:triangles=10000:texels=32 --size 48x32 --reflectors 1 --set reflectors.px=16 --set cube.max_px=16)
frame=(render reflections "$(realpath scenes/room.gltf)" --size 48x27 --reflectors 1 --set reflectors.px=16
	--set cube.max_px=32
	--no-images)
on=(--backend vulkan)

# without_device ARGUMENT...
without_device() { VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent run "$@"; }

ends_without_device vulkan 'no Vulkan device; install'

need_device vulkan
refuses 'device 7: there are [0-9]* devices, from 0' digest "${on[@]}" --device 7
refuses 'work group of 7: .* runs at most [0-9]* items at once, and [0-9]* together' digest "${on[@]}" --work-group 7

same_digests "the digests of C" compiling "${small[@]}" --method mvr

# Traces.
same_traces compiling
grep -q '"flags": "group=64"' "$scratch/canonical/trace-epr/trace.json"
verdict $? 'and how it is run'

# llvmpipe's limit, which newer versions may not have: triangles of the whole screen are drawn in bands, and a loop that
# the driver ends all the same is an error.
if grep -q llvmpipe "$scratch/backends"; then
	same_digests 'more pixels than llvmpipe has turns, and no reflectors' compiling atrium --size 320x210 --method mvr \
		--reflectors 0
	run digest atrium --size 1920x1080 --method mvr --reflectors 0 "${on[@]}"
	if [ "$status" -eq 0 ]; then
		cp "$scratch/stdout" "$scratch/expected"
		run digest atrium --size 1920x1080 --method mvr --reflectors 0
		cmp -s "$scratch/stdout" "$scratch/expected"
		verdict $? 'the digests of C, as the driver ends no loop'
	else
		ends 2 'stage eye: backend vulkan: .* ended a loop of eye early; llvmpipe' \
			'a loop that the driver ends is an error'
	fi
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
refuses 'spirv/vectors.spv: No such file' digest "${on[@]}" --build "$scratch/spirv"
compiled "$caches/gen/glsl" "$scratch/spirv" vectors points_vectors hulls_vectors
refuses 'breaks the numeric contract.*rint (3[0-9]* of 4096' digest "${on[@]}" --build "$scratch/spirv"
scripts/spirv-exact "$scratch"/spirv/*.spv
refuses 'stage pose: build: .*pose.spv: No such file' digest "${on[@]}" --build "$scratch/spirv"
head -c 30 "$scratch/spirv/vectors.spv" > "$scratch/short"
cp "$scratch/short" "$scratch/spirv/vectors.spv"
refuses 'vectors.spv: not a SPIR-V module' digest "${on[@]}" --build "$scratch/spirv"

# A device whose quotients and roots are some ulp off, as Vulkan lets them be: they are made of integers.
cp -r "$caches/gen/glsl" "$scratch/ulps"
sed -i 's|return a / b;|return a * (1.0 / b);|; s|return sqrt(x);|return 1.0 / inversesqrt(x);|' \
	"$scratch/ulps/base/compat.glsl"
grep -q inversesqrt "$scratch/ulps/base/compat.glsl"
verdict $? 'quotients and roots with errors are planted'
compiled "$scratch/ulps" "$scratch/off" vectors points_vectors hulls_vectors
scripts/spirv-exact "$scratch"/off/*.spv 2> /dev/null
refuses 'stage pose: build: .*pose.spv: No such file' digest "${on[@]}" --build "$scratch/off" # after all vectors

finish
