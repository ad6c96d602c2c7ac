#!/bin/bash
# What no build compiles alone: every public header, as C11 and as C++17, and twice in one file; and after macros of a
# program, which keep their values; and the programs of fuzzing, which are built by hand. Prints TAP.
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
for program in tests/fuzz/*.c; do
	n=$((n + 1))
	gcc -std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -fsyntax-only -Iinclude -iquote src -iquote . \
		"$program" || printf 'not '
	echo "ok $n - $program"
done
echo "1..$n"
