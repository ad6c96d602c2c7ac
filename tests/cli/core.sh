#!/bin/bash
# The small command of the matrix: it tells of nothing that it lacks, and digests as the large one does.
. "$(dirname "$0")/tap.bash"
large=$touchstone
touchstone=$large-core

for command in help 'help digest' 'digest --help'; do
	run $command
	[ "$status" -eq 0 ] && ! grep -qE '\b(list|render|info|bench)\b' "$scratch/stdout"
	verdict $? "names no command that is not there: $command"
done
refuses 'the nearest is width$' digest --set widht=640

small=(digest atrium:triangles=10000:texels=32 --size 96x54 --reflectors 2 --set reflectors.px=30 --set cube.max_px=64)
run "${small[@]}"
"$large" "${small[@]}" | cmp -s - "$scratch/stdout"
verdict $? 'the same digests'

limited=(digest atrium:triangles=10000:texels=32 --size 64x36 --method mvr --threads 3)
run "${limited[@]}"
for environment in OMP_THREAD_LIMIT=1 OMP_DYNAMIC=true OMP_MAX_ACTIVE_LEVELS=0; do
	env "$environment" "$touchstone" "${limited[@]}" 2> /dev/null | cmp -s - "$scratch/stdout"
	verdict $? "the same digests where OpenMP may give fewer threads: $environment"
done

finish
