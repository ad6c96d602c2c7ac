# What the scripts on OpenCL share. Sourced after tap.bash, from the root of the repository. Built kernels are kept from run
# to run: those of a frame take PoCL 10 s.
export POCL_CACHE_DIR=${touchstone%/*}/pocl
export ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0"
altering=$(realpath tests/cli/preload/opencl.c)

# need_device: ends the script where there is no device, as a skip, or as a failure if TS_REQUIRE names opencl.
need_device() {
	run list backends
	grep -q '^opencl ' "$scratch/stdout" && return
	if [[ ${TS_REQUIRE:-} == *opencl* ]]; then
		verdict 1 'an OpenCL device, which TS_REQUIRE asks for'
	else
		tests=$((tests + 1))
		echo "ok $tests - an OpenCL device # SKIP none here"
	fi
	finish
}

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

# ends STATUS PATTERN NAME: the command that ran ended so, with one line on stderr that matches if it failed.
ends() {
	[ "$status" -eq "$1" ] && { [ "$1" -eq 0 ] || [ "$(wc -l < "$scratch/stderr")" -eq 1 ]; } &&
		{ [ "$1" -le 1 ] || grep -q -- "$2" "$scratch/stderr"; }
	verdict $? "$3"
}

# same REFERENCE CANDIDATE NAME OPTION...: two traces of the same bits.
same() {
	local reference=$1 candidate=$2 name=$3
	shift 3
	run compare "$reference" "$candidate" "$@"
	[ "$status" -eq 0 ] && grep -q ' 0 different' "$scratch/stdout"
	verdict $? "$name"
}
