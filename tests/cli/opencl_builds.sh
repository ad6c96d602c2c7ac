#!/bin/bash
# OpenCL kernels built for other devices, and in ways that break the contract.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
small=(--size 48x32 --reflectors 2 --set reflectors.px=16 --set cube.max_px=16)
cl=(--backend opencl)
need_device opencl
render() { run "${frame[@]}" --method "$1" --trace -o "$scratch/$2" "${@:3}"; }

# Kernels are built anew for each device; without mirrors there are few.
# Work groups: tests/backends/opencl.c, make matrix.
export POCL_DEVICES='basic pthread'
run list backends
if [ "$(grep -c '^opencl ' "$scratch/stdout")" -eq 2 ]; then
	digest=(digest dining:triangles=10000:texels=32 "${small[@]}" --method mvr --reflectors 0)
	run "${digest[@]}"
	cp "$scratch/stdout" "$scratch/expected"
	run "${digest[@]}" "${cl[@]}" --device 1
	[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout" && cmp -s "$scratch/stdout" "$scratch/expected"
	verdict $? 'the digests of C from another device'
	refuses 'device 2: there are 2 devices' digest "${cl[@]}" --device 2
else
	tests=$((tests + 1))
	echo "ok $tests - two devices # SKIP PoCL offers none"
fi
unset POCL_DEVICES

# PoCL starts a linker, by its name.
mkdir "$scratch/cache"
digest=(digest dining:triangles=10000:texels=32 "${small[@]}" --method mvr --reflectors 0)
run "${digest[@]}"
cp "$scratch/stdout" "$scratch/expected"
(unset PATH; export POCL_CACHE_DIR=$scratch/cache; "$touchstone" "${digest[@]}" "${cl[@]}" > "$scratch/stdout")
cmp -s "$scratch/stdout" "$scratch/expected" && [ -n "$(ls "$scratch/cache")" ]
verdict $? 'without a PATH, and without what was built before'

# Builds that break the contract.
refuses 'breaks the numeric contract.*in [0-9]* primitives: .*muladd (' "${frame[@]}" --trace -o "$scratch/broken" \
	"${cl[@]}" --build -DTS_CANARY_CONTRACTS
refuses 'breaks the numeric contract.*in [0-9]* primitives: ' digest "${cl[@]}" --build -cl-fast-relaxed-math
[ ! -e "$scratch/broken" ] && [ ! -e "$scratch/broken.partial" ]
verdict $? 'and nothing written'
render mvr plain --reflectors 0
render mvr broken --reflectors 0 "${cl[@]}" --build -DTS_CANARY_CONTRACTS --inexact
ends 0 '' 'rendered all the same with --inexact'
run compare "$scratch/plain/trace-mvr" "$scratch/broken/trace-mvr"
[ "$status" -eq 1 ] && grep -q '^stage 0[0-9] [a-z]*, buffer .*; inputs identical' "$scratch/stdout"
verdict $? 'compare names the stage that differs first'
python3 - "$scratch/broken/trace-mvr/trace.json" <<'PY'
import json, sys
trace = json.load(open(sys.argv[1]))
a = trace["arithmetic"]
assert a["contraction"] is True and a["selftest"] > 0 and a["rounding"] == "nearest even" and a["denormals"] == "kept"
assert "-DTS_CANARY_CONTRACTS" in trace["producer"]["flags"]
PY
verdict $? 'and its trace says what is wrong with the arithmetic'
run digest dining:triangles=10000:texels=32 "${small[@]}" --reflectors 0 --method mvr "${cl[@]}" --build \
	-DTS_CANARY_CONTRACTS --inexact
[ "$status" -eq 0 ] && grep -q image.srgb "$scratch/stdout"
verdict $? 'digests too'

finish
