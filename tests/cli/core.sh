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

# Shards that it judges are merged as by the large one.
goldens=$(realpath reference/goldens) && cd "$scratch" || exit
for i in 1 2; do
	run golden check 'small-e*' small-mvr --goldens "$goldens" --shard $i/2 -o $i --tap
	[ "$status" -eq 0 ] && [ "$(cat stdout)" = $'ok 1 - small-'"$([ $i = 1 ] && echo epr || echo mvr)"$'\n1..1' ]
	verdict $? "TAP of shard $i"
done
run golden check small-epr --goldens "$goldens" --shard 2/2 -o 2 --force
[ "$status" -eq 0 ] && [ -s 2/report.json ] && grep -q '"seconds_in_all": [0-9]' 2/*.json
verdict $? '--force replaces a folder of its own'
run golden check 'small-e*' small-mvr --goldens "$goldens" --shard 2/2 -o 2 --force -q
for program in "$large" "$touchstone"; do
	"$program" merge 2 1 --junit "$(basename "$program").xml" --markdown summary.md > "$(basename "$program").txt"
	[ $? -eq 0 ] && [ "$(sed -n 3p summary.md)" = '2 passed, 0 failed, 0 known, 0 skipped' ]
	verdict $? "merged by $(basename "$program")"
done
cmp -s touchstone.txt touchstone-core.txt && grep -q 'tests="2" failures="0" errors="0" skipped="0"' touchstone-core.xml
verdict $? 'with the same report'

limited=(digest atrium:triangles=10000:texels=32 --size 64x36 --method mvr --threads 3)
run "${limited[@]}"
for environment in OMP_THREAD_LIMIT=1 OMP_DYNAMIC=true OMP_MAX_ACTIVE_LEVELS=0; do
	env "$environment" "$touchstone" "${limited[@]}" 2> /dev/null | cmp -s - "$scratch/stdout"
	verdict $? "the same digests where OpenMP may give fewer threads: $environment"
done

finish
