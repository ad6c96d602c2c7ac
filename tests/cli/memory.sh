#!/bin/bash
# The memory that render estimates is near what it takes, in small frames too,
# where most is the process's own and the scene's.
. "$(dirname "$0")/tap.bash"

case ${BUILD:-} in
*san) echo "1..0 # SKIP a sanitizer takes memory of its own"; exit 0 ;;
esac
TOUCHSTONE=$touchstone timeout 300 scripts/memory --small atrium:triangles=10000:texels=128 > "$scratch/table"
verdict $? "ten methods, estimates within 1.5 of the peak"
[ "$(grep -c ' by ' "$scratch/table")" -eq 12 ]
verdict $? "a line for each, and one with pictures and a page for two"
printf '%s\n' '#!/bin/sh' 'echo "{\"estimated_bytes\": 1000000}"' > "$scratch/liar"
chmod +x "$scratch/liar"
! TOUCHSTONE=$scratch/liar scripts/memory --small atrium:triangles=10000:texels=128 > "$scratch/table" &&
	grep -q 'not within' "$scratch/table"
verdict $? "the script sees an estimate that is too small"
finish
