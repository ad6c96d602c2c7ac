# What the scripts on Vulkan share. Sourced after tap.bash, from the root of the repository. Pipelines once built are
# kept from run to run; those with llvmpipe's limit of loops and those without it apart.
caches=${touchstone%/*}
lift=$scratch/lift.so
. tests/cli/device.bash

# make_lift: what lifts llvmpipe's limit (tests/cli/preload/llvmpipe.c).
make_lift() { ${CC:-gcc} -shared -fPIC -o "$lift" tests/cli/preload/llvmpipe.c -ldl; }

# compiling ARGUMENT...: as run, with the time that llvmpipe takes to compile.
compiling() {
	timeout 900 "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}

# lifted ARGUMENT...: as run, without that limit.
lifted() {
	MESA_SHADER_CACHE_DIR=$caches/mesa-lifted LD_PRELOAD=$lift \
		ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" \
		timeout 900 "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}

export MESA_SHADER_CACHE_DIR=$caches/mesa-limited
