#!/bin/bash
# Digests: one line a buffer, the same for any number of threads and with denormals flushed.
. "$(dirname "$0")/tap.bash"
small=(digest atrium:triangles=10000 --size 96x54 --reflectors 2 --set reflector_px=30 --set face_max=64)

for method in epr mvr; do
	run "${small[@]}" --method $method --threads 1
	cp "$scratch/stdout" "$scratch/$method"
	[ "$status" -eq 0 ] && ! grep -vqE '^(# reflections by [a-z]+|[0-9a-f]{64}  [0-9]{2}-[a-z0-9]+\.[a-z_]+\.npy)$' "$scratch/$method" &&
		grep -q 'image.srgb' "$scratch/$method"
	verdict $? "$method: one line a buffer"
	run "${small[@]}" --method $method --threads 3
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: three threads change nothing"
	run "${small[@]}" --method $method --flush-denormals
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: flushed denormals change nothing"
	run "${small[@]}" --method $method --reference
	cmp -s "$scratch/stdout" "$scratch/$method"
	verdict $? "$method: the reference changes nothing"
done

run "${small[@]}" --method epr --set seed=1
! cmp -s "$scratch/stdout" "$scratch/epr"
verdict $? 'another seed changes a digest'

finish
