#!/bin/bash
# A program of the library whose N-th allocation fails, for some N: it goes on to the same lines, or ends by one line
# that speaks of memory. Prints TAP.
. "$(dirname "$0")/../cli/tap.bash"
build=${BUILD:-build/release}
case $build in
*asan | *ubsan | *tsan)
	echo "1..0 # SKIP a sanitizer has a malloc of its own"
	exit ;;
esac
${CC:-gcc} -std=gnu11 -O1 -iquote . -shared -fPIC tests/faults/*.c -o "$scratch/fault.so" -ldl 2> "$scratch/stderr" &&
	LD_PRELOAD=$scratch/fault.so TOUCHSTONE_FAULT=memory:0 true ||
	{ echo "1..0 # SKIP calls cannot be failed here" && exit; }
mkdir "$scratch/lib"
soname=$(readelf -d "$build/libtouchstone.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')
ln -s "$PWD/$build/libtouchstone.so" "$scratch/lib/$soname"
ln -s "$PWD/$build/libtouchstone-image.so" "$scratch/lib"
${CC:-gcc} -std=c11 -Iinclude tests/api/example/example.c -L"$scratch/lib" -l":$soname" -Wl,-rpath,"$scratch/lib" \
	-o "$scratch/example" &&
	OMP_NUM_THREADS=1 "$scratch/example" > "$scratch/right"
verdict $? 'the example'

good=0 failed=0
for ((n = 1; n < 600; n += 23)); do
	timeout 60 env OMP_NUM_THREADS=1 LD_PRELOAD="$scratch/fault.so" TOUCHSTONE_FAULT=memory:$n "$scratch/example" \
		> "$scratch/stdout" 2> "$scratch/stderr"
	case $? in
	0) cmp -s "$scratch/stdout" "$scratch/right" || good=1 ;;
	2) [ "$(wc -l < "$scratch/stderr")" = 1 ] && grep -q memory "$scratch/stderr" && failed=$((failed + 1)) || good=1 ;;
	*) good=1 ;;
	esac
	[ $good = 0 ] || { echo "# memory:$n: $(head -1 "$scratch/stderr")" && break; }
done
[ $failed -gt 4 ]
verdict $((good + $?)) "without memory: the same lines, or one of memory ($failed times)"
finish
