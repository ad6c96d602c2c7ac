#!/bin/bash
# Embree and OpenCL are opened when they are needed: what needs neither does without them,
# and what does says what it lacks.
. "$(dirname "$0")/../cli/tap.bash"
small=(render reflections atrium:triangles=10000:texels=32 --size 48x27 --method epr --reflectors 1)

# without LIBRARY ARGUMENT...: as run, where there is no library whose name begins so.
without() {
	local library=$1
	shift
	timeout 100 env ASAN_OPTIONS="${ASAN_OPTIONS:-}:verify_asan_link_order=0" TOUCHSTONE_ABSENT="$library" \
		LD_PRELOAD="$scratch/absent.so" "$touchstone" "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	status=$?
}
# lacks STATUS PATTERN NAME: it ended so, with one line, and left nothing.
lacks() {
	[ "$status" -eq "$1" ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] && grep -q "$2" "$scratch/stderr" &&
		[ -z "$(ls -d "$scratch"/out* 2> /dev/null)" ]
	verdict $? "$3"
	rm -rf "$scratch"/out*
}

! readelf -d "$touchstone" | grep NEEDED | grep -qiE 'embree|tbb|opencl|vulkan|cuda|openimageio'
verdict $? 'the command links to none of what it opens'
${CC:-gcc} -shared -fPIC -o "$scratch/absent.so" tests/cli/preload/absent.c -ldl || finish

without libembree "${small[@]}" --no-images --trace -o "$scratch/trace"
[ "$status" -eq 0 ] && [ -e "$scratch/trace/trace-epr/trace.json" ]
verdict $? 'no Embree: a trace'
without libembree "${small[@]}" --truth=B -o "$scratch/out"
lacks 2 '^touchstone: .*rays need Embree, in Debian the package libembree[34]-[34]: libabsent.so: cannot open' \
	'no Embree: no truth'
without libembree render surfels checkerboard:surfels=10000 --size 48x27 --method deferred --truth=discs \
	-o "$scratch/out"
lacks 2 'rays need Embree' 'no Embree: no truth of surfels'
without libOpenCL digest "${small[@]:2}" --backend opencl
lacks 77 'no OpenCL device; install' 'no OpenCL: skipped'
without libOpenCL "${small[@]}" --backend opencl --require -o "$scratch/out"
lacks 2 'no OpenCL device; install' 'no OpenCL: an error with --require'
without libOpenCL list backends
[ "$status" -eq 0 ] && grep -q '^c ' "$scratch/stdout" && ! grep -q '^opencl' "$scratch/stdout"
verdict $? 'no OpenCL: none is listed'
finish
