#!/bin/bash
# Scripts that take arguments refuse what their usage does not have, in one line, and write nothing. Prints TAP.
set -u
. tests/cli/tap.bash
before=$(ls -A)

# says_usage SCRIPT ARGUMENT...: exit status 2, nothing on stdout, and the usage on stderr.
says_usage() {
	timeout 60 "$@" > "$scratch/stdout" 2> "$scratch/stderr"
	[ $? -eq 2 ] && [ ! -s "$scratch/stdout" ] && [ "$(wc -l < "$scratch/stderr")" -eq 1 ] &&
		grep -qE "usage: $1 |: (unknown|no) option --bogus" "$scratch/stderr" && [ "$(ls -A)" = "$before" ]
	verdict $? "refused: $*"
}

count=0
for script in scripts/*; do
	[ -x "$script" ] && [ ! -d "$script" ] || continue
	taken=$(head -n 20 "$script" | tr '\n#' '  ' | grep -oE "Usage: +$script( +(\[[^]]*\]|[A-Z][A-Z-]*)(\.\.\.)?)+") ||
		continue
	count=$((count + 1))
	says_usage "$script" --bogus
	! sed 's/\[[^]]*\]//g' <<< "${taken#Usage:*"$script"}" | grep -q '[A-Z]' || says_usage "$script"
done
[ "$count" -ge 30 ]
verdict $? 'the usages are found'
says_usage scripts/abi --write --check
says_usage scripts/abi --check more
says_usage scripts/pseudocode one two
says_usage scripts/verdicts --only
says_usage scripts/performance --from
says_usage scripts/run-tests --tier
says_usage scripts/house roms
finish
