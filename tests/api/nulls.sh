#!/bin/bash
# Every function of the public headers that takes a pointer stands in tests/api/nulls.c. Prints TAP.
set -u
forgotten=$(echo '#include <touchstone/touchstone.h>' |
	gcc -std=c11 -Iinclude -fsyntax-only -aux-info /dev/stdout -xc - |
	sed -nE 's|^/\* include/touchstone/.* \**(ts_[a-z0-9_]+) \(.*\*.*\);.*|\1|p' | sort -u |
	while read -r name; do grep -q "\b$name(" tests/api/nulls.c || echo "$name"; done)
[ -z "$forgotten" ] || printf '# not in tests/api/nulls.c: %s\nnot ' "$forgotten"
echo "ok 1 - every function of the API is given NULL"
echo "1..1"
