# What the scripts on OpenCL share. Sourced after tap.bash, from the root of the repository. Built kernels are kept from
# run to run: those of a frame take PoCL 10 s.
export POCL_CACHE_DIR=${touchstone%/*}/pocl
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
altering=$(realpath tests/cli/preload/opencl.c)
. tests/cli/device.bash

# need_altering: the library of preload/opencl.c.
need_altering() {
	${CC:-gcc} -shared -fPIC -o "$scratch/altering.so" "$altering" -ldl 2> "$scratch/stderr" && return
	tests=$((tests + 1))
	echo "ok $tests - the library that alters OpenCL # SKIP ${CC:-gcc} makes none: $(head -1 "$scratch/stderr")"
	finish
}

# altered "VARIABLE=VALUE ..." ARGUMENT...: as run, with OpenCL altered so.
altered() {
	local how=$1
	shift
	# shellcheck disable=SC2086
	timeout 300 env $how LD_PRELOAD="$scratch/altering.so" "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}
