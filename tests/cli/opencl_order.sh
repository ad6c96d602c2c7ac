#!/bin/bash
# OpenCL in any order: points as they arrive, work groups in reverse, memory of the device's own: the same bits as C's.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/traces.bash"
. "$(dirname "$0")/opencl.bash"
cl=(--backend opencl)
need_device opencl
render() { run "${frame[@]}" --method "$1" --trace -o "$scratch/$2" "${@:3}"; }
render all c

# Points as they arrive: more than there is room for at first, which is two a piece.
python3 - "$scratch/c/trace-epr" <<'PY'
import os, sys
size = lambda name: os.path.getsize(f"{sys.argv[1]}/{name}.npy") - 128
assert size("11-points.key") // 8 > 2 * size("07-split.piece") // 48 > 0
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
group=(--work-group 1) # one for all, as kernels are built for each
altered TOUCHSTONE_CL_REVERSE=1 "${frame[@]}" --method epr --trace -o "$scratch/reverse" "${cl[@]}" "${group[@]}"
same "$scratch/c/trace-epr" "$scratch/reverse/trace-epr" 'work groups in reverse order'
altered TOUCHSTONE_CL_REVERSE=1 "${frame[@]}" --method epr --trace -o "$scratch/later" "${cl[@]}" "${group[@]}" \
	--order arrival
same "$scratch/c/trace-epr" "$scratch/later/trace-epr" 'the last work group arrives first'
! cmp -s "$scratch/later/trace-epr/11-points.key.npy" "$scratch/c/trace-epr/11-points.key.npy"
verdict $? 'and its points first'
for method in epr mvr; do
	altered TOUCHSTONE_CL_COPIES=1 "${frame[@]}" --method $method --trace -o "$scratch/copies-$method" "${cl[@]}"
	same "$scratch/c/trace-$method" "$scratch/copies-$method/trace-$method" "memory of the device's own: $method"
done

# Two equal triangles: whichever point arrives first wins the texel.
twice=(render reflections scenes/triangle_twice.gltf --camera camera --reflectors 0 --size 64x64 --set cube.px=16
	--method epr --trace --no-images)
run "${twice[@]}" -o "$scratch/twice"
altered TOUCHSTONE_CL_REVERSE=1 "${twice[@]}" -o "$scratch/second" "${cl[@]}" "${group[@]}" --order arrival
run compare "$scratch/twice/trace-epr" "$scratch/second/trace-epr" --json
python3 - "$scratch/stdout" <<'PY'
import json, sys
rows = {r["buffer"]: r for r in json.load(open(sys.argv[1]))["buffers"]}
assert rows["splat.depth_index"]["verdict"] == "same" and rows["splat.depth_index"]["tied"] == 26
assert rows["points.key"]["verdict"] == rows["points.record"]["verdict"] == "same"
PY
verdict $? 'tied texels are counted'
run compare "$scratch/twice/trace-epr" "$scratch/second/trace-epr"
[ "$status" -eq 1 ] && tail -n 1 "$scratch/stdout" | grep -q '^stage 14 lookup.*splat.depth_index is tied; forced'
verdict $? 'what is looked up there may differ, and the report says how to judge it'
same "$scratch/twice/trace-epr" "$scratch/second/trace-epr" 'and each stage is right' --forced
altered TOUCHSTONE_CL_REVERSE=1 "${twice[@]}" -o "$scratch/order" "${cl[@]}" "${group[@]}"
same "$scratch/twice/trace-epr" "$scratch/order/trace-epr" 'in canonical order the lowest index wins'

finish
