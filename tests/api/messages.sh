#!/bin/bash
# What the library says names no subcommand and no table of the command. Prints TAP.
set -u
told() { grep -rnE '"[^"]*(touchstone |`)(list|info|golden|report|compare|replay|render|probe|explain|digest) ?[^"]*"' \
	"$@" --include='*.c' --include='*.cc'; }
command=$(told src/cli | wc -l)
library=$(told $(ls -d src/*/ | grep -vE '^src/(cli|study|python|kernels)/$') | grep -v '/tools/claims.c:')
[ "$command" -gt 2 ] || printf 'not '
echo "ok 1 - the command's own lines name its tables ($command)"
[ -z "$library" ] || printf '%s\n' "$library" | sed 's/^/# /'
[ -z "$library" ] || printf 'not '
echo "ok 2 - the library's lines do not"
echo "1..2"
