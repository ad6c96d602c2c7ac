#!/bin/bash
# The OpenCL backend from the command line: the same bits as C's, what it refuses,
# and how it ends where there is no device.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
small=(--size 48x32 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16)
on=(--backend opencl)

# without_device ARGUMENT...
without_device() { OCL_ICD_VENDORS=/nonexistent run "$@"; }

ends_without_device opencl 'no OpenCL device; install'
without_device digest "${on[@]}" --help
[ "$status" -eq 0 ] && grep -q work-group "$scratch/stdout"
verdict $? 'no device: help all the same'
refuses 'a whole number from 0 to 4096' digest "${on[@]}" --work-group 5000
refuses 'a whole number from 0 to 31' digest "${on[@]}" --device 32

need_device opencl
refuses 'device 7: there are [0-9]* devices, from 0' digest "${on[@]}" --device 7
refuses 'build: at most' digest "${on[@]}" --build -D"$(printf '%0300d' 0)"
run digest "${on[@]}" --build -no-such-option
[ "$status" -eq 2 ] && tail -n 1 "$scratch/stderr" | grep -q 'backend opencl: building the kernels' &&
	[ ! -s "$scratch/stdout" ]
verdict $? 'options that the compiler refuses'

digests() { same_digests "the digests of C: $*" run dining:triangles=10000:texels=32 "${small[@]}" --method "$@"; }
digests epr,mvr
digests epr,mvr --reflectors 0
digests epr,mvr --set lookup.bounces=3 --set lookup.samples=adaptive --set mvr.faces=adaptive
digests epr,mvr --set splat.plane_depth=on --set splat.clip=off --set mvr.filter=supersample --set cube.px=24
digests epr --set visibility.test=vertex --set density.path=paper --set splat.size=paper --set points.cull_unit=raster \
	--set points.conservative=exact
digests epr --set density.scale=2 --set density.per_area=on --set density.off_axis=on --set points.split=off \
	--set density.cap=off --set points.cull=off
for case in small-bounces small-adaptive; do
	prints '1 passed, 0 failed' golden check $case "${on[@]}"
done

# Traces.
same_traces run
python3 - "$scratch" <<'PY'
import json, sys
trace = json.load(open(sys.argv[1] + "/canonical/trace-epr/trace.json"))
device = next(d for d in json.load(open(sys.argv[1] + "/backends"))["backends"] if d["name"] == "opencl")
flags = trace["producer"]["flags"]
assert flags.startswith("-cl-std=CL1.2")
assert ("-cl-fp32-correctly-rounded-divide-sqrt" in flags) == (device["rounded"] == "exact")
assert trace["arithmetic"]["denormals"] == device["denormals"]
PY
verdict $? 'kernels are built for what the device can do'
run "${frame[@]}" --method mvr --trace -o "$scratch/mvr" "${on[@]}"
run "${frame[@]}" --method mvr --trace -o "$scratch/mvr-c"
same "$scratch/mvr-c/trace-mvr" "$scratch/mvr/trace-mvr" 'the trace of C: mvr'


/usr/bin/python3 tests/cli/animated.py write "$scratch/animated.gltf"
moving=(render reflections "$scratch/animated.gltf" --method epr --size 96x54 --reflectors 2 --set cube.hysteresis=8
	--frame 17 --trace)
run "${moving[@]}" -o "$scratch/still"
run "${moving[@]}" "${on[@]}" -o "$scratch/moving"
same "$scratch/still/trace-epr" "$scratch/moving/trace-epr" 'a file whose nodes move: the bits of C'
finish
