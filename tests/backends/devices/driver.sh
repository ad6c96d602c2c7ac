#!/bin/bash
# A driver that is absent is skipped; one that crashes, ends the process that asks, or has no memory is an error that
# says so, and leaves the list of backends whole. The drivers are of OpenCL, made here.
. "$(dirname "$0")/../../cli/tap.bash"
export OCL_ICD_VENDORS

# vendor NAME TEXT: a driver that does so when it is loaded; without TEXT it is not there.
vendor() {
	OCL_ICD_VENDORS=$scratch/$1
	mkdir -p "$OCL_ICD_VENDORS" && echo "$OCL_ICD_VENDORS/driver.so" > "$OCL_ICD_VENDORS/made.icd"
	[ $# -eq 1 ] || printf '#include <stdlib.h>\n__attribute__((constructor)) static void begin(void) { %s; }\n' "$2" |
		${CC:-gcc} -shared -fPIC -x c - -o "$OCL_ICD_VENDORS/driver.so"
}

# checks STATUS PATTERN NAME: what a golden on the device comes to.
checks() {
	run golden check small-epr --backend opencl
	[ "$status" -eq "$1" ] && grep -q -- "$2" "$scratch/stdout" "$scratch/stderr"
	verdict $? "$3"
}

# listed NAME: other backends, with a line about this one.
listed() {
	run list backends
	[ "$status" -eq 0 ] && grep -q '^c ' "$scratch/stdout" && [ "$(wc -l < "$scratch/stderr")" -eq 1 ]
	verdict $? "$1"
}

vendor absent
checks 77 'no OpenCL device; install' 'a driver that is not there: skipped'
vendor aborts 'abort()'
checks 2 'a driver crashed when it was asked for devices: signal 6' 'a driver that aborts: an error'
listed 'a driver that aborts: the others are listed'
for code in 0 1; do
	vendor "exits-$code" "exit($code)"
	checks 2 "ended the process that asked for devices, with exit code $code" "a driver that exits with $code: an error"
	listed "a driver that exits with $code: the others are listed"
done

unset OCL_ICD_VENDORS
if [ -e /etc/OpenCL/vendors/pocl.icd ]; then
	export POCL_CACHE_DIR=/proc/none
	checks 2 'POCL_CACHE_DIR' 'a driver that cannot write its cache: an error'
	unset POCL_CACHE_DIR
else
	echo "ok $((tests += 1)) - a driver that cannot write its cache: an error # SKIP no PoCL"
fi

case ${BUILD:-} in
*asan | *tsan) echo "ok $((tests += 1)) - no memory for a driver # SKIP a sanitizer takes more" && finish ;;
esac
for memory in 64 200; do
	run golden check small-epr --backend opencl --memory $memory
	[ "$status" -eq 2 ] && grep -q 'too little memory for a driver' "$scratch/stderr"
	verdict $? "$memory MiB: no memory for a driver"
done
finish
