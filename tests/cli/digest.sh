#!/bin/bash
# Digests: one line a buffer, the same for any number of threads and with denormals flushed.
. "$(dirname "$0")/tap.bash"
small=(digest atrium:triangles=10000:texels=32 --size 96x54 --reflectors 2 --set reflectors.px=30 --set cube.max_px=64)

for method in epr mvr; do
	run "${small[@]}" --method $method --threads 1
	cp "$scratch/stdout" "$scratch/$method"
	[ "$status" -eq 0 ] &&
		! grep -vqE '^(# reflections by [a-z]+|[0-9a-f]{64}  [0-9]{2}-[a-z_]+\.[a-z_]+\.npy)$' "$scratch/$method" &&
		grep -q 'image.srgb' "$scratch/$method"
	verdict $? "$method: one line a buffer"
	run "${small[@]}" --method $method --threads 3
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: three threads change nothing"
	run "${small[@]}" --method $method --flush-denormals
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: flushed denormals change nothing"
	run "${small[@]}" --method $method --no-fast-paths
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: the reference changes nothing"
done

# Buffers of all views are one file, however few are made at once; and shadows fall without mirrors.
shadows=(digest atrium:triangles=10000:texels=32 --size 96x54 --set lamp.views=7 --set lamp.cubes=3
	--set depth_map.px=32)
for effect in soft-shadows omni-shadows; do
	for method in mvr ivir; do
		run "${shadows[@]}" --effect $effect --method $method
		cp "$scratch/stdout" "$scratch/all"
		[ "$status" -eq 0 ] && grep -q "^# $effect by $method$" "$scratch/all" &&
			grep -q 'shadow_test.lit' "$scratch/all"
		verdict $? "$effect by $method has its buffers"
		run "${shadows[@]}" --effect $effect --method $method --set lamp.views_a_pass=2 --threads 3 --flush-denormals
		cmp -s "$scratch/stdout" "$scratch/all"
		verdict $? "$effect by $method: batches, threads and flushed denormals change nothing"
	done
	run "${shadows[@]}" --effect $effect --method mvr --reflectors 0
	"$touchstone" "${shadows[@]}" --effect $effect --method mvr | cmp -s - "$scratch/stdout"
	verdict $? "$effect has no mirrors by itself"
	run "${shadows[@]}" --effect $effect --method mvr --set reflectors.count=1
	! "$touchstone" "${shadows[@]}" --effect $effect --method mvr | cmp -s - "$scratch/stdout"
	verdict $? "$effect has those that are asked for"
done
for how in off on; do
	run "${shadows[@]}" --effect omni-shadows --method vir --set points.buffered=$how
	grep -v 'points\|count' "$scratch/stdout" > "$scratch/buffered-$how"
done
cmp -s "$scratch/buffered-off" "$scratch/buffered-on"
verdict $? 'stored points change nothing but that they are there'
refuses 'no effect "shadow"; the nearest is' digest --effect shadow
refuses 'no method "epr" of soft-shadows; "touchstone list methods" lists all$' digest --effect soft-shadows \
	--method epr

run "${small[@]}" --method epr --set seed=1
! cmp -s "$scratch/stdout" "$scratch/epr"
verdict $? 'another seed changes a digest'

finish
