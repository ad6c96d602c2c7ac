#!/bin/bash
# Every public header compiles alone, as C11 and as C++17, and twice in one file; and after macros of a program, which
# keep their values. Prints TAP.
set -u
n=0

check() { # NAME COMPILER FLAG...
	local name=$1
	shift
	n=$((n + 1))
	if printf '#include <touchstone/%s>\n#include <touchstone/%s>\n' "$header" "$header" |
		"$@" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Iinclude -; then
		echo "ok $n - $header as $name"
	else
		echo "not ok $n - $header as $name"
	fi
}

for path in include/touchstone/*.h; do
	header=$(basename "$path")
	check C11 gcc -std=c11 -x c
	check C++17 g++ -std=c++17 -x c++
done
n=$((n + 1))
own="BUFFER RECORD FIELD RECORD_END SUM INDEX DIM"
if { printf '#define %s 7\n' $own; echo '#include <touchstone/touchstone.h>'; printf \
	'_Static_assert(%s == 7, "%s");\n' $(printf '%s\n' $own | sed 's/.*/\0 \0/'); } |
	gcc -std=c11 -x c -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Iinclude -; then
	echo "ok $n - macros of the program"
else
	echo "not ok $n - macros of the program"
fi
echo "1..$n"
