#!/bin/bash
# The OpenCL backend from the command line: the same bits as C's, what it refuses, and how it ends where there is no device.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
small=(--size 48x32 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16)
cl=(--backend opencl)

# without_device ARGUMENT...
without_device() { OCL_ICD_VENDORS=/nonexistent run "$@"; }

without_device digest "${cl[@]}"
ends 77 'no OpenCL device; install' 'no device: skipped'
[ ! -s "$scratch/stdout" ]
verdict $? 'and nothing printed'
without_device digest "${cl[@]}" --require
ends 2 'no OpenCL device; install' 'no device: an error with --require'
without_device render reflections "${cl[@]}" -o "$scratch/none"
ends 77 'no OpenCL device; install' 'no device: nothing rendered'
[ ! -e "$scratch/none" ] && [ ! -e "$scratch/none.partial" ]
verdict $? 'and nothing written'
without_device list backends
[ "$status" -eq 0 ] && grep -q '^c ' "$scratch/stdout" && ! grep -q '^opencl' "$scratch/stdout"
verdict $? 'no device: C alone is listed'
without_device digest "${cl[@]}" --help
[ "$status" -eq 0 ] && grep -q work-group "$scratch/stdout"
verdict $? 'no device: help all the same'
refuses 'a whole number from 0 to 4096' digest "${cl[@]}" --work-group 5000
refuses 'a whole number from 0 to 31' digest "${cl[@]}" --device 32

need_device
refuses '--device 7: there are [0-9]* devices, from 0' digest "${cl[@]}" --device 7
refuses '--build: at most' digest "${cl[@]}" --build -D"$(printf '%0300d' 0)"
run digest "${cl[@]}" --build -no-such-option
[ "$status" -eq 2 ] && tail -n 1 "$scratch/stderr" | grep -q 'backend opencl: building the kernels' &&
	[ ! -s "$scratch/stdout" ]
verdict $? 'options that the compiler refuses'

# digests METHOD OPTION...: of C and of OpenCL.
digests() {
	run digest dining:triangles=10000:texels=32 "${small[@]}" --method "$@"
	cp "$scratch/stdout" "$scratch/expected"
	run digest dining:triangles=10000:texels=32 "${small[@]}" --method "$@" "${cl[@]}"
	[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout" && cmp -s "$scratch/stdout" "$scratch/expected"
	verdict $? "the digests of C: $*"
}

digests epr,mvr
digests epr,mvr --reflectors 0
digests epr,mvr --set lookup.bounces=3 --set lookup.samples=adaptive --set mvr.faces=adaptive
digests epr,mvr --set splat.plane_depth=on --set splat.clip=off --set mvr.filter=supersample --set cube.px=24
digests epr --set visibility.test=vertex --set density.path=paper --set splat.size=paper --set points.cull_unit=raster --set points.conservative=exact
digests epr --set density.scale=2 --set density.per_area=on --set density.off_axis=on --set points.split=off --set density.cap=off --set points.cull=off
for case in small-bounces small-adaptive; do
	prints '1 passed, 0 failed' golden check $case "${cl[@]}"
done

# Traces.
render() { run "${frame[@]}" --method "$1" --trace -o "$scratch/$2" "${@:3}"; }
render all c
render all cl "${cl[@]}"
for method in epr mvr; do
	same "$scratch/c/trace-$method" "$scratch/cl/trace-$method" "the trace of C: $method"
done
digests_hold "$scratch/cl/trace-epr"
verdict $? 'whose digests hold'
run list backends --json
python3 - "$scratch" <<'PY'
import json, sys
trace = json.load(open(sys.argv[1] + "/cl/trace-epr/trace.json"))
device = next(d for d in json.load(open(sys.argv[1] + "/stdout"))["backends"] if d["name"] == "opencl")
producer, arithmetic = trace["producer"], trace["arithmetic"]
assert producer["backend"] == "opencl" and producer["device"].startswith(device["device"] + ", ")
assert producer["compiler"] and producer["flags"].startswith("-cl-std=CL1.2")
assert ("-cl-fp32-correctly-rounded-divide-sqrt" in producer["flags"]) == (device["rounded"] == "exact")
assert arithmetic["rounding"] == "nearest even" and arithmetic["contraction"] is False and arithmetic["selftest"] == 0
assert arithmetic["denormals"] == device["denormals"]
PY
verdict $? 'its producer and arithmetic are the device'"'"'s'

finish
