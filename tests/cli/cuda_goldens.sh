#!/bin/bash
# Every golden case by the PTX, run instruction by instruction: the digests of C. Minutes.
. "$(dirname "$0")/tap.bash"
. "$(dirname "$0")/cuda.bash"
"$touchstone" golden check --backend cuda > "$scratch/stdout" 2>&1
grep -v '^same' "$scratch/stdout" | sed 's/^/# /'
tail -n 1 "$scratch/stdout" | grep -q "^$(grep -c '^[a-z]' reference/goldens/cases.txt) passed, 0 failed, 0 skipped"
verdict $? 'every golden case'
finish
