#!/bin/bash
# Calls of every command fail, one by one (scripts/faults, its brief form): it does what it does undisturbed, or ends
# with exit code 2 and one line that names the cause, and leaves everything as it was.
. "$(dirname "$0")/tap.bash"

scripts/faults --brief > "$scratch/said"
while read -r name cells; do
	case $name in
	bad: | again: | POCL_CACHE_DIR=*) echo "# $name $cells" ;;
	bad/tried | [0-9]*) ;;
	*:) echo "ok $((tests += 1)) - $name # SKIP $cells" ;;
	*)
		! grep -q '[1-9][0-9]*/' <<< "$cells"
		verdict $? "$name: bad of those tried: $cells"
		;;
	esac
done < "$scratch/said"
tail -n 1 "$scratch/said" | grep -q " passed, "
verdict $? "all commands were tried"
finish
