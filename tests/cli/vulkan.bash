# What the scripts on Vulkan share. Sourced after tap.bash, from the root of the repository. Pipelines once built are kept from
# run to run; those with llvmpipe's limit of loops and those without it apart.
caches=${touchstone%/*}
lift=$scratch/lift.so

# need_device: ends the script where there is no device, as a skip, or as a failure if TS_REQUIRE names vulkan.
need_device() {
	run list backends
	grep -q '^vulkan ' "$scratch/stdout" && return
	if [[ ${TS_REQUIRE:-} == *vulkan* ]]; then
		verdict 1 'a Vulkan device, which TS_REQUIRE asks for'
	else
		tests=$((tests + 1))
		echo "ok $tests - a Vulkan device # SKIP none here"
	fi
	finish
}

# make_lift: what lifts llvmpipe's limit (tests/cli/preload/llvmpipe.c).
make_lift() { ${CC:-gcc} -shared -fPIC -o "$lift" tests/cli/preload/llvmpipe.c -ldl; }

# lifted ARGUMENT...: as run, without that limit.
lifted() {
	MESA_SHADER_CACHE_DIR=$caches/mesa LD_PRELOAD=$lift ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" \
		timeout 600 "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}

export MESA_SHADER_CACHE_DIR=$caches/mesa-limited
