#!/bin/bash
# The functions that the public headers declare are those that the shared library exports, and tests/api/nulls.c gives
# NULL to each that takes a pointer. Prints TAP.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
n=0

none() { # NAME: nothing is in $folder/other
	n=$((n + 1))
	[ ! -s "$folder/other" ] || printf 'not '
	echo "ok $n - $1"
	sed 's/^/# /' "$folder/other"
}

echo '#include <touchstone/touchstone.h>' > "$folder/all.c"
gcc -std=c11 -Iinclude -fsyntax-only -aux-info "$folder/prototypes" "$folder/all.c"
declared() { # END: of a prototype
	sed -nE "s|^/\* include/touchstone/.* \**(ts_[a-z0-9_]+) \($1|\1|p" "$folder/prototypes" | sort -u
}
declared '.*' > "$folder/declared"
[ -s "$folder/declared" ] || echo 'no function' > "$folder/other"
nm -D --defined-only "${BUILD:-build/release}/libtouchstone.so" | awk '{print $NF}' | sort -u |
	diff "$folder/declared" - >> "$folder/other"
none 'libtouchstone.so exports what the headers declare (<: only declared, >: only exported)'
declared '.*\*.*\);.*' | while read -r name; do
	grep -q "\b$name(" tests/api/nulls.c || echo "$name"
done > "$folder/other"
none 'every function that takes a pointer is given NULL by tests/api/nulls.c'
echo "1..$n"
