#!/bin/bash
# The OpenCL backend from the command line: the same bits as C's, whatever the device, the work groups and the order; what it
# refuses; and how it ends where there is no device.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
small=(--size 48x32 --reflectors 2 --set reflector_px=16 --set face_max=16)
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

# digests METHOD OPTION...: of C and of OpenCL, with what stands in $and.
digests() {
	run digest dining:triangles=10000 "${small[@]}" --method "$@"
	cp "$scratch/stdout" "$scratch/expected"
	# shellcheck disable=SC2086
	run digest dining:triangles=10000 "${small[@]}" --method "$@" "${cl[@]}" $and
	[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout" && cmp -s "$scratch/stdout" "$scratch/expected"
	verdict $? "the digests of C: $*${and:+ $and}"
}

and=
digests epr,mvr
digests epr,mvr --reflectors 0
digests epr,mvr --set bounces=3 --set samples=adaptive --set mvr.faces=adaptive
digests epr,mvr --set planedepth=on --set clip=off --set mvr.filter=supersample --set face_px=24
digests epr --set visibility=vertex --set density=paper --set splat=paper --set cull_unit=raster --set conservative=exact
digests epr --set rho_scale=2 --set rho_is_area=on --set offaxis=on --set split=off --set cap=off --set cull=off
# Kernels are built anew for each of these; without mirrors there are few. All of them: make matrix.
and='--work-group 1' digests epr --reflectors 0
and='--work-group 256' digests mvr --reflectors 0
export POCL_DEVICES='basic pthread'
run list backends
if [ "$(grep -c '^opencl ' "$scratch/stdout")" -eq 2 ]; then
	digests mvr --reflectors 0
	and='--device 1' digests epr --reflectors 0
	refuses '--device 2: there are 2 devices' digest "${cl[@]}" --device 2
else
	tests=$((tests + 1))
	echo "ok $tests - two devices # SKIP PoCL offers none"
fi
unset POCL_DEVICES

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

# Builds that break the contract.
refuses 'breaks the numeric contract.*in [0-9]* primitives: .*muladd (' "${frame[@]}" --trace -o "$scratch/broken" \
	"${cl[@]}" --build -DTS_CANARY_CONTRACTS
refuses 'breaks the numeric contract.*in [0-9]* primitives: ' digest "${cl[@]}" --build -cl-fast-relaxed-math
[ ! -e "$scratch/broken" ] && [ ! -e "$scratch/broken.partial" ]
verdict $? 'and nothing written'
render epr plain --reflectors 0
render epr broken --reflectors 0 "${cl[@]}" --build -DTS_CANARY_CONTRACTS --inexact
ends 0 '' 'rendered all the same with --inexact'
run compare "$scratch/plain/trace-epr" "$scratch/broken/trace-epr"
[ "$status" -eq 1 ] && grep -q '^stage 0[0-9] [a-z]*, buffer .*; inputs identical' "$scratch/stdout"
verdict $? 'compare names the stage that differs first'
python3 - "$scratch/broken/trace-epr/trace.json" <<'PY'
import json, sys
trace = json.load(open(sys.argv[1]))
a = trace["arithmetic"]
assert a["contraction"] is True and a["selftest"] > 0 and a["rounding"] == "nearest even" and a["denormals"] == "kept"
assert "-DTS_CANARY_CONTRACTS" in trace["producer"]["flags"]
PY
verdict $? 'and its trace says what is wrong with the arithmetic'
run digest dining:triangles=10000 "${small[@]}" --reflectors 0 --method epr "${cl[@]}" --build -DTS_CANARY_CONTRACTS --inexact
[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout"
verdict $? 'digests too'

# Points as they arrive: more than there is room for at first, which is two a piece.
python3 - "$scratch/c/trace-epr" <<'PY'
import os, sys
size = lambda name: os.path.getsize(f"{sys.argv[1]}/{name}.npy") - 128
assert size("11-points.key") // 8 > 2 * size("07-split.triangle") // 48 > 0
PY
verdict $? 'a frame with more than two points a piece'
for i in 1 2 3; do
	render epr arrival$i --order arrival "${cl[@]}"
	same "$scratch/c/trace-epr" "$scratch/arrival$i/trace-epr" "run $i in order of arrival"
done
same "$scratch/c/trace-epr" "$scratch/arrival1/trace-epr" 'its stages one by one' --forced
render epr arrival --order arrival --threads 4
same "$scratch/c/trace-epr" "$scratch/arrival/trace-epr" "C's threads in order of arrival"

need_altering
altered TOUCHSTONE_CL_REVERSE=1 "${frame[@]}" --method epr --trace -o "$scratch/reverse" "${cl[@]}"
same "$scratch/c/trace-epr" "$scratch/reverse/trace-epr" 'work groups in reverse order'
altered TOUCHSTONE_CL_REVERSE=1 "${frame[@]}" --method epr --trace -o "$scratch/later" "${cl[@]}" --order arrival
same "$scratch/c/trace-epr" "$scratch/later/trace-epr" 'the last work group arrives first'
! cmp -s "$scratch/later/trace-epr/11-points.key.npy" "$scratch/c/trace-epr/11-points.key.npy"
verdict $? 'and its points first'
for method in epr mvr; do
	altered TOUCHSTONE_CL_COPIES=1 "${frame[@]}" --method $method --trace -o "$scratch/copies-$method" "${cl[@]}"
	same "$scratch/c/trace-$method" "$scratch/copies-$method/trace-$method" "memory of the device's own: $method"
done

# Two equal triangles: whichever point arrives first wins the texel.
twice=(render reflections scenes/triangle_twice.gltf --camera camera --reflectors 0 --size 64x64 --set face_px=16
	--method epr --trace --no-images)
run "${twice[@]}" -o "$scratch/twice"
altered TOUCHSTONE_CL_REVERSE=1 "${twice[@]}" -o "$scratch/second" "${cl[@]}" --work-group 1 --order arrival
run compare "$scratch/twice/trace-epr" "$scratch/second/trace-epr" --json
python3 - "$scratch/stdout" <<'PY'
import json, sys
rows = {r["buffer"]: r for r in json.load(open(sys.argv[1]))["buffers"]}
assert rows["splat.depth_index"]["verdict"] == "same" and rows["splat.depth_index"]["tied"] == 26
assert rows["points.key"]["verdict"] == rows["points.record"]["verdict"] == "same"
PY
verdict $? 'tied texels are counted'
run compare "$scratch/twice/trace-epr" "$scratch/second/trace-epr"
[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" | grep -q '^stage 14 lookup.*splat.depth_index is tied: --forced'
verdict $? 'what is looked up there may differ, and the report says how to judge it'
same "$scratch/twice/trace-epr" "$scratch/second/trace-epr" 'and each stage is right' --forced
altered TOUCHSTONE_CL_REVERSE=1 "${twice[@]}" -o "$scratch/order" "${cl[@]}" --work-group 1
same "$scratch/twice/trace-epr" "$scratch/order/trace-epr" 'in canonical order the lowest index wins'

finish
